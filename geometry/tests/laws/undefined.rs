//! NaN and infinity in every input: a defined answer, and no panic.

use geometry::{
    Aabb, BoxProbe, Ellipsoid, Interval, Plane, Primitive, Ray, Sphere, Transform, Triangle,
    conformance::{times, wild_numbers, wild_vectors},
};
use glam::{DMat3, Vec3};
use proptest::prelude::*;

fn wild_rays() -> impl Strategy<Value = Ray> {
    (wild_vectors(), wild_vectors()).prop_map(|(origin, direction)| Ray::new(origin, direction))
}

fn wild_intervals() -> impl Strategy<Value = Interval> {
    let wild = (wild_numbers(), wild_numbers()).prop_map(|(min, max)| Interval { min, max });
    prop_oneof![Just(Interval::FORWARD), wild]
}

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
        columns in prop::array::uniform3(wild_vectors()), translation in wild_vectors(),
        ray in wild_rays(), within in wild_intervals(),
    ) {
        let [x, y, z] = columns.map(Vec3::as_dvec3);
        let map = Transform { linear: DMat3::from_cols(x, y, z), translation: translation.as_dvec3() };
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
