use glam::{DVec3, Vec3};

use crate::{Intersection, Interval, Ray};

/// A ray made ready for many triangle tests: the one place that decides whether, and where, a ray meets a triangle.
///
/// # The test
///
/// Edge functions in a space where the ray runs along z, in `f64` throughout. The axis of the direction's largest component becomes
/// z; each corner, seen from the origin, is sheared along the ray onto the plane of the other two axes and scaled by that
/// component, which saves its reciprocal:
///
/// ```text
///   x' = x dz - z dx,  y' = y dz - z dy        U = x'c y'b - y'c x'b   (twice the area of o b c), V, W likewise
/// ```
///
/// The origin projects to 0, and is inside if U, V, W have one sign, zero included. Each is a difference of two products that only
/// swap sign when an edge is walked the other way, so the two triangles at an edge, and all at a vertex, decide alike: no ray
/// slips through. (Woop, Benthin, Wald: Watertight Ray/Triangle Intersection, JCGT 2013; in `f64` from `f32` corners, two-sided.)
///
/// `t` is that of the triangle's plane, not the corners' depths weighted: a sliver's weights cancel. The plane's normal does not:
/// its terms are products of differences of `f32`, exact in `f64`, so that only their difference is rounded. It is right to 0.51 ulp of
/// `f32`, `u` and `v` to that and 2^-50 of the corners' distance over the width seen; hit and miss are right where an edge is not
/// passed as closely as that, and never leave a gap between neighbours. (`conformance/triangle.rs`, `accel/tests/watertight.rs`.)
///
/// # Every hit lies in the triangle's box
///
/// An accelerator leaves out triangles whose boxes the ray does not meet, so a hit outside the box would be found or not by
/// chance. Two things could bring one about; both are in doubt, and a hit in doubt must show that the ray meets the box, and its `t`
/// is cut to where it does (`cut_to_box`).
///
/// * *A weight of 0.* A product of `f64` rounds monotonically, so a difference of two products never has the wrong sign, but may be 0
///   where the truth is not. With three weights other than 0 the origin is strictly inside the triangle of the three projected
///   corners, hence within the box of these; with a 0 it may be far off on the line of an edge.
/// * *A triangle seen edge-on.* `t = n.a / n.d`, with `n = e1 x e2`. Let `E1`, `E2` and `D` be the largest components of the two edges and of the
///   direction. Then `n` is off by at most `6 v E1 E2` in each component (`v = 2^-53`), the two dot products by 32 v E1 E2 times
///   `|a|` and `D`. Where `|n.d| >= 2^-20 E1 E2 D` that moves the point at `t` by less than `2^-27 (|a| + |t| D)`, an eighth
///   of the `f32` rounding that every box test ([`crate::BoxProbe`]) has slack for; below, the ray is in doubt.
///
/// The projected corners themselves are off by a few `v` of their distance, as much less than that slack.
#[derive(Clone, Copy, Debug)]
pub struct TriangleProbe {
    /// Which of x, y, z have become x, y, z.
    axes: [usize; 3],
    /// With its axes turned.
    origin: DVec3,
    /// With its axes turned: z is the largest component.
    direction: DVec3,
}

/// Seen at less than about this angle, in radians, a triangle counts as edge-on.
const EDGE_ON: f64 = 1.0 / (1 << 20) as f64;

