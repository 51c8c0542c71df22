//! Rays against boxes: one against the sixteen of a node, or many against one.

use geometry::Ray;

use super::{
    layout::Node,
    simd::{Isa, Lanes, map},
};
use crate::ordinary::FARTHEST;

/// Rays made ready for the boxes of nodes: `T` is a number of each.
///
/// The slab test (Kay and Kajiya 1986) with the planes chosen by the direction's signs: on each axis the ray crosses the near planes
/// at `(near - o) / d` and the far ones at `(far - o) / d`; it meets the boxes where the last near plane comes before the first far
/// one.
///
/// # No box that holds a hit is lost
///
/// With `u = 2^-24`, `R = max|o| + B`, `B` the greatest coordinate of the tree, and `i = 1/d` rounded: a crossing is computed as
/// `plane i - o i`, which rounds five times, or four where the processor fuses, and is off by at most `5u R |i|` and a little. A hit is off its box by an eighth of
/// `u R |i|` ([`geometry::TriangleProbe`]; other primitives: by much less), its `t` by another `u R |i|` when it is rounded to `f32`.
/// In the watertight way a triangle counts as met up to `8u R |i|` beside it ([`super::triangles`]). That makes less than `14.2u`; so the near
/// planes are moved towards the ray's start and the far ones away from it, by `16u R |i|` in `t`, rounded to no less than `15u R |i|`.
/// It is part of what is added anyway: nothing need be done for it in the test.
///
/// A component of the direction that is zero, or too small for its reciprocal, is replaced by one of 2^-84. [`crate::ordinary`] has seen to it that
/// this is less than 2^-48 of the largest, so that the ray is moved by less than 2^-47 R inside the tree, and that no coordinate is above
/// 2^36, so that nothing overflows to a NaN.
pub(super) struct BoxRays<T> {
    /// Of the near planes and of the far ones: `-o i`, moved.
    near: [T; 3],
    far: [T; 3],
    pub(super) inverse: [T; 3],
    min: T,
}

/// Of a sum of coordinates, the slack that every box has.
pub(super) const SLACK: f32 = 8.0 * f32::EPSILON;

/// Of a direction's components, the least that counts: 2^-48 of the least that the largest of them may be. The same for all rays, so that the first
/// division need not wait until it is known which is the largest.
const NEGLIGIBLE: f32 = 1.0 / (1_u64 << 48) as f32 / FARTHEST;

/// For each axis which planes a ray comes to first: 0 the lower ones, 1 the upper.
#[inline(always)]
pub(super) fn near_sides(ray: &Ray) -> [usize; 3] {
    let down = ray.direction.is_negative_bitmask() as usize;
    [down & 1, down >> 1 & 1, down >> 2 & 1]
}

/// `R`: how far any point of the tree is from the origins in the lanes, on any axis. `magnitude` is the tree's greatest coordinate.
#[inline(always)]
pub(super) fn reach<I: Copy, L: Lanes<I>>(isa: I, origins: [L; 3], magnitude: f32) -> L {
    let [x, y, z] = origins;
    x.abs().max(y.abs()).max(z.abs()) + L::splat(isa, magnitude)
}

impl<L: Copy> BoxRays<L> {
    /// Of the origins and directions of the rays in the lanes, and their [`reach`].
    #[inline(always)]
    pub(super) fn new<I: Copy>(isa: I, origins: [L; 3], directions: [L; 3], min: f32, reach: L) -> Self
    where
        L: Lanes<I>,
    {
        let (one, slack) = (L::splat(isa, 1.0), L::splat(isa, -SLACK) * reach);
        let least = L::splat(isa, NEGLIGIBLE);
        let mut rays = Self { near: origins, far: origins, inverse: directions, min: L::splat(isa, min) };
        for axis in 0..3 {
            let direction = directions[axis];
            let inverse = one / direction.abs().max(least).with_sign_of(direction);
            let (start, moved) = (origins[axis] * inverse, slack * inverse.abs());
            rays.near[axis] = moved - start;
            rays.far[axis] = L::splat(isa, 0.0) - (moved + start);
            rays.inverse[axis] = inverse;
        }
        rays
    }

    /// Where each lane's ray enters its box, and a bit for each that does so before the limit: a ray in all lanes and the boxes of a node, or
    /// many rays and one box. `planes` are those of an axis, the nearer ones first.
    ///
    /// Where all that is compared is negative, as in an interval that begins below 0, bits tell too early where a ray enters and too late where it leaves:
    /// no box is lost.
    #[inline(always)]
    pub(super) fn meet<I: Isa>(&self, planes: impl Fn(usize) -> [L; 2], limit: L) -> (L, u32)
    where
        L: Lanes<I>,
    {
        let (mut enters, mut leaves) = (self.min, limit);
        for axis in 0..3 {
            let [near, far] = planes(axis);
            enters = enters.max_by_bits(near.times_plus(self.inverse[axis], self.near[axis]));
            leaves = leaves.min_by_bits(far.times_plus(self.inverse[axis], self.far[axis]));
        }
        (enters, enters.le(leaves))
    }
}

impl<T> BoxRays<T> {
    #[inline(always)]
    pub(super) fn map<U>(&self, f: impl Fn(&T) -> U) -> BoxRays<U> {
        BoxRays {
            near: map(&self.near, &f),
            far: map(&self.far, &f),
            inverse: map(&self.inverse, &f),
            min: f(&self.min),
        }
    }
}

impl Node {
    /// The nearer and the farther planes of all boxes on an axis.
    #[inline(always)]
    pub(super) fn planes_of_all<I: Isa>(&self, isa: I, sides: [usize; 3], axis: usize) -> [I::F32x16; 2] {
        let (planes, side) = (&self.planes[axis], sides[axis] & 1);
        [I::F32x16::load(isa, &planes[side]), I::F32x16::load(isa, &planes[side ^ 1])]
    }
}
