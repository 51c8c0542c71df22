use geometry::{
    Ellipsoid, Interval, Primitive, Ray, Transform,
    conformance::{Aimed, ellipsoids, times},
};
use glam::{DMat3, DVec3};
use proptest::prelude::*;

use crate::exact::{DOUBLE, Exact, Quadratic, ULPS, Vector, approximate, exact, truths};

/// The map's inverse times its determinant, by cofactors, applied to a vector; and the determinant.
pub(crate) fn to_unit(map: &Transform, v: &Vector) -> (Vector, Exact) {
    let [x, y, z] = [map.linear.x_axis, map.linear.y_axis, map.linear.z_axis].map(Vector::from);
    let rows = [y.cross(&z), z.cross(&x), x.cross(&y)];
    let determinant = rows[0].dot(&x);
    (Vector(rows.map(|row| row.dot(v))), determinant)
}

/// `|M^-1 p|^2 - 1` of a point seen from the centre, times the determinant squared: positive outside.
pub(crate) fn outside(map: &Transform, point: &Vector) -> Exact {
    let (unit, determinant) = to_unit(map, &point.minus(&map.translation.into()));
    unit.dot(&unit) - &determinant * &determinant
}

/// The equation of `t`, scaled by the determinant squared.
pub(crate) fn equation(map: &Transform, ray: &Ray) -> Quadratic {
    let (from_center, determinant) = to_unit(map, &Vector::from(ray.origin).minus(&map.translation.into()));
    let (direction, _) = to_unit(map, &ray.direction.into());
    Quadratic {
        a: direction.dot(&direction),
        half_b: from_center.dot(&direction),
        c: from_center.dot(&from_center) - &determinant * &determinant,
    }
}

/// What a rounding in `f64` moves the line by, as the unit sphere sees it. The inverse is off by the map's condition number,
/// and by what cancels in its determinant (Hadamard's ratio: the axes' lengths over the volume); the origin by its distance too.
pub(crate) fn line_error(map: &Transform, ray: &Ray) -> f64 {
    let lengths = |m: DMat3| DVec3::new(m.x_axis.length(), m.y_axis.length(), m.z_axis.length());
    let inverse = map.linear.inverse();
    let condition = lengths(map.linear).length() * lengths(inverse).length();
    let skew = lengths(map.linear).element_product() / map.linear.determinant().abs();
    let distance = (inverse * (ray.origin.as_dvec3() - map.translation)).length();
    DOUBLE * (condition + skew) * (distance + 1.0)
}

/// How deep the line runs in the unit sphere: half the chord, squared; negative outside.
pub(crate) fn depth(equation: &Quadratic, map: &Transform) -> f64 {
    let (_, determinant) = to_unit(map, &DVec3::ZERO.into());
    approximate(&(equation.discriminant() / &equation.a / (&determinant * &determinant)))
}

proptest! {
    #![proptest_config(times(8))]

    #[test]
    fn hit_and_miss_are_right_unless_the_map_cannot_tell(aimed in ellipsoids()) {
        let Aimed { shape, ray } = aimed;
        let ellipsoid = Ellipsoid::new(shape).expect("maps of full rank");
        let equation = equation(&shape, &ray);
        let error = 4.0 * line_error(&shape, &ray);
        prop_assume!(depth(&equation, &shape).abs() > error);
        // Where the origin is on the surface to that precision, the near root may be on either side of it.
        let (_, determinant) = to_unit(&shape, &DVec3::ZERO.into());
        prop_assume!((approximate(&equation.c) / approximate(&(&determinant * &determinant))).abs() > error);
        prop_assert_eq!(ellipsoid.intersect(&ray, Interval::FORWARD).is_some(), equation.first_ahead().is_some());
    }

    /// To half an ulp, and what the inverse map, kept in `f64`, loses: its roundings are multiplied by the map's condition
    /// number and by the distance in radii, and at a shallow depth by its reciprocal.
    #[test]
    fn t_is_the_nearest_root_ahead_to_half_an_ulp_of_the_map(aimed in ellipsoids()) {
        let Aimed { shape, ray } = aimed;
        let ellipsoid = Ellipsoid::new(shape).expect("maps of full rank");
        let equation = equation(&shape, &ray);
        let error = 4.0 * line_error(&shape, &ray);
        let depth = depth(&equation, &shape);
        prop_assume!(depth > error);
        let Some(hit) = ellipsoid.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        let (direction, determinant) = to_unit(&shape, &ray.direction.into());
        let speed = direction.approximate().length() / approximate(&determinant).abs();
        let range = truths(hit.t, ULPS, error * (1.0 + 1.0 / depth.sqrt()) / speed);
        let near_start = range[0] <= Exact::ZERO;
        let root = equation.first_ahead();
        prop_assert!(near_start || root.is_some_and(|root| equation.root_is_within(root, &range)), "t = {}", hit.t);
    }

    #[test]
    fn the_box_holds_the_ellipsoid(aimed in ellipsoids(), unit in geometry::conformance::unit_vector()) {
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
    fn texture_coordinates_lie_in_the_texture(aimed in ellipsoids()) {
        let ellipsoid = Ellipsoid::new(aimed.shape).expect("maps of full rank");
        if let Some(hit) = ellipsoid.intersect(&aimed.ray, Interval::FORWARD) {
            let uv = ellipsoid.uv(&aimed.ray, &hit);
            prop_assert!((0.0..1.0).contains(&uv.x) && (0.0..=1.0).contains(&uv.y), "{}", uv);
        }
    }
}
