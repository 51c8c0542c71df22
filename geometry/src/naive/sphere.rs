use glam::Vec3;

use crate::{Intersection, Interval, Ray, Sphere};

/// A sphere by the school's quadratic formula, in `f32`, with `a = 1` for a normalised direction.
///
/// ```text
///   t^2 + 2 f.d t + (f.f - r^2) = 0          f  from the centre to the origin, |d| = 1
///   t = (-b -+ sqrt(b^2 - 4 c)) / 2           b = 2 f.d,  c = f.f - r^2
/// ```
///
/// As in nearly every introduction, from Haines' chapter in Glassner: An Introduction to Ray Tracing (1989) on.
///
/// `b^2` and `4 c` are both about `4 D^2` for a sphere at distance `D`, and their difference is about `4 r^2`: with `u = 2^-24`,
/// nothing is left of it where `(D / r)^2 > 1 / u`, that is, beyond `D / r` = 4000. The direction is a unit vector only to within `u`,
/// which `a = 1` makes an error of the same kind. And `-b - sqrt(..)` cancels again where the origin is near the surface: a ray that
/// starts there meets it once more.
pub fn quadratic_formula(sphere: &Sphere, ray: &Ray, within: Interval) -> Option<Intersection> {
    let length = ray.direction.length();
    let from_center = ray.origin - sphere.center;
    let roots = unit_direction_roots(from_center, ray.direction / length, sphere.radius)?;
    roots.into_iter().map(|distance| distance / length).find(|&t| within.contains(t)).map(Intersection::at)
}

/// The two distances, the lesser first.
pub(super) fn unit_direction_roots(from_center: Vec3, direction: Vec3, radius: f32) -> Option<[f32; 2]> {
    let b = 2.0 * from_center.dot(direction);
    let c = from_center.dot(from_center) - radius * radius;
    let discriminant = b * b - 4.0 * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    Some([(-b - root) / 2.0, (-b + root) / 2.0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Primitive;

    #[test]
    fn an_easy_sphere_is_met_where_it_is() {
        let sphere = Sphere { center: Vec3::ZERO, radius: 1.0 };
        let ray = Ray::new(Vec3::new(0.0, 0.0, -3.0), 4.0 * Vec3::Z);
        assert_eq!(quadratic_formula(&sphere, &ray, Interval::FORWARD), Some(Intersection::at(0.5)));
    }

    #[test]
    fn a_far_sphere_is_lost() {
        // Half a radius from the axis; but f.f = 1e8 + 0.25 and r^2 = 1 drown in 1e8, whose ulp is 8.
        let sphere = Sphere { center: Vec3::new(10_000.0, 0.5, 0.0), radius: 1.0 };
        let off = Ray::new(Vec3::ZERO, Vec3::new(1.0, 1.6e-4, 0.0));
        assert!(sphere.intersect(&off, Interval::FORWARD).is_none(), "1.1 above the centre");
        assert!(quadratic_formula(&sphere, &off, Interval::FORWARD).is_some());
    }
}
