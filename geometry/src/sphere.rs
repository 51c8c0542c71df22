use std::f64::consts::PI;

use glam::{DVec3, Vec2, Vec3};

use crate::{
    Aabb, Intersection, Interval, Primitive, Ray, Surface,
    rounding::{round_down, round_up},
};

/// A sphere whose axis is the z axis. One that is turned or stretched is an [`crate::Ellipsoid`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: Vec3,
    /// Its radius, greater than 0.
    pub radius: f32,
}

/// Where a line meets a sphere, seen from its centre: the two `t`, the lesser first.
///
/// Half-b quadratic with the discriminant taken from the point of the line nearest to the centre, in `f64`:
///
/// ```text
///        d ->            f  from the centre to the origin
///   o----------m----     m  = f - (f.d / d.d) d, perpendicular to d
///    \         | l       l  = |m|; met if l <= r, at t = -f.d / d.d -+ sqrt((r^2 - l^2) / d.d)
///   f \        |
///      \       c
/// ```
///
/// (Haines, Günther, Akenine-Möller: Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems 2019, chapter 7.)
/// The lesser root in magnitude is found from the product of the roots, `(f.f - r^2) / d.d`. Its numerator, the origin's
/// `power` (Steiner 1826), is asked for, since it cancels where the origin is near the surface; not of a line that misses.
pub(crate) fn line_meets_sphere(
    from_center: DVec3,
    direction: DVec3,
    radius: f64,
    power: impl FnOnce() -> f64,
) -> Option<[f64; 2]> {
    let a = direction.dot(direction);
    let half_b = from_center.dot(direction);
    let middle = -(half_b / a);
    let nearest = from_center + direction * middle;
    let depth = radius * radius - nearest.dot(nearest);
    // A zero direction makes a NaN here, and a NaN is not a hit.
    if depth.is_nan() || depth < 0.0 {
        return None;
    }
    let far = middle + (depth / a).sqrt().copysign(middle);
    let other = if far == 0.0 { 0.0 } else { power() / a / far };
    Some(if far < other { [far, other] } else { [other, far] })
}

/// The power of a point with respect to a sphere: its distance from the centre squared, less the radius squared.
///
/// In `f64`, and where more than 20 of its bits cancel, once more without their loss: a coordinate's difference is split into
/// an `f32`, whose square is exact, and a small rest; the squares' sum keeps what each step rounds off (Knuth's two-sum, The Art
/// of Computer Programming, volume 2, section 4.2.2).
fn power(point: Vec3, center: Vec3, radius: f32) -> f64 {
    let from_center = point.as_dvec3() - center.as_dvec3();
    let radius = f64::from(radius);
    let squared = radius * radius;
    let power = from_center.dot(from_center) - squared;
    if is_exact(power, squared) {
        return power;
    }
    let mut sum = -squared;
    let mut rest = 0.0;
    for axis in 0..3 {
        let (difference, rounded_off) = two_sum(f64::from(point[axis]), -f64::from(center[axis]));
        let high = f64::from(difference as f32);
        let low = (difference - high) + rounded_off;
        let (next, rounded_off) = two_sum(sum, high * high);
        sum = next;
        rest += rounded_off + low * (2.0 * high + low);
    }
    sum + rest
}

/// Whether no more than 20 bits of a power cancel, from the radius squared.
#[inline(always)]
pub(crate) fn is_exact(power: f64, squared: f64) -> bool {
    power.abs() * f64::from(1 << 20) > squared
}

/// Whether a ray surely starts outside and goes away from the centre: as all do that leave the sphere itself, for a light, say. Neither root is
/// then above 0. Of `f.d`, `f.f` and the radius squared.
///
/// The power is rounded in seven steps, and so off by less than 2^-50 of what is added up in it; if it is above that, it is greater than 0.
#[inline(always)]
pub(crate) fn is_left_behind(half_b: f64, distance_squared: f64, radius_squared: f64) -> bool {
    const SURELY: f64 = 1.0 / (1_u64 << 50) as f64;
    (half_b > 0.0) & (distance_squared - radius_squared > SURELY * (distance_squared + radius_squared))
}

/// A sum, and what its rounding lost: together exactly `a + b`.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_in_sum = sum - a;
    (sum, (a - (sum - b_in_sum)) + (b - b_in_sum))
}

/// The first of two `t`, rounded to `f32`, that lies in the interval.
pub(crate) fn first_within(roots: [f64; 2], within: Interval) -> Option<Intersection> {
    roots.into_iter().map(|t| t as f32).find(|&t| within.contains(t)).map(Intersection::at)
}

