use geometry::conformance::sphere::{LAWS, Part};
use geometry::{Intersection, Interval, Ray, Sphere, naive};

use crate::Kit;

#[test]
fn every_mistake_about_a_sphere_is_named() {
    Kit { page: "geometry/src/conformance/sphere.rs", laws: LAWS }.catches([
        ("nothing is returned", (|_, _, _| None) as Part, "a_sphere_straight_ahead_is_met"),
        (
            "only the far side is looked at",
            |sphere, ray, within| roots(sphere, ray).into_iter().skip(1).find_map(|t| counted(t, within)),
            "a_sphere_straight_ahead_is_met",
        ),
        (
            "the direction is taken for a unit vector",
            |sphere, ray, within| {
                let [_, half_b, c] = coefficients(sphere, ray);
                let root = (half_b * half_b - c).sqrt();
                [-half_b - root, -half_b + root].into_iter().find_map(|t| counted(t, within))
            },
            "t_counts_multiples_of_the_direction",
        ),
        (
            "the root of the discriminant's absolute value",
            |sphere, ray, within| {
                let [a, half_b, c] = coefficients(sphere, ray);
                let root = (half_b * half_b - a * c).abs().sqrt();
                [-half_b - root, -half_b + root].into_iter().find_map(|t| counted(t / a, within))
            },
            "a_ray_beside_the_sphere_misses_it",
        ),
        (
            "the absolute value of t",
            |sphere, ray, within| roots(sphere, ray).into_iter().find_map(|t| counted(t.abs(), within)),
            "a_sphere_behind_the_ray_is_not_met",
        ),
        (
            "only the near side is looked at",
            |sphere, ray, within| roots(sphere, ray).into_iter().take(1).find_map(|t| counted(t, within)),
            "from_inside_the_far_side_is_met",
        ),
        (
            "the interval is not checked",
            |sphere, ray, _| roots(sphere, ray).into_iter().find(|&t| t > 0.0).map(|t| Intersection::at(t as f32)),
            "a_hit_outside_the_interval_does_not_count",
        ),
        (
            "the interval's ends count as inside",
            |sphere, ray, within| {
                let t = roots(sphere, ray).into_iter().map(|t| t as f32);
                let mut t = t.filter(|&t| within.min <= t && t <= within.max && t != 0.0);
                t.next().map(Intersection::at)
            },
            "a_hit_outside_the_interval_does_not_count",
        ),
        (
            "the far side only for a negative near one",
            |sphere, ray, within| {
                let [near, far] = roots(sphere, ray);
                counted(if near > 0.0 { near } else { far }, within)
            },
            "the_far_side_is_met_where_the_near_one_does_not_count",
        ),
        (
            "texture coordinates in u and v",
            |sphere, ray, within| {
                let met = roots(sphere, ray).into_iter().find_map(|t| counted(t, within))?;
                Some(Intersection { u: 0.25, v: 0.5, ..met })
            },
            "nothing_but_t_is_told",
        ),
        (
            "the interval is checked so that NaN passes",
            |sphere, ray, within| {
                let outside = |t: &f32| *t <= within.min || *t >= within.max;
                let [a, half_b, c] = coefficients(sphere, ray);
                let discriminant = half_b * half_b - a * c;
                if discriminant < 0.0 {
                    return None;
                }
                let root = discriminant.sqrt();
                let t = [-half_b - root, -half_b + root].map(|t| (t / a) as f32);
                t.into_iter().find(|t| !outside(t)).map(Intersection::at)
            },
            "what_is_no_number_is_not_met",
        ),
        ("the school's formula in f32", naive::quadratic_formula, "a_small_sphere_far_off_keeps_its_digits"),
        (
            "the school's formula in f64",
            |sphere, ray, within| roots(sphere, ray).into_iter().find_map(|t| counted(t, within)),
            "t_is_the_nearest_root_ahead_to_half_an_ulp",
        ),
        (
            "an epsilon at the interval's lower end",
            |sphere, ray, within| {
                let later = Interval { min: within.min + 1e-4, ..within };
                geometry::Primitive::intersect(sphere, ray, later)
            },
            "t_is_the_nearest_root_ahead_to_half_an_ulp",
        ),
    ]);
}

/// The school's formula.
fn roots(sphere: &Sphere, ray: &Ray) -> [f64; 2] {
    let [a, half_b, c] = coefficients(sphere, ray);
    let root = (half_b * half_b - a * c).sqrt();
    [(-half_b - root) / a, (-half_b + root) / a]
}

fn coefficients(sphere: &Sphere, ray: &Ray) -> [f64; 3] {
    let from_center = ray.origin.as_dvec3() - sphere.center.as_dvec3();
    let direction = ray.direction.as_dvec3();
    let radius = f64::from(sphere.radius);
    [direction.dot(direction), from_center.dot(direction), from_center.dot(from_center) - radius * radius]
}

fn counted(t: f64, within: Interval) -> Option<Intersection> {
    within.contains(t as f32).then(|| Intersection::at(t as f32))
}
