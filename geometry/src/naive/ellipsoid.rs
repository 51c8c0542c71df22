use crate::{Ellipsoid, Intersection, Interval, Ray, naive::sphere::unit_direction_roots};

/// An ellipsoid as an object with an inverse matrix in `f32`: the ray goes into the space of the unit sphere, and there through the
/// quadratic formula.
///
/// The translation stands in the matrix, as in every tutorial on 4 x 4 matrices: `M^-1 o = A^-1 o + (-A^-1 c)` cancels when origin and
/// centre are both far from the scene's origin. At 10^6 radii from it, `f32` has 1/16 of a radius left.
pub fn single_precision_inverse(ellipsoid: &Ellipsoid, ray: &Ray, within: Interval) -> Option<Intersection> {
    let inverse = ellipsoid.to_unit();
    let linear = inverse.linear.as_mat3();
    let origin = linear * ray.origin + inverse.translation.as_vec3();
    let direction = linear * ray.direction;
    let length = direction.length();
    let roots = unit_direction_roots(origin, direction / length, 1.0)?;
    roots.into_iter().map(|distance| distance / length).find(|&t| within.contains(t)).map(Intersection::at)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Primitive, Transform};
    use glam::{DVec3, Vec3};

    fn ball_at(x: f64) -> Ellipsoid {
        Ellipsoid::new(Transform::translation(DVec3::new(x, 0.0, 0.0))).unwrap()
    }

    #[test]
    fn an_easy_ellipsoid_is_met_where_it_is() {
        let ray = Ray::new(Vec3::new(1.0, 0.0, -3.0), Vec3::Z);
        assert_eq!(single_precision_inverse(&ball_at(1.0), &ray, Interval::FORWARD), Some(Intersection::at(2.0)));
    }

    #[test]
    fn a_translation_that_f32_cannot_hold_moves_it() {
        // 2^25 + 1 is no f32: the nearest is 2^25, and a ray just beyond the ball's edge there meets it.
        let far = f64::from(1 << 25);
        let ray = Ray::new(Vec3::new(far as f32, 0.0, -3.0), Vec3::Z);
        assert!(ball_at(far + 1.5).intersect(&ray, Interval::FORWARD).is_none());
        assert!(single_precision_inverse(&ball_at(far + 1.5), &ray, Interval::FORWARD).is_some());
    }
}
