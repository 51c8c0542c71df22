//! What every accelerator keeps: a kit of laws, and the scenes and rays that they are tried on.
//!
//! A failing case prints as a literal. To paste it, write `use accel::conformance::{Asked, Thing::*};` and
//! `use glam::vec3 as Vec3;`.

pub mod accelerator;
mod aims;
mod scenes;
mod things;

pub use aims::{Aim, aims, intervals};
pub use things::{Asked, Thing, points, things};