/// The exact intersection again, in `f64`: the root that was rounded to `t`.
pub(crate) fn root_nearest(roots: Option<[f64; 2]>, t: f32) -> f64 {
    roots.and_then(|roots| roots.into_iter().find(|&root| root as f32 == t)).unwrap_or(f64::from(t))
}

/// Texture coordinates of a direction from the centre: `u` around the z axis from +x over +y, `v` from +z (0) to -z (1).
///
/// `v` from `atan2`, since `acos` loses half the digits at the poles. `u` is 0, never 1, at the seam. Both are right to half an ulp
/// of 1, 3.1e-8; near a pole, the direction's own rounding turns `u` by that over the distance from the axis.
pub(crate) fn sphere_uv(direction: DVec3) -> Vec2 {
    let around = libm::atan2(direction.y, direction.x) / (2.0 * PI);
    let u = (if around < 0.0 { around + 1.0 } else { around }) as f32;
    let v = libm::atan2((direction.x * direction.x + direction.y * direction.y).sqrt(), direction.z) / PI;
    Vec2::new(if u < 1.0 { u } else { 0.0 }, v as f32)
}

impl Sphere {
    fn roots(&self, ray: &Ray) -> Option<[f64; 2]> {
        let from_center = ray.origin.as_dvec3() - self.center.as_dvec3();
        let power = || power(ray.origin, self.center, self.radius);
        line_meets_sphere(from_center, ray.direction.as_dvec3(), f64::from(self.radius), power)
    }

    /// See [`is_left_behind`].
    #[inline]
    fn is_left_behind(&self, ray: &Ray) -> bool {
        let from_center = ray.origin.as_dvec3() - self.center.as_dvec3();
        let squared = f64::from(self.radius) * f64::from(self.radius);
        is_left_behind(from_center.dot(ray.direction.as_dvec3()), from_center.dot(from_center), squared)
    }

    /// The unit vector from the centre to an intersection.
    pub(crate) fn outward(&self, ray: &Ray, at: &Intersection) -> DVec3 {
        (ray.at(root_nearest(self.roots(ray), at.t)) - self.center.as_dvec3()).normalize()
    }
}

impl Primitive for Sphere {
    fn bounds(&self) -> Aabb {
        let center = self.center.as_dvec3();
        let radius = DVec3::splat(f64::from(self.radius));
        Aabb { min: round_down(center - radius), max: round_up(center + radius) }
    }

    /// `t` to 0.51 ulp, but for tangents: where the line passes the surface as closely as the inputs' own half ulp, to what `f64`
    /// sees, 2^-49 r (D + r) of the depth r^2 - l^2, D the origin's distance from the centre. Hit and miss are right down to that.
    fn intersect(&self, ray: &Ray, within: Interval) -> Option<Intersection> {
        if within.min >= 0.0 && self.is_left_behind(ray) {
            return None;
        }
        first_within(self.roots(ray)?, within)
    }

    /// The point is on the sphere to 2 u (|c| + r), u = 2^-24, however far the ray came: projected onto it, not `o + t d`.
    fn surface(&self, ray: &Ray, at: &Intersection) -> Surface {
        let normal = self.outward(ray, at);
        let position = self.center.as_dvec3() + normal * f64::from(self.radius);
        let magnitude = self.center.abs().max_element() + self.radius;
        Surface::rounded(position.as_vec3(), magnitude, normal.as_vec3())
    }

