use geometry::{Ray, Sphere};
use glam::DVec3;

use super::{Truth, half_ulp, half_ulps};
use crate::accuracy::exact::{Exact, ExactVector};

/// A ray against a sphere.
pub(crate) fn sphere(shape: &Sphere, ray: &Ray) -> Truth {
    let from_center = ExactVector::from(ray.origin).minus(shape.center.into());
    let moves = half_ulps(ray.origin) + half_ulps(shape.center);
    let radius = f64::from(shape.radius);
    roots(from_center, ray.direction.into(), radius, |away, along| {
        away.abs().dot(moves + half_ulps(ray.direction) * along.abs()) + half_ulp(shape.radius)
    })
}

/// The first root ahead of a line from `from_center` along `direction` and a sphere of a radius around 0. `wobble` says how far a point
/// that lies so many directions along the line may move away from the centre, along a unit vector, by half ulps of the input.
pub(super) fn roots(
    from_center: ExactVector,
    direction: ExactVector,
    radius: f64,
    wobble: impl Fn(DVec3, f64) -> f64,
) -> Truth {
    let squared_radius = Exact::from(radius) * Exact::from(radius);
    let a = direction.dot(direction);
    let half_b = from_center.dot(direction);
    let power = from_center.dot(from_center) - squared_radius;
    let discriminant = half_b * half_b - a * power;

    let middle = -(half_b / a);
    let nearest = from_center.plus(direction.times(middle)).approximate();
    let passing = nearest.length();
    // r^2 - l^2 = (r - l) (r + l)
    let depth = (discriminant / a).approximate() / (radius + passing);
    if depth.abs() <= wobble(nearest.normalize_or_zero(), middle.approximate()) {
        return Truth::Unclear;
    }
    let start = from_center.approximate();
    let height = power.approximate() / (radius + start.length());
    if height.abs() <= wobble(start.normalize_or_zero(), 0.0) {
        return Truth::Unclear;
    }
    if depth < 0.0 {
        return Truth::Miss;
    }
    let root = discriminant.sqrt();
    let far = if half_b.is_positive() { -half_b - root } else { root - half_b };
    let (one, other) = (far / a, power / far);
    let (first, second) = (one.min(other), one.max(other));
    [first, second].into_iter().find(|t| t.is_positive()).map_or(Truth::Miss, Truth::Hit)
}
