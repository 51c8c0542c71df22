use geometry::{Ray, Triangle};
use glam::DVec3;

use super::{Truth, half_ulps};
use crate::accuracy::exact::{Exact, ExactVector};

/// A ray against a triangle, from either side.
///
/// The signed volumes that the ray's direction spans with the corners, two by two, say on which side of each edge it passes; the
/// volume of the three corners, over the sum of those, is `t`.
pub(crate) fn triangle(shape: &Triangle, ray: &Ray) -> Truth {
    let corners = shape.corners.map(|corner| ExactVector::from(corner).minus(ray.origin.into()));
    let seen = corners.map(ExactVector::approximate);
    let direction = ExactVector::from(ray.direction);
    let moves = shape.corners.map(half_ulps);
    let origin_moves = half_ulps(ray.origin);
    let volume = |i: usize, j: usize| {
        let exact = corners[i].cross(corners[j]).dot(direction);
        let (by_first, by_second) = (seen[j].cross(ray.direction.as_dvec3()), ray.direction.as_dvec3().cross(seen[i]));
        let wobble = seen[i].cross(seen[j]).abs().dot(half_ulps(ray.direction))
            + by_first.abs().dot(moves[i])
            + by_second.abs().dot(moves[j])
            + (by_first + by_second).abs().dot(origin_moves);
        (exact, side(exact, wobble))
    };
    let sides = [volume(1, 2), volume(2, 0), volume(0, 1)];
    let clearly = |wanted: Side| sides.iter().any(|(_, side)| *side == wanted);
    if clearly(Side::Left) && clearly(Side::Right) {
        return Truth::Miss;
    }
    if clearly(Side::Unclear) {
        return Truth::Unclear;
    }
    let normals: [DVec3; 3] = [seen[1].cross(seen[2]), seen[2].cross(seen[0]), seen[0].cross(seen[1])];
    let wobble = (0..3).map(|i| normals[i].abs().dot(moves[i])).sum::<f64>()
        + (normals[0] + normals[1] + normals[2]).abs().dot(origin_moves);
    let all = corners[0].dot(corners[1].cross(corners[2]));
    if side(all, wobble) == Side::Unclear {
        return Truth::Unclear;
    }
    let t = all / (sides[0].0 + sides[1].0 + sides[2].0);
    if t.is_positive() { Truth::Hit(t) } else { Truth::Miss }
}

#[derive(Clone, Copy, PartialEq)]
enum Side {
    Left,
    Right,
    Unclear,
}

fn side(volume: Exact, wobble: f64) -> Side {
    if volume.approximate().abs() <= wobble {
        Side::Unclear
    } else if volume.is_positive() {
        Side::Left
    } else {
        Side::Right
    }
}
