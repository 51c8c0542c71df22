//! A sphere that was once got wrong.

use geometry::{
    Interval, Primitive, Ray, Sphere,
    conformance::{
        exact::{ULPS, truths},
        sphere::equation,
    },
};
use glam::Vec3;

/// The origin is 2^-24 of a radius outside: in plain `f64` the sphere's power keeps too few digits there.
#[test]
fn t_is_exact_from_just_off_the_surface() {
    let shape = Sphere { center: Vec3::ZERO, radius: 3290.0442 };
    let origin = Vec3::new(382.2006, -1819.9376, 2714.0635);
    let ray = Ray::new(origin, Vec3::new(0.5468313, -0.65495914, -0.52154005));
    let equation = equation(&shape, &ray);
    let hit = shape.intersect(&ray, Interval::FORWARD).unwrap();
    assert!(equation.root_is_within(equation.first_ahead().unwrap(), &truths(hit.t, ULPS, 0.0)), "{hit:?}");
}
