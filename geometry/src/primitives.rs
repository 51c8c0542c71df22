use std::sync::Arc;

use glam::Vec2;

use crate::{
    Aabb, Corners, Ellipsoid, Hit, Interval, Kernels, Mesh, Primitive, Ray, Sphere, Surface, Triangle,
    mesh::MeshCorners,
};

/// The bounded primitives of a scene, numbered from 0 in the order in which they were added.
///
/// Cheap to [`Self::subset`]: the shapes themselves are shared.
#[derive(Clone, Debug, Default)]
pub struct Primitives {
    shapes: Arc<Shapes>,
    numbered: Vec<Number>,
    kernels: Kernels,
}

#[derive(Clone, Debug, Default)]
struct Shapes {
    spheres: Vec<Sphere>,
    ellipsoids: Vec<Ellipsoid>,
    /// The triangles of all meshes, one mesh after the other, with their corners in place: one load for a test.
    triangles: Vec<Triangle>,
    meshes: Vec<MeshCorners>,
}

/// A triangle's own texture coordinates: its two edges from the first corner are the basis.
const EDGES: [Vec2; 3] = [Vec2::ZERO, Vec2::X, Vec2::Y];

/// How many primitives of each kind there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PrimitiveCount {
    /// Spheres that are neither turned nor stretched.
    pub spheres: usize,
    /// Spheres that are.
    pub ellipsoids: usize,
    /// Triangles of meshes and cubes.
    pub triangles: usize,
}

impl PrimitiveCount {
    /// How many there are of all kinds.
    pub fn total(self) -> usize {
        self.spheres + self.ellipsoids + self.triangles
    }
}

/// Which shape has a primitive's number.
#[derive(Clone, Copy, Debug)]
enum Number {
    Sphere(u32),
    Ellipsoid(u32),
    Triangle(u32),
}

impl Primitives {
    /// The same primitives, met by other kernels.
    #[must_use]
    pub fn with_kernels(self, kernels: Kernels) -> Self {
        Self { kernels, ..self }
    }

    /// What rays meet them with.
    pub fn kernels(&self) -> &Kernels {
        &self.kernels
    }

    /// How many there are.
    pub fn len(&self) -> u32 {
        self.numbered.len() as u32
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.numbered.is_empty()
    }

    /// Adds a sphere.
    pub fn add_sphere(&mut self, sphere: Sphere) {
        let spheres = &mut Arc::make_mut(&mut self.shapes).spheres;
        self.numbered.push(Number::Sphere(spheres.len() as u32));
        spheres.push(sphere);
    }

    /// Adds an ellipsoid.
    pub fn add_ellipsoid(&mut self, ellipsoid: Ellipsoid) {
        let ellipsoids = &mut Arc::make_mut(&mut self.shapes).ellipsoids;
        self.numbered.push(Number::Ellipsoid(ellipsoids.len() as u32));
        ellipsoids.push(ellipsoid);
    }

    /// Adds a mesh: its triangles get one number each, in order.
    ///
    /// # Panics
    /// If an index is not below the number of points, or values per point or triangle are fewer than these.
    pub fn add_mesh(&mut self, mesh: Mesh) {
        let Mesh { positions, triangles, normals, uvs } = mesh;
        for count in [normals.missing(&positions, &triangles), uvs.missing(&positions, &triangles)] {
            assert_eq!(count, 0, "a value for every corner");
        }
        let shapes = Arc::make_mut(&mut self.shapes);
        let first_triangle = shapes.triangles.len() as u32;
        let corners =
            triangles.iter().map(|&indices| Triangle { corners: indices.map(|index| positions[index as usize]) });
        shapes.triangles.extend(corners);
        self.numbered.extend((first_triangle..shapes.triangles.len() as u32).map(Number::Triangle));
        let per_point = matches!(normals, Corners::PerPoint(_)) || matches!(uvs, Corners::PerPoint(_));
        let point_indices = if per_point { triangles } else { Vec::new() };
        shapes.meshes.push(MeshCorners { first_triangle, point_indices, normals, uvs });
    }

