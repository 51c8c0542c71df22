use glam::{DMat3, DVec3, Vec2, Vec3};

use crate::{
    Aabb, Ellipsoid, Intersection, Interval, Plane, Primitive, Ray, Sphere, Transform, Triangle,
    sphere::sphere_uv,
    triangle::{interpolated_normal, interpolated_uv},
};

/// How a ray meets a shape: the contract of [`Primitive::intersect`], as a plain function.
pub type Intersect<Shape> = fn(&Shape, &Ray, Interval) -> Option<Intersection>;

/// How a ray passes a box: the part of the interval that lies in it, `None` if nowhere.
pub type Clip = fn(&Aabb, &Ray, Interval) -> Option<Interval>;

/// The texture coordinates of a sphere in a direction from its centre, of any length but 0, in the space in which its axis is the z axis.
pub type SphereUv = fn(DVec3) -> Vec2;

/// The texture coordinates of a place on a plane: its offset from the plane's own point, however far.
pub type PlaneUv = fn(&Plane, DVec3) -> Vec2;

/// A triangle's texture coordinates of those of its corners, by the barycentric weights `u` and `v` of the second and third.
pub type TriangleUv = fn([Vec2; 3], f32, f32) -> Vec2;

/// The normal to shade a triangle with, of those of its corners, by the weights `u` and `v` of the second and third: a unit vector. The
/// corners' have any length; `None` if nothing is left of them.
pub type SmoothNormal = fn([Vec3; 3], f32, f32) -> Option<Vec3>;

/// The matrix that an affine map moves normals with, up to a positive factor. See [`Transform::normals`].
pub type NormalMatrix = fn(&Transform) -> DMat3;

/// How rays meet primitives, and what is seen where they do. Each part can be replaced alone; `None` is this crate's own, which is called directly.
///
/// ```
/// use geometry::{Intersection, Interval, Kernels, Primitive, Ray, Triangle};
///
/// /// Met from the front alone.
/// fn one_sided(triangle: &Triangle, ray: &Ray, within: Interval) -> Option<Intersection> {
///     let from_front = triangle.scaled_normal().dot(ray.direction.as_dvec3()) < 0.0;
///     triangle.intersect(ray, within).filter(|_| from_front)
/// }
///
/// let kernels = Kernels { triangle: Some(one_sided), ..Kernels::default() };
/// ```
///
/// A kernel returns an intersection strictly within the interval, and the same one for the same arguments. What follows from
/// it is not the kernel's: a sphere's, an ellipsoid's and a plane's surface is computed from the ray and `t`, a triangle's from
/// `u` and `v`.
///
/// Each has a kit of laws, with the name of its field: `geometry::sphere_conformance!(my_sphere);`, and so on; the box test's is
/// `geometry::aabb_conformance!`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Kernels {
    /// The nearer intersection that lies in the interval, from outside or inside; `u` and `v` are 0. In place of
    /// [`Sphere::intersect`].
    pub sphere: Option<Intersect<Sphere>>,
    /// As for the sphere. In place of [`Ellipsoid::intersect`].
    pub ellipsoid: Option<Intersect<Ellipsoid>>,
    /// From both sides; `u` and `v` are the barycentric weights of the second and third corner. An accelerator that packs triangles
    /// for a test of its own must not, where this is set: it asks [`crate::Primitives::intersect`] instead. In place of
    /// [`Triangle::intersect`].
    pub triangle: Option<Intersect<Triangle>>,
    /// From both sides; `u` and `v` are 0. In place of [`Plane::intersect`].
    pub plane: Option<Intersect<Plane>>,
    /// May return too much, never too little: what it leaves out is never asked. The octree asks it for each cell that it visits;
    /// its own way needs only the three planes through a cell's centre, with [`crate::BoxProbe`].
    pub aabb: Option<Clip>,
    /// `u` around the z axis from +x over +y, in 0..1; `v` from 0 at +z to 1 at -z. Of spheres and ellipsoids.
    pub sphere_uv: Option<SphereUv>,
    /// Both in 0..1, repeating.
    pub plane_uv: Option<PlaneUv>,
    /// As the corners': they may be less than 0 or more than 1, which the texture repeats.
    pub triangle_uv: Option<TriangleUv>,
    /// Of meshes that have normals of their own.
    pub smooth_normal: Option<SmoothNormal>,
    /// Of ellipsoids, and of meshes that have normals of their own.
    pub normal_matrix: Option<NormalMatrix>,
}

