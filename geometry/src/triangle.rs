use glam::{DVec3, Vec2, Vec3};

use crate::{Aabb, Intersection, Interval, Primitive, Ray, Surface, TriangleProbe};

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

/// Texture coordinates between those of the corners, interpolated in `f64` and rounded once.
pub(crate) fn interpolated_uv(corners: [Vec2; 3], u: f32, v: f32) -> Vec2 {
    let uv = interpolate(corners.map(|uv| DVec3::new(f64::from(uv.x), f64::from(uv.y), 0.0)), u, v);
    Vec2::new(uv.x as f32, uv.y as f32)
}

/// The normal between those of the corners, made a unit vector again; `None` where they cancel.
pub(crate) fn interpolated_normal(corners: [Vec3; 3], u: f32, v: f32) -> Option<Vec3> {
    interpolate(corners.map(|normal| normal.as_dvec3()), u, v).try_normalize().map(|normal| normal.as_vec3())
}

impl Primitive for Triangle {
    #[inline]
    fn bounds(&self) -> Aabb {
        let [a, b, c] = self.corners;
        Aabb { min: a.min(b).min(c), max: a.max(b).max(c) }
    }

    /// See [`TriangleProbe`], which does it.
    fn intersect(&self, ray: &Ray, within: Interval) -> Option<Intersection> {
        let probe = TriangleProbe::new(ray);
        probe.intersect(self.corners.map(|corner| probe.turned(corner)), within)
    }

    /// The point is on the triangle's plane to 7 u of the greatest coordinate, u = 2^-24, whatever its shape: the mean of the corners,
    /// not `o + t d`, which on slivers is 255,000 u off.
    fn surface(&self, _ray: &Ray, at: &Intersection) -> Surface {
        let position = self.point(at.u, at.v).as_vec3();
        let magnitude = self.corners.map(|corner| corner.abs().max_element()).into_iter().fold(0.0, f32::max);
        Surface::rounded(position, magnitude, self.scaled_normal().normalize().as_vec3())
    }

    /// The coordinates in the basis of the two edges from the first corner.
    fn uv(&self, _ray: &Ray, at: &Intersection) -> Vec2 {
        Vec2::new(at.u, at.v)
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
        assert_eq!(RIGHT.uv(&ray, &hit), Vec2::splat(0.2));
    }

    #[test]
    fn no_area_or_no_direction_is_no_hit() {
        let needle = Triangle { corners: [Vec3::ZERO, Vec3::X, 2.0 * Vec3::X] };
        assert_eq!(needle.intersect(&Ray::new(Vec3::new(0.5, 0.0, 1.0), -Vec3::Z), Interval::FORWARD), None);
        assert_eq!(RIGHT.intersect(&Ray::new(Vec3::new(0.2, 0.2, 1.0), Vec3::ZERO), Interval::FORWARD), None);
    }
}
