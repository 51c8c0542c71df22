//! Which primitive does a ray meet first?
//!
//! [`none`] asks every primitive; [`octree`] asks only those in the cells that the ray passes (the report's section 4.1). Both are
//! plain functions from [`geometry::Primitives`] to an [`Accelerator`], and so is anybody's own.
//!
//! # Conventions
//!
//! Every accelerator returns the hit that [`none`] returns, bit for bit: `geometry` alone decides what is a hit and where,
//! and of hits at one distance the lowest primitive's counts. An accelerator may only leave out primitives that the ray
//! cannot meet. It knows boxes and numbers, never a colour; infinite planes stand outside.

mod accelerator;
mod none;
mod octree;
mod ordinary;
mod wide;

pub use accelerator::{Accelerator, Statistics};
pub use none::none;
pub use octree::octree;
pub use wide::{Hits, Instructions, wide, wide_watertight, wide_with};