    /// Those whose number passes, renumbered from 0.
    #[must_use]
    pub fn subset(&self, keep: impl Fn(u32) -> bool) -> Self {
        let numbered = (0..).zip(&self.numbered).filter(|&(number, _)| keep(number)).map(|(_, &shape)| shape).collect();
        Self { shapes: Arc::clone(&self.shapes), numbered, kernels: self.kernels }
    }

    /// A box around one.
    #[inline]
    pub fn bounds(&self, number: u32) -> Aabb {
        match self.numbered[number as usize] {
            Number::Triangle(index) => self.shapes.triangles[index as usize].bounds(),
            _ => self.shape(number).bounds(),
        }
    }

    /// A triangle's corners, for accelerators that pack them; `None` for other shapes.
    pub fn triangle(&self, number: u32) -> Option<&Triangle> {
        match self.numbered[number as usize] {
            Number::Triangle(index) => Some(&self.shapes.triangles[index as usize]),
            _ => None,
        }
    }

    /// A sphere that is met by its own kernel, for accelerators that ask it with one of theirs; `None` for other shapes.
    #[inline]
    pub fn sphere(&self, number: u32) -> Option<&Sphere> {
        match self.numbered[number as usize] {
            Number::Sphere(index) if self.kernels.sphere.is_none() => Some(&self.shapes.spheres[index as usize]),
            _ => None,
        }
    }

    /// The nearest hit of one, strictly within the interval.
    #[inline]
    pub fn intersect(&self, number: u32, ray: &Ray, within: Interval) -> Option<Hit> {
        let Self { shapes, kernels, .. } = self;
        let met = match self.numbered[number as usize] {
            Number::Triangle(index) => kernels.meet_triangle(&shapes.triangles[index as usize], ray, within),
            Number::Sphere(index) => kernels.meet_sphere(&shapes.spheres[index as usize], ray, within),
            Number::Ellipsoid(index) => kernels.meet_ellipsoid(&shapes.ellipsoids[index as usize], ray, within),
        };
        met.map(|met| met.on(number))
    }

