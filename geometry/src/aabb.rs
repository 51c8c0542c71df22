use glam::Vec3;

use crate::{Interval, Ray, rounding::UNIT_ROUNDOFF};

/// A box along the axes: the points `min <= p <= max`. Flat boxes hold their face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The least coordinates.
    pub min: Vec3,
    /// The greatest coordinates.
    pub max: Vec3,
}

impl Aabb {
    /// Holds nothing: the start of a union.
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// Holds everything.
    pub const EVERYTHING: Self = Self { min: Vec3::NEG_INFINITY, max: Vec3::INFINITY };

    /// The smallest box around some points.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |all, point| all.union(Self { min: point, max: point }))
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether the two share a point; touching counts.
    pub fn overlaps(self, other: Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// Whether every point of the other lies in this one.
    pub fn contains(self, other: Self) -> bool {
        self.min.cmple(other.min).all() && other.max.cmple(self.max).all()
    }

    /// The middle.
    pub fn center(self) -> Vec3 {
        0.5 * self.min + 0.5 * self.max
    }

    /// The edges' lengths.
    pub fn extent(self) -> Vec3 {
        self.max - self.min
    }

    /// Half the surface. A ray that meets a box meets a box inside it with the probability of the ratio of their surfaces.
    pub fn half_surface(self) -> f32 {
        let edge = self.extent();
        edge.x * edge.y + edge.y * edge.z + edge.z * edge.x
    }

    /// The greatest absolute value of any coordinate; 0 for the empty box.
    pub fn magnitude(self) -> f32 {
        if self.min.cmpgt(self.max).any() { 0.0 } else { self.min.abs().max(self.max.abs()).max_element() }
    }
}

/// A ray made ready for many box tests.
///
/// The slab test (Kay and Kajiya 1986; Williams et al. 2005) with a slack that makes it conservative: a box that the exact
/// ray meets is never lost, nor one that a primitive's `f64` test finds met by a hair.
///
/// ```text
///            |<- the slab ->|              t where the ray crosses an axis' two planes; the box is met
///   ray ---->-----X---------X----->        where the three intervals overlap.
///                near      far
/// ```
///
/// With `u` the unit roundoff, `o` the origin, `B` the greatest coordinate of all boxes asked about and `i = 1/d` (rounded):
/// `(b - o) i` carries three roundings, an error of at most `3u |b - o| |i| (1 + 2u)`, and `|b - o| <= |o| + B`. The slack of
/// `4u (|o| + B) |i|`, added outwards, covers it; the `u` to spare is 10^8 times a primitive's own `f64` error. Boxes below 1e-30
/// lose their last digits to underflow, which the smallest normal number, added to the coordinates and to `t`, makes good.
///
/// So no box is ever missed, however flat, small, far, or seen along an edge, and none is met that the ray passes by more than `8u
/// (|o| + B)`: `conformance/aabb.rs`.
///
/// A component of the direction that is zero, or too small for its reciprocal, is replaced by one of 2^-100 of the largest,
/// which moves the ray by less than the slack inside the boxes: so no infinity or NaN arises from finite input. Where the
/// largest itself is below 2^-64 or above 2^64, or the origin 2^64 times as far away as the boxes, `f32` has no number that small
/// left: the slack is infinite, and every box counts as met.
#[derive(Clone, Copy, Debug)]
pub struct BoxProbe {
    origin: Vec3,
    inverse: Vec3,
    slack: Vec3,
}

impl BoxProbe {
    /// Makes a ray ready. `magnitude` is the greatest absolute coordinate ([`Aabb::magnitude`]) of the boxes to come.
    pub fn new(ray: &Ray, magnitude: f32) -> Self {
        const NEGLIGIBLE: f32 = 1.0 / (1_u128 << 100) as f32;
        const SHORT: f32 = 1.0 / (1_u128 << 64) as f32;
        const LONG: f32 = (1_u128 << 64) as f32;
        let largest = ray.direction.abs().max_element();
        let floor = (largest * NEGLIGIBLE).max(f32::MIN_POSITIVE);
        let invert = |d: f32| 1.0 / if d.abs() < floor { floor.copysign(d) } else { d };
        let inverse = Vec3::new(invert(ray.direction.x), invert(ray.direction.y), invert(ray.direction.z));
        let is_near = ray.origin.abs().max_element() <= LONG * (magnitude + f32::MIN_POSITIVE);
        let slack = if is_near && (SHORT..=LONG).contains(&largest) {
            let smallest = Vec3::splat(f32::MIN_POSITIVE);
            (4.0 * UNIT_ROUNDOFF * (ray.origin.abs() + magnitude) + smallest) * inverse.abs() + smallest
        } else {
            Vec3::INFINITY
        };
        Self { origin: ray.origin, inverse, slack }
    }

