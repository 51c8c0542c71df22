use geometry::conformance::plane::{LAWS, Part};
use geometry::{Intersection, Interval, Plane, Ray, naive};

use crate::Kit;

#[test]
fn every_mistake_about_a_plane_is_named() {
    Kit { page: "geometry/src/conformance/plane.rs", laws: LAWS }.catches([
        ("nothing is returned", (|_, _, _| None) as Part, "a_plane_straight_ahead_is_met"),
        ("the numerator's sign", |plane, ray, within| counted(-t(plane, ray), within), "a_plane_straight_ahead_is_met"),
        (
            "the plane goes through the origin of space",
            |plane, ray, within| {
                let [origin, direction] = [ray.origin, ray.direction].map(|v| plane.normal().dot(v.as_dvec3()));
                counted(-origin / direction, within)
            },
            "a_plane_straight_ahead_is_met",
        ),
        (
            "culled from behind",
            |plane, ray, within| {
                counted(t(plane, ray), within).filter(|_| plane.normal().dot(ray.direction.as_dvec3()) < 0.0)
            },
            "a_plane_is_met_from_behind",
        ),
        (
            "the absolute value of t",
            |plane, ray, within| counted(t(plane, ray).abs(), within),
            "a_plane_behind_the_ray_is_not_met",
        ),
        (
            "t is the distance",
            |plane, ray, within| counted(t(plane, ray) * ray.direction.as_dvec3().length(), within),
            "t_counts_multiples_of_the_direction",
        ),
        (
            "a ray in the plane is met at once",
            |plane, ray, within| {
                let t = t(plane, ray);
                counted(if t.is_nan() { f64::from(f32::MIN_POSITIVE) } else { t }, within)
            },
            "a_parallel_ray_misses_it",
        ),
        (
            "the interval is not checked",
            |plane, ray, _| counted(t(plane, ray), Interval::FORWARD),
            "a_hit_outside_the_interval_does_not_count",
        ),
        (
            "texture coordinates in u and v",
            |plane, ray, within| Some(Intersection { u: 0.25, v: 0.5, ..counted(t(plane, ray), within)? }),
            "nothing_but_t_is_told",
        ),
        (
            "a comparison that NaN passes",
            |plane, ray, within| {
                let t = t(plane, ray) as f32;
                let outside = t <= within.min || t >= within.max;
                // Parallel rays are left out beforehand.
                let parallel = plane.normal().dot(ray.direction.as_dvec3()) == 0.0;
                (!parallel && !outside).then(|| Intersection::at(t))
            },
            "what_is_no_number_is_not_met",
        ),
        ("an epsilon for parallel rays", naive::rejecting_near_parallel, "a_plane_is_met_near_the_horizon"),
        (
            "all in f32",
            |plane, ray, within| {
                let normal = plane.normal().as_vec3();
                let t = normal.dot(plane.point() - ray.origin) / normal.dot(ray.direction);
                within.contains(t).then(|| Intersection::at(t))
            },
            "t_is_exact_to_half_an_ulp",
        ),
    ]);
}

fn t(plane: &Plane, ray: &Ray) -> f64 {
    let offset = plane.point().as_dvec3() - ray.origin.as_dvec3();
    plane.normal().dot(offset) / plane.normal().dot(ray.direction.as_dvec3())
}

fn counted(t: f64, within: Interval) -> Option<Intersection> {
    within.contains(t as f32).then(|| Intersection::at(t as f32))
}
