//! Texture coordinates, held against the exact point's.

use geometry::{
    Ellipsoid, Interval, PLANE_TEXTURE_SIZE, Primitive, Ray, Sphere,
    conformance::{Aimed, PlaneGiven, ellipsoids, planes, spheres, times},
};
use glam::{DVec3, Vec2, Vec3};
use proptest::prelude::*;

use crate::exact::{DOUBLE, Exact, Quadratic, Real, SINGLE, Vector, apart_on_circle, exact, pi, real};
use crate::{ellipsoid, plane, sphere};

/// Half a unit in the last place of the `f32` below 1: what rounding a coordinate costs. NUMERICS asks for 1.2e-7.
const ROUNDING: f64 = 0.51 * SINGLE;

/// The first root ahead. (Its `t` alone does not say which root was met: from far off, two may round to one.)
fn first_root(equation: &Quadratic) -> Option<Real> {
    let reach = real(&equation.discriminant()).sqrt();
    let reach = if equation.first_ahead()? == 0 { -reach } else { reach };
    Some((reach - real(&equation.half_b)) / real(&equation.a))
}

/// `u` and `v` of the point `origin + t direction`, seen from the sphere's centre: u around z from +x over +y, v from +z down.
fn sphere_uv(origin: &Vector, direction: &Vector, t: &Real) -> [Real; 2] {
    let [x, y, z] = [0, 1, 2].map(|axis| real(&origin.0[axis]) + t * real(&direction.0[axis]));
    let angle = |y: &Real, x: &Real| if *y == Real::ZERO && *x == Real::ZERO { Real::ZERO } else { y.atan2(x) };
    let width = (&x * &x + &y * &y).sqrt();
    [angle(&y, &x) / (pi() + pi()), angle(&width, &z) / pi()]
}

/// The coordinates are the exact ones rounded, and what the point is off, in radii: around the axis the more, the nearer to it.
fn are_those(uv: Vec2, [u, v]: &[Real; 2], off: f64) -> Result<(), TestCaseError> {
    let nearest_pole = f64::sin(std::f64::consts::PI * v.to_f64().value());
    let around = apart_on_circle(uv.x, u);
    prop_assert!(around <= ROUNDING + off / nearest_pole, "u = {} is off by {}", uv.x, around);
    let along = (real(&exact(uv.y)) - v).to_f64().value().abs();
    prop_assert!(along <= ROUNDING + off, "v = {} is off by {}", uv.y, along);
    Ok(())
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
        are_those(shape.uv(&ray, &hit), &uv, off)?;
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
        are_those(shape.uv(&ray, &hit), &uv, error * (1.0 + 1.0 / depth.sqrt()))?;
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
    let reach = t_error * ray.direction.as_dvec3().length() + length(&offset) + 2.0 * length(&step);
    let uv = shape.uv(&ray, &hit);
    for (gradient, coordinate) in gradients(&given).into_iter().zip(uv.to_array()) {
        let sum = |v: &Vector| {
            let [x, y, z] = [0, 1, 2].map(|axis| &gradient[axis] * real(&v.0[axis]));
            x + y + z
        };
        let steepness = DVec3::from(gradient.each_ref().map(|x| x.to_f64().value())).length();
        let error = 16.0 * DOUBLE * reach * steepness * shear(&given);
        let off = apart_on_circle(coordinate, &sum(&offset));
        prop_assert!(off <= ROUNDING + error, "{} is off by {}", coordinate, off);
    }
    Ok(())
}

/// What `u` and `v` grow by along each axis.
fn gradients(plane: &PlaneGiven) -> [[Real; 3]; 2] {
    match *plane {
        PlaneGiven::ByNormal { normal, .. } => {
            let n = Vector::from(normal);
            let is_floor = normal.y.abs() > normal.x.abs().max(normal.z.abs());
            let up = if is_floor { -DVec3::Z * f64::from(normal.y.signum()) } else { DVec3::Y };
            // v = up less its part along n, u = v x n; both of length 1, over the texture's size.
            let squared = n.dot(&n);
            let share = n.dot(&up.into()) / squared;
            let v = Vector::from(up).minus(&Vector(n.0.clone().map(|x| x * &share)));
            let size = |v: &Vector| real(&v.dot(v)).sqrt() * real(&exact(PLANE_TEXTURE_SIZE));
            [v.cross(&n), v].map(|v| v.0.each_ref().map(|x| real(x) / size(&v)))
        }
        PlaneGiven::ByPoints { point, along_u, along_v } => {
            let [u, v] = [along_u, along_v].map(|end| Vector::from(end).minus(&point.into()));
            let cross = u.cross(&v);
            let squared = real(&cross.dot(&cross));
            [v.cross(&cross), cross.cross(&u)].map(|v| v.0.map(|x| real(&x) / &squared))
        }
    }
}

/// How much the edges of a plane by three points cancel in its normal: one over the sine between them.
fn shear(plane: &PlaneGiven) -> f64 {
    match *plane {
        PlaneGiven::ByNormal { .. } => 1.0,
        PlaneGiven::ByPoints { point, along_u, along_v } => {
            let [u, v] = [along_u, along_v].map(|end| end.as_dvec3() - point.as_dvec3());
            u.length() * v.length() / u.cross(v).length()
        }
    }
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