    fn uv(&self, ray: &Ray, at: &Intersection) -> Vec2 {
        sphere_uv(self.outward(ray, at))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Sphere = Sphere { center: Vec3::ZERO, radius: 1.0 };

    #[test]
    fn a_sphere_is_met_first_in_front_and_from_inside_behind_the_centre() {
        let outside = Ray::new(Vec3::new(0.0, 0.0, -3.0), Vec3::Z);
        assert_eq!(UNIT.intersect(&outside, Interval::FORWARD), Some(Intersection::at(2.0)));
        let inside = Ray::new(Vec3::ZERO, Vec3::Z);
        assert_eq!(UNIT.intersect(&inside, Interval::FORWARD), Some(Intersection::at(1.0)));
    }

    #[test]
    fn t_counts_multiples_of_the_direction() {
        let ray = Ray::new(Vec3::new(0.0, 0.0, -3.0), 4.0 * Vec3::Z);
        assert_eq!(UNIT.intersect(&ray, Interval::FORWARD), Some(Intersection::at(0.5)));
    }

    #[test]
    fn a_tangent_meets_the_sphere() {
        let ray = Ray::new(Vec3::new(1.0, 0.0, -3.0), Vec3::Z);
        assert_eq!(UNIT.intersect(&ray, Interval::FORWARD), Some(Intersection::at(3.0)));
    }

    /// Rays that leave the sphere by a hair, or not: what is left out is what the roots would leave out.
    #[test]
    fn a_sphere_that_is_left_behind_has_no_root_in_front() {
        let ulp = |number: f32, steps: i32| f32::from_bits(number.to_bits().wrapping_add_signed(steps));
        let mut left_behind = [0, 0];
        for (radius, far) in [(1.0_f32, 0.0_f32), (0.3, 7.0), (1e-3, 100.0), (1e6, 1.0)] {
            let sphere = Sphere { center: Vec3::new(far, -far, 0.5 * far), radius };
            for (steps, lean) in (-40..40).flat_map(|steps| [-1.0, -1e-7, 0.0, 1e-7, 1.0].map(|lean| (steps, lean))) {
                let origin = Vec3::new(ulp(far + radius, steps), -far, 0.5 * far);
                let ray = Ray::new(origin, Vec3::new(lean, 1.0, -0.5));
                let met = sphere.roots(&ray).and_then(|roots| first_within(roots, Interval::FORWARD));
                assert_eq!(sphere.intersect(&ray, Interval::FORWARD), met, "{sphere:?} {ray:?}");
                left_behind[usize::from(sphere.is_left_behind(&ray))] += 1;
            }
        }
        assert!(left_behind.into_iter().all(|count| count > 300), "{left_behind:?}");
    }

    #[test]
    fn of_two_roots_in_an_interval_the_lesser_is_met() {
        let beyond = Ray::new(Vec3::new(0.0, 0.0, 3.0), Vec3::Z);
        let behind = Interval { min: -10.0, max: 0.0 };
        assert_eq!(UNIT.intersect(&beyond, behind), Some(Intersection::at(-4.0)));
        assert_eq!(UNIT.intersect(&beyond, Interval { min: -3.0, ..behind }), Some(Intersection::at(-2.0)));
    }

    #[test]
    fn a_power_keeps_what_its_squares_round_off() {
        // (1e6 - 1e-20)^2 - 1e12: the difference itself is rounded.
        let power = power(Vec3::new(1e6, 0.0, 0.0), Vec3::new(1e-20, 0.0, 0.0), 1e6);
        assert!((power + 2e-14).abs() < 1e-20, "{power}");
        assert!(is_exact(1e-5, 1.0) && !is_exact(1e-7, 1.0));
    }

    #[test]
    fn a_sphere_is_left_behind_only_if_rounding_cannot_be_the_reason() {
        let unit = 1e12_f64;
        assert!(is_left_behind(1.0, unit * (1.0 + 1e-14), unit));
        assert!(!is_left_behind(1.0, unit.next_up(), unit));
        assert!(!is_left_behind(-1.0, 4.0, 1.0) && !is_left_behind(1.0, 1.0, 4.0));
    }

    #[test]
    fn the_box_reaches_a_radius_to_each_side_and_the_points_error_grows_with_both() {
        let sphere = Sphere { center: Vec3::new(1.0, -2.0, 64.0), radius: 8.0 };
        assert_eq!(sphere.bounds(), Aabb { min: Vec3::new(-7.0, -10.0, 56.0), max: Vec3::new(9.0, 6.0, 72.0) });
        let ray = Ray::new(Vec3::new(1.0, -2.0, 0.0), Vec3::Z);
        let surface = sphere.surface(&ray, &Intersection::at(56.0));
        assert_eq!(surface, Surface::rounded(Vec3::new(1.0, -2.0, 56.0), 64.0 + 8.0, -Vec3::Z));
    }

    #[test]
    fn u_runs_from_x_over_y_and_v_from_the_north_pole_down() {
        assert_eq!(sphere_uv(DVec3::X), Vec2::new(0.0, 0.5));
        assert_eq!(sphere_uv(DVec3::Y), Vec2::new(0.25, 0.5));
        assert_eq!(sphere_uv(DVec3::Z).y, 0.0);
        assert_eq!(sphere_uv(-DVec3::Z).y, 1.0);
        assert_eq!(sphere_uv(DVec3::new(1.0, -1e-30, 0.0)).x, 0.0, "just before the seam wraps to 0, not 1");
    }
}
