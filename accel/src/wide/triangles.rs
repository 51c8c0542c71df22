//! Rays against triangles: one against the eight of a block, or many against one.

use geometry::Interval;

use super::{
    layout::Block,
    simd::{Isa, Lanes},
};

/// Rays made ready for triangles: `T` is a number of each. Corners and directions have their axes turned as the probe's.
///
/// The test of [`geometry::TriangleProbe`] in `f32`, with the shear divided out:
///
/// ```text
///   x' = (vx - ox) - Sx (vz - oz),   Sx = dx/dz,   y' likewise;    U = x'c y'b - y'c x'b, V, W likewise
/// ```
///
/// (Woop, Benthin, Wald: Watertight Ray/Triangle Intersection, JCGT 2013.) The watertight way takes the signs of U, V, W as they come. The
/// exact way knows how far off they may be: it leaves out what is surely missed, takes what is surely met, and passes on what `f32`
/// cannot tell to the probe.
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
///   |U - exact| <= (32 + 8) u R m + 128 u^2 R^2  <  k m + q = f,     k = 44 u R,   q = 160 u^2 R^2 + 2^-120
/// ```
///
/// (the `2^-120` is for what underflows). What the probe accepts has exact U, V, W of one sign but for a share of 2^-52, far
/// below the 4 u R m to spare. So a triangle is passed on unless one of them is below `-f` and another above `f`.
///
/// The depths: the probe's `t` lies between the least and the greatest of the corners' `z / dz` but for `u R / 8 dz`, and is then rounded
/// to `f32`. Here these are rounded three times. So nothing is lost that starts before `limit + 6u R / dz` and does not
/// end before `min - 6u R / dz`.
///
/// # What is surely met
///
/// With U, V, W all above `f`, or all below `-f`, the exact ones have one sign, and the probe's as well, whose own error is far below `4u R m`.
/// It takes a hit of one sign unless it sees the triangle edge-on: `|n.d| < 2^-20 E1 E2 |dz|` for its edges' largest components. The shear keeps
/// volumes, so `n.d = dz (U + V + W)`; and an edge is no longer than `E = 2m + |dz| (end - start) + k`. Where each of U, V, W is beyond
/// `f + 2^-20 E^2`, the triangle is not edge-on, and is met.
///
/// `t = (U a + V b + W c) / (U + V + W)` from the corners' depths is then a mean with weights of one sign. The depths are off by
/// `D = 6u R / dz`; the weights, by `f` each, move the mean by at most `3f (end - start + 2D) / |U + V + W|`, where the sum is above `3f`; eight roundings of numbers
/// up to `R / dz` are less than `2D`, the probe's own less than `D / 3`. Together
///
/// ```text
///   |t - the probe's| <= 6D + 3.125 f (end - start) / |U + V + W|
/// ```
pub(super) struct TriangleRays<T> {
    pub(super) origin: [T; 3],
    /// `dx / dz`, `dy / dz`.
    pub(super) shear: [T; 2],
    /// `1 / dz` and `|dz|`.
    per_depth: T,
    depth: T,
    /// `k` and `q` of the bound.
    bound: [T; 2],
    /// `D`: 6u R / dz.
    depth_slack: T,
}

/// 2^-20 and what rounds: where a triangle seen edge-on begins.
const EDGE_ON: f32 = 1.0625 / (1_u32 << 20) as f32;

/// Of `R`, how far `x'` and `y'` may be off: 8u.
pub(super) const PROJECTED: f32 = 4.0 * f32::EPSILON;

/// What is seen of triangles in the lanes: `T` is a number of each.
struct Seen<T> {
    /// U, V, W.
    weights: [T; 3],
    least: T,
    greatest: T,
    /// The corners' depths in multiples of the direction.
    depths: [T; 3],
    /// The corners' `x'` and `y'`.
    corners: [[T; 2]; 3],
}

/// Triangles that may be met, a bit for each lane; and for those that surely are, between which distances.
pub(super) struct Met<T> {
    pub(super) possible: u32,
    pub(super) certain: u32,
    pub(super) low: T,
    pub(super) high: T,
}

impl<L: Copy> TriangleRays<L> {
    /// Of the origins and directions of the rays in the lanes, axes turned so that the direction's last is the largest, and their
    /// [`reach`](super::boxes::reach).
    #[inline(always)]
    pub(super) fn new<I: Copy>(isa: I, origin: [L; 3], direction: [L; 3], reach: L) -> Self
    where
        L: Lanes<I>,
    {
        const ROUNDOFF: f32 = 0.5 * f32::EPSILON;
        const UNDERFLOW: f32 = 1.0 / (1_u128 << 120) as f32;
        let reach = L::splat(isa, ROUNDOFF) * reach;
        let per_depth = L::splat(isa, 1.0) / direction[2];
        Self {
            origin,
            shear: [direction[0] * per_depth, direction[1] * per_depth],
            per_depth,
            depth: direction[2].abs(),
            bound: [L::splat(isa, 44.0) * reach, L::splat(isa, 160.0) * reach * reach + L::splat(isa, UNDERFLOW)],
            depth_slack: L::splat(isa, 6.0) * reach * per_depth.abs(),
        }
    }

