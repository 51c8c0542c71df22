//! Many rays against one sphere: what each alone would find.

use geometry::{
    Interval, Primitive, Ray, Sphere,
    conformance::{Aimed, spheres, times},
    meet_sphere_lanes,
};
use glam::Vec3;
use proptest::prelude::*;

/// What a bundle of rays finds, each ray at its place; `None` where it is left to the sphere itself.
fn together<const N: usize>(sphere: &Sphere, rays: &[Ray; N], within: Interval) -> [Option<Option<f32>>; N] {
    let rows = |component: fn(&Ray) -> Vec3| {
        [0, 1, 2].map(|axis| std::array::from_fn::<f32, N, _>(|lane| component(&rays[lane])[axis]))
    };
    let (origins, directions) = (rows(|ray| ray.origin), rows(|ray| ray.direction));
    let met = meet_sphere_lanes(sphere, origins.each_ref(), directions.each_ref(), within);
    std::array::from_fn(|lane| (met.is_in_doubt[lane] == 0).then(|| Some(met.t[lane]).filter(|t| !t.is_nan())))
}

/// A ray, the same backwards, one that leaves where it hits, and one of another length.
fn bundle(sphere: &Sphere, ray: &Ray) -> [Ray; 4] {
    let left = sphere.intersect(ray, Interval::FORWARD).map(|hit| sphere.surface(ray, &hit).leave(-ray.direction));
    let backwards = Ray::new(ray.origin, -ray.direction);
    [*ray, backwards, left.unwrap_or(backwards), Ray::new(ray.origin, 0.3 * ray.direction)]
}

#[test]
fn rays_that_start_off_the_surface_are_not_left_to_the_sphere_itself() {
    let sphere = Sphere { center: Vec3::new(1.0, 2.0, 3.0), radius: 0.5 };
    let ray = Ray::new(Vec3::new(1.1, 1.9, 8.0), -Vec3::Z);
    let found = together(&sphere, &bundle(&sphere, &ray), Interval::FORWARD);
    // The one that leaves the surface neither.
    assert!(found.iter().all(Option::is_some) && found[0] != Some(None) && found[2] == Some(None), "{found:?}");
}

/// The power of a point 2^-24 off the surface has too few digits in plain `f64`, on the way in.
#[test]
fn rays_that_start_just_off_the_surface_are_left_to_the_sphere_itself() {
    let sphere = Sphere { center: Vec3::ZERO, radius: 1.0 };
    let ray = Ray::new(Vec3::new(0.0, 0.0, 1.0_f32.next_up()), -Vec3::Z);
    let found = together(&sphere, &[ray; 4], Interval::FORWARD);
    assert_eq!(found, [None; 4]);
}

#[test]
fn the_ends_of_an_interval_lie_outside() {
    let sphere = Sphere { center: Vec3::ZERO, radius: 1.0 };
    let rays = [Ray::new(Vec3::new(0.0, 0.0, -3.0), Vec3::Z); 4];
    for (min, max, met) in [(0.0, 2.0, None), (2.0, 4.0, None), (2.0, 5.0, Some(4.0)), (0.0, 3.0, Some(2.0))] {
        assert_eq!(together(&sphere, &rays, Interval { min, max }), [Some(met); 4], "{min} to {max}");
    }
}

proptest! {
    #![proptest_config(times(16))]

    #[test]
    fn rays_met_together_meet_what_each_meets(
        Aimed { shape, ray } in spheres(),
        max in prop_oneof![Just(f32::INFINITY), Just(1.0), 0.0_f32..10.0],
    ) {
        let within = Interval { min: 0.0, max };
        let rays = bundle(&shape, &ray);
        for (found, ray) in together(&shape, &rays, within).into_iter().zip(&rays) {
            if let Some(found) = found {
                prop_assert_eq!(found, shape.intersect(ray, within).map(|hit| hit.t), "{:?} {:?}", shape, ray);
            }
        }
    }
}
