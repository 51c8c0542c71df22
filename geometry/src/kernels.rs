use crate::{Aabb, Ellipsoid, Intersection, Interval, Plane, Primitive, Ray, Sphere, Triangle};

/// How a ray meets a shape: the contract of [`Primitive::intersect`], as a plain function.
pub type Intersect<Shape> = fn(&Shape, &Ray, Interval) -> Option<Intersection>;

/// How a ray passes a box: the part of the interval that lies in it, `None` if nowhere.
pub type Clip = fn(&Aabb, &Ray, Interval) -> Option<Interval>;

/// How rays meet primitives. Each part can be replaced alone; `None` is this crate's own, which is called directly.
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
    use crate::{Mesh, Primitives, Transform};
    use glam::Vec3;

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
}
