use super::block::{Block, Field};
use super::layout::Mark;
use super::report::Read;
use super::unrendered::OtherFields;
use super::{Parser, Reported};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::{Camera, CameraPlacement, Kind, Lens, Statement, Triple, Unknown, View};
use crate::span::{Span, Spanned};

/// The types that are rendered.
const RENDERED: &[&str] = &["pinhole", "thinlens"];
const TYPES: &[&str] = &["pinhole", "thinlens", "spherical", "fisheye"];
const FIELDS: &[&str] = &[
    "type",
    "shutter",
    "eye",
    "target",
    "up",
    "transform",
    "steps",
    "fov",
    "aspect",
    "shift",
    "fdist",
    "lensr",
    "sides",
    "rotation",
];

/// The fields of a camera, as far as they were there.
#[derive(Default)]
struct Fields {
    look: Look,
    /// A placement that needs no `eye`.
    whole: Option<(CameraPlacement, Span)>,
    shutter: Option<Spanned<[f32; 2]>>,
    fov: Option<Spanned<f32>>,
    aspect: Option<Spanned<f32>>,
    shift: Option<Spanned<[f32; 2]>>,
    focus_distance: Option<Spanned<f32>>,
    radius: Option<Spanned<f32>>,
    sides: Option<Spanned<u32>>,
    rotation: Option<Spanned<f32>>,
}

#[derive(Clone, Copy, Default)]
struct Look {
    eye: Option<Spanned<Triple>>,
    target: Option<Spanned<Triple>>,
    up: Option<Spanned<Triple>>,
}

impl<'s> Parser<'s> {
    pub(super) fn camera(&mut self, keyword: Token<'s>) -> Read<Statement> {
        let block = self.open(keyword, FIELDS, &[])?;
        let kind = self.find_type(&block, RENDERED)?;
        if !TYPES.contains(&kind.text) {
            return self.unknown_camera(&block, kind);
        }
        if !RENDERED.contains(&kind.text) {
            self.warn_of_unrendered(&block, kind, RENDERED, "this camera is skipped");
        }
        let mut fields = Fields::default();
        self.fields(&block, |parser, field| match (field.text, kind.text) {
            ("fdist" | "lensr" | "sides" | "rotation", "thinlens") => parser.lens_field(&mut fields, field),
            ("fov" | "aspect" | "shift", "pinhole" | "thinlens") => parser.view_field(&mut fields, field),
            _ => parser.camera_field(&mut fields, field),
        })?;
        let placement = self.placement(&block, &fields);
        let lens = self.lens(&block, kind, &fields);
        let (placement, (lens, shutter)) = (placement?, lens?);
        Ok(Statement::Camera(Camera { lens: Spanned::new(lens, kind.span), placement, shutter }))
    }

    /// A camera of a type that nobody knows is a statement that nobody knows.
    fn unknown_camera(&mut self, block: &Block<'s>, kind: Token<'s>) -> Read<Statement> {
        self.warn_of_unknown(block, kind, TYPES, "this camera is skipped");
        let brace = |text: &str, span| Spanned::new(text.to_owned(), span);
        let mut other = OtherFields::Unknown { kind: block.keyword, words: vec![brace("{", block.opened)] };
        self.fields(block, |parser, field| parser.other_field(&mut other, field))?;
        match other.finish() {
            Kind::Unknown(Unknown { keyword, mut words }) => {
                words.push(brace("}", self.cursor.previous()));
                Ok(Statement::Unknown(Unknown { keyword, words }))
            }
            Kind::Unrendered(_) => Err(Reported),
        }
    }

    fn camera_field(&mut self, fields: &mut Fields, field: Token<'s>) -> Read<Field> {
        match field.text {
            "type" => {
                self.word(field)?;
            }
            "shutter" => {
                fields.shutter = Some(self.floats(field)?);
                let message = "`shutter` does nothing: movement is not rendered";
                self.context.report(Diagnostic::warning(Code::Ignored, field.span, message).label("ignored"));
            }
            "eye" | "target" | "up" => self.look_field(&mut fields.look, field)?,
            "transform" => {
                let transform = self.transform(field)?;
                let span = transform.span;
                fields.whole = Some((CameraPlacement::Transform(transform), span));
            }
            "steps" => {
                let (times, steps) = self.moving(field, Self::camera_step)?;
                let span = field.span.to(self.cursor.previous());
                fields.whole = Some((CameraPlacement::Moving { times, steps }, span));
            }
            _ => return Ok(Field::Unknown),
        }
        Ok(Field::Known)
    }