impl TriangleProbe {
    /// Makes a ray ready.
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        // Looked up, not branched on: rays that have been reflected go all ways.
        const TURNED: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];
        let axes = TURNED[largest_axis(ray.direction)];
        Self { axes, origin: turned(ray.origin, axes).as_dvec3(), direction: turned(ray.direction, axes).as_dvec3() }
    }

    /// A point with the axes turned so that the ray's largest component is last.
    #[inline]
    pub fn turned(&self, point: Vec3) -> Vec3 {
        turned(point, self.axes)
    }

    /// Which of x, y, z are the first, second and third component of [`Self::turned`].
    #[inline]
    pub fn axes(&self) -> [usize; 3] {
        self.axes
    }

    /// Where the ray meets the triangle with these corners, each [`Self::turned`], strictly within the interval.
    #[inline(always)]
    pub fn intersect(&self, corners: [Vec3; 3], within: Interval) -> Option<Intersection> {
        let corners = corners.map(|corner| corner.as_dvec3());
        let seen = corners.map(|corner| corner - self.origin);
        let weights = edge_functions(seen, self.direction);
        if !have_one_sign(weights) {
            return None;
        }
        // Edge-on, or without area: there is no one place where they meet.
        let sum = weights[0] + weights[1] + weights[2];
        if sum == 0.0 {
            return None;
        }
        let t = self.t_of(corners, seen, weights)? as f32;
        if !within.contains(t) {
            return None;
        }
        let inverse = 1.0 / sum;
        Some(Intersection { t, u: (weights[1] * inverse) as f32, v: (weights[2] * inverse) as f32 })
    }

    /// The `t` of a triangle that the ray meets: that of its plane, cut to its box if in doubt.
    #[inline(always)]
    fn t_of(&self, corners: [DVec3; 3], seen: [DVec3; 3], weights: [f64; 3]) -> Option<f64> {
        let plane = plane_of(corners, seen, weights, self.direction);
        if !plane.is_in_doubt {
            return Some(plane.t);
        }
        // Corners in a row: the weights are rounding noise, and there is no surface to leave.
        if plane.normal == DVec3::ZERO { None } else { self.cut_to_box(seen, plane.t) }
    }

    /// Where the ray meets a triangle that it is known to meet: as [`Self::intersect`], but what has been decided by a coarser test is not
    /// decided again. The weights are cut to the triangle. `None` if the ray is beside the triangle's box after all.
    #[inline(always)]
    #[expect(clippy::manual_clamp, reason = "`clamp` would keep a NaN")]
    pub fn locate(&self, corners: [Vec3; 3]) -> Option<Intersection> {
        let corners = corners.map(|corner| corner.as_dvec3());
        let seen = corners.map(|corner| corner - self.origin);
        let weights = edge_functions(seen, self.direction);
        let inverse = 1.0 / (weights[0] + weights[1] + weights[2]);
        // `f64::max` makes a NaN, of a triangle seen edge-on, 0.
        let u = (weights[1] * inverse).max(0.0).min(1.0);
        let v = (weights[2] * inverse).max(0.0).min(1.0 - u);
        let t = self.t_of(corners, seen, weights)?;
        Some(Intersection { t: t as f32, u: u as f32, v: v as f32 })
    }

    /// A `t` cut to where the ray is in the box of corners seen from its origin; `None` if that is nowhere. Where `t` is not a number,
    /// where the ray enters.
    ///
    /// The box is grown by much more than its own rounding, and much less than the slack of a box test in `f32`.
    #[cold]
    fn cut_to_box(&self, seen: [DVec3; 3], t: f64) -> Option<f64> {
        const SLACK: f64 = 1.0 / (1_u64 << 44) as f64;
        let min = seen[0].min(seen[1]).min(seen[2]);
        let max = seen[0].max(seen[1]).max(seen[2]);
        let slack = SLACK * (self.origin.abs() + min.abs().max(max.abs()));
        let (mut enters, mut leaves) = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..3 {
            let (min, max) = (min[axis] - slack[axis], max[axis] + slack[axis]);
            let direction = self.direction[axis];
            if direction == 0.0 {
                if min > 0.0 || max < 0.0 {
                    return None;
                }
            } else {
                let (a, b) = (min / direction, max / direction);
                enters = enters.max(a.min(b));
                leaves = leaves.min(a.max(b));
            }
        }
        // `f64::max` returns the other operand for a NaN.
        (enters <= leaves).then(|| t.max(enters).min(leaves))
    }
}

/// Where a ray meets the plane of a triangle that it meets.
pub(crate) struct PlaneMet {
    pub(crate) t: f64,
    /// Not of unit length.
    normal: DVec3,
    pub(crate) is_in_doubt: bool,
}

