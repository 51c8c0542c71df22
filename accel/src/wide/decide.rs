//! Who decides whether a triangle is met.

use geometry::{Hit, Interval};

use super::{
    layout::Block,
    simd::{Isa, Lanes},
    traverse::{Search, Walk},
    triangles::TriangleLanes,
};

/// One of the two ways to decide.
pub(super) trait Decide: Sized {
    /// Takes the hits with a block's triangles.
    fn block<'a, I: Isa>(walk: &mut Walk<'a, I, Self>, block: &'a Block);

    /// Whether any of a block's triangles is met.
    fn is_met<I: Isa>(
        search: &Search<'_, I, Self>,
        triangles: &TriangleLanes<I>,
        block: &Block,
        box_limit: I::F32,
        depth_limit: I::F32,
    ) -> bool;

    /// The nearest hit, at the end.
    fn finish<I: Isa>(walk: &Walk<'_, I, Self>) -> Option<Hit>;
}

/// `f32` leaves out what is surely not met, `geometry` decides: the hits of asking every primitive, bit for bit.
pub(super) struct Exact;

impl Decide for Exact {
    #[inline(always)]
    fn block<'a, I: Isa>(walk: &mut Walk<'a, I, Self>, block: &'a Block) {
        let mut candidates = walk.triangles.candidates(walk.isa, block, walk.depth_limit);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            if let Some(met) = walk.probe.intersect(walk.triangles.corners(block, lane), walk.within) {
                walk.found(met.on(block.primitives[lane & 7]), None);
            }
        }
    }

    #[inline(always)]
    fn is_met<I: Isa>(
        search: &Search<'_, I, Self>,
        triangles: &TriangleLanes<I>,
        block: &Block,
        _: I::F32,
        depth_limit: I::F32,
    ) -> bool {
        let mut candidates = triangles.candidates(search.isa, block, depth_limit);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            if search.probe.intersect(triangles.corners(block, lane), search.within).is_some() {
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn finish<I: Isa>(walk: &Walk<'_, I, Self>) -> Option<Hit> {
        walk.nearest
    }
}

/// `f32` decides by edge functions that leave no gap between neighbours; `geometry` then computes where the nearest is met.
pub(super) struct Watertight;

impl Decide for Watertight {
    #[inline(always)]
    fn block<'a, I: Isa>(walk: &mut Walk<'a, I, Self>, block: &'a Block) {
        let min = I::F32::splat(walk.isa, walk.within.min);
        let (mut met, t) = walk.triangles.met(walk.isa, block, min, walk.box_limit);
        if met == 0 {
            return;
        }
        let mut ts = [0.0; 8];
        t.store(&mut ts);
        while met != 0 {
            let lane = met.trailing_zeros() as usize;
            met &= met - 1;
            let t = ts[lane & 7];
            if t < walk.within.max {
                walk.found(Hit { t, u: 0.0, v: 0.0, primitive: block.primitives[lane & 7] }, Some((block, lane)));
            }
        }
    }

    #[inline(always)]
    fn is_met<I: Isa>(
        search: &Search<'_, I, Self>,
        triangles: &TriangleLanes<I>,
        block: &Block,
        box_limit: I::F32,
        _: I::F32,
    ) -> bool {
        let Interval { min, max } = search.within;
        let (mut met, t) = triangles.met(search.isa, block, I::F32::splat(search.isa, min), box_limit);
        met &= t.lt(I::F32::splat(search.isa, max));
        met != 0
    }

    #[inline(always)]
    fn finish<I: Isa>(walk: &Walk<'_, I, Self>) -> Option<Hit> {
        let hit = walk.nearest?;
        let Some((block, lane)) = walk.place else { return Some(hit) };
        let Some(at) = walk.probe.locate(walk.triangles.corners(block, lane)) else { return Some(hit) };
        let t = if walk.within.contains(at.t) { at.t } else { hit.t };
        Some(Hit { t, u: at.u, v: at.v, ..hit })
    }
}
