//! The laws of the primitives, held against exact rational arithmetic.
//!
//! Every `f32` and `f64` is a rational number, and so is every polynomial of them: the oracle rounds nowhere. Where the truth is
//! a root, the quadratic's signs on both sides of the claim decide. Inputs come from [`geometry::conformance`].

mod boxes;
mod ellipsoid;
mod exact;
mod leaving;
mod plane;
mod secondary;
mod sphere;
mod texture;
mod triangle;
mod undefined;
