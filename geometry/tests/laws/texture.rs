//! Texture coordinates, held against the exact point's.

use geometry::{
    Ellipsoid, Interval, Primitive, Ray, Sphere,
    conformance::{
        Aimed, PlaneGiven, Verdict, ellipsoid, ellipsoids,
        exact::{DOUBLE, Exact, Quadratic, Real, Vector, exact, real},
        plane,
        plane_uv::are_exact,
        planes, sphere,
        sphere_uv::{are_those, real_sphere_uv},
        spheres, times,
    },
};
use glam::Vec3;
use proptest::prelude::*;

/// The first root ahead. (Its `t` alone does not say which root was met: from far off, two may round to one.)
fn first_root(equation: &Quadratic) -> Option<Real> {
    let reach = real(&equation.discriminant()).sqrt();
    let reach = if equation.first_ahead()? == 0 { -reach } else { reach };
    Some((reach - real(&equation.half_b)) / real(&equation.a))
}

/// `u` and `v` of the point `origin + t direction`, seen from the sphere's centre.
fn sphere_uv(origin: &Vector, direction: &Vector, t: &Real) -> [Real; 2] {
    real_sphere_uv([0, 1, 2].map(|axis| real(&origin.0[axis]) + t * real(&direction.0[axis])))
}

/// The kit's verdict as a test's.
fn holds(verdict: Verdict) -> Result<(), TestCaseError> {
    verdict.map_err(|broken| TestCaseError::fail(format!("{} expected, {} found", broken.expected, broken.found)))
}

proptest! {
    #![proptest_config(times(4))]

    #[test]
    fn a_spheres_are_those_of_the_exact_point_to_a_rounding(aimed in spheres()) {
        let Aimed { shape, ray } = aimed;
        let (clearance, scale) = sphere::clearance(&shape, &ray);
        let error = f64::exp2(-49.0) * scale;
        prop_assume!(clearance < -error);
        let Some(hit) = shape.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        let Some(t) = first_root(&sphere::equation(&shape, &ray)) else { return Ok(()) };
        let uv = sphere_uv(&Vector::from(ray.origin).minus(&shape.center.into()), &ray.direction.into(), &t);
        let radius = f64::from(shape.radius);
        let distance = (ray.origin.as_dvec3() - shape.center.as_dvec3()).length();
        let off = error / (-clearance).sqrt() / radius + 8.0 * DOUBLE * (distance / radius + 1.0);
        holds(are_those(shape.uv(&ray, &hit), &uv, off))?;
    }

    #[test]
    fn an_ellipsoids_are_those_of_the_exact_point_to_a_rounding_of_the_map(aimed in ellipsoids()) {
        let Aimed { shape: map, ray } = aimed;
        let shape = Ellipsoid::new(map).expect("maps of full rank");
        let equation = ellipsoid::equation(&map, &ray);
        let error = 4.0 * ellipsoid::line_error(&map, &ray);
        let depth = ellipsoid::depth(&equation, &map);
        prop_assume!(depth > error);
        let Some(hit) = shape.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        let (from_center, determinant) =
            ellipsoid::to_unit(&map, &Vector::from(ray.origin).minus(&map.translation.into()));
        let (direction, _) = ellipsoid::to_unit(&map, &ray.direction.into());
        // Times the determinant, which turns the vectors around where the map mirrors.
        let sign = exact(if determinant < Exact::ZERO { -1.0 } else { 1.0 });
        let [from_center, direction] = [from_center, direction].map(|v| Vector(v.0.map(|x| x * &sign)));
        let Some(t) = first_root(&equation) else { return Ok(()) };
        let uv = sphere_uv(&from_center, &direction, &t);
        holds(are_those(shape.uv(&ray, &hit), &uv, error * (1.0 + 1.0 / depth.sqrt())))?;
    }

    /// However far out: the whole part is taken off before narrowing.
    #[test]
    fn a_planes_are_those_of_the_exact_point_to_a_rounding(aimed in planes()) {
        plane_coordinates_are_exact(&aimed)?;
    }
}

fn plane_coordinates_are_exact(aimed: &Aimed<PlaneGiven>) -> Result<(), TestCaseError> {
    let Aimed { shape: given, ray } = *aimed;
    let (point, normal) = plane::point_and_normal(&given);
    let Some(shape) = given.plane() else { return Ok(()) };
    let Some(hit) = shape.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
    let Some((t, t_error)) = plane::exact_t(&point, &normal, &ray) else { return Ok(()) };
    let step = Vector(Vector::from(ray.direction).0.map(|x| x * &t));
    let offset = Vector::from(ray.origin).plus(&step).minus(&point);
    let length = |v: &Vector| v.approximate().length();
    let reach = t_error * ray.direction.as_dvec3().length() + 2.0 * length(&step);
    holds(are_exact(shape.uv(&ray, &hit), &given, &offset, reach))
}

/// The seam: just before it, a coordinate must not become 1.
#[test]
fn a_coordinate_that_would_round_to_1_is_0() {
    let shape = Sphere { center: Vec3::ZERO, radius: 1.0 };
    let ray = Ray::new(Vec3::new(2.0, -1e-9, 0.0), -Vec3::X);
    let hit = shape.intersect(&ray, Interval::FORWARD).unwrap();
    assert_eq!(shape.uv(&ray, &hit).x, 0.0);
}

/// 4e5 from the origin of space, an edge of 0.04: `f64` has 2^-35 of it left there, and the ray's own offset has all.
#[test]
fn a_small_texture_far_off_keeps_its_digits() {
    let point = Vec3::new(-126376.984, 171865.48, -373613.1);
    let along_u = Vec3::new(-126369.24, 171642.13, -374012.6);
    let shape = PlaneGiven::ByPoints { point, along_u, along_v: Vec3::new(-126376.98, 171865.48, -373613.06) };
    let ray = Ray::new(Vec3::new(-126376.67, 171865.66, -373613.1), Vec3::new(-16.909813, -10.072831, 0.35563028));
    plane_coordinates_are_exact(&Aimed { shape, ray }).unwrap();
}