    /// What is possible and what is certain to be met in the exact way, strictly within the interval and no later than `limit`. `None` if
    /// nothing is possible. `corners` are those of the triangles in the lanes, by number and axis.
    #[inline(always)]
    pub(super) fn meet<I: Isa>(
        &self,
        isa: I,
        corners: impl Fn(usize, usize) -> L,
        within: Interval,
        limit: L,
    ) -> Option<Met<L>>
    where
        L: Lanes<I>,
    {
        let (min, max) = (L::splat(isa, within.min), L::splat(isa, within.max));
        let seen = self.see::<I>(corners);
        let [[ax, ay], [bx, by], [cx, cy]] = seen.corners;
        let [starts, ends] = seen.span::<I>();
        let largest = ax.abs().max(ay.abs()).max(bx.abs().max(by.abs())).max(cx.abs().max(cy.abs()));
        let off = self.bound[0] * largest + self.bound[1];
        let inside = (L::splat(isa, 0.0) - off).le(seen.least) | seen.greatest.le(off);
        let possible = inside & starts.le(limit + self.depth_slack) & (min - self.depth_slack).le(ends);
        if possible == 0 {
            return None;
        }
        let span = ends - starts;
        let edge = largest + largest + span * self.depth + self.bound[0];
        let beyond = off + L::splat(isa, EDGE_ON) * edge * edge;
        let (t, inverse) = seen.mean_depth(isa);
        let slack = L::splat(isa, 3.125) * off * span * inverse.abs() + L::splat(isa, 6.0) * self.depth_slack;
        let (low, high) = (t - slack, t + slack);
        let strictly = beyond.lt(seen.least) | seen.greatest.lt(L::splat(isa, 0.0) - beyond);
        // Where a ray starts near a surface, that is met just behind its start.
        let outside = high.le(min) | limit.lt(low);
        let possible = possible & !(strictly & outside);
        Some(Met { possible, certain: strictly & possible & min.lt(low) & high.lt(max), low, high })
    }

    /// What is met in the watertight way. `None` if nothing is.
    #[inline(always)]
    pub(super) fn meet_watertight<I: Isa>(
        &self,
        isa: I,
        corners: impl Fn(usize, usize) -> L,
        within: Interval,
        limit: L,
    ) -> Option<Met<L>>
    where
        L: Lanes<I>,
    {
        let zero = L::splat(isa, 0.0);
        let seen = self.see::<I>(corners);
        let inside = zero.le(seen.least) | seen.greatest.le(zero);
        // A NaN, of a sum of 0, is below nothing.
        let (t, _) = seen.mean_depth(isa);
        let met = inside & L::splat(isa, within.min).lt(t) & t.lt(L::splat(isa, within.max)) & t.le(limit);
        if met == 0 {
            return None;
        }
        // Weights of a sliver may round to 0 beside it, where its corners are all on one side.
        let [[ax, ay], [bx, by], [cx, cy]] = seen.corners;
        let across = ax.min(bx).min(cx).le(zero) & zero.le(ax.max(bx).max(cx));
        let up = ay.min(by).min(cy).le(zero) & zero.le(ay.max(by).max(cy));
        let met = met & across & up;
        (met != 0).then_some(Met { possible: met, certain: met, low: t, high: t })
    }

    #[inline(always)]
    fn see<I: Isa>(&self, corners: impl Fn(usize, usize) -> L) -> Seen<L>
    where
        L: Lanes<I>,
    {
        let ([ax, ay], a_depth) = self.project::<I>([corners(0, 0), corners(0, 1), corners(0, 2)]);
        let ([bx, by], b_depth) = self.project::<I>([corners(1, 0), corners(1, 1), corners(1, 2)]);
        let ([cx, cy], c_depth) = self.project::<I>([corners(2, 0), corners(2, 1), corners(2, 2)]);
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        Seen {
            weights: [u, v, w],
            least: u.min(v).min(w),
            greatest: u.max(v).max(w),
            depths: [a_depth, b_depth, c_depth],
            corners: [[ax, ay], [bx, by], [cx, cy]],
        }
    }

    /// The `x'` and `y'` of a corner in each lane, and its depth.
    #[inline(always)]
    fn project<I: Isa>(&self, corner: [L; 3]) -> ([L; 2], L)
    where
        L: Lanes<I>,
    {
        let [x, y, z] = [corner[0] - self.origin[0], corner[1] - self.origin[1], corner[2] - self.origin[2]];
        ([x - self.shear[0] * z, y - self.shear[1] * z], z * self.per_depth)
    }
}

impl<L: Copy> Seen<L> {
    /// Where the triangles start and end.
    #[inline(always)]
    fn span<I: Isa>(&self) -> [L; 2]
    where
        L: Lanes<I>,
    {
        let [a, b, c] = self.depths;
        [a.min(b).min(c), a.max(b).max(c)]
    }

    /// The corners' mean depth by their weights, and one over the weights' sum.
    #[inline(always)]
    fn mean_depth<I: Isa>(&self, isa: I) -> (L, L)
    where
        L: Lanes<I>,
    {
        let ([u, v, w], [a, b, c]) = (self.weights, self.depths);
        let inverse = L::splat(isa, 1.0) / (u + v + w);
        ((u * a + v * b + w * c) * inverse, inverse)
    }
}

