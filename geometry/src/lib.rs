//! Rays, boxes, transforms and the primitives of a scene.
//!
//! Everything is stored in `f32`; the steps that cancel (a difference of products, a discriminant) are taken in `f64`, which
//! makes the result as good as the storage allows. No function here asks for a unit vector unless it says so.
//!
//! # Conventions
//!
//! * Right-handed space. Counter-clockwise corners are seen from the front; normals point to the front, out of closed bodies.
//! * A ray's points are `origin + t * direction`. `t` counts multiples of `direction`, whatever its length.
//! * A hit counts if `t` lies strictly inside the [`Interval`] asked for.
//! * Texture coordinates: `u` to the right, `v` upwards, `v = 0` at the bottom of the picture.
//! * NaN anywhere in a ray or a primitive: no hit. Nothing panics.

mod aabb;
#[cfg(feature = "conformance")]
pub mod conformance;
mod cube;
mod ellipsoid;
mod hit;
mod interval;
mod kernels;
mod mesh;
pub mod naive;
mod plane;
mod primitive;
mod primitives;
mod ray;
mod rounding;
mod sphere;
mod sphere_lanes;
mod surface;
mod transform;
mod triangle;
mod triangle_lanes;
mod triangle_probe;

pub use aabb::{Aabb, BoxProbe};
pub use cube::unit_cube;
pub use ellipsoid::Ellipsoid;
pub use hit::{Hit, Intersection};
pub use interval::Interval;
pub use kernels::{Clip, Intersect, Kernels, NormalMatrix, PlaneUv, SmoothNormal, SphereUv, TriangleUv};
pub use mesh::{Corners, Mesh};
pub use plane::{PLANE_TEXTURE_SIZE, Plane};
pub use primitive::Primitive;
pub use primitives::{PrimitiveCount, Primitives};
pub use ray::Ray;
pub use sphere::Sphere;
pub use sphere_lanes::{SphereMet, meet_sphere_lanes};
pub use surface::{RayOrigin, Surface};
pub use transform::Transform;
pub use triangle::Triangle;
pub use triangle_lanes::{LanesMet, TriangleLanes, intersect_lanes};
pub use triangle_probe::TriangleProbe;
