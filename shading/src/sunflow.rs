//! Lighting as Sunflow 0.07.3 computes it, so that a picture can be held against its pictures, pixel by pixel.
//!
//! Its units are physical: a light's power is the flux that it sends to all sides, a matt surface divides by pi, and nothing is lit
//! where no light reaches. Every surface casts a full shadow, glass too.

mod constant;
mod flux;
mod glass;
mod long_normal;
mod mirror;
mod phong;
mod ray_origin;
mod shaded;
mod shiny;
mod texture;

pub use constant::Constant;
pub use flux::inverse_square_falloff;
pub use glass::Glass;
pub use long_normal::LongNormal;
pub use mirror::Mirror;
pub use phong::Phong;
pub use ray_origin::ray_origin;
pub use shiny::Shiny;
pub use texture::SmoothTexture;