#[inline(always)]
pub(crate) fn plane_of(corners: [DVec3; 3], seen: [DVec3; 3], weights: [f64; 3], direction: DVec3) -> PlaneMet {
    let (along_b, along_c) = (corners[1] - corners[0], corners[2] - corners[0]);
    let normal = along_b.cross(along_c);
    let facing = normal.dot(direction);
    let t = normal.dot(seen[0]) / facing;
    let size = along_b.abs().max_element() * along_c.abs().max_element();
    let is_edge_on = facing.abs() < EDGE_ON * size * direction.z.abs();
    let is_in_doubt = is_edge_on | (weights[0] == 0.0) | (weights[1] == 0.0) | (weights[2] == 0.0);
    PlaneMet { t, normal, is_in_doubt }
}

/// The edge functions of corners seen from the origin, along a direction whose z is its largest component.
#[inline(always)]
pub(crate) fn edge_functions(corners: [DVec3; 3], direction: DVec3) -> [f64; 3] {
    let [a, b, c] = [sheared(corners[0], direction), sheared(corners[1], direction), sheared(corners[2], direction)];
    let edge = |from: [f64; 2], to: [f64; 2]| to[0] * from[1] - to[1] * from[0];
    [edge(b, c), edge(c, a), edge(a, b)]
}

#[inline(always)]
fn sheared(corner: DVec3, direction: DVec3) -> [f64; 2] {
    let sheared = corner.truncate() * direction.z - direction.truncate() * corner.z;
    [sheared.x, sheared.y]
}

#[inline(always)]
pub(crate) fn have_one_sign([a, b, c]: [f64; 3]) -> bool {
    // Not &&: the comparisons are cheaper than branches on them.
    ((a >= 0.0) & (b >= 0.0) & (c >= 0.0)) | ((a <= 0.0) & (b <= 0.0) & (c <= 0.0))
}

/// The axis of the component of largest magnitude; the first of equal ones.
#[inline]
fn largest_axis(direction: Vec3) -> usize {
    let [x, y, z] = direction.abs().to_array();
    let of_y_and_z = if y >= z { 1 } else { 2 };
    if (x >= y) & (x >= z) { 0 } else { of_y_and_z }
}

