//! NaN and infinity in every input: a defined answer, and no panic.

use geometry::{
    Aabb, BoxProbe, Ellipsoid, Interval, Plane, Primitive, Ray, Sphere, Triangle,
    conformance::{times, wild_intervals, wild_maps, wild_numbers, wild_rays, wild_vectors},
};

use proptest::prelude::*;

/// A hit of undefined input: none if anything is NaN; else within the interval, and finite.
fn check(primitive: &dyn Primitive, has_nan: bool, ray: &Ray, within: Interval) -> Result<(), TestCaseError> {
    let _ = primitive.bounds();
    let hit = primitive.intersect(ray, within);
    if has_nan || ray.origin.is_nan() || ray.direction.is_nan() || within.min.is_nan() || within.max.is_nan() {
        prop_assert_eq!(hit, None);
    }
    if let Some(hit) = hit {
        prop_assert!(within.contains(hit.t));
        let _ = primitive.surface(ray, &hit).leave(ray.direction);
        let _ = primitive.surface(ray, &hit).leave_towards(ray.origin);
        let _ = primitive.uv(ray, &hit);
    }
    Ok(())
}

proptest! {
    #![proptest_config(times(32))]

    #[test]
    fn a_sphere(center in wild_vectors(), radius in wild_numbers(), ray in wild_rays(), within in wild_intervals()) {
        check(&Sphere { center, radius }, center.is_nan() || radius.is_nan(), &ray, within)?;
    }

    #[test]
    fn a_triangle(
        a in wild_vectors(), b in wild_vectors(), c in wild_vectors(), ray in wild_rays(), within in wild_intervals(),
    ) {
        let corners = [a, b, c];
        check(&Triangle { corners }, corners.iter().any(|corner| corner.is_nan()), &ray, within)?;
    }

    #[test]
    fn a_plane(
        a in wild_vectors(), b in wild_vectors(), c in wild_vectors(), ray in wild_rays(), within in wild_intervals(),
    ) {
        if let Some(plane) = Plane::from_normal(a, b) {
            check(&plane, a.is_nan() || b.is_nan(), &ray, within)?;
        }
        if let Some(plane) = Plane::from_points(a, b, c) {
            check(&plane, a.is_nan() || b.is_nan() || c.is_nan(), &ray, within)?;
        }
    }

    #[test]
    fn an_ellipsoid(
        map in wild_maps(), ray in wild_rays(), within in wild_intervals(),
    ) {
        if let Some(ellipsoid) = Ellipsoid::new(map) {
            check(&ellipsoid, false, &ray, within)?;
        }
    }

    #[test]
    fn a_box(min in wild_vectors(), max in wild_vectors(), ray in wild_rays(), within in wild_intervals()) {
        let bounds = Aabb { min, max };
        let probe = BoxProbe::new(&ray, bounds.magnitude());
        let _ = (probe.clip(bounds, within), probe.octant(), bounds.center(), bounds.extent());
    }
}
