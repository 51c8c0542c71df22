use geometry::{
    Interval, Primitive, Ray,
    conformance::{Aimed, PlaneGiven, planes, times},
};
use proptest::prelude::*;

use crate::exact::{DOUBLE, Exact, SINGLE, ULPS, Vector, exact, is_within, truths};

/// The plane as it was given: a point, and a normal of some length.
pub(crate) fn point_and_normal(plane: &PlaneGiven) -> (Vector, Vector) {
    match *plane {
        PlaneGiven::ByNormal { point, normal } => (point.into(), normal.into()),
        PlaneGiven::ByPoints { point, along_u, along_v } => {
            let point = Vector::from(point);
            let normal = Vector::from(along_u).minus(&point).cross(&Vector::from(along_v).minus(&point));
            (point, normal)
        }
    }
}

/// Where a ray meets the plane through a point, and what `f64` makes of it at best: its rounding of the offset, and of the
/// normal relative to the cosine. `None` for parallel rays.
pub(crate) fn exact_t(point: &Vector, normal: &Vector, ray: &Ray) -> Option<(Exact, f64)> {
    let offset = point.minus(&ray.origin.into());
    let along = normal.dot(&ray.direction.into());
    if along == Exact::ZERO {
        return None;
    }
    let t = normal.dot(&offset) / along.clone();
    let length = ray.direction.as_dvec3().length();
    let cosine = crate::exact::approximate(&along).abs() / (normal.approximate().length() * length);
    let error = (offset.approximate().length() / length + crate::exact::approximate(&t).abs()) / cosine;
    Some((t, error))
}

proptest! {
    #![proptest_config(times(16))]

    /// `f64` adds a few roundings of the offset to the plane's point. They show only where both the point is far beside the hit
    /// and the ray nearly parallel: half an ulp of the inputs would move `t` 2^28 times as far.
    #[test]
    fn t_is_exact_to_half_an_ulp(aimed in planes()) {
        let Aimed { shape, ray } = aimed;
        let (point, normal) = point_and_normal(&shape);
        let (Some(plane), Some((t, scale))) = (shape.plane(), exact_t(&point, &normal, &ray)) else { return Ok(()) };
        let error = 4.0 * DOUBLE * scale;
        match plane.intersect(&ray, Interval::FORWARD) {
            Some(hit) => prop_assert!(is_within(&t, &truths(hit.t, ULPS, error)), "t = {}", hit.t),
            None => prop_assert!(t <= exact(error)),
        }
    }

    #[test]
    fn texture_coordinates_lie_in_the_texture(aimed in planes()) {
        let Some(plane) = aimed.shape.plane() else { return Ok(()) };
        let Some(hit) = plane.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
        let uv = plane.uv(&aimed.ray, &hit);
        prop_assert!((0.0..1.0).contains(&uv.x) && (0.0..1.0).contains(&uv.y), "{}", uv);
    }

    #[test]
    fn a_hit_point_is_on_the_plane_to_a_rounding(aimed in planes()) {
        let Aimed { shape, ray } = aimed;
        let Some(plane) = shape.plane() else { return Ok(()) };
        let Some(hit) = plane.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        let (point, normal) = point_and_normal(&shape);
        let position = plane.surface(&ray, &hit).position;
        let off = normal.dot(&Vector::from(position).minus(&point));
        let magnitude = position.abs().max(point.approximate().as_vec3().abs()).max_element();
        let bound = exact(8.0 * SINGLE * f64::from(magnitude));
        prop_assert!(&off * &off <= &bound * &bound * normal.dot(&normal));
    }
}