#[inline]
fn turned(v: Vec3, [x, y, z]: [usize; 3]) -> Vec3 {
    let v = v.to_array();
    Vec3::new(v[x], v[y], v[z])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hit_is_in_doubt_at_each_edge_and_each_corner() {
        let corners = [DVec3::new(-1.0, -1.0, 2.0), DVec3::new(1.0, -1.0, 2.0), DVec3::new(0.0, 1.0, 2.0)];
        for zeros in 0..7 {
            let weights = [0, 1, 2].map(|edge| if zeros >> edge & 1 == 1 { 0.0 } else { 1.0 });
            assert_eq!(plane_of(corners, corners, weights, DVec3::Z).is_in_doubt, zeros != 0, "{weights:?}");
        }
    }

    #[test]
    fn edge_on_is_a_matter_of_angle_not_of_size() {
        for (width, depth, length) in [(1.0, 1.0, 1.0), (1000.0, 0.25, 1.0), (1.0, 1.0, 64.0), (1e-3, 1e-2, 0.1)] {
            for (angle, is_in_doubt) in [(0.5 * EDGE_ON, true), (2.0 * EDGE_ON, false)] {
                let corners = [DVec3::ZERO, DVec3::new(0.0, width, 0.0), DVec3::new(depth * angle, 0.0, depth)];
                let plane = plane_of(corners, corners, [1.0, 1.0, 1.0], length * DVec3::Z);
                assert_eq!(plane.is_in_doubt, is_in_doubt, "{width} x {depth} at {angle}, ray of {length}");
            }
        }
    }

    #[test]
    fn the_axes_are_turned_until_the_largest_is_last() {
        for (direction, axes) in [(Vec3::X, [1, 2, 0]), (Vec3::Y, [2, 0, 1]), (Vec3::Z, [0, 1, 2])] {
            let probe = TriangleProbe::new(&Ray::new(Vec3::ZERO, direction));
            assert_eq!(probe.axes(), axes);
            assert_eq!(probe.turned(Vec3::new(0.0, 1.0, 2.0)).to_array(), axes.map(|axis| axis as f32));
        }
    }

    #[test]
    fn what_is_known_to_be_met_is_located_in_the_triangle() {
        let corners = [Vec3::new(1.0, 1.0, 4.0), Vec3::new(3.0, 1.0, 4.0), Vec3::new(1.0, 5.0, 8.0)];
        let located = |x, y| TriangleProbe::new(&Ray::new(Vec3::new(x, y, 0.0), 2.0 * Vec3::Z)).locate(corners);
        // z = 4 + (y - 1).
        assert_eq!(located(1.5, 2.0), Some(Intersection { t: 2.5, u: 0.25, v: 0.25 }));
        // Beside it, the weights are cut, and `t` stays that of the plane.
        assert_eq!(located(0.5, 2.0), Some(Intersection { t: 2.5, u: 0.0, v: 0.25 }));
        assert_eq!(located(1.5, 0.0), Some(Intersection { t: 1.5, u: 0.25, v: 0.0 }));
        assert_eq!(located(4.0, 1.5), Some(Intersection { t: 2.25, u: 1.0, v: 0.0 }));
        assert_eq!(located(2.0, 4.0), Some(Intersection { t: 3.5, u: 0.5, v: 0.5 }));
        // On the line of an edge, and beside the box.
        assert_eq!(located(4.0, 1.0), None);
    }

    /// Corners on one line through the ray as `f64` sees it, beside the ray: the weights are rounding noise.
    #[test]
    fn a_hit_in_doubt_lies_in_the_triangles_box() {
        // The ray runs in the plane y = 0 of the triangle, past it: x stays 0, the corners' x is 5 to 6.
        let corners = [Vec3::new(5.0, 0.0, 1.0), Vec3::new(6.0, 0.0, 1.0), Vec3::new(5.0, 0.0, 2.0)];
        let probe = TriangleProbe::new(&Ray::new(Vec3::ZERO, Vec3::Z));
        assert_eq!(probe.cut_to_box(corners.map(|corner| corner.as_dvec3()), 1.5), None);
        // Through it, but with a t from noise: cut to the box, z from 1 to 2.
        let probe = TriangleProbe::new(&Ray::new(Vec3::new(5.25, 0.0, 0.0), Vec3::Z));
        let seen = corners.map(|corner| corner.as_dvec3() - probe.origin);
        for (t, low, high) in [(7.0, 2.0, 2.1), (-7.0, 0.9, 1.0), (f64::NAN, 0.9, 1.0)] {
            let cut = probe.cut_to_box(seen, t).unwrap();
            assert!((low..=high).contains(&cut), "{t} cut to {cut}");
        }
    }

    #[test]
    fn the_box_that_a_hit_in_doubt_is_cut_to_is_grown_by_a_few_roundings() {
        let corners = [DVec3::new(-1.0, 0.0, 1.0), DVec3::new(1.0, 0.0, 1.0), DVec3::new(0.0, 0.0, 2.0)];
        let probe = TriangleProbe::new(&Ray::new(Vec3::new(0.0, 0.0, -1e6), Vec3::Z));
        let seen = corners.map(|corner| corner - probe.origin);
        // 2^-44 of the coordinate and the distance, 1e6 each.
        let past = probe.cut_to_box(seen, 2e6).unwrap() - (1e6 + 2.0);
        assert!((1e-7..2e-7).contains(&past), "{past}");
        // In its plane y = 0 and beside it, or through it: seen edge-on, so cut.
        assert!(probe.t_of(corners, seen, [0.0, 1.0, 1.0]).is_some_and(|t| (1e6..2e6).contains(&t)));
        let beside = TriangleProbe::new(&Ray::new(Vec3::new(5.0, 0.0, 0.0), Vec3::Z));
        assert_eq!(beside.t_of(corners, corners.map(|corner| corner - beside.origin), [0.0, 1.0, 1.0]), None);
    }
}
