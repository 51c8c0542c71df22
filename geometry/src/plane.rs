use glam::{DVec3, Vec2, Vec3};

use crate::{Aabb, Intersection, Interval, Primitive, Ray, Surface};

/// The edge of one copy of the texture on a plane given by point and normal, in the scene's units.
pub const PLANE_TEXTURE_SIZE: f64 = 10.0;

/// An infinite plane; the texture repeats over it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    point: Vec3,
    normal: DVec3,
    /// `u` and `v` of a point are the products of these with its offset from `point`.
    gradients: [DVec3; 2],
}

impl Plane {
    /// The plane through a point, perpendicular to a normal of any length; `None` if the normal is zero or not finite.
    ///
    /// The texture stands upright on a wall (`v` along +y as far as the plane allows), and on a floor or ceiling `u` runs
    /// along +x; it starts at the point and repeats every [`PLANE_TEXTURE_SIZE`].
    pub fn from_normal(point: Vec3, normal: Vec3) -> Option<Self> {
        let normal = normal.as_dvec3().try_normalize()?;
        let is_floor = normal.y.abs() > normal.x.abs().max(normal.z.abs());
        let up = if is_floor { -DVec3::Z * normal.y.signum() } else { DVec3::Y };
        let v = (up - normal * up.dot(normal)).normalize();
        let u = v.cross(normal);
        Some(Self { point, normal, gradients: [u / PLANE_TEXTURE_SIZE, v / PLANE_TEXTURE_SIZE] })
    }

    /// The plane through three points, which span the texture: `u` runs from the first to the second, `v` from the first to the
    /// third, one copy for each edge's length. `None` if the points lie on a line.
    pub fn from_points(point: Vec3, along_u: Vec3, along_v: Vec3) -> Option<Self> {
        let u = along_u.as_dvec3() - point.as_dvec3();
        let v = along_v.as_dvec3() - point.as_dvec3();
        let cross = u.cross(v);
        let normal = cross.try_normalize()?;
        // The dual basis: each gradient is perpendicular to the other edge, and 1 along its own.
        let length_squared = cross.dot(cross);
        Some(Self { point, normal, gradients: [v.cross(cross) / length_squared, cross.cross(u) / length_squared] })
    }

    /// A point of it.
    pub fn point(&self) -> Vec3 {
        self.point
    }

    /// Its normal, a unit vector to its front.
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// What `u` and `v` grow by along each axis: their products with an offset from [`Self::point`] are how many copies of the texture
    /// lie on the way.
    pub fn gradients(&self) -> [DVec3; 2] {
        self.gradients
    }

    /// The texture coordinates at an offset from [`Self::point`], each in 0..1.
    pub fn uv_at(&self, offset: DVec3) -> Vec2 {
        Vec2::new(repeat(self.gradients[0].dot(offset)), repeat(self.gradients[1].dot(offset)))
    }

    /// From [`Self::point`] to where a ray's line meets the plane.
    pub(crate) fn offset(&self, ray: &Ray) -> DVec3 {
        // The difference of what is given is exact, or nearly so; that of the hit point would lose what is small beside it.
        let to_origin = ray.origin.as_dvec3() - self.point.as_dvec3();
        to_origin + ray.direction.as_dvec3() * self.t(ray)
    }

    /// The same plane, all of which shows the texture's place (0, 0).
    #[must_use]
    pub fn without_texture_coordinates(self) -> Self {
        Self { gradients: [DVec3::ZERO; 2], ..self }
    }

    /// The same plane under an affine map; `None` if the map has no inverse.
    pub fn transformed(&self, by: &crate::Transform) -> Option<Self> {
        let to_local = by.inverse()?.linear.transpose();
        Some(Self {
            point: by.point_f32(self.point),
            normal: (by.normals() * self.normal).try_normalize()?,
            gradients: self.gradients.map(|gradient| to_local * gradient),
        })
    }

    /// Where the line meets the plane, in `f64`: `n.(p - o) / n.d`, right to 0.51 ulp of `f32`. Never by a small `n.d` alone is a hit
    /// turned down. `(h - n.o) / n.d` would subtract what is large; a plane's point far beside a nearly parallel ray costs
    /// `f64` a few roundings of the way between them over the cosine.
    fn t(&self, ray: &Ray) -> f64 {
        let offset = self.point.as_dvec3() - ray.origin.as_dvec3();
        self.normal.dot(offset) / self.normal.dot(ray.direction.as_dvec3())
    }
}

impl Primitive for Plane {
    fn bounds(&self) -> Aabb {
        Aabb::EVERYTHING
    }

    fn intersect(&self, ray: &Ray, within: Interval) -> Option<Intersection> {
        let t = self.t(ray) as f32;
        // A parallel ray makes an infinity or a NaN, which no interval contains.
        within.contains(t).then(|| Intersection::at(t))
    }

