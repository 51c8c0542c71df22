//! Accelerators from the registry: obvhs and bvh, each with the triangle test that serves it best.

use std::time::Duration;

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::{BHShape, BoundingHierarchy};
use bvh::bvh::Bvh;
use geometry::{Interval, Ray};
use glam::{Vec3, Vec3A};
use nalgebra::{Point3, Vector3};
use obvhs::BvhBuildParams;
use obvhs::bvh2::{Bvh2, builder::build_bvh2_from_tris};
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
use obvhs::ray::RayHit;
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;

use crate::meshes::Scene;
use crate::tracer::Tracer;

/// One of obvhs's trees with its triangles in the order of the leaves.
pub struct Obvhs<T> {
    tree: T,
    triangles: Vec<RtTriangle>,
}

fn triangles_of(scene: &Scene) -> Vec<Triangle> {
    let corner = |corner: u32| Vec3A::from(scene.mesh.positions[corner as usize]);
    let triangle = |corners: &[u32; 3]| {
        let [v0, v1, v2] = corners.map(corner);
        Triangle { v0, v1, v2 }
    };
    scene.mesh.triangles.iter().map(triangle).collect()
}

fn in_order(triangles: &[Triangle], order: &[u32]) -> Vec<RtTriangle> {
    order.iter().map(|&triangle| RtTriangle::from(&triangles[triangle as usize])).collect()
}

/// Its best setting: slower ones to build are no slower to ask.
const QUALITY: BvhBuildParams = BvhBuildParams::very_slow_build();

impl Obvhs<CwBvh> {
    pub fn wide(scene: &Scene) -> Self {
        let triangles = triangles_of(scene);
        let tree = build_cwbvh_from_tris(&triangles, QUALITY, &mut Duration::default());
        Self { triangles: in_order(&triangles, &tree.primitive_indices), tree }
    }
}

impl Obvhs<Bvh2> {
    pub fn binary(scene: &Scene) -> Self {
        let triangles = triangles_of(scene);
        let tree = build_bvh2_from_tris(&triangles, QUALITY, &mut Duration::default());
        Self { triangles: in_order(&triangles, &tree.primitive_indices), tree }
    }
}

fn obvhs_ray(ray: &Ray, within: Interval) -> obvhs::ray::Ray {
    obvhs::ray::Ray::new(ray.origin.into(), ray.direction.into(), within.min, within.max)
}

/// Two types of tree with methods of the same names.
macro_rules! trace_with_obvhs {
    ($($tree:ty),*) => {$(
        impl Tracer for Obvhs<$tree> {
            fn closest(&self, ray: &Ray) -> Option<(u32, f32)> {
                let mut hit = RayHit::none();
                let test = |ray: &obvhs::ray::Ray, place: usize| self.triangles[place].intersect(ray);
                let found = self.tree.ray_traverse(obvhs_ray(ray, Interval::FORWARD), &mut hit, test);
                found.then(|| (self.tree.primitive_indices[hit.primitive_id as usize], hit.t))
            }

            fn any(&self, ray: &Ray, within: Interval) -> bool {
                let test = |ray: &obvhs::ray::Ray, place: usize| self.triangles[place].intersect(ray);
                !self.tree.ray_traverse_miss(obvhs_ray(ray, within), test)
            }
        }
    )*};
}

trace_with_obvhs!(CwBvh, Bvh2);

/// The crate bvh.
pub struct BvhCrate {
    tree: Bvh<f32, 3>,
    shapes: Vec<Shape>,
}

/// A triangle, and its box kept, as the tree asks for it again and again.
struct Shape {
    corner: Vec3,
    edges: [Vec3; 2],
    bounds: Aabb<f32, 3>,
    triangle: u32,
    node: usize,
}

impl Bounded<f32, 3> for Shape {
    fn aabb(&self) -> Aabb<f32, 3> {
        self.bounds
    }
}

impl BHShape<f32, 3> for Shape {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl Shape {
    /// Moeller and Trumbore's test (1997), of both sides; the crate's own is of one.
    fn meets(&self, ray: &Ray, within: Interval) -> Option<f32> {
        let [first, second] = self.edges;
        let across = ray.direction.cross(second);
        let scale = 1.0 / first.dot(across);
        let away = ray.origin - self.corner;
        let u = scale * away.dot(across);
        let other = away.cross(first);
        let v = scale * ray.direction.dot(other);
        let t = scale * second.dot(other);
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && within.min < t && t < within.max).then_some(t)
    }
}

impl BvhCrate {
    pub fn build(scene: &Scene) -> Self {
        let shape = |(triangle, corners): (usize, &[u32; 3])| {
            let [a, b, c] = corners.map(|corner| scene.mesh.positions[corner as usize]);
            let point = |at: Vec3| Point3::new(at.x, at.y, at.z);
            let bounds = Aabb::with_bounds(point(a.min(b).min(c)), point(a.max(b).max(c)));
            Shape { corner: a, edges: [b - a, c - a], bounds, triangle: triangle as u32, node: 0 }
        };
        let mut shapes: Vec<_> = scene.mesh.triangles.iter().enumerate().map(shape).collect();
        Self { tree: Bvh::build_par(&mut shapes), shapes }
    }
}

fn bvh_ray(ray: &Ray) -> bvh::ray::Ray<f32, 3> {
    let (o, d) = (ray.origin, ray.direction);
    bvh::ray::Ray::new(Point3::new(o.x, o.y, o.z), Vector3::new(d.x, d.y, d.z))
}

impl Tracer for BvhCrate {
    /// All triangles on the ray, in the order of the tree. The crate's ordered ways (`nearest_traverse_iterator`,
    /// `nearest_child_traverse_iterator`) leave out what is behind a hit or put the nearer first, and were slower on every mesh.
    fn closest(&self, ray: &Ray) -> Option<(u32, f32)> {
        let mut nearest = None;
        let mut within = Interval::FORWARD;
        for shape in self.tree.traverse_iterator(&bvh_ray(ray), &self.shapes) {
            if let Some(t) = shape.meets(ray, within) {
                nearest = Some((shape.triangle, t));
                within.max = t;
            }
        }
        nearest
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        self.tree.traverse_iterator(&bvh_ray(ray), &self.shapes).any(|shape| shape.meets(ray, within).is_some())
    }
}
