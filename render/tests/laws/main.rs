//! The laws of cameras, held against arithmetic of 256 bits. Inputs come from [`render::conformance`].

mod camera;
mod exact;
mod undefined;
