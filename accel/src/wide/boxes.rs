//! A ray against the eight boxes of a node.

use geometry::Ray;
use glam::Vec3;

use super::{
    layout::Node,
    simd::{Isa, Lanes, splat},
};

/// A ray made ready for the boxes of nodes.
///
/// The slab test (Kay and Kajiya 1986) with the planes chosen by the direction's signs: on each axis the ray crosses the near planes
/// at `(near - o) / d` and the far ones at `(far - o) / d`; it meets the boxes where the last near plane comes before the first far
/// one.
///
/// # No box that holds a hit is lost
///
/// With `u = 2^-24`, `R = |o| + B` on the axis, `B` the greatest coordinate of the tree, and `i = 1/d` rounded: a crossing is computed as
/// `plane i - o i`, which rounds five times, or four where the processor fuses, and is off by at most `5u R |i|` and a little. A hit is off its box by an eighth of
/// `u R |i|` ([`geometry::TriangleProbe`]; other primitives: by much less), its `t` by another `u R |i|` when it is rounded to `f32`.
/// In the watertight way a triangle counts as met up to `8u R |i|` beside it ([`super::triangles`]). That makes less than `14.2u`; the origin
/// itself is moved, forward for the near planes and back for the far ones, by `16u R`, rounded to no less than `15u R`. Nothing
/// need be done for it in the test.
///
/// A component of the direction that is zero, or too small for its reciprocal, is replaced by one of 2^-48 of the largest: that
/// moves the ray by 2^-47 R inside the tree. [`crate::ordinary`] has seen to it that nothing overflows to a NaN.
pub(super) struct BoxRay {
    /// Of the near planes and of the far ones: the origin, moved, times `i`.
    pub(super) near: [f32; 3],
    pub(super) far: [f32; 3],
    pub(super) inverse: [f32; 3],
    /// For each axis which planes are near: 0 the lower ones, 1 the upper.
    pub(super) sides: [usize; 3],
}

/// Of a sum of coordinates, the slack that every box has.
pub(super) const SLACK: f32 = 8.0 * f32::EPSILON;

/// Of the largest component of a direction, the least that counts.
pub(super) const NEGLIGIBLE: f32 = 1.0 / (1_u64 << 48) as f32;

impl BoxRay {
    #[inline(always)]
    pub(super) fn new(ray: &Ray, magnitude: f32) -> Self {
        let floor = (ray.direction.abs().max_element() * NEGLIGIBLE).max(f32::MIN_POSITIVE);
        let direction = ray.direction.to_array().map(|d| if d.abs() < floor { floor.copysign(d) } else { d });
        let inverse = direction.map(|d| 1.0 / d);
        let slack = SLACK * (ray.origin.abs() + Vec3::splat(magnitude));
        let forward = slack.copysign(direction.into());
        let (near_origin, far_origin) = (ray.origin + forward, ray.origin - forward);
        Self {
            near: (near_origin * Vec3::from(inverse)).to_array(),
            far: (far_origin * Vec3::from(inverse)).to_array(),
            inverse,
            sides: direction.map(|d| usize::from(d < 0.0)),
        }
    }

    /// The same for all lanes.
    #[inline(always)]
    pub(super) fn lanes<I: Isa>(&self, isa: I, min: f32) -> BoxLanes<I> {
        BoxLanes {
            near: splat(isa, self.near),
            far: splat(isa, self.far),
            inverse: splat(isa, self.inverse),
            sides: self.sides,
            min: I::F32::splat(isa, min),
        }
    }
}

/// A [`BoxRay`], each number in all lanes.
pub(super) struct BoxLanes<I: Isa> {
    pub(super) near: [I::F32; 3],
    pub(super) far: [I::F32; 3],
    pub(super) inverse: [I::F32; 3],
    pub(super) sides: [usize; 3],
    pub(super) min: I::F32,
}

impl<I: Isa> BoxLanes<I> {
    /// Where the ray enters each box, and a bit for each box that it meets before `limit`.
    #[inline(always)]
    pub(super) fn meet(&self, isa: I, node: &Node, limit: f32) -> (I::F32, u32) {
        let limit = I::F32::splat(isa, limit);
        let enters = self.enter(isa, node, 0).max(self.enter(isa, node, 1)).max(self.enter(isa, node, 2).max(self.min));
        let leaves = self.leave(isa, node, 0).min(self.leave(isa, node, 1)).min(self.leave(isa, node, 2).min(limit));
        (enters, enters.le(leaves))
    }

    #[inline(always)]
    fn enter(&self, isa: I, node: &Node, axis: usize) -> I::F32 {
        let near = I::F32::load(isa, &node.planes[axis][self.sides[axis] & 1]);
        near.times_less(self.inverse[axis], self.near[axis])
    }

    #[inline(always)]
    fn leave(&self, isa: I, node: &Node, axis: usize) -> I::F32 {
        let far = I::F32::load(isa, &node.planes[axis][self.sides[axis] & 1 ^ 1]);
        far.times_less(self.inverse[axis], self.far[axis])
    }
}
