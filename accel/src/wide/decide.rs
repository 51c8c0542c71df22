//! Who decides whether a triangle is met, and which is the nearest.

use geometry::{Hit, Interval, Ray, TriangleProbe};
use glam::Vec3;

use super::{
    layout::Block,
    simd::{Isa, Lanes},
    triangles::{Met, TriangleRays},
};

/// Where a triangle of the tree stands: its block's number, eight times, and its lane.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Place(u32);

impl Place {
    /// Places in blocks that there are not.
    pub(super) const NOWHERE: Self = Self(u32::MAX);
    pub(super) const KNOWN: Self = Self(u32::MAX - 1);

    /// There are fewer than 2^29 blocks: a [`super::layout::Link`] has no bits for more.
    #[inline(always)]
    pub(super) fn new(block: usize, lane: usize) -> Self {
        Self((block as u32) << 3 | lane as u32)
    }

    #[inline(always)]
    pub(super) fn bits(self) -> u32 {
        self.0
    }

    #[inline(always)]
    pub(super) fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    #[inline(always)]
    pub(super) fn is_triangle(self) -> bool {
        self != Self::NOWHERE && self != Self::KNOWN
    }

    #[inline(always)]
    fn lane(self) -> usize {
        (self.0 & 7) as usize
    }

    #[inline(always)]
    fn block(self, blocks: &[Block]) -> &Block {
        &blocks[(self.0 >> 3) as usize]
    }

    #[inline(always)]
    pub(super) fn primitive(self, blocks: &[Block]) -> u32 {
        self.block(blocks).primitives[self.lane()]
    }

    /// A coordinate of one of its corners.
    #[inline(always)]
    pub(super) fn coordinate(self, blocks: &[Block], corner: usize, axis: usize) -> f32 {
        self.block(blocks).corners[corner][axis][self.lane()]
    }

    /// Its corners, axes turned.
    #[inline(always)]
    pub(super) fn corners(self, blocks: &[Block], axes: [usize; 3]) -> [Vec3; 3] {
        self.block(blocks).corners_at(self.lane(), axes)
    }
}

/// A ray's nearest hit so far.
///
/// Where `f32` is certain that a triangle is met, it need not be asked where just, as long as nothing else is met within the same few
/// roundings: only the nearest one is, at the end. What is known just is kept apart (`known`): it is seldom needed, and this stays in
/// registers.
#[derive(Clone, Copy)]
pub(super) struct Nearest {
    /// [`Place::NOWHERE`] of nothing, [`Place::KNOWN`] of what is known just.
    pub(super) place: Place,
    /// Its `t` lies between these. Of nothing, both are the end of the interval.
    pub(super) low: f32,
    pub(super) high: f32,
}

/// To be written over.
pub(super) const NO_HIT: Hit = Hit { t: f32::INFINITY, u: 0.0, v: 0.0, primitive: u32::MAX };

/// What is asked: for a closer look at one triangle.
#[derive(Clone, Copy)]
pub(super) struct Asked<'a> {
    pub(super) blocks: &'a [Block],
    pub(super) ray: &'a Ray,
    /// Borrowed, not copied: to copy both ends in one step, just after each has been written, makes a processor wait.
    pub(super) within: &'a Interval,
}

impl Nearest {
    #[inline(always)]
    pub(super) fn none(within: Interval) -> Self {
        Self { place: Place::NOWHERE, low: within.max, high: within.max }
    }

    /// With a triangle that is met for certain, between two distances, if it comes before the nearest so far.
    #[inline(always)]
    pub(super) fn or_certain<D: Decide>(
        self,
        asked: Asked,
        known: &mut Hit,
        place: Place,
        [low, high]: [f32; 2],
    ) -> Self {
        if low > self.high {
            self
        } else if high < self.low {
            Self { place, low, high }
        } else {
            self.or_possible::<D>(asked, known, place, low)
        }
    }

    /// With a triangle that may be met, if it is, and before the nearest so far.
    #[inline(always)]
    pub(super) fn or_possible<D: Decide>(self, asked: Asked, known: &mut Hit, place: Place, low: f32) -> Self {
        match self.nearer::<D>(asked, known, place, low) {
            Some(t) => Self { place: D::place(place), low: t, high: t },
            None => self,
        }
    }

    /// Where such a triangle is met.
    ///
    /// A call of its own, so that what is rare does not take the registers of the rest; and what it returns fits into two of them, so
    /// that the nearest hit need not stand in memory for it.
    #[cold]
    #[inline(never)]
    fn nearer<D: Decide>(self, asked: Asked, known: &mut Hit, place: Place, low: f32) -> Option<f32> {
        let hit = D::hit(asked, place, low).filter(|&hit| self.is_after::<D>(asked, *known, hit))?;
        D::keep(hit, known);
        Some(hit.t)
    }

