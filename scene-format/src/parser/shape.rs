use super::Parser;
use super::block::{Block, Field, kept, texts};
use super::mesh::MeshFields;
use super::report::Read;
use crate::diagnostic::Diagnostic;
use crate::lexer::{Token, is_number};
use crate::scene_file::{MeshForm, Other, PlaneOrientation, Shape, SphereForm, Triple};

/// The types that are rendered.
pub(super) const TYPES: &[&str] = &["sphere", "plane", "box", "generic-mesh", "mesh", "flat-mesh"];

/// The fields of an object that depend on its type, as far as they were there.
pub(super) enum ShapeFields<'s> {
    Sphere { center: Option<Triple>, radius: Option<f32> },
    Plane { points: Vec<Triple>, normal: Option<Triple> },
    Box,
    Mesh(MeshFields<'s>),
    Other { kind: Token<'s>, words: Vec<Token<'s>> },
}

impl<'s> ShapeFields<'s> {
    pub(super) fn new(kind: Token<'s>) -> Self {
        match kind.text {
            "sphere" => Self::Sphere { center: None, radius: None },
            "plane" => Self::Plane { points: Vec::new(), normal: None },
            "box" => Self::Box,
            "generic-mesh" => Self::Mesh(MeshFields::new(MeshForm::Generic)),
            "mesh" => Self::Mesh(MeshFields::new(MeshForm::Lines)),
            "flat-mesh" => Self::Mesh(MeshFields::new(MeshForm::FlatLines)),
            _ => Self::Other { kind, words: Vec::new() },
        }
    }
}

impl<'s> Parser<'s> {
    pub(super) fn shape_field(&mut self, shape: &mut ShapeFields<'s>, field: Token<'s>) -> Read<Field> {
        match (shape, field.text) {
            (ShapeFields::Sphere { center, .. }, "c") => *center = Some(self.floats(field)?),
            (ShapeFields::Sphere { radius, .. }, "r") => {
                *radius = Some(self.float_that(field, "greater than 0", |radius| radius > 0.0)?);
            }
            (ShapeFields::Plane { points, .. }, "p") => {
                points.push(self.floats(field)?);
                // All points in one go: `p` is the one field that may stand in a block more than once.
                while let Some(next) = self.take("p") {
                    points.push(self.floats(next)?);
                }
            }
            (ShapeFields::Plane { normal, .. }, "n") => *normal = Some(self.normal(field)?),
            (ShapeFields::Mesh(mesh), "points" | "triangles" | "normals" | "uvs" | "face_shaders") => {
                return self.mesh_field(mesh, field);
            }
            (ShapeFields::Mesh(mesh), number) if is_number(number) => return self.mesh_lines(mesh, field),
            (ShapeFields::Other { words, .. }, _) => return self.collect(field, words),
            _ => return Ok(Field::Unknown),
        }
        Ok(Field::Known)
    }

    pub(super) fn finish_shape(&mut self, block: &Block<'s>, shape: ShapeFields<'s>) -> Read<Shape> {
        match shape {
            ShapeFields::Sphere { center: None, radius: None } => Ok(Shape::Sphere(SphereForm::Unit)),
            ShapeFields::Sphere { center, radius } => {
                let center = self.require(block, center, "c", "c x y z");
                let radius = self.require(block, radius, "r", "r <radius>");
                Ok(Shape::Sphere(SphereForm::CenterRadius { center: center?, radius: radius? }))
            }
            ShapeFields::Plane { points, normal } => self.plane(block, &points, normal),
            ShapeFields::Box => Ok(Shape::Box),
            ShapeFields::Mesh(mesh) => self.finish_mesh(block, mesh).map(Shape::Mesh),
            ShapeFields::Other { kind, words } => Ok(Shape::Other(Other { keyword: kept(kind), words: texts(&words) })),
        }
    }

    fn normal(&mut self, field: Token<'s>) -> Read<Triple> {
        let normal = self.floats(field)?;
        if normal == [0.0; 3] {
            let place = field.span.to(self.cursor.previous());
            return self.fail(Diagnostic::error(place, "a plane's normal must not be 0 0 0"));
        }
        Ok(normal)
    }

    fn plane(&mut self, block: &Block<'s>, points: &[Triple], normal: Option<Triple>) -> Read<Shape> {
        let orientation = match (points, normal) {
            ([_], Some(normal)) => PlaneOrientation::Normal(normal),
            ([_, second, third], None) => PlaneOrientation::Points([*second, *third]),
            _ => {
                let found = format!("found {} times `p` and {} times `n`", points.len(), u8::from(normal.is_some()));
                let error = Diagnostic::error(block.keyword.span, "the plane is not determined")
                    .label(found)
                    .help("write `p x y z n x y z`, or three times `p x y z`");
                return self.fail(error);
            }
        };
        match points.first() {
            Some(&point) => Ok(Shape::Plane { point, orientation }),
            None => self.require(block, None, "p", "p x y z"),
        }
    }
}
