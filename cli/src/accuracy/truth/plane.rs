use geometry::Ray;
use glam::Vec3;

use super::{Truth, half_ulps};
use crate::accuracy::exact::ExactVector;

/// A ray against the plane through a point, perpendicular to a normal of any length, as they were given.
pub(crate) fn plane(point: Vec3, normal: Vec3, ray: &Ray) -> Truth {
    let offset = ExactVector::from(point).minus(ray.origin.into());
    let height = ExactVector::from(normal).dot(offset);
    let along = ExactVector::from(normal).dot(ray.direction.into());
    let size = normal.as_dvec3().abs();
    let turn = half_ulps(normal);
    let height_moves = size.dot(half_ulps(point) + half_ulps(ray.origin)) + offset.approximate().abs().dot(turn);
    let along_moves = size.dot(half_ulps(ray.direction)) + ray.direction.as_dvec3().abs().dot(turn);
    if height.approximate().abs() <= height_moves || along.approximate().abs() <= along_moves {
        return Truth::Unclear;
    }
    let t = height / along;
    if t.is_positive() { Truth::Hit(t) } else { Truth::Miss }
}
