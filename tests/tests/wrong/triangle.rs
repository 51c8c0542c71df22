use geometry::conformance::triangle::{LAWS, Part};
use geometry::{Intersection, Interval, Ray, Triangle, naive};

use crate::Kit;

#[test]
fn every_mistake_about_a_triangle_is_named() {
    Kit { page: "geometry/src/conformance/triangle.rs", laws: LAWS }.catches([
        ("nothing is returned", (|_, _, _| None) as Part, "a_triangle_straight_ahead_is_met"),
        (
            "t is the distance to the plane",
            |triangle, ray, within| {
                let normal = triangle.scaled_normal().normalize();
                let met = meet(triangle, ray).filter(inside)?;
                counted(Met { t: met.t * normal.dot(ray.direction.as_dvec3()).abs(), ..met }, within)
            },
            "a_triangle_straight_ahead_is_met",
        ),
        (
            "u + v is not looked at",
            |triangle, ray, within| {
                let met = meet(triangle, ray)?;
                counted(met, within).filter(|_| (0.0..=1.0).contains(&met.u) && (0.0..=1.0).contains(&met.v))
            },
            "a_ray_beside_the_triangle_misses_it",
        ),
        (
            "one edge is not looked at",
            |triangle, ray, within| {
                let met = meet(triangle, ray)?;
                counted(met, within).filter(|_| met.u >= 0.0 && met.u + met.v <= 1.0)
            },
            "a_ray_beside_the_triangle_misses_it",
        ),
        (
            "culled from behind",
            |triangle, ray, within| {
                let met = meet(triangle, ray).filter(inside)?;
                counted(met, within).filter(|_| met.determinant > 0.0)
            },
            "a_triangle_is_met_from_behind",
        ),
        (
            "the absolute value of t",
            |triangle, ray, within| {
                let met = meet(triangle, ray).filter(inside)?;
                counted(Met { t: met.t.abs(), ..met }, within)
            },
            "a_triangle_behind_the_ray_is_not_met",
        ),
        (
            "the direction is normalised",
            |triangle, ray, within| {
                let met = meet(triangle, ray).filter(inside)?;
                counted(Met { t: met.t * ray.direction.as_dvec3().length(), ..met }, within)
            },
            "t_counts_multiples_of_the_direction",
        ),
        (
            "the interval is not checked",
            |triangle, ray, _| counted(meet(triangle, ray).filter(inside)?, Interval::FORWARD),
            "a_hit_outside_the_interval_does_not_count",
        ),
        (
            "u and v are swapped",
            |triangle, ray, within| {
                let met = counted(meet(triangle, ray).filter(inside)?, within)?;
                Some(Intersection { u: met.v, v: met.u, ..met })
            },
            "u_and_v_are_the_weights_of_the_second_and_third_corner",
        ),
        (
            "u and v are those of the first two corners",
            |triangle, ray, within| {
                let met = counted(meet(triangle, ray).filter(inside)?, within)?;
                Some(Intersection { u: 1.0 - met.u - met.v, v: met.u, ..met })
            },
            "u_and_v_are_the_weights_of_the_second_and_third_corner",
        ),
        (
            "edges do not belong to it",
            |triangle, ray, within| {
                let met = meet(triangle, ray)?;
                counted(met, within).filter(|_| met.u > 0.0 && met.v > 0.0 && met.u + met.v < 1.0)
            },
            "edges_and_corners_belong_to_the_triangle",
        ),
        ("Möller's and Trumbore's epsilon", naive::moeller_trumbore, "a_small_triangle_is_met"),
        (
            "a comparison that NaN passes",
            |triangle, ray, within| {
                let met = meet(triangle, ray)?;
                let beside = met.u < 0.0 || met.v < 0.0 || met.u + met.v > 1.0;
                let t = met.t as f32;
                let outside = t <= within.min || t >= within.max;
                (!beside && !outside).then_some(Intersection { t, u: met.u as f32, v: met.v as f32 })
            },
            "what_is_no_number_is_not_met",
        ),
        (
            "corners in a row have an area, by rounding",
            |triangle, ray, within| {
                let direction = ray.direction.as_dvec3();
                let [a, b, c] = triangle.corners.map(|corner| corner.as_dvec3() - ray.origin.as_dvec3());
                let weights = [(b, c), (c, a), (a, b)].map(|(from, to)| direction.dot(from.cross(to)));
                let sum: f64 = weights.iter().sum();
                let one_sign = weights.iter().all(|&w| w >= 0.0) || weights.iter().all(|&w| w <= 0.0);
                let [wa, wb, wc] = weights.map(|weight| weight / sum);
                let t = (a * wa + b * wb + c * wc).dot(direction) / direction.length_squared();
                counted(Met { t, u: wb, v: wc, determinant: sum }, within).filter(|_| one_sign && sum != 0.0)
            },
            "a_triangle_without_area_is_never_met",
        ),
        (
            "edges decided one by one, in f64",
            |triangle, ray, within| counted(meet(triangle, ray).filter(inside)?, within),
            "no_ray_leaves_a_closed_mesh_through_its_edges_or_corners",
        ),
        (
            "t of the weighted depths",
            |triangle, ray, within| {
                let met = geometry::Primitive::intersect(triangle, ray, Interval { min: f32::NEG_INFINITY, ..within })?;
                let along = triangle.point(met.u, met.v) - ray.origin.as_dvec3();
                let direction = ray.direction.as_dvec3();
                let t = (along.dot(direction) / direction.length_squared()) as f32;
                within.contains(t).then_some(Intersection { t, ..met })
            },
            "t_is_exact_to_half_an_ulp",
        ),
    ]);
}

#[derive(Clone, Copy)]
struct Met {
    t: f64,
    u: f64,
    v: f64,
    determinant: f64,
}

/// Möller's and Trumbore's formula, in `f64`, without their epsilon.
fn meet(triangle: &Triangle, ray: &Ray) -> Option<Met> {
    let [a, b, c] = triangle.corners.map(|corner| corner.as_dvec3());
    let direction = ray.direction.as_dvec3();
    let (edge1, edge2) = (b - a, c - a);
    let p = direction.cross(edge2);
    let determinant = edge1.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let from_corner = ray.origin.as_dvec3() - a;
    let q = from_corner.cross(edge1);
    let [u, v, t] = [from_corner.dot(p), direction.dot(q), edge2.dot(q)].map(|x| x / determinant);
    Some(Met { t, u, v, determinant })
}

fn inside(met: &Met) -> bool {
    met.u >= 0.0 && met.v >= 0.0 && met.u + met.v <= 1.0
}

fn counted(met: Met, within: Interval) -> Option<Intersection> {
    let t = met.t as f32;
    within.contains(t).then_some(Intersection { t, u: met.u as f32, v: met.v as f32 })
}
