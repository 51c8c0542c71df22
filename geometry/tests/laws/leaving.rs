//! Surfaces, and the rays that leave them.

use geometry::{
    Ellipsoid, Interval, Primitive, Ray, Sphere, Surface, Transform, Triangle,
    conformance::{Aimed, ellipsoids, planes, spheres, times, triangles, unit_vector},
};
use glam::{DMat3, DVec3, Vec3};
use proptest::prelude::*;

use crate::exact::{Exact, SINGLE, Vector, exact};
use crate::{ellipsoid, plane, triangle};

/// A direction with a length.
fn directions() -> impl Strategy<Value = Vec3> {
    (unit_vector(), prop_oneof![Just(1.0), Just(1e-3), Just(1e3)]).prop_map(|(unit, length)| (unit * length).as_vec3())
}

/// Where to leave to: any direction, or one so many roundings off the tangent plane.
#[derive(Clone, Copy, Debug)]
struct Heading {
    direction: Vec3,
    roundings: Option<f64>,
}

fn headings() -> impl Strategy<Value = Heading> {
    let roundings = prop_oneof![3 => Just(None), 1 => (-8.0..8.0).prop_map(Some)];
    (directions(), roundings).prop_map(|(direction, roundings)| Heading { direction, roundings })
}

impl Heading {
    fn from(self, surface: &Surface) -> Vec3 {
        let Some(roundings) = self.roundings else { return self.direction };
        let (direction, normal) = (self.direction.as_dvec3(), surface.geometric_normal.as_dvec3());
        let along = direction - normal * normal.dot(direction);
        (along + normal * (roundings * SINGLE * along.length())).as_vec3()
    }
}

/// Whether the normal is a unit vector, and the box of the error holds a point of the surface: `side` is positive before the
/// surface, negative behind, continuous and convex, so that it is greatest at a corner. It is least at the deepest point, which
/// is a corner too if the surface is flat.
fn bounds_hold(
    surface: &Surface,
    deepest: Option<DVec3>,
    side: impl Fn(&Vector) -> Exact,
) -> Result<(), TestCaseError> {
    let normal = surface.geometric_normal.as_dvec3();
    prop_assert!((normal.length() - 1.0).abs() <= 2.0 * SINGLE, "{}", normal);
    prop_assert!(surface.error.min_element() >= 0.0);
    let signs = (0..8).map(|bits| DVec3::from([0, 1, 2].map(|axis| if bits >> axis & 1 == 0 { -1.0 } else { 1.0 })));
    let corners: Vec<Exact> = signs
        .map(|sign| side(&Vector::from(surface.position).plus(&(surface.error.as_dvec3() * sign).into())))
        .collect();
    let deepest = deepest.map(|point| side(&point.into()));
    prop_assert!(corners.iter().any(|side| *side >= Exact::ZERO), "the whole box is behind the surface");
    prop_assert!(
        corners.iter().chain(&deepest).any(|side| *side <= Exact::ZERO),
        "the whole box is before the surface"
    );
    Ok(())
}

/// The point of the error's box that is deepest in an ellipsoid, by minimising along one axis after the other.
fn deepest_point(surface: &Surface, to_unit: DMat3, center: DVec3) -> DVec3 {
    let position = surface.position.as_dvec3();
    let reach = surface.error.as_dvec3();
    let mut step = DVec3::ZERO;
    for axis in (0..3).cycle().take(192) {
        let column = to_unit.col(axis);
        let unit = to_unit * (position + step - center);
        step[axis] = (step[axis] - column.dot(unit) / column.length_squared()).clamp(-reach[axis], reach[axis]);
    }
    position + step
}

/// The cosine to the normal, if the direction is clearly on one side. A unit normal's three coordinates are each rounded by half
/// of `u` at most, together by 0.87 u: nearer to the tangent plane than that, the surface does not know its sides.
fn cosine(surface: &Surface, direction: Vec3) -> Option<f64> {
    let cosine = surface.geometric_normal.as_dvec3().dot(direction.as_dvec3()) / direction.as_dvec3().length();
    (cosine.abs() > SINGLE).then_some(cosine)
}

/// Less than any radius of curvature of an ellipsoid: the shortest axis squared over the longest.
fn sharpest_bend(linear: DMat3) -> f64 {
    let size = |m: DMat3| DVec3::new(m.x_axis.length(), m.y_axis.length(), m.z_axis.length()).length();
    1.0 / (size(linear.inverse()).powi(2) * size(linear))
}