impl Kernels {
    /// A ray against a sphere.
    #[inline]
    pub fn meet_sphere(&self, sphere: &Sphere, ray: &Ray, within: Interval) -> Option<Intersection> {
        meet(self.sphere, sphere, ray, within)
    }

    /// A ray against an ellipsoid.
    #[inline]
    pub fn meet_ellipsoid(&self, ellipsoid: &Ellipsoid, ray: &Ray, within: Interval) -> Option<Intersection> {
        meet(self.ellipsoid, ellipsoid, ray, within)
    }

    /// A ray against a triangle.
    #[inline]
    pub fn meet_triangle(&self, triangle: &Triangle, ray: &Ray, within: Interval) -> Option<Intersection> {
        meet(self.triangle, triangle, ray, within)
    }

    /// A ray against a plane.
    #[inline]
    pub fn meet_plane(&self, plane: &Plane, ray: &Ray, within: Interval) -> Option<Intersection> {
        meet(self.plane, plane, ray, within)
    }

    /// The texture coordinates of a sphere in a direction from its centre.
    pub fn uv_of_sphere(&self, outward: DVec3) -> Vec2 {
        self.sphere_uv.map_or_else(|| sphere_uv(outward), |uv| uv(outward))
    }

    /// The texture coordinates of a plane where a ray meets it.
    pub fn uv_of_plane(&self, plane: &Plane, ray: &Ray) -> Vec2 {
        let offset = plane.offset(ray);
        self.plane_uv.map_or_else(|| plane.uv_at(offset), |uv| uv(plane, offset))
    }

    /// A triangle's texture coordinates of its corners'.
    pub fn uv_of_triangle(&self, corners: [Vec2; 3], u: f32, v: f32) -> Vec2 {
        self.triangle_uv.map_or_else(|| interpolated_uv(corners, u, v), |uv| uv(corners, u, v))
    }

    /// The normal to shade a triangle with, of its corners'.
    pub fn normal_between(&self, corners: [Vec3; 3], u: f32, v: f32) -> Option<Vec3> {
        self.smooth_normal.map_or_else(|| interpolated_normal(corners, u, v), |normal| normal(corners, u, v))
    }

    /// What moves normals as a map moves points.
    pub fn matrix_of_normals(&self, map: &Transform) -> DMat3 {
        self.normal_matrix.map_or_else(|| map.normals(), |matrix| matrix(map))
    }
}

