use glam::{DVec3, Vec2, Vec3, swizzles::Vec3Swizzles};

use crate::{Aabb, Intersection, Interval, Primitive, Ray, Surface};

/// A triangle, met from both sides; counter-clockwise corners are seen from the front.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// The corners.
    pub corners: [Vec3; 3],
}

impl Triangle {
    /// The point with barycentric weights `u` and `v` on the second and third corner.
    pub fn point(&self, u: f32, v: f32) -> DVec3 {
        interpolate(self.corners.map(|corner| corner.as_dvec3()), u, v)
    }

    /// The edges' cross product in `f64`: to the front, as long as twice the area.
    pub fn scaled_normal(&self) -> DVec3 {
        let [a, b, c] = self.corners.map(|corner| corner.as_dvec3());
        (b - a).cross(c - a)
    }
}

/// The mean of three values by barycentric weights, `u` and `v` on the second and third.
pub(crate) fn interpolate(values: [DVec3; 3], u: f32, v: f32) -> DVec3 {
    let (u, v) = (f64::from(u), f64::from(v));
    values[0] * (1.0 - u - v) + values[1] * u + values[2] * v
}

impl Primitive for Triangle {
    fn bounds(&self) -> Aabb {
        Aabb::around(self.corners)
    }

    /// Edge functions in a space where the ray runs along z, in `f64` throughout.
    ///
    /// The axis of the direction's largest component becomes z; each corner, seen from the origin, is sheared along the ray
    /// onto the plane of the other two axes and scaled by that component, which saves its reciprocal:
    ///
    /// ```text
    ///   x' = x dz - z dx,  y' = y dz - z dy        U = x'c y'b - y'c x'b   (twice the area of o b c), V, W likewise
    /// ```
    ///
    /// The origin projects to 0, and is inside if U, V, W have one sign, zero included. Each is a difference of two products that
    /// only swap sign when an edge is walked the other way, so the two triangles at an edge, and all at a vertex, decide
    /// alike: no ray slips through. (Woop, Benthin, Wald: Watertight Ray/Triangle Intersection, JCGT 2013; in `f64` from
    /// `f32` corners, two-sided.)
    ///
    /// `t` is that of the triangle's plane, not the corners' depths weighted: a sliver's weights cancel. The plane's normal
    /// does not: its terms are products of differences of `f32`, exact in `f64`, so that only their difference is rounded.
    fn intersect(&self, ray: &Ray, within: Interval) -> Option<Intersection> {
        let origin = ray.origin.as_dvec3();
        let direction = ray.direction.as_dvec3();
        let [weight_a, weight_b, weight_c] = {
            let [a, b, c] = self.corners.map(|corner| corner.as_dvec3() - origin);
            match largest_axis(ray.direction) {
                Axis::X => edge_functions([a.yzx(), b.yzx(), c.yzx()], direction.yzx()),
                Axis::Y => edge_functions([a.zxy(), b.zxy(), c.zxy()], direction.zxy()),
                Axis::Z => edge_functions([a, b, c], direction),
            }
        }?;
        let sum = weight_a + weight_b + weight_c;
        // Edge-on, or without area: there is no one place where they meet.
        if sum == 0.0 {
            return None;
        }
        let normal = self.scaled_normal();
        let t = (normal.dot(self.corners[0].as_dvec3() - origin) / normal.dot(direction)) as f32;
        if !within.contains(t) {
            return None;
        }
        let inverse = 1.0 / sum;
        Some(Intersection { t, u: (weight_b * inverse) as f32, v: (weight_c * inverse) as f32 })
    }

    fn surface(&self, _ray: &Ray, at: &Intersection) -> Surface {
        let position = self.point(at.u, at.v).as_vec3();
        let magnitude = self.bounds().magnitude();
        Surface::rounded(position, magnitude, self.scaled_normal().normalize().as_vec3())
    }

    /// The coordinates in the basis of the two edges from the first corner.
    fn uv(&self, _ray: &Ray, at: &Intersection) -> Vec2 {
        Vec2::new(at.u, at.v)
    }
}

/// The edge functions of corners seen from the origin, along a direction whose z is its largest component; `None` if they differ in
/// sign.
#[inline]
fn edge_functions(corners: [DVec3; 3], direction: DVec3) -> Option<[f64; 3]> {
    let [a, b, c] = corners.map(|corner| {
        let sheared = corner.truncate() * direction.z - direction.truncate() * corner.z;
        [sheared.x, sheared.y]
    });
    let edge = |from: [f64; 2], to: [f64; 2]| to[0] * from[1] - to[1] * from[0];
    let weights = [edge(b, c), edge(c, a), edge(a, b)];
    let all_positive = weights.iter().all(|&weight| weight >= 0.0);
    let all_negative = weights.iter().all(|&weight| weight <= 0.0);
    (all_positive || all_negative).then_some(weights)
}

enum Axis {
    X,
    Y,
    Z,
}

/// The axis of the component of largest magnitude; the first of equal ones.
fn largest_axis(direction: Vec3) -> Axis {
    let [x, y, z] = direction.abs().to_array();
    if x >= y && x >= z {
        Axis::X
    } else if y >= z {
        Axis::Y
    } else {
        Axis::Z
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RIGHT: Triangle = Triangle { corners: [Vec3::ZERO, Vec3::X, Vec3::Y] };

    fn down_at(x: f32, y: f32) -> Option<Intersection> {
        RIGHT.intersect(&Ray::new(Vec3::new(x, y, 2.0), -Vec3::Z), Interval::FORWARD)
    }

    #[test]
    fn u_and_v_are_the_weights_of_the_second_and_third_corner() {
        assert_eq!(down_at(0.25, 0.5), Some(Intersection { t: 2.0, u: 0.25, v: 0.5 }));
    }

    #[test]
    fn edges_and_corners_belong_to_the_triangle() {
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5), (0.5, 0.0), (0.0, 0.5)] {
            assert!(down_at(x, y).is_some(), "at {x}, {y}");
        }
        assert_eq!(down_at(-1e-6, 0.5), None);
        assert_eq!(down_at(0.6, 0.5), None);
    }

    #[test]
    fn it_is_met_from_behind_with_the_normal_still_to_the_front() {
        let ray = Ray::new(Vec3::new(0.2, 0.2, -1.0), Vec3::Z);
        let hit = RIGHT.intersect(&ray, Interval::FORWARD).unwrap();
        assert_eq!(hit.t, 1.0);
        assert_eq!(RIGHT.surface(&ray, &hit).geometric_normal, Vec3::Z);
    }

    #[test]
    fn no_area_or_no_direction_is_no_hit() {
        let needle = Triangle { corners: [Vec3::ZERO, Vec3::X, 2.0 * Vec3::X] };
        assert_eq!(needle.intersect(&Ray::new(Vec3::new(0.5, 0.0, 1.0), -Vec3::Z), Interval::FORWARD), None);
        assert_eq!(RIGHT.intersect(&Ray::new(Vec3::new(0.2, 0.2, 1.0), Vec3::ZERO), Interval::FORWARD), None);
    }
}
