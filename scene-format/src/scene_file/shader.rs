use super::{Color, Other, Paint};
use crate::span::Spanned;

/// `shader { name NAME type KIND ... }`
#[derive(Clone, Debug, PartialEq)]
pub struct Shader {
    /// The name that objects use.
    pub name: Spanned<String>,
    /// What it computes.
    pub kind: ShaderKind,
}

/// What a shader computes.
#[derive(Clone, Debug, PartialEq)]
pub enum ShaderKind {
    /// `constant`: one colour.
    Constant(Color),
    /// `diffuse`: a matt surface; phong without a highlight.
    Diffuse(Paint),
    /// `phong`: a matt surface with a highlight.
    Phong {
        /// The matt part.
        diffuse: Paint,
        /// The colour of the highlight.
        specular: Color,
        /// How narrow the highlight is.
        exponent: f32,
        /// `samples`: Sunflow's glossy reflection rays, which girasol does not trace.
        samples: Option<u32>,
    },
    /// `mirror`: `refl <color>`.
    Mirror(Color),
    /// `glass`
    Glass {
        /// The index of refraction inside over that outside, greater than 0.
        eta: f32,
        /// Multiplies what passes each surface.
        color: Color,
        /// What is lost on the way through the glass.
        absorption: Absorption,
    },
    /// `shiny`: a matt surface with a mirror over it.
    Shiny {
        /// The matt part.
        diffuse: Paint,
        /// The mirror's share at normal incidence.
        reflection: f32,
    },
    /// Any other type: rendered as a matt surface with the block's own diffuse paint, where it has one.
    Other {
        /// The type, and all words of the block after it.
        block: Other,
        /// What `diff` or `texture` gave in it.
        diffuse: Option<Paint>,
    },
}

/// What glass takes from the light on its way. Both parts are optional in the file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Absorption {
    /// `absorption.distance`: the length at which the colour's full effect is reached; 0 or `None` switches absorption off.
    pub distance: Option<f32>,
    /// `absorption.color`: grey 0.5 (linear) unless given.
    pub color: Option<Color>,
}