/// A ray that leaves starts on the side it goes to, and no farther off than the error and a rounding make necessary.
fn starts_on_its_side(
    surface: &Surface,
    ray: &Ray,
    cosine: f64,
    side: impl Fn(&Vector) -> Exact,
) -> Result<(), TestCaseError> {
    let side = side(&ray.origin.into());
    prop_assert!(if cosine > 0.0 { side > Exact::ZERO } else { side < Exact::ZERO }, "{:?}", ray);
    let moved = (ray.origin.as_dvec3() - surface.position.as_dvec3()).length();
    prop_assert!(moved <= 2.0 * surface.error.as_dvec3().length() + 1e-30, "by {} for {}", moved, surface.error);
    Ok(())
}

fn triangle_is_left(aimed: &Aimed<Triangle>, heading: impl Fn(&Surface) -> Vec3) -> Result<(), TestCaseError> {
    let Some(hit) = aimed.shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
    let surface = aimed.shape.surface(&aimed.ray, &hit);
    let (point, normal) = triangle::point_and_normal(&aimed.shape);
    let side = |p: &Vector| normal.dot(&p.minus(&point));
    bounds_hold(&surface, None, side)?;
    let direction = heading(&surface);
    let Some(cosine) = cosine(&surface, direction) else { return Ok(()) };
    let leaving = surface.leave(direction);
    starts_on_its_side(&surface, &leaving, cosine, side)?;
    prop_assert_eq!(aimed.shape.intersect(&leaving, Interval::FORWARD), None);
    Ok(())
}

/// Inwards, the other side of the sphere: `t = -2 (f.d) / (d.d)`, to the precision of the start; where the chord is longer
/// than the sphere is uncertain.
fn sphere_is_left(aimed: &Aimed<Sphere>, heading: impl Fn(&Surface) -> Vec3) -> Result<(), TestCaseError> {
    let shape = aimed.shape;
    let Some(hit) = shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
    let surface = shape.surface(&aimed.ray, &hit);
    let side = |p: &Vector| {
        let from_center = p.minus(&shape.center.into());
        from_center.dot(&from_center) - exact(shape.radius) * exact(shape.radius)
    };
    let radius = f64::from(shape.radius);
    let error = surface.error.as_dvec3().length();
    let to_unit = DMat3::from_diagonal(DVec3::splat(1.0 / radius));
    bounds_hold(&surface, Some(deepest_point(&surface, to_unit, shape.center.as_dvec3())), side)?;
    let direction = heading(&surface);
    let Some(cosine) = cosine(&surface, direction) else { return Ok(()) };
    let leaving = surface.leave(direction);
    let again = shape.intersect(&leaving, Interval::FORWARD);
    if cosine > 0.0 {
        starts_on_its_side(&surface, &leaving, cosine, side)?;
        prop_assert_eq!(again, None);
    } else if radius > 2.0 * error {
        // Else the grid of `f32` is as coarse there as the sphere is small: no number may lie inside.
        starts_on_its_side(&surface, &leaving, cosine, side)?;
        prop_assert!(again.is_some(), "a leak");
    }
    if cosine < 0.0 && cosine.powi(2) * radius > 64.0 * error {
        let chord = -2.0 * cosine * radius;
        let length = leaving.direction.as_dvec3().length();
        let t = again.map(|again| f64::from(again.t) * length);
        prop_assert!(t.is_some_and(|t| (t - chord).abs() < 16.0 * error / cosine.abs()), "{:?} for {}", t, chord);
    }
    Ok(())
}

fn ellipsoid_is_left(aimed: &Aimed<Transform>, heading: impl Fn(&Surface) -> Vec3) -> Result<(), TestCaseError> {
    let shape = Ellipsoid::new(aimed.shape).expect("maps of full rank");
    let Some(hit) = shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
    let surface = shape.surface(&aimed.ray, &hit);
    let side = |p: &Vector| ellipsoid::outside(&aimed.shape, p);
    let inverse = aimed.shape.linear.inverse();
    bounds_hold(&surface, Some(deepest_point(&surface, inverse, aimed.shape.translation)), side)?;
    let direction = heading(&surface);
    let Some(cosine) = cosine(&surface, direction) else { return Ok(()) };
    let leaving = surface.leave(direction);
    let again = shape.intersect(&leaving, Interval::FORWARD);
    if cosine > 0.0 {
        starts_on_its_side(&surface, &leaving, cosine, side)?;
        prop_assert_eq!(again, None);
    } else if surface.error.as_dvec3().length() < sharpest_bend(aimed.shape.linear) {
        // Else its tip is as small as the grid of `f32` there: no number may lie just inside.
        starts_on_its_side(&surface, &leaving, cosine, side)?;
        prop_assert!(again.is_some(), "a leak");
    }
    Ok(())
}

