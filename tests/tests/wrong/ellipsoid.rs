use geometry::conformance::ellipsoid::{LAWS, Part};
use geometry::{Ellipsoid, Intersection, Interval, Ray, naive};
use glam::DVec3;

use crate::Kit;

#[test]
fn every_mistake_about_an_ellipsoid_is_named() {
    Kit { page: "geometry/src/conformance/ellipsoid.rs", laws: LAWS }.catches([
        ("nothing is returned", (|_, _, _| None) as Part, "a_moved_sphere_is_met_where_it_is"),
        (
            "the translation moves the direction, too",
            |shape, ray, within| {
                let (origin, _) = seen(shape, ray);
                nearest(origin, shape.to_unit().point(ray.direction.as_dvec3()), within)
            },
            "a_moved_sphere_is_met_where_it_is",
        ),
        (
            "the map in place of its inverse",
            |shape, ray, within| {
                let map = shape.to_world();
                nearest(map.point(ray.origin.as_dvec3()), map.direction(ray.direction.as_dvec3()), within)
            },
            "a_moved_sphere_is_met_where_it_is",
        ),
        (
            "the direction is normalised in the sphere's space",
            |shape, ray, within| {
                let (origin, direction) = seen(shape, ray);
                nearest(origin, direction.normalize(), within)
            },
            "t_counts_multiples_of_the_direction",
        ),
        (
            "the transpose in place of the inverse",
            |shape, ray, within| {
                let map = shape.to_world();
                let inverse = map.linear.transpose();
                let origin = inverse * (ray.origin.as_dvec3() - map.translation);
                nearest(origin, inverse * ray.direction.as_dvec3(), within)
            },
            "a_stretched_ellipsoid_is_met_where_its_equation_says",
        ),
        (
            "the root of the discriminant's absolute value",
            |shape, ray, within| {
                let (origin, direction) = seen(shape, ray);
                let [a, half_b, c] = coefficients(origin, direction);
                let root = (half_b * half_b - a * c).abs().sqrt();
                [-half_b - root, -half_b + root].into_iter().find_map(|t| counted(t / a, within))
            },
            "a_ray_beside_the_ellipsoid_misses_it",
        ),
        (
            "the absolute value of t",
            |shape, ray, within| {
                let (origin, direction) = seen(shape, ray);
                roots(origin, direction).into_iter().find_map(|t| counted(t.abs(), within))
            },
            "an_ellipsoid_behind_the_ray_is_not_met",
        ),
        (
            "only the near side is looked at",
            |shape, ray, within| {
                let (origin, direction) = seen(shape, ray);
                counted(roots(origin, direction)[0], within)
            },
            "from_inside_the_far_side_is_met",
        ),
        (
            "the interval is not checked",
            |shape, ray, _| {
                let (origin, direction) = seen(shape, ray);
                nearest(origin, direction, Interval::FORWARD)
            },
            "a_hit_outside_the_interval_does_not_count",
        ),
        ("the inverse matrix folded, in f32", naive::single_precision_inverse, "a_far_translation_costs_nothing"),
        (
            "an epsilon for the discriminant",
            |shape, ray, within| {
                let (origin, direction) = seen(shape, ray);
                let [a, half_b, c] = coefficients(origin, direction);
                if half_b * half_b - a * c < 1e-6 { None } else { nearest(origin, direction, within) }
            },
            "hit_and_miss_are_right_unless_the_map_cannot_tell",
        ),
    ]);
}

/// The ray as the unit sphere sees it.
fn seen(shape: &Ellipsoid, ray: &Ray) -> (DVec3, DVec3) {
    let inverse = shape.to_unit().linear;
    (inverse * (ray.origin.as_dvec3() - shape.to_world().translation), inverse * ray.direction.as_dvec3())
}

fn nearest(origin: DVec3, direction: DVec3, within: Interval) -> Option<Intersection> {
    roots(origin, direction).into_iter().find_map(|t| counted(t, within))
}

fn roots(origin: DVec3, direction: DVec3) -> [f64; 2] {
    let [a, half_b, c] = coefficients(origin, direction);
    let root = (half_b * half_b - a * c).sqrt();
    [(-half_b - root) / a, (-half_b + root) / a]
}

fn coefficients(origin: DVec3, direction: DVec3) -> [f64; 3] {
    [direction.dot(direction), origin.dot(direction), origin.dot(origin) - 1.0]
}

fn counted(t: f64, within: Interval) -> Option<Intersection> {
    within.contains(t as f32).then(|| Intersection::at(t as f32))
}