impl<T> TriangleRays<T> {
    #[inline(always)]
    pub(super) fn map<U>(&self, f: impl Fn(&T) -> U) -> TriangleRays<U> {
        TriangleRays {
            origin: [f(&self.origin[0]), f(&self.origin[1]), f(&self.origin[2])],
            shear: [f(&self.shear[0]), f(&self.shear[1])],
            per_depth: f(&self.per_depth),
            depth: f(&self.depth),
            bound: [f(&self.bound[0]), f(&self.bound[1])],
            depth_slack: f(&self.depth_slack),
        }
    }
}

impl Block {
    /// A component of one of the corners of all triangles.
    #[inline(always)]
    pub(super) fn of_all<I: Isa>(&self, isa: I, corner: usize, axis: usize) -> I::F32x8 {
        I::F32x8::load(isa, &self.corners[corner][axis])
    }
}

#[cfg(test)]
mod tests {
    use geometry::{Intersection, Ray, TriangleProbe, conformance::triangles};
    use glam::Vec3;
    use proptest::prelude::*;

    use super::*;
    use crate::wide::{boxes::reach, simd::Portable};

    /// What is told of one triangle, and what the probe says.
    fn both(corners: [Vec3; 3], ray: &Ray, within: Interval) -> (Option<Met<f32>>, Option<Intersection>) {
        let probe = TriangleProbe::new(ray);
        let magnitude = corners.iter().map(|corner| corner.abs().max_element()).fold(0.0, f32::max);
        let turned = corners.map(|corner| probe.turned(corner).to_array());
        let (origin, direction) = (probe.turned(ray.origin).to_array(), probe.turned(ray.direction).to_array());
        let rays = TriangleRays::new(Portable, origin, direction, reach(Portable, origin, magnitude));
        let met = rays.meet::<Portable>(Portable, |corner, axis| turned[corner][axis], within, within.max);
        (met, probe.intersect(turned.map(Vec3::from), within))
    }

    fn check(corners: [Vec3; 3], ray: &Ray, within: Interval) -> Result<bool, TestCaseError> {
        let (met, truth) = both(corners, ray, within);
        let Some(met) = met else {
            prop_assert_eq!(truth, None, "a hit was left out");
            return Ok(false);
        };
        prop_assert!(met.possible == 1 || truth.is_none(), "a hit was left out: {:?}", truth);
        if met.certain == 1 {
            let t = truth.map(|truth| truth.t);
            let is_between = t.is_some_and(|t| met.low <= t && t <= met.high);
            prop_assert!(is_between, "{:?} is not between {} and {}", t, met.low, met.high);
        }
        Ok(met.certain == 1)
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 4096, ..ProptestConfig::default() })]

        /// Aimed at corners, edges and beside them, from near and far, edge-on and at slivers.
        #[test]
        fn nothing_met_is_left_out_and_what_is_certain_is_met_there(aimed in triangles(), end in 0.0_f32..3.0) {
            let corners = aimed.shape.corners;
            check(corners, &aimed.ray, Interval::FORWARD)?;
            check(corners, &aimed.ray, Interval { min: 0.0, max: end })?;
        }

        /// Aimed within some roundings of an edge of a small triangle, seen from some distance.
        #[test]
        fn so_it_is_within_roundings_of_an_edge(
            corners in prop::array::uniform3(prop::array::uniform3(-1.0_f32..1.0)),
            origin in prop::array::uniform3(-1.0_f32..1.0),
            (scale, far) in (0_i32..12, 0_i32..12),
            (along, off) in (0.0_f32..1.0, -40_i32..40),
            edge in 0_usize..3,
        ) {
            let far = f32::powi(2.0, far) * Vec3::new(0.8, -0.5, 0.9);
            let corners = corners.map(|corner| f32::powi(0.5, scale) * Vec3::from(corner) + far);
            let origin = Vec3::from(origin);
            let target = corners[edge].lerp(corners[(edge + 1) % 3], along);
            let target = target + off as f32 * f32::EPSILON * far.abs().max_element() * Vec3::X;
            check(corners, &Ray::new(origin, target - origin), Interval::FORWARD)?;
        }
    }

    /// The bounds are not so wide that nothing would be certain.
    #[test]
    fn a_ray_through_the_middle_is_certain_to_meet() {
        let corners = [Vec3::new(-1.0, -1.0, 4.0), Vec3::new(1.0, -1.0, 5.0), Vec3::new(0.0, 1.0, 3.0)];
        let ray = Ray::new(Vec3::ZERO, Vec3::new(0.01, -0.02, 1.0));
        assert!(check(corners, &ray, Interval::FORWARD).is_ok_and(|is_certain| is_certain));
        let (met, truth) = both(corners, &ray, Interval::FORWARD);
        let (met, t) = (met.unwrap(), truth.unwrap().t);
        assert!(met.high - met.low < 1e-4 * t, "{} to {}", met.low, met.high);
    }
}
