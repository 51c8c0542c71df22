use super::Parser;
use super::block::{Block, Field};
use super::mesh::MeshFields;
use super::report::Read;
use super::unrendered::OtherFields;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::grammar;
use crate::lexer::{Token, is_number};
use crate::scene_file::{Color, Kind, Light, MeshForm, Triple};
use crate::span::Spanned;

/// The types that are rendered.
const RENDERED: &[&str] = &["point"];
/// All types.
const TYPES: &[&str] = &["point", "meshlight", "mesh", "spherical", "directional", "ibl", "sunsky", "cornellbox"];
const FIELDS: &[&str] =
    &["type", "name", "color", "power", "p", "emit", "radiance", "samples", "points", "triangles", "normals", "uvs"];

/// What stands after `power`.
enum Power {
    Number(Spanned<f32>),
    /// The old form: colour times power.
    Color(Spanned<Color>),
}

impl<'s> Parser<'s> {
    pub(super) fn light(&mut self, keyword: Token<'s>) -> Read<Light> {
        let block = self.open(keyword, FIELDS, grammar::LIGHTS)?;
        let kind = self.find_type(&block, RENDERED)?;
        match kind.text {
            "point" => return self.point_light(&block),
            known if TYPES.contains(&known) => self.warn_of_unrendered(&block, kind, RENDERED, "gives no light"),
            _ => self.warn_of_unknown(&block, kind, TYPES, "gives no light"),
        }
        match kind.text {
            "meshlight" => self.mesh_light(&block, kind, MeshForm::Generic),
            "mesh" => self.mesh_light(&block, kind, MeshForm::Lines),
            _ => {
                let mut other = OtherFields::new(kind, grammar::LIGHTS);
                self.fields(&block, |parser, field| match field.text {
                    "type" => parser.word(field).map(|_| Field::Known),
                    _ => parser.other_field(&mut other, field),
                })?;
                Ok(match other.finish() {
                    Kind::Unrendered(light) => Light::Unrendered(light),
                    Kind::Unknown(light) => Light::Unknown(light),
                })
            }
        }
    }

    fn point_light(&mut self, block: &Block<'s>) -> Read<Light> {
        let mut color: Option<Spanned<Color>> = None;
        let mut power: Option<Power> = None;
        let mut position: Option<Spanned<Triple>> = None;
        self.fields(block, |parser, field| {
            match field.text {
                "type" => {
                    parser.word(field)?;
                }
                "color" => color = Some(parser.color(field)?),
                "power" => power = Some(parser.power(field)?),
                "p" => position = Some(parser.floats(field)?),
                _ => return Ok(Field::Unknown),
            }
            Ok(Field::Known)
        })?;
        let position = self.require(block, position, "p", "p x y z");
        let power = self.require(block, power, "power", "power <number>");
        let (color, power) = match (power?, color) {
            (Power::Color(color), None) => (color, None),
            (Power::Number(power), color) => (self.require(block, color, "color", "color r g b")?, Some(power)),
            (Power::Color(also), Some(color)) => {
                let error = Diagnostic::error(Code::Contradiction, also.span, "the light has two colours")
                    .note(color.span, "this already says which it has");
                return self.fail(error.help("after `color`, `power` is one number"));
            }
        };
        Ok(Light::Point { color, power, position: position? })
    }

    fn power(&mut self, field: Token<'s>) -> Read<Power> {
        if self.cursor.peek().is_some_and(|token| token.is_open()) {
            return Ok(Power::Color(self.color(field)?));
        }
        let first = self.float(field)?;
        if !self.at_number() {
            return Ok(Power::Number(first));
        }
        let rest = self.floats(field)?;
        let [green, blue] = rest.value;
        Ok(Power::Color(Spanned::new(Color::Bare([first.value, green, blue]), first.span.to(rest.span))))
    }

    /// `name NAME emit <color> ...` and the triangles, in either form.
    fn mesh_light(&mut self, block: &Block<'s>, kind: Token<'s>, form: MeshForm) -> Read<Light> {
        let (mut name, mut emission, mut radiance, mut samples) = (None, None, None, None);
        let mut mesh = MeshFields::new(form);
        self.fields(block, |parser, field| {
            match field.text {
                "type" => {
                    parser.word(field)?;
                }
                "name" => {
                    let given = parser.string(field)?;
                    parser.claim(&given);
                    name = Some(given);
                }
                "emit" => emission = Some(parser.color(field)?),
                "radiance" => radiance = Some(parser.float(field)?),
                "samples" => samples = Some(parser.count(field)?),
                "points" | "triangles" => return parser.mesh_field(&mut mesh, field),
                number if is_number(number) => return parser.mesh_lines(&mut mesh, field),
                _ => return Ok(Field::Unknown),
            }
            Ok(Field::Known)
        })?;
        let emission = self.require(block, emission, "emit", "emit r g b");
        let mesh = self.finish_mesh(block, mesh)?;
        Ok(Light::Mesh { name, emission: emission?, radiance, samples, mesh: Box::new(Spanned::new(mesh, kind.span)) })
    }
}
