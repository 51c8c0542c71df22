use super::block::{Block, Field, kept, texts};
use super::report::Read;
use super::{Parser, Reported};
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::{Camera, CameraPlacement, Lens, Other, Statement, Transform, Triple};
use crate::span::Spanned;

const TYPES: &[&str] = &["pinhole", "thinlens"];
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
    view: View,
    transform: Option<Spanned<Transform>>,
    fov: Option<Spanned<f32>>,
    aspect: Option<Spanned<f32>>,
    shift: Option<[f32; 2]>,
    focus_distance: Option<f32>,
    radius: Option<f32>,
    sides: Option<u32>,
    rotation: Option<f32>,
}

#[derive(Clone, Copy, Default)]
struct View {
    eye: Option<Spanned<Triple>>,
    target: Option<Spanned<Triple>>,
    up: Option<Spanned<Triple>>,
}

impl<'s> Parser<'s> {
    pub(super) fn camera(&mut self, keyword: Token<'s>) -> Read<Statement> {
        let block = self.open(keyword, FIELDS)?;
        let kind = self.find_type(&block, TYPES)?;
        if !TYPES.contains(&kind.text) {
            self.warn_of_type(&block, kind, TYPES, "this camera is skipped");
            let mut words = vec!["{".to_owned()];
            words.extend(texts(&self.other_fields(&block)?));
            words.push("}".to_owned());
            return Ok(Statement::Other(Other { keyword: kept(keyword), words }));
        }
        let thin = kind.text == "thinlens";
        let mut fields = Fields::default();
        self.fields(&block, |parser, field| match field.text {
            "fdist" | "lensr" | "sides" | "rotation" if thin => parser.lens_field(&mut fields, field),
            _ => parser.camera_field(&mut fields, field),
        })?;
        self.finish_camera(&block, kind, &fields).map(Statement::Camera)
    }

    fn camera_field(&mut self, fields: &mut Fields, field: Token<'s>) -> Read<Field> {
        match field.text {
            "type" => {
                self.word(field)?;
            }
            "shutter" => {
                let _open_and_close: [f32; 2] = self.floats(field)?;
                let warning = Diagnostic::warning(field.span, "`shutter` does nothing: movement is not rendered");
                self.context.report(warning.label("ignored"));
            }
            "eye" | "target" | "up" => self.view_field(&mut fields.view, field)?,
            "transform" => fields.transform = Some(self.transform(field)?),
            "steps" => match self.moving(field, Self::camera_step)? {
                Ok(transform) => fields.transform = Some(transform),
                Err(view) => fields.view = view,
            },
            "fov" => {
                fields.fov = Some(self.checked(field, "between 0 and 180 degrees", |fov| 0.0 < fov && fov < 180.0)?);
            }
            "aspect" => fields.aspect = Some(self.checked(field, "greater than 0", |aspect| aspect > 0.0)?),
            "shift" => fields.shift = Some(self.floats(field)?),
            _ => return Ok(Field::Unknown),
        }
        Ok(Field::Known)
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

    fn view_field(&mut self, view: &mut View, field: Token<'s>) -> Read<()> {
        let triple: Triple = self.floats(field)?;
        let place = match field.text {
            "eye" => &mut view.eye,
            "target" => &mut view.target,
            _ => &mut view.up,
        };
        *place = Some(Spanned::new(triple, field.span.to(self.cursor.previous())));
        Ok(())
    }

    /// One step of a moving camera: a transform, or a view in braces.
    fn camera_step(&mut self, steps: Token<'s>) -> Read<Result<Spanned<Transform>, View>> {
        if let Some(transform) = self.take("transform") {
            return self.transform(transform).map(Ok);
        }
        let open = self.expect("{", format_args!("`{}` needs a place for each step", steps.text))?;
        let mut view = View::default();
        while let Some(field) = self.cursor.peek().filter(|field| matches!(field.text, "eye" | "target" | "up")) {
            self.cursor.next();
            self.view_field(&mut view, field)?;
        }
        self.close_group(open, "the camera's step")?;
        Ok(Err(view))
    }

    fn checked(&mut self, field: Token<'_>, condition: &str, holds: impl Fn(f32) -> bool) -> Read<Spanned<f32>> {
        let value = self.float_that(field, condition, holds)?;
        Ok(Spanned::new(value, self.cursor.previous()))
    }

    fn finish_camera(&mut self, block: &Block<'s>, kind: Token<'s>, fields: &Fields) -> Read<Camera> {
        let placement = self.placement(block, fields);
        let fov = self.require(block, fields.fov, "fov", "fov <degrees>");
        let aspect = self.require(block, fields.aspect, "aspect", "aspect <width over height>");
        let lens = self.lens(block, kind, fields);
        Ok(Camera { lens: lens?, placement: placement?, fov: fov?, aspect: aspect?, shift: fields.shift })
    }

    fn lens(&mut self, block: &Block<'s>, kind: Token<'s>, fields: &Fields) -> Read<Lens> {
        if kind.text == "pinhole" {
            return Ok(Lens::Pinhole);
        }
        let focus_distance = self.require(block, fields.focus_distance, "fdist", "fdist <distance>");
        let radius = self.require(block, fields.radius, "lensr", "lensr <radius>");
        let (sides, rotation) = (fields.sides, fields.rotation);
        Ok(Lens::Thin { focus_distance: focus_distance?, radius: radius?, sides, rotation })
    }

    fn placement(&mut self, block: &Block<'s>, fields: &Fields) -> Read<CameraPlacement> {
        let View { eye, target, up } = fields.view;
        if let Some(transform) = &fields.transform {
            if let Some(also) = eye.or(target).or(up) {
                let error = Diagnostic::error(also.span, "the camera has two places")
                    .note(transform.span, "the transform already says where it stands")
                    .help("write either `eye`, `target` and `up`, or `transform`");
                return self.fail(error);
            }
            return Ok(CameraPlacement::Transform(transform.clone()));
        }
        let eye = self.require(block, eye, "eye", "eye x y z");
        let target = self.require(block, target, "target", "target x y z");
        let up = self.require(block, up, "up", "up x y z");
        match (eye, target, up) {
            (Ok(eye), Ok(target), Ok(up)) => {
                let span = eye.span.to(target.span).to(up.span);
                Ok(CameraPlacement::LookAt { eye: eye.value, target: target.value, up: up.value, span })
            }
            _ => Err(Reported),
        }
    }
}
