//! What our own primitives keep beyond their kits: surfaces, texture coordinates of hits, many triangles at once, defined answers to
//! undefined inputs; and cases that were once got wrong.
//!
//! The truth is [`geometry::conformance::exact`]'s: rational numbers, which round nowhere.

mod sphere;
mod sphere_lanes;
mod surface;
mod texture;
mod triangle;
mod undefined;