    /// The point is on the plane to 8 u of the greatest coordinate of it and of the plane's point, u = 2^-24.
    fn surface(&self, ray: &Ray, _at: &Intersection) -> Surface {
        let position = ray.at(self.t(ray));
        // What rounding left of the distance to the plane is taken off once more.
        let off = self.normal.dot(position - self.point.as_dvec3());
        let position = (position - self.normal * off).as_vec3();
        let magnitude = self.point.abs().max(position.abs()).max_element();
        Surface::rounded(position, magnitude, self.normal.as_vec3())
    }

    fn uv(&self, ray: &Ray, _at: &Intersection) -> Vec2 {
        self.uv_at(self.offset(ray))
    }
}

/// The fraction in 0..1, taken before narrowing to `f32`: far out the whole part would eat the fraction's digits. Right to half an
/// ulp of 1, 3.1e-8 of a copy, where `f32` would be off by half a copy 1e7 copies out.
fn repeat(coordinate: f64) -> f32 {
    let fraction = (coordinate - coordinate.floor()) as f32;
    // A tiny negative number, and rounding up, give 1, which is 0 of the next copy.
    if fraction < 1.0 { fraction } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_knows_the_point_that_it_was_given() {
        let point = Vec3::new(1.0, 2.0, 3.0);
        assert_eq!(Plane::from_normal(point, Vec3::Z).map(|plane| plane.point()), Some(point));
    }

    #[test]
    fn a_plane_is_met_from_both_sides_and_never_by_a_parallel_ray() {
        let floor = Plane::from_normal(Vec3::ZERO, Vec3::new(0.0, 0.0, 2.0)).unwrap();
        for (z, direction) in [(3.0, -Vec3::Z), (-3.0, Vec3::Z)] {
            let ray = Ray::new(Vec3::new(0.0, 0.0, z), direction);
            assert_eq!(floor.intersect(&ray, Interval::FORWARD), Some(Intersection::at(3.0)));
        }
        for z in [0.0, 1.0] {
            assert_eq!(floor.intersect(&Ray::new(Vec3::new(0.0, 0.0, z), Vec3::X), Interval::FORWARD), None);
        }
    }

    #[test]
    fn a_plane_moves_with_its_points_and_its_texture() {
        let floor = Plane::from_normal(Vec3::ZERO, Vec3::Z).unwrap();
        let by = crate::Transform::scale(DVec3::new(2.0, 1.0, 3.0))
            .then(&crate::Transform::translation(DVec3::new(0.0, 0.0, 1.0)));
        let moved = floor.transformed(&by).unwrap();
        let ray = Ray::new(Vec3::new(0.0, 0.0, 5.0), -Vec3::Z);
        assert_eq!(moved.intersect(&ray, Interval::FORWARD), Some(Intersection::at(4.0)));
        assert_eq!(uv_below(&moved, 1.0, 0.25), uv_below(&floor, 0.5, 0.25));
        assert_eq!(floor.transformed(&crate::Transform::scale(DVec3::ZERO)).map(|_| ()), None);
    }

    fn uv_below(plane: &Plane, x: f32, y: f32) -> Vec2 {
        let ray = Ray::new(Vec3::new(x, y, 5.0), -Vec3::Z);
        plane.uv(&ray, &plane.intersect(&ray, Interval::FORWARD).unwrap())
    }

    #[test]
    fn the_texture_of_a_plane_by_normal_repeats_every_ten_units() {
        let floor = Plane::from_normal(Vec3::ZERO, Vec3::Z).unwrap();
        assert_eq!(uv_below(&floor, 2.5, 5.0), Vec2::new(0.25, 0.5));
        assert_eq!(uv_below(&floor, 12.5, -5.0), Vec2::new(0.25, 0.5));
        assert_eq!(uv_below(&floor, -1e-9, 0.0).x, 0.0);
        assert_eq!(uv_below(&floor.without_texture_coordinates(), 2.5, 5.0), Vec2::ZERO);
    }

    #[test]
    fn a_slope_between_floor_and_wall_counts_as_a_wall() {
        let slope = Plane::from_normal(Vec3::ZERO, Vec3::new(1.0, 1.0, 0.0)).unwrap();
        let [u, v] = slope.gradients();
        // v runs up the slope, towards +y.
        assert!(v.y > 0.0 && v.x < 0.0 && u.z < 0.0, "{u} {v}");
    }

    #[test]
    fn three_points_span_one_copy_of_the_texture() {
        let skew = Plane::from_points(Vec3::ZERO, Vec3::new(2.0, 0.0, 0.0), Vec3::new(1.0, 4.0, 0.0)).unwrap();
        // (1, 0, 0) is half of the first edge; (0.5, 2, 0) half of the second.
        assert_eq!(uv_below(&skew, 1.0, 0.0), Vec2::new(0.5, 0.0));
        assert_eq!(uv_below(&skew, 0.5, 2.0), Vec2::new(0.0, 0.5));
        assert_eq!(Plane::from_points(Vec3::ZERO, Vec3::X, 2.0 * Vec3::X), None);
    }
}
