//! Puts a scene together from its parts and renders it, bucket by bucket.
//!
//! [`assemble`] makes a [`Scene`] of what a `.sc` file says, with the parts that [`Modules`] names; [`render`] makes a [`Film`] of it.
//! This is the only crate that knows accelerators, shaders and the scene format together.
//!
//! # Conventions
//!
//! * The image is a function of the scene and the [`Settings`] without `threads` and `bucket`: a pixel's colour depends on its
//!   own place alone, never on what was rendered before it or where.
//! * Pixels are counted from the top left corner of the whole picture, also in a crop.
//! * Colours are linear until [`Film::to_srgb_bytes`].

mod adaptive;
mod assemble;
mod buckets;
mod camera;
mod camera_rays;
#[cfg(feature = "conformance")]
pub mod conformance;
mod dialect;
mod film;
mod inventory;
mod light_samples;
mod lit;
mod lost_rays;
mod modules;
mod passes;
mod pixels;
mod raster;
mod renderer;
mod sampler;
mod scene;
mod settings;
mod tracer;
mod view;

pub use assemble::{Assembled, Lighting, ShadingNeeds, assemble};
pub use buckets::{BucketOrdering, Tile, bucket_order};
pub use camera::{Camera, Frame, Pinhole, ThinLens};
pub use dialect::Dialect;
pub use film::{Film, RayCounts};
pub use inventory::Inventory;
pub(crate) use light_samples::LightPlan;
pub use light_samples::LightSamples;
pub use lost_rays::LostRays;
pub use modules::{Modules, Shaders};
pub use pixels::{Pixels, one_by_one};
pub use raster::Raster;
pub use renderer::{FinishedBucket, Renderer, render};
pub use sampler::{Purpose, Sample, Sampler, centred, random, sobol};
pub use scene::Scene;
pub use settings::{Allotment, Buckets, Crop, Settings};
pub use view::{Lens, View, Viewpoint, camera};
