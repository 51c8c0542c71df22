use super::Parser;
use super::block::Field;
use super::report::{Read, Reported};
use super::shape::{self, ShapeFields};
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::{Object, Shape, SphereForm, Transform};
use crate::span::Spanned;

const FIELDS: &[&str] = &[
    "shader",
    "shaders",
    "modifier",
    "modifiers",
    "transform",
    "noinstance",
    "accel",
    "type",
    "name",
    "c",
    "r",
    "p",
    "n",
    "points",
    "triangles",
    "normals",
    "uvs",
    "face_shaders",
];

/// What objects and instances have in common.
#[derive(Default)]
pub(super) struct Common {
    pub(super) name: Option<Spanned<String>>,
    pub(super) shaders: Vec<Spanned<String>>,
    pub(super) modifiers: Vec<Spanned<String>>,
    pub(super) transform: Option<Spanned<Transform>>,
}

impl<'s> Parser<'s> {
    pub(super) fn object(&mut self, keyword: Token<'s>) -> Read<Object> {
        let block = self.open(keyword, FIELDS)?;
        let kind = self.find_type(&block, shape::TYPES)?;
        if !shape::TYPES.contains(&kind.text) {
            self.warn_of_type(&block, kind, shape::TYPES, "left out of the picture");
        }
        let mut common = Common::default();
        let mut noinstance = false;
        let mut shape = ShapeFields::new(kind);
        self.fields(&block, |parser, field| match field.text {
            "type" => parser.word(field).map(|_| Field::Known),
            "noinstance" => {
                noinstance = true;
                Ok(Field::Known)
            }
            "accel" => {
                parser.word(field)?;
                let warning = Diagnostic::warning(field.span, "an object's own `accel` does nothing");
                parser.context.report(warning.label("ignored: one accelerator holds the whole scene"));
                Ok(Field::Known)
            }
            _ => match parser.common_field(&mut common, field)? {
                Field::Known => Ok(Field::Known),
                Field::Unknown => parser.shape_field(&mut shape, field),
            },
        })?;
        if common.shaders.is_empty() && !noinstance {
            let warning = Diagnostic::warning(keyword.span, "the object names no shader");
            self.context.report(warning.help("write `shader <name>` in the block"));
        }
        let shape = self.finish_shape(&block, shape)?;
        let Common { name, shaders, modifiers, transform } = common;
        if shape == Shape::Sphere(SphereForm::Unit) && transform.is_none() && !noinstance {
            let warning = Diagnostic::warning(kind.span, "the sphere has neither `c` and `r` nor a transform");
            self.context.report(warning.label("drawn with radius 1 around the origin"));
        }
        Ok(Object { shaders, modifiers, transform, noinstance, name, shape: Spanned::new(shape, kind.span) })
    }

    pub(super) fn common_field(&mut self, common: &mut Common, field: Token<'s>) -> Read<Field> {
        match field.text {
            "name" => {
                let name = self.string(field)?;
                self.claim(&name);
                common.name = Some(name);
            }
            "shader" => common.shaders = vec![self.string(field)?],
            "shaders" => common.shaders = self.names(field)?,
            "modifier" => common.modifiers = vec![self.string(field)?],
            "modifiers" => common.modifiers = self.names(field)?,
            "transform" => common.transform = Some(self.transform(field)?),
            _ => return Ok(Field::Unknown),
        }
        Ok(Field::Known)
    }

    /// A count and so many names.
    fn names(&mut self, field: Token<'s>) -> Read<Vec<Spanned<String>>> {
        let count = self.count(field)?;
        // Not collected by a size hint: the count is the file's, and may be anything.
        let mut names = Vec::new();
        for _ in 0..count {
            match self.string(field) {
                Ok(name) => names.push(name),
                Err(Reported) => return Err(Reported),
            }
        }
        Ok(names)
    }
}
