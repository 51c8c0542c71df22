use super::Parser;
use super::block::{Block, Field};
use super::curved::{BezierFields, ParticleFields};
use super::mesh::MeshFields;
use super::report::Read;
use super::unrendered::OtherFields;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::grammar;
use crate::lexer::{Token, is_number};
use crate::scene_file::{Kind, MeshForm, PlaneOrientation, Shape, SphereForm, Subdivision, Triple};
use crate::span::Spanned;

/// The types that are rendered.
pub(super) const RENDERED: &[&str] = &[
    "sphere",
    "plane",
    "box",
    "generic-mesh",
    "mesh",
    "flat-mesh",
    "file-mesh",
    "bezier-mesh",
    "cylinder",
    "torus",
    "sphereflake",
    "teapot",
    "gumbo",
    "particles",
];

/// The fields of an object that depend on its type, as far as they were there.
#[expect(clippy::large_enum_variant, reason = "there is one at a time, while its object is read")]
pub(super) enum ShapeFields<'s> {
    Sphere { center: Option<Spanned<Triple>>, radius: Option<Spanned<f32>> },
    Plane { points: Vec<Spanned<Triple>>, normal: Option<Spanned<Triple>> },
    Box,
    Mesh(Box<MeshFields<'s>>),
    FileMesh { file: Option<Spanned<String>>, smooth: Option<Spanned<bool>> },
    Bezier(BezierFields),
    Cylinder,
    Torus { radii: Option<Spanned<[f32; 2]>> },
    Sphereflake { level: Option<Spanned<u32>>, axis: Option<Spanned<Triple>>, radius: Option<Spanned<f32>> },
    Teapot(Subdivision),
    Gumbo(Subdivision),
    Particles(ParticleFields),
    Other(OtherFields<'s>),
}

impl<'s> ShapeFields<'s> {
    pub(super) fn new(kind: Token<'s>) -> Self {
        match kind.text {
            "sphere" => Self::Sphere { center: None, radius: None },
            "plane" => Self::Plane { points: Vec::new(), normal: None },
            "box" => Self::Box,
            "generic-mesh" => Self::Mesh(Box::new(MeshFields::new(MeshForm::Generic))),
            "mesh" => Self::Mesh(Box::new(MeshFields::new(MeshForm::Lines))),
            "flat-mesh" => Self::Mesh(Box::new(MeshFields::new(MeshForm::FlatLines))),
            "file-mesh" => Self::FileMesh { file: None, smooth: None },
            "bezier-mesh" => Self::Bezier(BezierFields::default()),
            "cylinder" => Self::Cylinder,
            "torus" => Self::Torus { radii: None },
            "sphereflake" => Self::Sphereflake { level: None, axis: None, radius: None },
            "teapot" => Self::Teapot(Subdivision::default()),
            "gumbo" => Self::Gumbo(Subdivision::default()),
            "particles" => Self::Particles(ParticleFields::default()),
            _ => Self::Other(OtherFields::new(kind, grammar::OBJECTS)),
        }
    }
}

impl<'s> Parser<'s> {
    /// Warns of a type that is not rendered.
    pub(super) fn check_object_type(&mut self, block: &Block<'s>, kind: Token<'s>) {
        const EFFECT: &str = "left out of the picture";
        let unrendered = || grammar::OBJECTS.iter().map(|(name, _)| *name);
        if RENDERED.contains(&kind.text) {
            return;
        }
        if unrendered().any(|name| name == kind.text) {
            return self.warn_of_unrendered(block, kind, RENDERED, EFFECT);
        }
        let known: Vec<&str> = RENDERED.iter().copied().chain(unrendered()).collect();
        self.warn_of_unknown(block, kind, &known, EFFECT);
    }

    pub(super) fn shape_field(&mut self, shape: &mut ShapeFields<'s>, field: Token<'s>) -> Read<Field> {
        match (shape, field.text) {
            (ShapeFields::Sphere { center, .. }, "c") => *center = Some(self.floats(field)?),
            (ShapeFields::Sphere { radius, .. }, "r") => *radius = Some(self.float(field)?),
            (ShapeFields::Plane { points, .. }, "p") => {
                points.push(self.floats(field)?);
                // All points in one go: `p` is the one field that may stand in a block more than once.
                while let Some(next) = self.take("p") {
                    points.push(self.floats(next)?);
                }
            }
            (ShapeFields::Plane { normal, .. }, "n") => *normal = Some(self.direction(field, "a plane's normal")?),
            (ShapeFields::Mesh(mesh), "points" | "triangles" | "normals" | "uvs" | "face_shaders") => {
                return self.mesh_field(mesh, field);
            }
            (ShapeFields::Mesh(mesh), number) if is_number(number) => return self.mesh_lines(mesh, field),
            (ShapeFields::FileMesh { file, .. }, "filename") => *file = Some(self.string(field)?),
            (ShapeFields::FileMesh { smooth, .. }, "smooth_normals") => *smooth = Some(self.boolean(field)?),
            (ShapeFields::Bezier(bezier), _) => return self.bezier_field(bezier, field),
            (ShapeFields::Torus { radii }, "r") => *radii = Some(self.torus_radii(field)?),
            (ShapeFields::Sphereflake { level, .. }, "level") => *level = Some(self.count(field)?),
            (ShapeFields::Sphereflake { axis, .. }, "axis") => {
                *axis = Some(self.direction(field, "a sphereflake's axis")?);
            }
            (ShapeFields::Sphereflake { radius, .. }, "radius") => *radius = Some(self.float(field)?),
            (ShapeFields::Teapot(subdivision) | ShapeFields::Gumbo(subdivision), _) => {
                return self.subdivision_field(subdivision, field);
            }
            (ShapeFields::Particles(particles), _) => return self.particle_field(particles, field),
            (ShapeFields::Other(other), _) => return self.other_field(other, field),
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
            ShapeFields::Mesh(mesh) => self.finish_mesh(block, *mesh).map(Shape::Mesh),
            ShapeFields::FileMesh { file, smooth } => {
                Ok(Shape::FileMesh { file: self.require(block, file, "filename", "filename <file>")?, smooth })
            }
            ShapeFields::Bezier(bezier) => self.finish_bezier(block, bezier).map(Shape::Bezier),
            ShapeFields::Cylinder => Ok(Shape::Cylinder),
            ShapeFields::Torus { radii } => {
                Ok(Shape::Torus { radii: self.require(block, radii, "r", "r <inner> <outer>")? })
            }
            ShapeFields::Sphereflake { level, axis, radius } => Ok(Shape::Sphereflake { level, axis, radius }),
            ShapeFields::Teapot(subdivision) => Ok(Shape::Teapot(subdivision)),
            ShapeFields::Gumbo(subdivision) => Ok(Shape::Gumbo(subdivision)),
            ShapeFields::Particles(particles) => self.finish_particles(block, particles),
            ShapeFields::Other(other) => Ok(match other.finish() {
                Kind::Unrendered(shape) => Shape::Unrendered(shape),
                Kind::Unknown(shape) => Shape::Unknown(shape),
            }),
        }
    }

    pub(super) fn positive(&mut self, field: Token<'s>) -> Read<Spanned<f32>> {
        self.float_that(field, "greater than 0", |number| number > 0.0)
    }

    /// A vector that must not be zero.
    fn direction(&mut self, field: Token<'s>, what: &str) -> Read<Spanned<Triple>> {
        let direction: Spanned<Triple> = self.floats(field)?;
        if direction.value == [0.0; 3] {
            let place = field.span.to(direction.span);
            return self.fail(Diagnostic::error(Code::OutOfRange, place, format!("{what} must not be 0 0 0")));
        }
        Ok(direction)
    }

    fn torus_radii(&mut self, field: Token<'s>) -> Read<Spanned<[f32; 2]>> {
        self.placed(|parser| Ok([parser.positive(field)?.value, parser.positive(field)?.value]))
    }

    fn plane(&mut self, block: &Block<'s>, points: &[Spanned<Triple>], normal: Option<Spanned<Triple>>) -> Read<Shape> {
        match (points, normal) {
            ([point], Some(normal)) => {
                Ok(Shape::Plane { point: *point, orientation: PlaneOrientation::Normal(normal) })
            }
            ([point, second, third], None) => {
                Ok(Shape::Plane { point: *point, orientation: PlaneOrientation::Points([*second, *third]) })
            }
            _ => {
                let found = format!("found {} times `p` and {} times `n`", points.len(), u8::from(normal.is_some()));
                let message = "the plane is not determined";
                let error = Diagnostic::error(Code::UndeterminedPlane, block.keyword.span, message)
                    .label(found)
                    .help("write `p x y z n x y z`, or three times `p x y z`");
                self.fail(error)
            }
        }
    }
}
