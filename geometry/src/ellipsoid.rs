use glam::{DMat3, DVec3, Vec2, Vec3};

use crate::{
    Aabb, Intersection, Interval, Primitive, Ray, Surface, Transform,
    rounding::{round_down, round_up},
    sphere::{first_within, line_meets_sphere, root_nearest, sphere_uv},
};

/// The unit sphere under an affine map: turned, stretched, sheared. Its texture turns with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    to_world: Transform,
    to_unit: Transform,
}

impl Ellipsoid {
    /// The unit sphere at the origin, placed by a map; `None` if the map has no inverse.
    pub fn new(to_world: Transform) -> Option<Self> {
        Some(Self { to_world, to_unit: to_world.inverse()? })
    }

    /// What places the unit sphere.
    pub fn to_world(&self) -> &Transform {
        &self.to_world
    }

    /// The way back.
    pub fn to_unit(&self) -> &Transform {
        &self.to_unit
    }

    /// The ray as the unit sphere sees it. The translation is taken off first, before anything is scaled: far from the origin
    /// the products of a folded matrix would cancel.
    fn unit_roots(&self, ray: &Ray) -> Option<[f64; 2]> {
        let from_center = self.to_unit.linear * (ray.origin.as_dvec3() - self.to_world.translation);
        let power = || from_center.dot(from_center) - 1.0;
        line_meets_sphere(from_center, self.to_unit.linear * ray.direction.as_dvec3(), 1.0, power)
    }

    /// The surface at an intersection, its normal moved by the matrix that is made of the map.
    pub(crate) fn surface_by(
        &self,
        ray: &Ray,
        at: &Intersection,
        normals: impl FnOnce(&Transform) -> DMat3,
    ) -> Surface {
        let unit = self.unit_point(ray, at);
        let position = self.to_world.point(unit).as_vec3();
        let normal = (normals(&self.to_world) * unit).normalize();
        let distance = self.distance(position, normal) as f32;
        Surface::rounded(position, self.bounds().magnitude(), normal.as_vec3()).off_by(distance)
    }

    /// How far a point near the surface is from it along a normal, to first order: the equation's value over its derivative. At
    /// most a quarter of the way through the body.
    fn distance(&self, point: Vec3, normal: DVec3) -> f64 {
        let unit = self.to_unit.linear * (point.as_dvec3() - self.to_world.translation);
        let across = self.to_unit.linear * normal;
        let slope = unit.dot(across).abs();
        ((unit.length_squared() - 1.0).abs() / (2.0 * slope)).min(0.5 * slope / across.length_squared())
    }

    /// The point of the unit sphere at an intersection.
    pub(crate) fn unit_point(&self, ray: &Ray, at: &Intersection) -> DVec3 {
        let t = root_nearest(self.unit_roots(ray), at.t);
        (self.to_unit.linear * (ray.at(t) - self.to_world.translation)).normalize()
    }
}

impl Primitive for Ellipsoid {
    /// The map's rows are the gradients of the world's coordinates: the unit sphere reaches as far as their lengths.
    fn bounds(&self) -> Aabb {
        let rows = self.to_world.linear.transpose();
        // A last few bits for the rounding of the lengths themselves.
        let reach =
            DVec3::new(rows.x_axis.length(), rows.y_axis.length(), rows.z_axis.length()) * (1.0 + 8.0 * f64::EPSILON);
        Aabb { min: round_down(self.to_world.translation - reach), max: round_up(self.to_world.translation + reach) }
    }

    /// As for the sphere, as the unit sphere sees it: a rounding of `f64` is multiplied by the map's condition number. A translation
    /// of 1e6 costs nothing.
    fn intersect(&self, ray: &Ray, within: Interval) -> Option<Intersection> {
        first_within(self.unit_roots(ray)?, within)
    }

    fn surface(&self, ray: &Ray, at: &Intersection) -> Surface {
        self.surface_by(ray, at, Transform::normals)
    }

    fn uv(&self, ray: &Ray, at: &Intersection) -> Vec2 {
        sphere_uv(self.unit_point(ray, at))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stretched_sphere_is_met_where_its_equation_says() {
        // x^2 / 9 + y^2 + z^2 = 1 along the x axis: x = -3.
        let ellipsoid = Ellipsoid::new(Transform::scale(DVec3::new(3.0, 1.0, 1.0))).unwrap();
        let ray = Ray::new(Vec3::new(-5.0, 0.0, 0.0), Vec3::X);
        let hit = ellipsoid.intersect(&ray, Interval::FORWARD).unwrap();
        assert_eq!(hit.t, 2.0);
        assert_eq!(ellipsoid.surface(&ray, &hit).geometric_normal, -Vec3::X);
    }

    #[test]
    fn the_box_is_a_rounding_too_wide_and_no_more() {
        let map = Transform::scale(DVec3::new(3.0, 2.0, 1.0)).then(&Transform::translation(DVec3::new(0.0, 4.0, -8.0)));
        let Aabb { min, max } = Ellipsoid::new(map).unwrap().bounds();
        let (low, high) = (Vec3::new(-3.0, 2.0, -9.0), Vec3::new(3.0, 6.0, -7.0));
        assert!(min.cmplt(low).all() && high.cmplt(max).all());
        assert!((low - min).max(max - high).max_element() < 1e-6, "{min} to {max}");
    }

    #[test]
    fn a_points_distance_is_the_equations_value_over_its_derivative() {
        for scale in [1.0, 4.0] {
            let ellipsoid = Ellipsoid::new(Transform::scale(DVec3::splat(scale))).unwrap();
            let distance = |x: f64| ellipsoid.distance(Vec3::new((scale * x) as f32, 0.0, 0.0), DVec3::X) / scale;
            // x^2 - 1 over 2x.
            assert!((distance(1.001) - 0.001).abs() < 1e-6);
            assert!((distance(0.5) - 0.25).abs() < 1e-6, "no more than x/2: the quotient is 0.75");
        }
    }

    #[test]
    fn the_texture_turns_with_the_sphere() {
        // The north pole (v = 0) turned onto +x.
        let turned = Ellipsoid::new(Transform::rotation(DVec3::Y, 90.0)).unwrap();
        let ray = Ray::new(Vec3::new(5.0, 0.0, 0.0), -Vec3::X);
        let hit = turned.intersect(&ray, Interval::FORWARD).unwrap();
        assert_eq!(turned.uv(&ray, &hit).y, 0.0);
    }

    #[test]
    fn a_mirrored_sphere_keeps_its_normals_outward() {
        let mirrored = Ellipsoid::new(Transform::scale(DVec3::new(-1.0, 2.0, 1.0))).unwrap();
        let ray = Ray::new(Vec3::new(5.0, 0.0, 0.0), -Vec3::X);
        let hit = mirrored.intersect(&ray, Interval::FORWARD).unwrap();
        assert_eq!(mirrored.surface(&ray, &hit).geometric_normal, Vec3::X);
    }
}
