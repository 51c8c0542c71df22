//! What every implementation of a part keeps: kits of laws, and the inputs that they are tried on.
//!
//! A kernel that keeps its kit is right on scenes. Each kit is a module with the name of its part, which is the part's page; the
//! inputs are there for tests of your own as well.
//!
//! A failing case prints as a literal. To paste it, write `use glam::{DMat3, dvec3 as DVec3, vec3 as Vec3};`.

pub mod aabb;
mod claim;
pub mod ellipsoid;
pub mod exact;
mod figure;
mod inputs;
mod law;
pub mod normal_matrix;
mod picture;
pub mod plane;
pub mod plane_uv;
pub mod ray_origin;
pub mod smooth_normal;
pub mod sphere;
pub mod sphere_uv;
pub mod triangle;
pub mod triangle_uv;

pub use figure::{Figure, Ink};
pub use inputs::*;
pub use law::{Broken, Counterexample, Law, Trial, Verdict, same};
