//! The laws of optics, lights and colours, held against arithmetic of 256 bits. Inputs come from [`shading::conformance`].

mod exact;
mod light;
mod optics;
mod srgb;
mod sunflow;
mod undefined;
