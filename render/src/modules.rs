use std::sync::Arc;

use accel::Accelerator;
use geometry::{Kernels, Primitives, RayOrigin, Surface};
use scene_format::{Files, Limits, Parsed};
use shading::{
    Absorption, Color, Constant, Falloff, Glass, ImageTexture, Mirror, Phong, PointLight, Shader, SoftShadows, Texture,
    sunflow,
};

use crate::{BucketOrdering, Camera, Dialect, Renderer, Sampler, View, bucket_order, camera, centred, render, sobol};

/// The parts of the renderer, each a plain function that can be replaced alone:
///
/// ```
/// use render::Modules;
/// let without_tree = Modules { accelerator: accel::none, ..Modules::default() };
/// ```
#[derive(Clone, Copy)]
pub struct Modules {
    /// Reads a scene: its name for messages, its text, what gives it its includes, and the limits.
    pub parse: for<'s> fn(&str, &'s str, &dyn Files, &Limits) -> Parsed<'s>,
    /// How much a scene may ask for.
    pub limits: Limits,
    /// How rays meet each kind of primitive.
    pub kernels: Kernels,
    /// Where shadow rays and mirrored and refracted rays start.
    pub ray_origin: RayOrigin,
    /// Builds what finds the nearest hit.
    pub accelerator: fn(Primitives) -> Box<dyn Accelerator>,
    /// Make the shaders.
    pub shaders: Shaders,
    /// Makes the camera of what the scene says of it; `None` where that defines no view.
    pub camera: fn(&View) -> Option<Box<dyn Camera>>,
    /// Makes a texture of a picture's texels.
    pub texture: fn(ImageTexture) -> Arc<dyn Texture>,
    /// How a light's light falls off with the distance.
    pub falloff: Falloff,
    /// The lights that take the place of one when its shadows are to be soft.
    pub soft_shadows: fn(PointLight, SoftShadows) -> Vec<PointLight>,
    /// Where samples fall.
    pub sampler: Sampler,
    /// The order in which buckets are rendered.
    pub bucket_order: BucketOrdering,
    /// Renders the whole picture.
    pub render: Renderer,
    /// How the scene's words are meant.
    pub dialect: Dialect,
}

impl Modules {
    /// The same parts, but shading, light and sampling are those of Sunflow 0.07.3, to be compared with its pictures.
    #[must_use]
    pub fn lit_as_by_sunflow(self) -> Self {
        Self {
            shaders: Shaders::sunflow(),
            texture: |picture| Arc::new(sunflow::SmoothTexture { picture }),
            ray_origin: sunflow::ray_origin,
            falloff: sunflow::inverse_square_falloff,
            sampler: centred,
            dialect: Dialect::Sunflow,
            ..self
        }
    }
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

impl Shaders {
    /// Sunflow's.
    pub fn sunflow() -> Self {
        Self {
            constant: |color| Box::new(sunflow::Constant { color }),
            phong: |diffuse, specular, exponent| Box::new(sunflow::Phong { diffuse, specular, exponent }),
            mirror: |reflection| Box::new(sunflow::Mirror { reflection }),
            glass: |eta, color, absorption| Box::new(sunflow::Glass { eta, color, absorption }),
        }
    }
}

impl Default for Modules {
    // Never inlined: the same part has the same address in every crate, so that a program can tell which ones are its own.
    #[inline(never)]
    fn default() -> Self {
        Self {
            parse: scene_format::parse_within,
            limits: Limits::default(),
            kernels: Kernels::default(),
            ray_origin: Surface::origin_towards,
            accelerator: accel::wide,
            shaders: Shaders::default(),
            camera,
            texture: |picture| Arc::new(picture),
            falloff: shading::linear_falloff,
            soft_shadows: shading::light_cluster,
            sampler: sobol,
            bucket_order,
            render,
            dialect: Dialect::default(),
        }
    }
}

impl Default for Shaders {
    // See above.
    #[inline(never)]
    fn default() -> Self {
        Self {
            constant: |color| Box::new(Constant { color }),
            phong: |diffuse, specular, exponent| Box::new(Phong { diffuse, specular, exponent }),
            mirror: |reflection| Box::new(Mirror { reflection }),
            glass: |eta, color, absorption| Box::new(Glass { eta, color, absorption }),
        }
    }
}