    /// For each axis the `t` at which the ray crosses the plane through `point`.
    pub fn crossings(&self, point: Vec3) -> Vec3 {
        (point - self.origin) * self.inverse
    }

    /// How far, for each axis, [`Self::crossings`] may be off.
    pub fn slack(&self) -> Vec3 {
        self.slack
    }

    /// Bit 0, 1, 2 set where the ray runs towards lower x, y, z.
    pub fn octant(&self) -> usize {
        let negative = |component: f32| usize::from(component.is_sign_negative());
        negative(self.inverse.x) | negative(self.inverse.y) << 1 | negative(self.inverse.z) << 2
    }

    /// Where the ray is in the box, widened by the slack and cut to `within`; `None` if nowhere. NaN counts as met.
    pub fn clip(&self, bounds: Aabb, within: Interval) -> Option<Interval> {
        let a = self.crossings(bounds.min);
        let b = self.crossings(bounds.max);
        // f32::min and max return the other operand for a NaN: a NaN cuts nothing off.
        let near = Vec3::new(a.x.min(b.x), a.y.min(b.y), a.z.min(b.z)) - self.slack;
        let far = Vec3::new(a.x.max(b.x), a.y.max(b.y), a.z.max(b.z)) + self.slack;
        let min = near.x.max(near.y).max(near.z.max(within.min));
        let max = far.x.min(far.y).min(far.z.min(within.max));
        // Written so that a NaN, too, lets the box pass.
        if min > max { None } else { Some(Interval { min, max }) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Aabb = Aabb { min: Vec3::ZERO, max: Vec3::ONE };

    fn meets(bounds: Aabb, origin: [f32; 3], direction: [f32; 3]) -> bool {
        let ray = Ray::new(origin.into(), direction.into());
        BoxProbe::new(&ray, bounds.magnitude()).clip(bounds, Interval::FORWARD).is_some()
    }

    #[test]
    fn a_box_contains_another_if_neither_end_sticks_out() {
        let moved = |low: f32, high: f32| Aabb { min: Vec3::splat(low), max: Vec3::splat(high) };
        assert!(UNIT.contains(UNIT) && UNIT.contains(moved(0.25, 0.75)));
        assert!(!UNIT.contains(moved(-0.25, 0.75)) && !UNIT.contains(moved(0.25, 1.25)));
    }

    #[test]
    fn boxes_overlap_where_they_share_a_point_and_along_every_axis() {
        let from = |corner: Vec3| Aabb { min: corner, max: corner + Vec3::ONE };
        assert!(UNIT.overlaps(from(Vec3::splat(0.5))) && UNIT.overlaps(from(Vec3::ONE)), "touching counts");
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            assert!(!UNIT.overlaps(from(1.5 * axis)) && !UNIT.overlaps(from(-1.5 * axis)), "apart along {axis}");
        }
    }

    #[test]
    fn the_center_is_the_middle_and_the_extent_the_edges_lengths() {
        let bounds = Aabb { min: Vec3::new(1.0, -3.0, 2.0), max: Vec3::new(2.0, 5.0, 2.0) };
        assert_eq!(bounds.center(), Vec3::new(1.5, 1.0, 2.0));
        assert_eq!(bounds.extent(), Vec3::new(1.0, 8.0, 0.0));
        assert_eq!(Aabb { min: Vec3::ZERO, max: Vec3::MAX }.center(), 0.5 * Vec3::MAX, "no sum that overflows");
    }

    #[test]
    fn a_ray_through_the_middle_meets_the_box_and_one_beside_it_does_not() {
        assert!(meets(UNIT, [-1.0, 0.5, 0.5], [1.0, 0.0, 0.0]));
        assert!(!meets(UNIT, [-1.0, 1.5, 0.5], [1.0, 0.0, 0.0]));
        assert!(!meets(UNIT, [-1.0, 0.5, 0.5], [-1.0, 0.0, 0.0]));
    }

    #[test]
    fn a_ray_in_a_face_meets_the_box_for_both_zeros() {
        for zero in [0.0, -0.0] {
            assert!(meets(UNIT, [-1.0, 0.0, 0.5], [1.0, zero, zero]));
            assert!(meets(UNIT, [-1.0, 1.0, 1.0], [1.0, zero, zero]));
        }
    }

    #[test]
    fn half_the_surface_is_one_face_of_each_kind() {
        assert_eq!(Aabb { min: Vec3::X, max: Vec3::new(3.0, 3.0, 5.0) }.half_surface(), 6.0 + 15.0 + 10.0);
    }

    #[test]
    fn an_octant_has_a_bit_for_each_axis_that_is_run_down() {
        for octant in 0..8 {
            let down = |axis: usize| if octant >> axis & 1 == 1 { -1.0 } else { 1.0 };
            let ray = Ray::new(Vec3::ZERO, Vec3::new(down(0), down(1), down(2)));
            assert_eq!(BoxProbe::new(&ray, 1.0).octant(), octant);
        }
    }

    #[test]
    fn a_box_is_widened_by_the_slack_that_the_probe_tells() {
        let probe = BoxProbe::new(&Ray::new(Vec3::new(-4.0, 0.5, 0.5), Vec3::X), 1.0);
        assert!(probe.slack().x > 0.0 && probe.slack().x < 1e-5, "{}", probe.slack());
        let crossed = Interval { min: 4.0 - probe.slack().x, max: 5.0 + probe.slack().x };
        assert_eq!(probe.clip(UNIT, Interval::FORWARD), Some(crossed));
    }

    #[test]
    fn a_box_is_met_from_the_end_of_numbers() {
        const FAR: f32 = f32::MAX;
        let wide = Aabb { min: Vec3::new(-2.0, 0.0, 0.0), max: Vec3::new(3.0, 4.0, 0.0) };
        assert!(meets(wide, [0.0, 0.0, FAR], [0.0, 0.0, -1.4]));
        assert!(meets(wide, [0.0, 0.0, FAR], [0.0, 0.0, -FAR]));
        let around = Aabb { min: Vec3::splat(-0.1), max: Vec3::splat(0.1) };
        assert!(meets(around, [0.0, -FAR, 0.0], [0.0, FAR, 0.0]));
        assert!(meets(around, [FAR, 0.05, 0.0], [-FAR, -0.1, -0.2]));
    }

    #[test]
    fn a_flat_box_is_met() {
        let flat = Aabb { min: Vec3::ZERO, max: Vec3::new(1.0, 1.0, 0.0) };
        assert!(meets(flat, [0.5, 0.5, -1.0], [0.0, 0.0, 1.0]));
        assert!(meets(flat, [-0.5, 0.5, 0.0], [1.0, 0.0, 0.0]));
    }

    #[test]
    fn the_empty_box_has_no_magnitude_and_is_the_neutral_union() {
        assert_eq!(Aabb::EMPTY.magnitude(), 0.0);
        assert_eq!(Aabb::EMPTY.union(UNIT), UNIT);
    }
}
