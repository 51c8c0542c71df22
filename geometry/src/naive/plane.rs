use crate::{Intersection, Interval, Plane, Ray};

/// A smaller `n.d` in magnitude counts as parallel.
const EPSILON: f32 = 1e-6;

/// A plane in `f32`, where a ray that is nearly parallel counts as parallel.
///
/// `t = n.(p - o) / (n.d)`, as in any introduction, the two dot products in `f32` and guarded by `abs(n.d) < epsilon` against a
/// division by zero that `f32` does not mind. The guard loses true hits: all near the horizon, and, since `n.d` grows with the
/// direction's length, all of a direction shorter than the epsilon. Of what is left, `n.d` has lost its digits to cancellation where it
/// is small, and `n.(p - o)` where the plane is far from the scene's origin.
pub fn rejecting_near_parallel(plane: &Plane, ray: &Ray, within: Interval) -> Option<Intersection> {
    let normal = plane.normal().as_vec3();
    let along = normal.dot(ray.direction);
    if along.abs() < EPSILON {
        return None;
    }
    let t = normal.dot(plane.point() - ray.origin) / along;
    within.contains(t).then(|| Intersection::at(t))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Primitive;
    use glam::Vec3;

    #[test]
    fn a_floor_is_met_below_and_lost_near_the_horizon() {
        let floor = Plane::from_normal(Vec3::ZERO, Vec3::Z).unwrap();
        let below = Ray::new(2.0 * Vec3::Z, -Vec3::Z);
        assert_eq!(rejecting_near_parallel(&floor, &below, Interval::FORWARD), Some(Intersection::at(2.0)));
        let horizon = Ray::new(2.0 * Vec3::Z, Vec3::new(1.0, 0.0, -5e-7));
        assert_eq!(floor.intersect(&horizon, Interval::FORWARD), Some(Intersection::at(4e6)));
        assert_eq!(rejecting_near_parallel(&floor, &horizon, Interval::FORWARD), None);
    }
}
