use std::sync::Arc;

use accel::Accelerator;
use geometry::Primitives;
use scene_format::{Files, Parsed, scene_file::BucketOrder};
use shading::{Absorption, Color, Constant, Falloff, Glass, Mirror, Phong, PointLight, Shader, SoftShadows, Texture};

use crate::{Sampler, Tile, bucket_order, jitter};

/// The parts of the renderer, each a plain function that can be replaced alone:
///
/// ```
/// use render::Modules;
/// let without_tree = Modules { accelerator: accel::none, ..Modules::default() };
/// ```
#[derive(Clone, Copy)]
pub struct Modules {
    /// Reads a scene: its name for messages, its text, and what gives it its includes.
    pub parse: fn(&str, &str, &dyn Files) -> Parsed,
    /// Builds what finds the nearest hit.
    pub accelerator: fn(Primitives) -> Box<dyn Accelerator>,
    /// Make the shaders.
    pub shaders: Shaders,
    /// How a light's light falls off with the distance.
    pub falloff: Falloff,
    /// The lights that take the place of one when its shadows are to be soft.
    pub soft_shadows: fn(PointLight, SoftShadows) -> Vec<PointLight>,
    /// Where samples fall.
    pub sampler: Sampler,
    /// The order in which buckets are rendered, from the number of columns and rows; each bucket exactly once.
    pub bucket_order: fn(BucketOrder, u32, u32) -> Vec<Tile>,
}

/// What makes each of the report's four shaders.
#[derive(Clone, Copy)]
pub struct Shaders {
    /// From the colour.
    pub constant: fn(Color) -> Box<dyn Shader>,
    /// From the matt part, the highlight's colour and its exponent.
    pub phong: fn(Arc<dyn Texture>, Color, f32) -> Box<dyn Shader>,
    /// From the share of light that is reflected.
    pub mirror: fn(Color) -> Box<dyn Shader>,
    /// From the index of refraction, the colour and the absorption.
    pub glass: fn(f32, Color, Option<Absorption>) -> Box<dyn Shader>,
}

impl Default for Modules {
    fn default() -> Self {
        Self {
            parse: scene_format::parse,
            accelerator: accel::octree,
            shaders: Shaders::default(),
            falloff: shading::linear_falloff,
            soft_shadows: shading::light_cluster,
            sampler: jitter,
            bucket_order,
        }
    }
}

impl Default for Shaders {
    fn default() -> Self {
        Self {
            constant: |color| Box::new(Constant { color }),
            phong: |diffuse, specular, exponent| Box::new(Phong { diffuse, specular, exponent }),
            mirror: |reflection| Box::new(Mirror { reflection }),
            glass: |eta, color, absorption| Box::new(Glass { eta, color, absorption }),
        }
    }
}
