use super::Parser;
use super::block::Field;
use super::report::Read;
use super::shape::{self, ShapeFields};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::grammar;
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
    "filename",
    "smooth_normals",
    "wrap",
    "subdivs",
    "smooth",
    "level",
    "axis",
    "radius",
    "num",
    "little_endian",
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
        let block = self.open(keyword, FIELDS, grammar::OBJECTS)?;
        let kind = self.find_type(&block, shape::RENDERED)?;
        self.check_object_type(&block, kind);
        let mut common = Common::default();
        let (mut noinstance, mut accelerator) = (None, None);
        let mut shape = ShapeFields::new(kind);
        self.fields(&block, |parser, field| match field.text {
            "type" => parser.word(field).map(|_| Field::Known),
            "noinstance" => {
                noinstance = Some(Spanned::new((), field.span));
                Ok(Field::Known)
            }
            "accel" => {
                accelerator = Some(parser.string(field)?);
                let warning = Diagnostic::warning(Code::Ignored, field.span, "an object's own `accel` does nothing");
                parser.context.report(warning.label("ignored: one accelerator holds the whole scene"));
                Ok(Field::Known)
            }
            _ => match parser.common_field(&mut common, field)? {
                Field::Known => Ok(Field::Known),
                Field::Unknown => parser.shape_field(&mut shape, field),
            },
        })?;
        if common.shaders.is_empty() && noinstance.is_none() {
            let warning = Diagnostic::warning(Code::NoShader, keyword.span, "the object names no shader");
            self.context.report(warning.help("write `shader <name>` in the block"));
        }
        let shape = self.finish_shape(&block, shape)?;
        let Common { name, shaders, modifiers, transform } = common;
        if shape == Shape::Sphere(SphereForm::Unit) && transform.is_none() && noinstance.is_none() {
            let message = "the sphere has neither `c` and `r` nor a transform";
            let warning = Diagnostic::warning(Code::NoPlace, kind.span, message);
            self.context.report(warning.label("drawn with radius 1 around the origin"));
        }
        let shape = Spanned::new(shape, kind.span);
        Ok(Object { shaders, modifiers, transform, noinstance, accelerator, name, shape })
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
        let count = self.count(field)?.value;
        // Not collected by a size hint: the count is the file's, and may be anything.
        let mut names = Vec::new();
        for _ in 0..count {
            let name = self.word(field)?;
            names.push(super::block::kept(name));
        }
        Ok(names)
    }
}
