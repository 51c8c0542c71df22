//! Who decides whether a triangle is met.

use geometry::{Hit, Interval, TriangleProbe};

use super::{
    layout::Block,
    simd::{Isa, Lanes},
    triangles::TriangleLanes,
};

/// A ray made ready for triangles.
pub(super) struct Aimed<'a, I: Isa> {
    pub(super) isa: I,
    pub(super) within: Interval,
    pub(super) probe: &'a TriangleProbe,
    pub(super) triangles: TriangleLanes<I>,
}

/// A ray's nearest hit so far.
#[derive(Clone, Copy)]
pub(super) struct Nearest<'a> {
    pub(super) hit: Option<Hit>,
    /// Where its triangle stands, if in a block: for who has still to look closer.
    place: Option<(&'a Block, usize)>,
    /// Its `t`, or the end of the interval.
    pub(super) limit: f32,
}

impl<'a> Nearest<'a> {
    #[inline(always)]
    pub(super) fn none(within: Interval) -> Self {
        Self { hit: None, place: None, limit: within.max }
    }

    /// Takes a hit, if it comes before the nearest so far.
    #[inline(always)]
    pub(super) fn take(&mut self, hit: Hit, place: Option<(&'a Block, usize)>) {
        if self.hit.is_none_or(|nearest| hit.is_before(nearest)) {
            *self = Self { hit: Some(hit), place, limit: hit.t };
        }
    }
}

/// One of the two ways to decide.
pub(super) trait Decide: Sized {
    /// Takes the hits with a block's triangles.
    fn block<'a, I: Isa>(aimed: &Aimed<I>, block: &'a Block, nearest: &mut Nearest<'a>);

    /// Whether any of a block's triangles is met.
    fn is_met<I: Isa>(aimed: &Aimed<I>, block: &Block) -> bool;

    /// The nearest hit, at the end.
    fn finish(within: Interval, probe: &TriangleProbe, nearest: &Nearest) -> Option<Hit>;
}

/// `f32` leaves out what is surely not met, `geometry` decides: the hits of asking every primitive, bit for bit.
pub(super) struct Exact;

impl Decide for Exact {
    #[inline(always)]
    fn block<'a, I: Isa>(aimed: &Aimed<I>, block: &'a Block, nearest: &mut Nearest<'a>) {
        let mut candidates = aimed.triangles.candidates(aimed.isa, block, nearest.limit);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            if let Some(met) = aimed.probe.intersect(aimed.triangles.corners(block, lane), aimed.within) {
                nearest.take(met.on(block.primitives[lane & 7]), None);
            }
        }
    }

    #[inline(always)]
    fn is_met<I: Isa>(aimed: &Aimed<I>, block: &Block) -> bool {
        let mut candidates = aimed.triangles.candidates(aimed.isa, block, aimed.within.max);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            if aimed.probe.intersect(aimed.triangles.corners(block, lane), aimed.within).is_some() {
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn finish(_: Interval, _: &TriangleProbe, nearest: &Nearest) -> Option<Hit> {
        nearest.hit
    }
}

/// `f32` decides by edge functions that leave no gap between neighbours; `geometry` then computes where the nearest is met.
pub(super) struct Watertight;

impl Decide for Watertight {
    #[inline(always)]
    fn block<'a, I: Isa>(aimed: &Aimed<I>, block: &'a Block, nearest: &mut Nearest<'a>) {
        let (mut met, t) = aimed.triangles.met(aimed.isa, block, aimed.within.min, nearest.limit);
        if met == 0 {
            return;
        }
        let mut ts = [0.0; 8];
        t.store(&mut ts);
        while met != 0 {
            let lane = met.trailing_zeros() as usize;
            met &= met - 1;
            let t = ts[lane & 7];
            // At the nearest's own distance the lower number wins; at the interval's end nothing does.
            if t < aimed.within.max {
                nearest.take(Hit { t, u: 0.0, v: 0.0, primitive: block.primitives[lane & 7] }, Some((block, lane)));
            }
        }
    }

    #[inline(always)]
    fn is_met<I: Isa>(aimed: &Aimed<I>, block: &Block) -> bool {
        let Interval { min, max } = aimed.within;
        let (met, t) = aimed.triangles.met(aimed.isa, block, min, max);
        met & t.lt(I::F32::splat(aimed.isa, max)) != 0
    }

    #[inline(always)]
    fn finish(within: Interval, probe: &TriangleProbe, nearest: &Nearest) -> Option<Hit> {
        let hit = nearest.hit?;
        let Some((block, lane)) = nearest.place else { return Some(hit) };
        let Some(at) = probe.locate(block.corners_at(lane, probe.axes())) else { return Some(hit) };
        let t = if within.contains(at.t) { at.t } else { hit.t };
        Some(Hit { t, u: at.u, v: at.v, ..hit })
    }
}
