//! Turns a hit into a colour: shaders, textures and lights.
//!
//! A [`Shader`] sees one [`ShadingPoint`] and asks it for light and for further rays; what stands behind (which accelerator, how
//! many threads) it cannot know: it speaks to a [`World`].
//!
//! # Conventions
//!
//! * Colours are linear sRGB, not clamped; they become 8-bit sRGB only in the finished picture.
//! * `n` is the unit shading normal on the viewer's side, `v` the unit vector to the viewer, `l` to a light.
//! * Lighting is the report's: no division by pi, no inverse square; see [`Falloff`]. The other one is in [`sunflow`].

mod bounces;
mod color;
#[cfg(feature = "conformance")]
pub mod conformance;
mod glass;
mod lazy_surface;
mod light;
mod light_formula;
mod light_lanes;
mod matt;
mod mirror;
pub mod optics;
mod shader;
mod shading_point;
pub mod srgb;
pub mod sunflow;
mod texture;
mod world;

pub use bounces::Bounces;
pub use color::Color;
pub use glass::{Absorption, Glass};
pub use lazy_surface::LazySurface;
pub use light::{Falloff, PointLight, SoftShadows, light_cluster, linear_falloff, logarithmic_falloff};
pub use light_formula::{Facing, Incident, LightFormula};
pub use light_lanes::FacingLanes;
pub use matt::{Constant, Phong};
pub use mirror::Mirror;
pub use shader::Shader;
pub use shading_point::ShadingPoint;
pub use texture::{ImageTexture, Texture};
pub use world::World;
