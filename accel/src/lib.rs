//! Which primitive does a ray meet first?
//!
//! Three answers, to be read one after the other:
//!
//! * [`none`] asks every primitive;
//! * [`octree`] asks those in the cells that the ray passes (the report's section 4.1);
//! * [`wide`] makes of the same cells nodes of sixteen boxes and blocks of eight triangles, each tested in one step.
//!
//! All are plain functions from [`geometry::Primitives`] to an [`Accelerator`], and so is anybody's own.
//!
//! [`vectorize`] lends the wide octree's instructions to whoever has the same steps to do for many numbers.
//!
//! # Conventions
//!
//! Every accelerator returns the hit that [`none`] returns, bit for bit: `geometry` alone decides what is a hit and where,
//! and of hits at one distance the lowest primitive's counts. An accelerator may only leave out primitives that the ray
//! cannot meet, or that it can prove not to be the nearest. ([`wide_watertight`] alone decides hits itself.) It knows boxes and numbers, never a colour; infinite planes stand outside.
//!
#![doc = include_str!("../docs/steps.md")]
#![doc = "<div>\n"]
#![doc = include_str!("../docs/octree.svg")]
#![doc = "</div>\n\n"]
#![doc = include_str!("../docs/papers.md")]

mod accelerator;
#[cfg(feature = "conformance")]
pub mod conformance;
mod none;
mod octree;
mod ordinary;
mod wide;

pub use accelerator::{Accelerator, Statistics, Visits};
pub use none::none;
pub use octree::octree;
pub use wide::{Hits, Instructions, Step, vectorize, wide, wide_up_to, wide_watertight, wide_with};
