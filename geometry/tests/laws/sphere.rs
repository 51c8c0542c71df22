use geometry::{
    Interval, Primitive, Ray, Sphere,
    conformance::{Aimed, spheres, times},
};
use glam::Vec3;
use proptest::prelude::*;

use crate::exact::{Exact, Quadratic, SINGLE, ULPS, Vector, approximate, exact, truths};

/// `|o + t d - c|^2 - r^2`.
pub(crate) fn equation(sphere: &Sphere, ray: &Ray) -> Quadratic {
    let from_center = Vector::from(ray.origin).minus(&sphere.center.into());
    let direction = Vector::from(ray.direction);
    Quadratic {
        a: direction.dot(&direction),
        half_b: from_center.dot(&direction),
        c: from_center.dot(&from_center) - exact(sphere.radius) * exact(sphere.radius),
    }
}

/// The line's distance from the centre, squared, less the radius squared; and the scale of its errors.
pub(crate) fn clearance(sphere: &Sphere, ray: &Ray) -> (f64, f64) {
    let equation = equation(sphere, ray);
    let radius = f64::from(sphere.radius);
    let distance = (ray.origin.as_dvec3() - sphere.center.as_dvec3()).length();
    (-approximate(&equation.discriminant()) / approximate(&equation.a), radius * (distance + radius))
}

fn t_is_exact(Aimed { shape, ray }: &Aimed<Sphere>) -> Result<(), TestCaseError> {
    let equation = equation(shape, ray);
    if let (Some(hit), Some(root)) = (shape.intersect(ray, Interval::FORWARD), equation.first_ahead()) {
        prop_assert!(equation.root_is_within(root, &truths(hit.t, ULPS, 0.0)), "t = {}", hit.t);
    }
    Ok(())
}

proptest! {
    #![proptest_config(times(16))]

    /// Where half an ulp of the inputs could not make hit and miss of each other: within 4 u of tangency, the square root
    /// doubles the digits that are lost.
    #[test]
    fn t_is_the_nearest_root_ahead_to_half_an_ulp(aimed in spheres()) {
        let (clearance, scale) = clearance(&aimed.shape, &aimed.ray);
        prop_assume!(clearance.abs() > 8.0 * SINGLE * scale);
        t_is_exact(&aimed)?;
    }

    /// More nearly tangential, `t` is as exact as `f64` sees: a rounding of the depth, divided by the depth's root.
    #[test]
    fn t_is_as_exact_as_f64_sees_near_a_tangent(aimed in spheres()) {
        let Aimed { shape, ray } = aimed;
        let (clearance, scale) = clearance(&shape, &ray);
        let error = f64::exp2(-49.0) * scale;
        prop_assume!(clearance < -error);
        let equation = equation(&shape, &ray);
        if let (Some(hit), Some(root)) = (shape.intersect(&ray, Interval::FORWARD), equation.first_ahead()) {
            let error = error / (-clearance).sqrt() / ray.direction.as_dvec3().length();
            prop_assert!(equation.root_is_within(root, &truths(hit.t, ULPS, error)), "t = {}", hit.t);
        }
    }

    /// Stronger than NUMERICS' `(4 + 32 u (D/r)^2) u (D + r)`: the inputs are taken as exact, and `f64` sees 2^29 times finer.
    #[test]
    fn hit_and_miss_are_right_unless_the_line_touches_as_closely_as_f64_sees(aimed in spheres()) {
        let (clearance, scale) = clearance(&aimed.shape, &aimed.ray);
        prop_assume!(clearance.abs() > f64::exp2(-49.0) * scale);
        let is_hit = aimed.shape.intersect(&aimed.ray, Interval::FORWARD).is_some();
        prop_assert_eq!(is_hit, equation(&aimed.shape, &aimed.ray).first_ahead().is_some());
    }

    /// Whichever root it is, the one after it is found from there on, if it rounds to another `t`.
    #[test]
    fn the_far_side_is_met_beyond_the_near_one(aimed in spheres()) {
        let (clearance, scale) = clearance(&aimed.shape, &aimed.ray);
        prop_assume!(clearance < -8.0 * SINGLE * scale);
        let equation = equation(&aimed.shape, &aimed.ray);
        prop_assume!(equation.first_ahead() == Some(0));
        let near = aimed.shape.intersect(&aimed.ray, Interval::FORWARD).expect("not ambiguous");
        match aimed.shape.intersect(&aimed.ray, Interval { min: near.t, max: f32::INFINITY }) {
            Some(far) => prop_assert!(equation.root_is_within(1, &truths(far.t, ULPS, 0.0)), "t = {}", far.t),
            None => prop_assert!(equation.root_is_within(1, &truths(near.t, ULPS, 0.0))),
        }
    }

    #[test]
    fn texture_coordinates_lie_in_the_texture(aimed in spheres()) {
        if let Some(hit) = aimed.shape.intersect(&aimed.ray, Interval::FORWARD) {
            let uv = aimed.shape.uv(&aimed.ray, &hit);
            prop_assert!((0.0..1.0).contains(&uv.x) && (0.0..=1.0).contains(&uv.y), "{}", uv);
        }
    }

    /// The bound of NUMERICS for a point on the ray; ours is on the sphere itself.
    #[test]
    fn a_hit_point_is_on_the_sphere_to_a_rounding(aimed in spheres()) {
        let Aimed { shape, ray } = aimed;
        let Some(hit) = shape.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        let surface = shape.surface(&ray, &hit);
        let from_center = Vector::from(surface.position).minus(&shape.center.into());
        let bound = exact(2.0 * SINGLE * f64::from(shape.center.length() + shape.radius));
        let radius = exact(shape.radius);
        let squared = from_center.dot(&from_center);
        let inner = (&radius - &bound).max(Exact::ZERO);
        let outer = radius + bound;
        prop_assert!(&inner * &inner <= squared && squared <= &outer * &outer);
    }
}

/// The origin is 2^-24 of a radius outside: in plain `f64` the sphere's power keeps too few digits there.
#[test]
fn t_is_exact_from_just_off_the_surface() {
    let shape = Sphere { center: Vec3::ZERO, radius: 3290.0442 };
    let origin = Vec3::new(382.2006, -1819.9376, 2714.0635);
    let ray = Ray::new(origin, Vec3::new(0.5468313, -0.65495914, -0.52154005));
    t_is_exact(&Aimed { shape, ray }).unwrap();
}
