//! Surfaces: on the shape, with a bound of their error, and rays to a target.

use geometry::{
    Ellipsoid, Interval, Primitive, Sphere, Surface,
    conformance::{
        Aimed, ellipsoid, ellipsoids,
        exact::{DOUBLE, Exact, SINGLE, Vector, exact},
        plane::point_and_normal as plane_of,
        planes, spheres, times,
        triangle::point_and_normal,
        triangles, unit_vector,
    },
};
use glam::{DMat3, DVec3, Vec3};
use proptest::prelude::*;

/// A direction with a length.
fn directions() -> impl Strategy<Value = Vec3> {
    (unit_vector(), prop_oneof![Just(1.0), Just(1e-3), Just(1e3)]).prop_map(|(unit, length)| (unit * length).as_vec3())
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

proptest! {
    #![proptest_config(times(16))]

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

    #[test]
    fn a_hit_point_is_on_the_plane_to_a_rounding(aimed in planes()) {
        let Aimed { shape, ray } = aimed;
        let Some(plane) = shape.plane() else { return Ok(()) };
        let Some(hit) = plane.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        let (point, normal) = plane_of(&shape);
        let position = plane.surface(&ray, &hit).position;
        let off = normal.dot(&Vector::from(position).minus(&point));
        let magnitude = position.abs().max(point.approximate().as_vec3().abs()).max_element();
        let bound = exact(8.0 * SINGLE * f64::from(magnitude));
        prop_assert!(&off * &off <= &bound * &bound * normal.dot(&normal));
    }

    #[test]
    fn a_hit_point_is_on_the_triangles_plane_to_a_rounding(aimed in triangles()) {
        let Aimed { shape, ray } = aimed;
        let Some(hit) = shape.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        let (point, normal) = point_and_normal(&shape);
        let off = normal.dot(&Vector::from(shape.surface(&ray, &hit).position).minus(&point));
        let bound = exact(7.0 * SINGLE * f64::from(shape.bounds().magnitude()));
        prop_assert!(&off * &off <= &bound * &bound * normal.dot(&normal));
    }

    #[test]
    fn the_box_holds_the_ellipsoid(aimed in ellipsoids(), unit in unit_vector()) {
        let bounds = Ellipsoid::new(aimed.shape).expect("maps of full rank").bounds();
        let [low, high] = [bounds.min, bounds.max].map(Vector::from);
        // A hair inside, since the unit vector is rounded.
        let unit = Vector::from(unit * (1.0 - 4.0 * DOUBLE));
        let transposed = aimed.shape.linear.transpose();
        let rows = [transposed.x_axis, transposed.y_axis, transposed.z_axis];
        for (axis, row) in rows.into_iter().enumerate() {
            let coordinate = Vector::from(row).dot(&unit) + exact(aimed.shape.translation[axis]);
            prop_assert!(low.0[axis] <= coordinate && coordinate <= high.0[axis], "axis {}", axis);
        }
    }

    #[test]
    fn the_error_of_a_triangles_surface_holds_the_triangle(aimed in triangles()) {
        let Some(hit) = aimed.shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
        let (point, normal) = point_and_normal(&aimed.shape);
        bounds_hold(&aimed.shape.surface(&aimed.ray, &hit), None, |p| normal.dot(&p.minus(&point)))?;
    }

    #[test]
    fn the_error_of_a_planes_surface_holds_the_plane(aimed in planes()) {
        let Some(shape) = aimed.shape.plane() else { return Ok(()) };
        let Some(hit) = shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
        let (point, normal) = plane_of(&aimed.shape);
        bounds_hold(&shape.surface(&aimed.ray, &hit), None, |p| normal.dot(&p.minus(&point)))?;
    }

    #[test]
    fn the_error_of_a_spheres_surface_holds_the_sphere(aimed in spheres()) {
        let shape: Sphere = aimed.shape;
        let Some(hit) = shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
        let surface = shape.surface(&aimed.ray, &hit);
        let to_unit = DMat3::from_diagonal(DVec3::splat(1.0 / f64::from(shape.radius)));
        bounds_hold(&surface, Some(deepest_point(&surface, to_unit, shape.center.as_dvec3())), |p| {
            let from_center = p.minus(&shape.center.into());
            from_center.dot(&from_center) - exact(shape.radius) * exact(shape.radius)
        })?;
    }

    #[test]
    fn the_error_of_an_ellipsoids_surface_holds_the_ellipsoid(aimed in ellipsoids()) {
        let shape = Ellipsoid::new(aimed.shape).expect("maps of full rank");
        let Some(hit) = shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
        let surface = shape.surface(&aimed.ray, &hit);
        let deepest = deepest_point(&surface, aimed.shape.linear.inverse(), aimed.shape.translation);
        bounds_hold(&surface, Some(deepest), |p| ellipsoid::outside(&aimed.shape, p))?;
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
        let cosine = surface.geometric_normal.as_dvec3().dot(ray.direction.as_dvec3()) / ray.direction.as_dvec3().length();
        let height = surface.geometric_normal.dot(target - surface.position).abs();
        if height > 2.0 * surface.geometric_normal.abs().dot(surface.error) && cosine.abs() > SINGLE {
            prop_assert_eq!(aimed.shape.intersect(&ray, Interval::SEGMENT), None);
        }
    }
}
