use super::{Color, Paint, Unknown, Unrendered, Value};
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
    Constant(Spanned<Color>),
    /// `diffuse`: a matt surface; phong without a highlight.
    Diffuse(Paint),
    /// `phong`: a matt surface with a highlight.
    Phong {
        /// The matt part.
        diffuse: Paint,
        /// The colour of the highlight.
        specular: Spanned<Color>,
        /// How narrow the highlight is.
        exponent: Spanned<f32>,
        /// `samples`: Sunflow's glossy reflection rays, which girasol does not trace.
        samples: Option<Spanned<u32>>,
    },
    /// `mirror`: `refl <color>`.
    Mirror(Spanned<Color>),
    /// `glass`
    Glass {
        /// The index of refraction inside over that outside, greater than 0.
        eta: Spanned<f32>,
        /// Multiplies what passes each surface.
        color: Spanned<Color>,
        /// What is lost on the way through the glass.
        absorption: Absorption,
    },
    /// `shiny`: a matt surface with a mirror over it.
    Shiny {
        /// The matt part.
        diffuse: Paint,
        /// The mirror's share at normal incidence.
        reflection: Spanned<f32>,
    },
    /// Another type of Sunflow's: rendered as a matt surface with the block's own [paint](Self::own_paint), where it has one.
    Unrendered(Unrendered),
    /// A type that nobody knows: rendered likewise.
    Unknown {
        /// The words.
        block: Unknown,
        /// What `diff` or `texture` seems to give among them.
        paint: Option<Paint>,
    },
}

/// What glass takes from the light on its way. Both parts are optional in the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Absorption {
    /// `absorption.distance`: the length at which the colour's full effect is reached; 0 or `None` switches absorption off.
    pub distance: Option<Spanned<f32>>,
    /// `absorption.color`: grey 0.5 (linear) unless given.
    pub color: Option<Spanned<Color>>,
}

impl ShaderKind {
    /// What covers the surface of a type that is not rendered; a texture before a colour, as `uber` has it.
    pub fn own_paint(&self) -> Option<Paint> {
        let block = match self {
            Self::Unrendered(block) => block,
            Self::Unknown { paint, .. } => return paint.clone(),
            _ => return None,
        };
        let first = |names: [&str; 2]| {
            let field = block.fields.iter().find(|field| names.contains(&field.name.as_str()))?;
            field.values.first()
        };
        match (first(["texture", "diff.texture"]), first(["diff", "bright"])) {
            (Some(Spanned { value: Value::Word(file), span }), _) => {
                Some(Paint::Texture(Spanned::new(file.clone(), *span)))
            }
            (_, Some(Spanned { value: Value::Color(color), span })) => {
                Some(Paint::Color(Spanned::new(color.clone(), *span)))
            }
            _ => None,
        }
    }
}