    fn view_field(&mut self, fields: &mut Fields, field: Token<'s>) -> Read<Field> {
        match field.text {
            "fov" => {
                let fov = self.float(field)?;
                if !(0.0 < fov.value && fov.value < 180.0) {
                    let message = "a plane shows more than 0 and less than 180 degrees";
                    let effect = "is as wide as twice the tangent of half of this";
                    self.warn_of_view(fov.span, message, effect, "60 is usual");
                }
                fields.fov = Some(fov);
            }
            "aspect" => {
                let aspect = self.float_that(field, "other than 0", |aspect| aspect != 0.0)?;
                if aspect.value < 0.0 {
                    let message = "the width of a plane over its height is more than 0";
                    self.warn_of_view(
                        aspect.span,
                        message,
                        "is upside down",
                        "write the picture's width over its height",
                    );
                }
                fields.aspect = Some(aspect);
            }
            _ => fields.shift = Some(self.floats(field)?),
        }
        Ok(Field::Known)
    }

    /// Of a view that no plane can show, and what becomes of the picture.
    fn warn_of_view(&mut self, place: Span, message: &str, effect: &str, help: &str) {
        let warning = Diagnostic::warning(Code::ImpossibleView, place, message);
        self.context.report(warning.label(format!("the picture {effect}, as Sunflow's is")).help(help));
    }

    fn lens_field(&mut self, fields: &mut Fields, field: Token<'s>) -> Read<Field> {
        match field.text {
            "fdist" => {
                fields.focus_distance = Some(self.float_that(field, "greater than 0", |distance| distance > 0.0)?);
            }
            "lensr" => fields.radius = Some(self.float_that(field, "0 or greater", |radius| radius >= 0.0)?),
            "sides" => fields.sides = Some(self.count(field)?),
            _ => fields.rotation = Some(self.float(field)?),
        }
        Ok(Field::Known)
    }

    fn look_field(&mut self, look: &mut Look, field: Token<'s>) -> Read<()> {
        let triple = self.floats(field)?;
        match field.text {
            "eye" => look.eye = Some(triple),
            "target" => look.target = Some(triple),
            _ => look.up = Some(triple),
        }
        Ok(())
    }

    /// One step of a moving camera: a transform, or a place in braces.
    fn camera_step(&mut self, steps: Token<'s>) -> Read<CameraPlacement> {
        if let Some(transform) = self.take("transform") {
            return self.matrix(transform).map(CameraPlacement::Transform);
        }
        let open = self.expect("{", format_args!("`{}` needs a place for each step", steps.text))?;
        let mut look = Look::default();
        while let Some(field) = self.cursor.peek().filter(|field| matches!(field.text, "eye" | "target" | "up")) {
            self.cursor.next();
            self.mark(field, Mark::Field);
            self.look_field(&mut look, field)?;
        }
        self.close_group(open, "the camera's step")?;
        match look {
            Look { eye: Some(eye), target: Some(target), up: Some(up) } => {
                Ok(CameraPlacement::LookAt { eye, target, up })
            }
            _ => {
                let error = Diagnostic::error(Code::MissingField, open.span, "the camera's step is incomplete");
                self.fail(error.label("expected `eye x y z target x y z up x y z` in these braces"))
            }
        }
    }

    fn lens(&mut self, block: &Block<'s>, kind: Token<'s>, fields: &Fields) -> Read<(Lens, Option<Spanned<[f32; 2]>>)> {
        let shutter = fields.shutter;
        match kind.text {
            "spherical" => return Ok((Lens::Spherical, shutter)),
            "fisheye" => return Ok((Lens::Fisheye, shutter)),
            _ => {}
        }
        let fov = self.require(block, fields.fov, "fov", "fov <degrees>");
        let aspect = self.require(block, fields.aspect, "aspect", "aspect <width over height>");
        let view = fov.and_then(|fov| Ok(View { fov, aspect: aspect?, shift: fields.shift }));
        if kind.text == "pinhole" {
            return Ok((Lens::Pinhole(view?), shutter));
        }
        let focus_distance = self.require(block, fields.focus_distance, "fdist", "fdist <distance>");
        let radius = self.require(block, fields.radius, "lensr", "lensr <radius>");
        let (sides, rotation) = (fields.sides, fields.rotation);
        let lens = Lens::Thin { view: view?, focus_distance: focus_distance?, radius: radius?, sides, rotation };
        Ok((lens, shutter))
    }

    fn placement(&mut self, block: &Block<'s>, fields: &Fields) -> Read<CameraPlacement> {
        let Look { eye, target, up } = fields.look;
        if let Some((whole, span)) = &fields.whole {
            if let Some(also) = eye.or(target).or(up) {
                let error = Diagnostic::error(Code::Contradiction, also.span, "the camera has two places")
                    .note(*span, "this already says where it stands")
                    .help("write either `eye`, `target` and `up`, or `transform`");
                return self.fail(error);
            }
            return Ok(whole.clone());
        }
        let eye = self.require(block, eye, "eye", "eye x y z");
        let target = self.require(block, target, "target", "target x y z");
        let up = self.require(block, up, "up", "up x y z");
        Ok(CameraPlacement::LookAt { eye: eye?, target: target?, up: up? })
    }
}
