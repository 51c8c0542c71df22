//! A ray against the eight triangles of a block.

use geometry::{Ray, TriangleProbe};
use glam::Vec3;

use super::{
    layout::Block,
    simd::{Isa, Lanes, splat},
};

/// A ray made ready for blocks of triangles.
///
/// The test of [`TriangleProbe`] in `f32`, on eight triangles at once, with the shear divided out:
///
/// ```text
///   x' = (vx - ox) - Sx (vz - oz),   Sx = dx/dz,   y' likewise;    U = x'c y'b - y'c x'b, V, W likewise
/// ```
///
/// (Woop, Benthin, Wald: Watertight Ray/Triangle Intersection, JCGT 2013.) It is used as a filter: `f32` cannot decide near the edges,
/// but it knows how far off it may be, and passes what it cannot decide on to the probe.
///
/// # The filter loses no hit
///
/// Let `u = 2^-24`, `B` the greatest coordinate of the tree, `R = max|o| + B`: no component of `v - o` is greater. Rounded
/// differences are off by `u R`; `Sx`, at most 1, by `2u`; the product by another `u R`, and the last difference, at most `2R`, by `2u R`:
///
/// ```text
///   |x' - exact| <= u R + (1 + 2 + 1) u R + 2u R = 7u R,   and with terms in u^2:  e = 8u R
/// ```
///
/// Let `m` be the largest of the six `|x'|, |y'|`. Then `U` from exact products of the computed `x', y'` is off by `4 e m + 2 e^2`, the
/// products and their difference round off at most `4u m^2 <= 8u R m`, and so
///
/// ```text
///   |U - exact| <= (32 + 8) u R m + 128 u^2 R^2  <  k m + q,     k = 44 u R,   q = 160 u^2 R^2 + 2^-120
/// ```
///
/// (the `2^-120` is for what underflows). What the probe accepts has exact U, V, W of one sign but for a share of 2^-52, far
/// below the 4 u R m to spare. So a triangle is passed on unless one of them is below `-(k m + q)` and another above `k m + q`.
///
/// The depths: the probe's `t` lies between the least and the greatest of the corners' `z / dz` but for `u R / 8 dz`, and is then rounded
/// to `f32`. Here these are rounded three times. So nothing is lost that starts before `limit + 6u R / dz` and does not
/// end before `min - 6u R / dz`.
pub(super) struct TriangleRay {
    axes: [usize; 3],
    origin: [f32; 3],
    shear: [f32; 2],
    /// 1 / dz.
    per_depth: f32,
    /// `k` and `q` of the bound.
    bound: [f32; 2],
    min: f32,
    /// 6u R / dz.
    depth_slack: f32,
}

impl TriangleRay {
    #[inline(always)]
    pub(super) fn new(ray: &Ray, probe: &TriangleProbe, min: f32, magnitude: f32) -> Self {
        const ROUNDOFF: f32 = 0.5 * f32::EPSILON;
        const UNDERFLOW: f32 = 1.0 / (1_u128 << 120) as f32;
        let reach = ROUNDOFF * (ray.origin.abs().max_element() + magnitude);
        let (origin, direction) = (probe.turned(ray.origin), probe.turned(ray.direction));
        let per_depth = 1.0 / direction.z;
        let depth_slack = 6.0 * reach * per_depth.abs();
        Self {
            axes: probe.axes(),
            origin: origin.to_array(),
            shear: [direction.x * per_depth, direction.y * per_depth],
            per_depth,
            bound: [44.0 * reach, 160.0 * reach * reach + UNDERFLOW],
            min: min - depth_slack,
            depth_slack,
        }
    }

    /// The same for all lanes.
    #[inline(always)]
    pub(super) fn lanes<I: Isa>(&self, isa: I) -> TriangleLanes<I> {
        TriangleLanes {
            axes: self.axes,
            origin: splat(isa, self.origin),
            shear: [I::F32::splat(isa, self.shear[0]), I::F32::splat(isa, self.shear[1])],
            per_depth: I::F32::splat(isa, self.per_depth),
            bound: [I::F32::splat(isa, self.bound[0]), I::F32::splat(isa, self.bound[1])],
            min: I::F32::splat(isa, self.min),
            depth_slack: self.depth_slack,
        }
    }
}

/// A [`TriangleRay`], each number in all lanes.
pub(super) struct TriangleLanes<I: Isa> {
    axes: [usize; 3],
    origin: [I::F32; 3],
    shear: [I::F32; 2],
    per_depth: I::F32,
    bound: [I::F32; 2],
    min: I::F32,
    depth_slack: f32,
}

impl<I: Isa> TriangleLanes<I> {
    /// A bit for each triangle that the ray may meet no later than its nearest hit so far.
    #[inline(always)]
    pub(super) fn candidates(&self, isa: I, block: &Block, nearest: f32) -> u32 {
        let limit = I::F32::splat(isa, nearest + self.depth_slack);
        let [ax, ay, a_depth] = self.projected(isa, &block.corners[0]);
        let [bx, by, b_depth] = self.projected(isa, &block.corners[1]);
        let [cx, cy, c_depth] = self.projected(isa, &block.corners[2]);
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        let largest = ax.abs().max(ay.abs()).max(bx.abs().max(by.abs())).max(cx.abs().max(cy.abs()));
        let bound = self.bound[0] * largest + self.bound[1];
        let least = u.min(v).min(w);
        let greatest = u.max(v).max(w);
        let zero = I::F32::splat(isa, 0.0);
        let inside = (zero - bound).le(least) | greatest.le(bound);
        let starts = a_depth.min(b_depth).min(c_depth);
        let ends = a_depth.max(b_depth).max(c_depth);
        inside & starts.le(limit) & self.min.le(ends)
    }

    /// A bit for each triangle that `f32` decides the ray meets, and where.
    #[inline(always)]
    pub(super) fn met(&self, isa: I, block: &Block, min: f32, limit: f32) -> (u32, I::F32) {
        let (min, limit) = (I::F32::splat(isa, min), I::F32::splat(isa, limit));
        let [ax, ay, a_depth] = self.projected(isa, &block.corners[0]);
        let [bx, by, b_depth] = self.projected(isa, &block.corners[1]);
        let [cx, cy, c_depth] = self.projected(isa, &block.corners[2]);
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        let zero = I::F32::splat(isa, 0.0);
        let inside = zero.le(u.min(v).min(w)) | u.max(v).max(w).le(zero);
        let sum = u + v + w;
        let t = (u * a_depth + v * b_depth + w * c_depth) / sum;
        // A NaN, of a sum of 0, is below nothing.
        (inside & min.lt(t) & t.le(limit), t)
    }

    /// The sheared `x'` and `y'` of a corner of each triangle, and its depth in multiples of the direction.
    #[inline(always)]
    fn projected(&self, isa: I, rows: &[[f32; 8]; 3]) -> [I::F32; 3] {
        let [x, y, z] = self.axes;
        let x = I::F32::load(isa, &rows[x]) - self.origin[0];
        let y = I::F32::load(isa, &rows[y]) - self.origin[1];
        let z = I::F32::load(isa, &rows[z]) - self.origin[2];
        [x - self.shear[0] * z, y - self.shear[1] * z, z * self.per_depth]
    }

    /// The corners of one triangle of a block, turned as the probe wants them.
    #[inline(always)]
    pub(super) fn corners(&self, block: &Block, lane: usize) -> [Vec3; 3] {
        block.corners_at(lane, self.axes)
    }
}