    /// The surface at a hit that [`Self::intersect`] has found for the same ray; a mesh's own normals are interpolated.
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let at = hit.intersection();
        let mut surface = match self.numbered[hit.primitive as usize] {
            Number::Triangle(index) => self.shapes.triangles[index as usize].surface(ray, &at),
            Number::Sphere(index) => self.shapes.spheres[index as usize].surface(ray, &at),
            Number::Ellipsoid(index) => {
                self.shapes.ellipsoids[index as usize].surface_by(ray, &at, |map| self.kernels.matrix_of_normals(map))
            }
        };
        let normals = self.mesh_corners(hit.primitive, |mesh| &mesh.normals);
        if let Some(normal) = normals.and_then(|normals| self.kernels.normal_between(normals, at.u, at.v)) {
            surface.shading_normal = normal;
        }
        surface
    }

    /// The texture coordinates at a hit; a mesh's own are interpolated.
    pub fn uv(&self, ray: &Ray, hit: &Hit) -> Vec2 {
        let (at, kernels) = (hit.intersection(), &self.kernels);
        match self.numbered[hit.primitive as usize] {
            Number::Sphere(index) => kernels.uv_of_sphere(self.shapes.spheres[index as usize].outward(ray, &at)),
            Number::Ellipsoid(index) => {
                kernels.uv_of_sphere(self.shapes.ellipsoids[index as usize].unit_point(ray, &at))
            }
            Number::Triangle(_) => {
                let given = self.mesh_corners(hit.primitive, |mesh| &mesh.uvs);
                kernels.uv_of_triangle(given.unwrap_or(EDGES), at.u, at.v)
            }
        }
    }

    /// How many of them are spheres, ellipsoids and triangles.
    pub fn count(&self) -> PrimitiveCount {
        let mut count = PrimitiveCount::default();
        for number in &self.numbered {
            match number {
                Number::Sphere(_) => count.spheres += 1,
                Number::Ellipsoid(_) => count.ellipsoids += 1,
                Number::Triangle(_) => count.triangles += 1,
            }
        }
        count
    }

    /// The memory that the primitives take, in bytes.
    pub fn bytes(&self) -> usize {
        let shapes = &self.shapes;
        size_of_val(&self.numbered[..])
            + size_of_val(&shapes.spheres[..])
            + size_of_val(&shapes.ellipsoids[..])
            + size_of_val(&shapes.triangles[..])
            + shapes.meshes.iter().map(MeshCorners::bytes).sum::<usize>()
    }

    fn shape(&self, number: u32) -> &dyn Primitive {
        match self.numbered[number as usize] {
            Number::Sphere(index) => &self.shapes.spheres[index as usize],
            Number::Ellipsoid(index) => &self.shapes.ellipsoids[index as usize],
            Number::Triangle(index) => &self.shapes.triangles[index as usize],
        }
    }

    /// The values at the corners of a triangle, if it is one and its mesh has them.
    fn mesh_corners<T: Copy>(&self, number: u32, values: impl Fn(&MeshCorners) -> &Corners<T>) -> Option<[T; 3]> {
        let Number::Triangle(index) = self.numbered[number as usize] else { return None };
        let mesh = &self.shapes.meshes[self.shapes.meshes.partition_point(|mesh| mesh.first_triangle <= index) - 1];
        let face = (index - mesh.first_triangle) as usize;
        values(mesh).of(face, mesh.point_indices.get(face).copied().unwrap_or_default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    fn two_meshes_and_a_sphere() -> Primitives {
        let corners = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
        let mut primitives = Primitives::default();
        primitives.add_mesh(Mesh { positions: corners.clone(), triangles: vec![[0, 1, 2]], ..Mesh::default() });
        primitives.add_sphere(Sphere { center: Vec3::new(0.0, 0.0, -9.0), radius: 1.0 });
        primitives.add_mesh(Mesh {
            positions: corners.iter().map(|&corner| corner - Vec3::Z).collect(),
            triangles: vec![[0, 1, 2]],
            normals: Corners::PerPoint(vec![Vec3::X, Vec3::X, Vec3::X]),
            uvs: Corners::PerTriangle(vec![[Vec2::ZERO, Vec2::new(4.0, 0.0), Vec2::new(0.0, 4.0)]]),
        });
        primitives
    }

    const DOWN: Ray = Ray { origin: Vec3::new(0.25, 0.25, 1.0), direction: Vec3::NEG_Z };

    #[test]
    fn each_shape_has_the_number_of_its_turn() {
        let primitives = two_meshes_and_a_sphere();
        assert_eq!(primitives.len(), 3);
        assert_eq!(primitives.count(), PrimitiveCount { spheres: 1, ellipsoids: 0, triangles: 2 });
        let t: Vec<_> =
            (0..3).map(|number| primitives.intersect(number, &DOWN, Interval::FORWARD).map(|hit| hit.t)).collect();
        assert_eq!((t[0], t[2]), (Some(1.0), Some(2.0)));
        assert!(t[1].is_some_and(|t| t > 9.0));
    }

    #[test]
    fn a_mesh_has_its_own_normals_and_texture_coordinates_and_others_the_triangles_own() {
        let primitives = two_meshes_and_a_sphere();
        let at = |number| primitives.intersect(number, &DOWN, Interval::FORWARD).unwrap();
        assert_eq!(primitives.surface(&DOWN, &at(0)).shading_normal, Vec3::Z);
        assert_eq!(primitives.uv(&DOWN, &at(0)), Vec2::new(0.25, 0.25));
        assert_eq!(primitives.surface(&DOWN, &at(2)).shading_normal, Vec3::X);
        assert_eq!(primitives.surface(&DOWN, &at(2)).geometric_normal, Vec3::Z);
        assert_eq!(primitives.uv(&DOWN, &at(2)), Vec2::new(1.0, 1.0));
    }

    #[test]
    fn each_kind_of_shape_is_counted_and_handed_out_as_what_it_is() {
        let mut primitives = two_meshes_and_a_sphere();
        assert!(!primitives.is_empty() && Primitives::default().is_empty());
        primitives.add_ellipsoid(Ellipsoid::new(crate::Transform::IDENTITY).unwrap());
        primitives.add_ellipsoid(Ellipsoid::new(crate::Transform::IDENTITY).unwrap());
        assert_eq!(primitives.count(), PrimitiveCount { spheres: 1, ellipsoids: 2, triangles: 2 });
        assert_eq!(PrimitiveCount { spheres: 1, ellipsoids: 20, triangles: 300 }.total(), 321);
        let triangles = [0, 1, 2, 3, 4].map(|number| primitives.triangle(number).map(|triangle| triangle.corners[0]));
        assert_eq!(triangles, [Some(Vec3::ZERO), None, Some(-Vec3::Z), None, None]);
        let spheres = |primitives: &Primitives| [0, 1, 2, 3, 4].map(|number| primitives.sphere(number).is_some());
        assert_eq!(spheres(&primitives), [false, true, false, false, false]);
        // One that is met by another kernel is not for an accelerator's own.
        let swapped = primitives.with_kernels(Kernels { sphere: Some(|_, _, _| None), ..Kernels::default() });
        assert!(swapped.kernels().sphere.is_some());
        assert_eq!(spheres(&swapped), [false; 5]);
    }

    #[test]
    fn memory_is_counted_by_shapes_and_by_what_their_corners_say() {
        let numbers = |count: usize| count * size_of::<Number>();
        let mut primitives = Primitives::default();
        assert_eq!(primitives.bytes(), 0);
        primitives.add_sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
        primitives.add_ellipsoid(Ellipsoid::new(crate::Transform::IDENTITY).unwrap());
        let round = size_of::<Sphere>() + size_of::<Ellipsoid>();
        assert_eq!(primitives.bytes(), numbers(2) + round);
        let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE];
        let triangles = vec![[0, 1, 2], [1, 2, 3]];
        let triangles_and_mesh = 2 * size_of::<Triangle>() + size_of::<MeshCorners>();
        primitives.add_mesh(Mesh { positions: positions.clone(), triangles: triangles.clone(), ..Mesh::default() });
        assert_eq!(primitives.bytes(), numbers(4) + round + triangles_and_mesh);
        let normals = Corners::PerPoint(vec![Vec3::Z; 4]);
        let uvs = Corners::PerTriangle(vec![[Vec2::ZERO; 3]; 2]);
        primitives.add_mesh(Mesh { positions, triangles, normals, uvs });
        // Twelve bytes a point and an index of a triangle, eight for each of its corners' places in the texture.
        assert_eq!(primitives.bytes(), numbers(6) + round + 2 * triangles_and_mesh + 4 * 12 + 2 * 12 + 2 * 24);
    }

    #[test]
    #[should_panic(expected = "a value for every corner")]
    fn values_that_are_missing_are_noticed_when_a_mesh_is_added() {
        let normals = Corners::PerPoint(vec![Vec3::Z; 2]);
        let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
        Primitives::default().add_mesh(Mesh { positions, triangles: vec![[0, 1, 0]], normals, ..Mesh::default() });
    }

    #[test]
    fn a_subset_is_renumbered() {
        let rest = two_meshes_and_a_sphere().subset(|number| number != 0);
        assert_eq!(rest.len(), 2);
        assert_eq!(rest.intersect(1, &DOWN, Interval::FORWARD).unwrap().t, 2.0);
    }
}