/// By the kernel that was given, or the shape's own: a branch that is always taken the same way, not a call through a pointer.
#[inline]
fn meet<Shape: Primitive>(
    kernel: Option<Intersect<Shape>>,
    shape: &Shape,
    ray: &Ray,
    within: Interval,
) -> Option<Intersection> {
    match kernel {
        None => shape.intersect(ray, within),
        Some(kernel) => kernel(shape, ray, within),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Corners, Hit, Mesh, Primitives};

    const DOWN: Ray = Ray { origin: Vec3::new(0.25, 0.25, 5.0), direction: Vec3::NEG_Z };

    /// A sphere, an ellipsoid and a triangle, all met by [`DOWN`].
    fn one_of_each(kernels: Kernels) -> [bool; 3] {
        let mut primitives = Primitives::default().with_kernels(kernels);
        primitives.add_sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
        primitives.add_ellipsoid(Ellipsoid::new(Transform::IDENTITY).unwrap());
        primitives.add_mesh(Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        });
        // A subset keeps the kernels.
        let primitives = primitives.subset(|_| true);
        [0, 1, 2].map(|number| primitives.intersect(number, &DOWN, Interval::FORWARD).is_some())
    }

    #[test]
    fn each_kernel_is_replaced_alone() {
        let own = Kernels::default();
        assert_eq!(one_of_each(own), [true, true, true]);
        assert_eq!(one_of_each(Kernels { sphere: Some(|_, _, _| None), ..own }), [false, true, true]);
        assert_eq!(one_of_each(Kernels { ellipsoid: Some(|_, _, _| None), ..own }), [true, false, true]);
        assert_eq!(one_of_each(Kernels { triangle: Some(|_, _, _| None), ..own }), [true, true, false]);
        let floor = Plane::from_normal(Vec3::ZERO, Vec3::Z).unwrap();
        assert!(own.meet_plane(&floor, &DOWN, Interval::FORWARD).is_some());
        let none = Kernels { plane: Some(|_, _, _| None), ..own };
        assert!(none.meet_plane(&floor, &DOWN, Interval::FORWARD).is_none());
    }

    #[test]
    fn each_way_to_find_a_place_in_a_texture_is_replaced_alone() {
        let uvs = |kernels: Kernels| {
            let mut primitives = Primitives::default().with_kernels(kernels);
            primitives.add_sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
            primitives.add_ellipsoid(Ellipsoid::new(Transform::IDENTITY).unwrap());
            for uvs in [Corners::None, Corners::Everywhere(Vec2::splat(0.5))] {
                let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
                primitives.add_mesh(Mesh { positions, triangles: vec![[0, 1, 2]], uvs, ..Mesh::default() });
            }
            let uv = |number| primitives.uv(&DOWN, &primitives.intersect(number, &DOWN, Interval::FORWARD).unwrap());
            let floor = Plane::from_normal(Vec3::ZERO, Vec3::Z).unwrap();
            [0, 1, 2, 3].map(uv).into_iter().chain([kernels.uv_of_plane(&floor, &DOWN)]).collect::<Vec<_>>()
        };
        let own = Kernels::default();
        let [sphere, ellipsoid, bare, mesh, plane] = uvs(own)[..] else { panic!("five") };
        let mine = Vec2::splat(7.0);
        assert_eq!(uvs(Kernels { sphere_uv: Some(|_| Vec2::splat(7.0)), ..own }), [mine, mine, bare, mesh, plane]);
        let triangle = Kernels { triangle_uv: Some(|_, _, _| Vec2::splat(7.0)), ..own };
        assert_eq!(uvs(triangle), [sphere, ellipsoid, mine, mine, plane]);
        let plane = Kernels { plane_uv: Some(|_, _| Vec2::splat(7.0)), ..own };
        assert_eq!(uvs(plane), [sphere, ellipsoid, bare, mesh, mine]);
    }

    #[test]
    fn normals_are_turned_and_interpolated_by_whoever_is_asked_to() {
        let normals = |kernels: Kernels| {
            let mut primitives = Primitives::default().with_kernels(kernels);
            primitives.add_ellipsoid(Ellipsoid::new(Transform::IDENTITY).unwrap());
            primitives.add_mesh(Mesh {
                positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
                triangles: vec![[0, 1, 2]],
                normals: Corners::Everywhere(Vec3::Y),
                ..Mesh::default()
            });
            let above = Ray { origin: Vec3::new(0.0, 0.0, 5.0), ..DOWN };
            [0, 1].map(|number| {
                let hit: Hit = primitives.intersect(number, &above, Interval::FORWARD).unwrap();
                primitives.surface(&above, &hit).shading_normal
            })
        };
        let own = Kernels::default();
        assert_eq!(normals(own), [Vec3::Z, Vec3::Y]);
        let turned = Kernels { normal_matrix: Some(|map| -map.normals()), ..own };
        assert_eq!(normals(turned), [-Vec3::Z, Vec3::Y]);
        assert_eq!(normals(Kernels { smooth_normal: Some(|_, _, _| Some(Vec3::X)), ..own }), [Vec3::Z, Vec3::X]);
    }
}