    /// With a hit of what is not a triangle of the tree, if it comes before the nearest so far.
    #[inline(always)]
    pub(super) fn or_hit<D: Decide>(self, asked: Asked, known: &mut Hit, hit: Hit) -> Self {
        if !self.is_after::<D>(asked, *known, hit) {
            return self;
        }
        *known = hit;
        Self { place: Place::KNOWN, low: hit.t, high: hit.t }
    }

    /// Whether the nearest so far comes after a hit.
    #[inline(always)]
    fn is_after<D: Decide>(self, asked: Asked, known: Hit, hit: Hit) -> bool {
        let so_far = || match self.place {
            Place::NOWHERE => None,
            Place::KNOWN => Some(known),
            place => D::hit(asked, place, self.low),
        };
        hit.t < self.low || hit.t <= self.high && so_far().is_none_or(|nearest| hit.is_before(nearest))
    }

    /// The nearest hit, at the end.
    #[inline(always)]
    pub(super) fn finish<D: Decide>(self, asked: Asked, known: Hit) -> Option<Hit> {
        match self.place {
            Place::NOWHERE => None,
            Place::KNOWN => Some(known),
            place => D::finish(asked, place, self.low),
        }
    }

    /// What has been found already, if just where is known: for who asks primitives one by one.
    #[inline(always)]
    pub(super) fn known(self, known: Hit) -> Option<Hit> {
        (self.place == Place::KNOWN).then_some(known)
    }
}

/// One of the two ways to decide.
pub(super) trait Decide: Sized {
    /// Which of the triangles in the lanes are met, strictly within the interval and no later than `limit`; `corners` gives theirs by number
    /// and axis.
    fn meet<I: Isa, L: Lanes<I>>(
        isa: I,
        rays: &TriangleRays<L>,
        corners: impl Fn(usize, usize) -> L,
        within: Interval,
        limit: L,
    ) -> Option<Met<L>>;

    /// Where a triangle is met, to be compared with others; `low` is what `meet` has told of it.
    fn hit(asked: Asked, place: Place, low: f32) -> Option<Hit>;

    /// What is remembered of such a hit: its place, or the hit itself.
    fn place(place: Place) -> Place;

    /// Remembers the hit, if it is not its place that is remembered.
    fn keep(hit: Hit, known: &mut Hit);

    /// Where the nearest is met.
    fn finish(asked: Asked, place: Place, low: f32) -> Option<Hit>;
}

/// `f32` decides where it can, and `geometry` where it cannot: the hits of asking every primitive, bit for bit.
pub(super) struct Exact;

impl Decide for Exact {
    #[inline(always)]
    fn meet<I: Isa, L: Lanes<I>>(
        isa: I,
        rays: &TriangleRays<L>,
        corners: impl Fn(usize, usize) -> L,
        within: Interval,
        limit: L,
    ) -> Option<Met<L>> {
        rays.meet(isa, corners, within, limit)
    }

    #[inline(always)]
    fn hit(asked: Asked, place: Place, _: f32) -> Option<Hit> {
        let probe = TriangleProbe::new(asked.ray);
        let met = probe.intersect(place.corners(asked.blocks, probe.axes()), *asked.within)?;
        Some(met.on(place.primitive(asked.blocks)))
    }

    #[inline(always)]
    fn place(_: Place) -> Place {
        Place::KNOWN
    }

    #[inline(always)]
    fn keep(hit: Hit, known: &mut Hit) {
        *known = hit;
    }

    #[inline(always)]
    fn finish(asked: Asked, place: Place, low: f32) -> Option<Hit> {
        Self::hit(asked, place, low)
    }
}

/// `f32` decides by edge functions that leave no gap between neighbours; `geometry` then computes where the nearest is met.
pub(super) struct Watertight;

impl Decide for Watertight {
    #[inline(always)]
    fn meet<I: Isa, L: Lanes<I>>(
        isa: I,
        rays: &TriangleRays<L>,
        corners: impl Fn(usize, usize) -> L,
        within: Interval,
        limit: L,
    ) -> Option<Met<L>> {
        rays.meet_watertight(isa, corners, within, limit)
    }

    #[inline(always)]
    fn hit(asked: Asked, place: Place, low: f32) -> Option<Hit> {
        Some(Hit { t: low, u: 0.0, v: 0.0, primitive: place.primitive(asked.blocks) })
    }

    #[inline(always)]
    fn place(place: Place) -> Place {
        place
    }

    #[inline(always)]
    fn keep(_: Hit, _: &mut Hit) {}

    #[inline(always)]
    fn finish(asked: Asked, place: Place, low: f32) -> Option<Hit> {
        let (primitive, probe) = (place.primitive(asked.blocks), TriangleProbe::new(asked.ray));
        let Some(at) = probe.locate(place.corners(asked.blocks, probe.axes())) else {
            return Some(Hit { t: low, u: 0.0, v: 0.0, primitive });
        };
        let t = if asked.within.contains(at.t) { at.t } else { low };
        Some(Hit { t, u: at.u, v: at.v, primitive })
    }
}
