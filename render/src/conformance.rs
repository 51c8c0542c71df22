//! The kits of the parts of this crate, and their inputs: far eyes, narrow views, places of the picture to look through.
//!
//! A kit is a module with a list `LAWS`, from the easiest law to the hardest; its macro names each as a test of a part of your own:
//! `render::sampler_conformance!(my_sampler);`. [`geometry::conformance`] tells what a law is, and has the numbers and vectors that the inputs
//! are made of.

pub mod bucket_order;
pub mod camera;
pub mod renderer;
pub mod sampler;
mod view;

pub use view::{Axes, by_transform, lenses, ordinary_views, places, views};
