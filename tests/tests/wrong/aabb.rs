use geometry::conformance::aabb::{LAWS, Part};
use geometry::{Aabb, BoxProbe, Interval, Ray, naive};
use glam::Vec3;

use crate::Kit;

#[test]
fn every_mistake_about_a_box_is_named() {
    Kit { page: "geometry/src/conformance/aabb.rs", laws: LAWS }.catches([
        ("nothing is returned", (|_, _, _| None) as Part, "a_box_straight_ahead_is_passed_where_it_is"),
        (
            "near and far are not put in order",
            |bounds, ray, within| {
                let [a, b] = crossings(bounds, ray);
                overlap([a, b], within).filter(not_empty)
            },
            "a_box_straight_ahead_is_passed_where_it_is",
        ),
        (
            "one axis is forgotten",
            |bounds, ray, within| {
                let [near, far] = slabs(bounds, ray);
                let z = [f32::NEG_INFINITY, f32::INFINITY];
                overlap([near.with_z(z[0]), far.with_z(z[1])], within).filter(not_empty)
            },
            "a_box_straight_ahead_is_passed_where_it_is",
        ),
        (
            "the intervals are united, not cut",
            |bounds, ray, within| {
                let [near, far] = slabs(bounds, ray);
                Some(Interval { min: near.min_element().max(within.min), max: far.max_element().min(within.max) })
            },
            "a_box_straight_ahead_is_passed_where_it_is",
        ),
        (
            "a miss is returned as an empty part",
            |bounds, ray, within| overlap(slabs(bounds, ray), within),
            "a_ray_beside_the_box_misses_it",
        ),
        (
            "the box behind the origin counts",
            |bounds, ray, within| {
                overlap(slabs(bounds, ray), Interval { min: f32::NEG_INFINITY, ..within }).filter(not_empty)
            },
            "a_box_behind_the_ray_is_missed",
        ),
        (
            "an origin inside counts as a miss",
            |bounds, ray, within| {
                let [near, far] = slabs(bounds, ray);
                overlap([near, far], within).filter(|part| not_empty(part) && near.max_element() > within.min)
            },
            "from_inside_the_box_is_passed_from_the_start",
        ),
        (
            "the interval's end is not looked at",
            |bounds, ray, within| {
                overlap(slabs(bounds, ray), Interval { max: f32::INFINITY, ..within }).filter(not_empty)
            },
            "a_box_outside_the_interval_is_missed",
        ),
        ("flat boxes are lost", naive::slab_test, "a_flat_box_is_not_lost"),
        (
            "a direction of 0 along an axis is a miss",
            |bounds, ray, within| {
                let is_zero = ray.direction.cmpeq(Vec3::ZERO).any();
                overlap(slabs(bounds, ray), within).filter(|part| not_empty(part) && !is_zero)
            },
            "a_box_is_not_lost_by_a_ray_along_the_axes",
        ),
        (
            "a comparison that NaN fails",
            |bounds, ray, within| {
                let [a, b] = crossings(bounds, ray);
                let (mut min, mut max) = (within.min, within.max);
                for axis in 0..3 {
                    let (near, far) = if a[axis] < b[axis] { (a[axis], b[axis]) } else { (b[axis], a[axis]) };
                    if !(near <= max && far >= min) {
                        return None;
                    }
                    (min, max) = (min.max(near), max.min(far));
                }
                Some(Interval { min, max })
            },
            "a_box_is_not_lost_by_a_ray_along_the_axes",
        ),
        (
            "a clamp that panics",
            |bounds, ray, within| {
                let part = overlap(slabs(bounds, ray), within).filter(not_empty)?;
                Some(Interval { min: part.min.clamp(within.min, within.max), ..part })
            },
            "what_is_no_number_makes_no_panic",
        ),
        (
            "the slabs as written down, without slack",
            |bounds, ray, within| overlap(slabs(bounds, ray), within).filter(not_empty),
            "a_box_that_the_exact_ray_meets_is_never_missed",
        ),
        (
            "a slack of a hundred-thousandth",
            |bounds, ray, within| {
                let by = 1e-5 * (bounds.magnitude() + ray.origin.abs().max_element());
                let grown = Aabb { min: bounds.min - by, max: bounds.max + by };
                BoxProbe::new(ray, grown.magnitude()).clip(grown, within)
            },
            "a_box_that_the_exact_ray_clearly_passes_is_missed",
        ),
    ]);
}

/// Where the ray crosses the planes of the low faces, and of the high ones.
fn crossings(bounds: &Aabb, ray: &Ray) -> [Vec3; 2] {
    [bounds.min, bounds.max].map(|corner| (corner - ray.origin) / ray.direction)
}

/// The same in order; along an axis that the ray does not move on, everywhere or nowhere.
fn slabs(bounds: &Aabb, ray: &Ray) -> [Vec3; 2] {
    let [mut near, mut far] = crossings(bounds, ray);
    for axis in 0..3 {
        let inside = bounds.min[axis] <= ray.origin[axis] && ray.origin[axis] <= bounds.max[axis];
        (near[axis], far[axis]) = match ray.direction[axis] {
            0.0 if inside => (f32::NEG_INFINITY, f32::INFINITY),
            0.0 => (f32::INFINITY, f32::NEG_INFINITY),
            _ => (near[axis].min(far[axis]), near[axis].max(far[axis])),
        };
    }
    [near, far]
}

/// A NaN cuts nothing off.
fn overlap([near, far]: [Vec3; 2], within: Interval) -> Option<Interval> {
    let min = near.x.max(near.y).max(near.z).max(within.min);
    let max = far.x.min(far.y).min(far.z).min(within.max);
    Some(Interval { min, max })
}

fn not_empty(part: &Interval) -> bool {
    part.min <= part.max
}