proptest! {
    #![proptest_config(times(16))]

    #[test]
    fn a_triangle_is_not_met_again(aimed in triangles(), heading in headings()) {
        triangle_is_left(&aimed, |surface| heading.from(surface))?;
    }

    #[test]
    fn a_plane_is_not_met_again(aimed in planes(), heading in headings()) {
        let Some(shape) = aimed.shape.plane() else { return Ok(()) };
        let Some(hit) = shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
        let surface = shape.surface(&aimed.ray, &hit);
        let (point, normal) = plane::point_and_normal(&aimed.shape);
        let side = |p: &Vector| normal.dot(&p.minus(&point));
        bounds_hold(&surface, None, side)?;
        let direction = heading.from(&surface);
        let Some(cosine) = cosine(&surface, direction) else { return Ok(()) };
        let leaving = surface.leave(direction);
        starts_on_its_side(&surface, &leaving, cosine, side)?;
        prop_assert_eq!(shape.intersect(&leaving, Interval::FORWARD), None);
    }

    #[test]
    fn a_sphere_is_not_met_again_outwards_and_on_its_far_side_inwards(aimed in spheres(), heading in headings()) {
        sphere_is_left(&aimed, |surface| heading.from(surface))?;
    }

    #[test]
    fn an_ellipsoid_is_not_met_again_outwards_and_on_its_far_side_inwards(aimed in ellipsoids(), heading in headings()) {
        ellipsoid_is_left(&aimed, |surface| heading.from(surface))?;
    }

    #[test]
    fn a_ray_towards_a_target_reaches_it_at_1(aimed in triangles(), target in directions(), scale in 0..7) {
        let Some(hit) = aimed.shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
        let surface = aimed.shape.surface(&aimed.ray, &hit);
        let target = surface.position + target * 10_f32.powi(scale - 3);
        let ray = surface.leave_towards(target);
        let off = (ray.at(1.0) - target.as_dvec3()).abs();
        let rounding = SINGLE * ray.direction.abs().as_dvec3() + f64::from(f32::from_bits(1));
        prop_assert!(off.cmple(rounding).all(), "off by {}", off);
        // A target within the error's reach of the surface may as well be behind it.
        let height = surface.geometric_normal.dot(target - surface.position).abs();
        if height > 2.0 * surface.geometric_normal.abs().dot(surface.error) && cosine(&surface, ray.direction).is_some() {
            prop_assert_eq!(aimed.shape.intersect(&ray, Interval::SEGMENT), None);
        }
    }
}

/// The weights of so thin a triangle cancel; `t` must not be made of them.
#[test]
fn a_large_sliver_is_not_met_again() {
    let corners = [Vec3::ZERO, Vec3::new(0.0, 0.0, 2700633.8), Vec3::new(3.003649, 0.0, 4782476.5)];
    let ray = Ray::new(Vec3::new(0.2760935, -1909636.4, -137227.38), Vec3::new(0.0, 1909636.4, 1909636.4));
    let direction = Vec3::new(-0.33343172, 0.3504778, 0.8752077);
    triangle_is_left(&Aimed { shape: Triangle { corners }, ray }, |_| direction).unwrap();
}

/// Each coordinate of the start rounded away from the surface would be a step of 1/32 sideways here: out of the sphere.
#[test]
fn a_ray_into_a_sphere_far_off_starts_inside() {
    let shape = Sphere { center: Vec3::new(0.0, 0.0, 326323.97), radius: 1.0 };
    let ray = Ray::new(shape.center, Vec3::new(0.99998367, 0.0, 0.005715572));
    sphere_is_left(&Aimed { shape, ray }, |_| Vec3::new(3.266308e-5, 0.0, -0.0057154787)).unwrap();
}

/// The centre is half a step of `f32` off the nearest number: rounding moves the point so far along the surface, which bends away
/// under it by 0.0037^2 / 2, a hundred times the point's own error along the normal.
#[test]
fn a_ray_into_an_ellipsoid_far_off_starts_inside() {
    let shape = Transform::translation(DVec3::new(100000.0037, 0.0, 0.0));
    let ray = Ray::new(Vec3::new(100000.0, 0.0, 3.0), Vec3::new(0.00185, 0.0, -1.0));
    ellipsoid_is_left(&Aimed { shape, ray }, |_| -Vec3::Z).unwrap();
}
