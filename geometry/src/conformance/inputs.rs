//! The inputs of the laws: rays aimed at primitives, with the cases that break naive kernels made common.
//!
//! The families are multiplied rather than listed: a far origin, a grazing ray, a large offset and a direction of odd length meet in
//! one case.

mod aabb;
mod cube;
mod ellipsoid;
mod mesh;
mod numbers;
mod plane;
mod secondary;
mod sphere;
mod triangle;
mod wild;

use proptest::prelude::*;

pub use aabb::{boxes, drawn_boxes};
pub(crate) use cube::Cube;
pub use ellipsoid::{drawn_ellipsoids, ellipsoids, moved_spheres};
pub use mesh::{Enclosed, closed_meshes, split_octahedron};
pub(crate) use numbers::{frame, in_plane, slope};
pub use numbers::{magnitude, unit_vector};
pub use plane::{PlaneGiven, drawn_planes, planes};
pub use secondary::{Apart, CubeEdge, GAP, cube_edges, ellipsoids_apart, planes_apart, spheres_apart, triangles_apart};
pub use sphere::{drawn_spheres, spheres};
pub use triangle::{DrawnTriangle, drawn_triangles, flat_triangles, triangles};
pub use wild::{wild_intervals, wild_maps, wild_numbers, wild_rays, wild_vectors};

use crate::Ray;

/// A shape, and a ray that meets it or narrowly does not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aimed<S> {
    /// The shape.
    pub shape: S,
    /// The ray. Its direction has any length.
    pub ray: Ray,
}

/// How many cases a law is tried on: a multiple of proptest's own number. `PROPTEST_CASES` sets one number for all laws.
///
/// Failures are not kept in a file: each becomes a literal test.
pub fn times(factor: u32) -> ProptestConfig {
    let default = ProptestConfig::default();
    let cases = factor * default.cases;
    ProptestConfig { cases, max_global_rejects: 16 * cases, failure_persistence: None, ..default }
}
