use super::block::{Block, Field};
use super::report::Read;
use super::unrendered::OtherFields;
use super::{Parser, Reported};
use crate::grammar;
use crate::lexer::Token;
use crate::number;
use crate::scene_file::{Absorption, Color, Kind, Paint, Shader, ShaderKind};
use crate::span::Spanned;

const TYPES: &[&str] = &["constant", "diffuse", "phong", "mirror", "glass", "shiny"];
const FIELDS: &[&str] = &[
    "name",
    "type",
    "diff",
    "texture",
    "spec",
    "samples",
    "refl",
    "eta",
    "color",
    "absorption.distance",
    "absorption.color",
    "absorbtion.distance",
    "absorbtion.color",
];

/// The fields of all types, as far as they were there.
struct Fields<'s> {
    name: Option<Spanned<String>>,
    diffuse: Option<Paint>,
    specular: Option<(Spanned<Color>, Spanned<f32>)>,
    samples: Option<Spanned<u32>>,
    mirror: Option<Spanned<Color>>,
    reflection: Option<Spanned<f32>>,
    eta: Option<Spanned<f32>>,
    color: Option<Spanned<Color>>,
    absorption: Absorption,
    /// Of a type that is not rendered.
    other: OtherFields<'s>,
}

impl<'s> Parser<'s> {
    pub(super) fn shader(&mut self, keyword: Token<'s>) -> Read<Shader> {
        let block = self.open(keyword, FIELDS, grammar::SHADERS)?;
        let kind = self.find_type(&block, TYPES)?;
        let other = OtherFields::new(kind, grammar::SHADERS);
        if let OtherFields::Unrendered { .. } = other {
            self.warn_of_unrendered(&block, kind, TYPES, "drawn as a matt surface");
        } else if !TYPES.contains(&kind.text) {
            let known: Vec<&str> =
                TYPES.iter().copied().chain(grammar::SHADERS.iter().map(|(name, _)| *name)).collect();
            self.warn_of_unknown(&block, kind, &known, "drawn as a matt surface");
        }
        let mut fields = Fields {
            name: None,
            diffuse: None,
            specular: None,
            samples: None,
            mirror: None,
            reflection: None,
            eta: None,
            color: None,
            absorption: Absorption::default(),
            other,
        };
        self.fields(&block, |parser, field| parser.shader_field(kind, &mut fields, field))?;
        let name = fields.name.take();
        let name = self.require(&block, name, "name", "name <name>");
        let kind = self.finish_shader(&block, kind, fields);
        Ok(Shader { name: name?, kind: kind? })
    }

    fn shader_field(&mut self, kind: Token<'s>, fields: &mut Fields<'s>, field: Token<'s>) -> Read<Field> {
        match (field.text, kind.text) {
            ("name", _) => {
                let name = self.string(field)?;
                self.claim(&name);
                fields.name = Some(name);
            }
            ("type", _) => {
                self.word(field)?;
                // Of a constant shader the word `color` may be left out.
                if kind.text == "constant" && self.at_color() {
                    fields.color = Some(self.color(field)?);
                }
            }
            (_, other) if !TYPES.contains(&other) => return self.other_field(&mut fields.other, field),
            ("diff", "diffuse" | "phong" | "shiny") => fields.diffuse = Some(Paint::Color(self.color(field)?)),
            ("texture", "diffuse" | "phong" | "shiny") => fields.diffuse = Some(Paint::Texture(self.string(field)?)),
            ("spec", "phong") => fields.specular = Some((self.color(field)?, self.float(field)?)),
            ("samples", "phong") => fields.samples = Some(self.count(field)?),
            ("refl", "mirror") => fields.mirror = Some(self.color(field)?),
            ("refl", "shiny") => fields.reflection = Some(self.float(field)?),
            ("eta", "glass") => fields.eta = Some(self.float_that(field, "greater than 0", |eta| eta > 0.0)?),
            ("color", "constant" | "glass") => fields.color = Some(self.color(field)?),
            ("absorption.distance" | "absorbtion.distance", "glass") => {
                fields.absorption.distance = Some(self.float(field)?);
            }
            ("absorption.color" | "absorbtion.color", "glass") => {
                fields.absorption.color = Some(self.color(field)?);
            }
            _ => return Ok(Field::Unknown),
        }
        Ok(Field::Known)
    }

    fn finish_shader(&mut self, block: &Block<'s>, kind: Token<'s>, fields: Fields<'s>) -> Read<ShaderKind> {
        match kind.text {
            "constant" => Ok(ShaderKind::Constant(self.require(block, fields.color, "color", "color r g b")?)),
            "diffuse" => Ok(ShaderKind::Diffuse(self.require_paint(block, fields.diffuse)?)),
            "phong" => {
                let diffuse = self.require_paint(block, fields.diffuse);
                let specular = self.require(block, fields.specular, "spec", "spec r g b <exponent>");
                let (Ok(diffuse), Ok((specular, exponent))) = (diffuse, specular) else { return Err(Reported) };
                Ok(ShaderKind::Phong { diffuse, specular, exponent, samples: fields.samples })
            }
            "mirror" => Ok(ShaderKind::Mirror(self.require(block, fields.mirror, "refl", "refl r g b")?)),
            "glass" => {
                let eta = self.require(block, fields.eta, "eta", "eta <index of refraction>");
                let color = self.require(block, fields.color, "color", "color r g b");
                Ok(ShaderKind::Glass { eta: eta?, color: color?, absorption: fields.absorption })
            }
            "shiny" => {
                let diffuse = self.require_paint(block, fields.diffuse);
                let reflection = self.require(block, fields.reflection, "refl", "refl <share>");
                Ok(ShaderKind::Shiny { diffuse: diffuse?, reflection: reflection? })
            }
            _ => Ok(match fields.other.finish() {
                Kind::Unrendered(block) => ShaderKind::Unrendered(block),
                Kind::Unknown(block) => ShaderKind::Unknown { paint: paint_among(&block.words), block },
            }),
        }
    }

    fn require_paint(&mut self, block: &Block<'_>, paint: Option<Paint>) -> Read<Paint> {
        self.require(block, paint, "diff", "diff r g b` or `texture <file>")
    }
}

/// The diffuse paint among the words of a type that nobody knows; a texture before a colour.
fn paint_among(words: &[Spanned<String>]) -> Option<Paint> {
    let after = |names: &[&str]| {
        let at = words.iter().position(|word| names.contains(&word.as_str()))?;
        words.get(at + 1..)
    };
    if let Some(file) = after(&["texture", "diff.texture"]).and_then(|words| words.first()) {
        return Some(Paint::Texture(file.clone()));
    }
    let words = after(&["diff", "bright"])?;
    let place = words.first()?.span;
    let words: Vec<&str> = words.iter().take(5).map(|word| word.as_str()).collect();
    let color =
        |r: &str, g: &str, b: &str| Some([number::float(r).ok()?, number::float(g).ok()?, number::float(b).ok()?]);
    let color = match *words.as_slice() {
        ["{", "sRGB nonlinear", r, g, b] => Color::SrgbNonlinear(color(r, g, b)?),
        ["{", "sRGB linear", r, g, b] => Color::SrgbLinear(color(r, g, b)?),
        ["{", "XYZ", r, g, b] => Color::Xyz(color(r, g, b)?),
        [r, g, b, ..] => Color::Bare(color(r, g, b)?),
        _ => return None,
    };
    Some(Paint::Color(Spanned::new(color, place)))
}
