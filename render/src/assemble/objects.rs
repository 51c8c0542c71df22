use geometry::{Corners, Ellipsoid, Mesh, Plane, Sphere, Transform, unit_cube};
use glam::{Vec2, Vec3};
use scene_format::{
    Code, Diagnostic, Span, Spanned,
    scene_file::{self, Instance, MeshForm, Object, PerVertex, PlaneOrientation, Shape, SphereForm, Triple},
};

use crate::Dialect;

use super::{Parts, placement::dvec3, placement::invertible};

/// Coordinates beyond this make boxes and distances overflow.
const LARGEST_COORDINATE: f32 = 1e15;

impl<'a> Parts<'a> {
    pub(super) fn add_object(&mut self, object: &'a Object) {
        if let Some(name) = &object.name {
            self.geometries.insert(&name.value, &object.shape);
        }
        if object.noinstance.is_some() {
            return;
        }
        match invertible(object.transform.as_ref()) {
            Ok(to_world) => self.add_shape(&object.shape, &object.shaders, &to_world),
            Err(diagnostic) => self.diagnostics.push(diagnostic),
        }
    }

    pub(super) fn add_instance(&mut self, instance: &'a Instance) {
        let Some(&shape) = self.geometries.get(instance.geometry.value.as_str()) else {
            let name = &instance.geometry;
            self.diagnostics.push(
                Diagnostic::warning(
                    Code::UndeclaredGeometry,
                    name.span,
                    format!("no object `{}` comes before this instance of it", name.value),
                )
                .label("the instance is left out"),
            );
            return;
        };
        // The centre and radius of a sphere belong to its own object: an instance starts from the unit sphere.
        let unit_sphere = Spanned::new(Shape::Sphere(SphereForm::Unit), shape.span);
        let shape = if matches!(shape.value, Shape::Sphere(_)) { &unit_sphere } else { shape };
        match invertible(instance.transform.as_ref()) {
            Ok(to_world) => self.add_shape(shape, &instance.shaders, &to_world),
            Err(diagnostic) => self.diagnostics.push(diagnostic),
        }
    }

    fn add_shape(&mut self, shape: &Spanned<Shape>, shaders: &[Spanned<String>], to_world: &Transform) {
        let added = match &shape.value {
            Shape::Sphere(form) => self.add_sphere(*form, shaders, to_world),
            Shape::Plane { point, orientation } => {
                self.add_plane(point.value, *orientation, shaders, to_world, shape.span)
            }
            Shape::Box => self.add_mesh(placed(unit_cube(), to_world), None, shaders, shape.span),
            Shape::Mesh(mesh) => self.add_mesh(
                placed(from_file(mesh, self.modules.dialect), to_world),
                mesh.face_shaders.as_ref().map(|shaders| shaders.as_slice()),
                shaders,
                shape.span,
            ),
            _ => Ok(()),
        };
        match added {
            Err(NotPlaced::TooFar) => self.diagnostics.push(
                Diagnostic::error(Code::TooFar, shape.span, "this object reaches too far out")
                    .label(format!("a coordinate beyond {LARGEST_COORDINATE:e}"))
                    .help("scale the scene down, or look for a number that has too many digits"),
            ),
            Err(NotPlaced::Because(diagnostic)) => self.diagnostics.push(diagnostic),
            Ok(()) => {}
        }
    }

    fn add_sphere(
        &mut self,
        form: SphereForm,
        shaders: &[Spanned<String>],
        to_world: &Transform,
    ) -> Result<(), NotPlaced> {
        let place = match form {
            SphereForm::Unit => *to_world,
            SphereForm::CenterRadius { center, radius } => Transform::scale(glam::DVec3::splat(radius.value.into()))
                .then(&Transform::translation(dvec3(center.value)))
                .then(to_world),
        };
        // Turned or stretched, it is an ellipsoid.
        match place.uniform_scale() {
            Some(scale) => {
                let sphere = Sphere { center: place.translation.as_vec3(), radius: scale as f32 };
                check_reach([sphere.center, Vec3::splat(sphere.radius)])?;
                self.bounded.add_sphere(sphere);
            }
            None => {
                let ellipsoid = Ellipsoid::new(place).ok_or(NotPlaced::TooFar)?;
                let bounds = geometry::Primitive::bounds(&ellipsoid);
                check_reach([bounds.min, bounds.max])?;
                self.bounded.add_ellipsoid(ellipsoid);
            }
        }
        let shader = self.first_shader(shaders);
        self.shader_of_bounded.push(shader);
        Ok(())
    }

    fn add_plane(
        &mut self,
        point: Triple,
        orientation: PlaneOrientation,
        shaders: &[Spanned<String>],
        to_world: &Transform,
        span: Span,
    ) -> Result<(), NotPlaced> {
        let local = match orientation {
            PlaneOrientation::Normal(normal) => Plane::from_normal(point.into(), normal.value.into()),
            PlaneOrientation::Points([second, third]) => {
                Plane::from_points(point.into(), second.value.into(), third.value.into())
            }
        };
        let plane = local.and_then(|plane| plane.transformed(to_world)).ok_or_else(|| {
            NotPlaced::Because(match orientation {
                PlaneOrientation::Normal(_) => {
                    Diagnostic::error(Code::UndeterminedPlane, span, "this plane's normal is zero")
                        .help("`n 0 0 1` is a floor where z points upwards")
                }
                PlaneOrientation::Points(_) => {
                    Diagnostic::error(Code::UndeterminedPlane, span, "this plane's three points lie on one line")
                        .help("move one of them aside")
                }
            })
        })?;
        let (plane, shader) = match self.modules.dialect {
            Dialect::Report => (plane, self.first_shader(shaders)),
            Dialect::Sunflow => {
                let shader = match shaders.first() {
                    Some(name) => {
                        self.shaders.used_with_normals(name, sunflow_normal_length(point, orientation, to_world))
                    }
                    None => self.shaders.default_shader(),
                };
                let plane = match orientation {
                    PlaneOrientation::Normal(_) => plane.without_texture_coordinates(),
                    PlaneOrientation::Points(_) => plane,
                };
                (plane, shader)
            }
        };
        self.planes.push(plane);
        self.shader_of_planes.push(shader);
        Ok(())
    }

    fn add_mesh(
        &mut self,
        mesh: Mesh,
        face_shaders: Option<&[u32]>,
        shaders: &[Spanned<String>],
        span: Span,
    ) -> Result<(), NotPlaced> {
        check_reach(mesh.positions.iter().copied())?;
        self.warn_of_flat_triangles(&mesh, span);
        let faces = mesh.triangles.len();
        match face_shaders {
            None => {
                let shader = self.first_shader(shaders);
                self.shader_of_bounded.extend(std::iter::repeat_n(shader, faces));
            }
            Some(indices) => {
                let numbers: Vec<u32> = shaders.iter().map(|name| self.shaders.used(name)).collect();
                let default = numbers.len() as u32;
                if indices.iter().any(|&index| index >= default) {
                    self.diagnostics.push(
                        Diagnostic::warning(
                            Code::NoSuchFaceShader,
                            span,
                            "some face shaders of this mesh are not in its list of shaders",
                        )
                        .label(format!("the object has {default}"))
                        .help("those triangles are rendered in the default colour"),
                    );
                }
                for face in 0..faces {
                    let number = indices.get(face).and_then(|&index| numbers.get(index as usize)).copied();
                    let number = number.unwrap_or_else(|| self.shaders.default_shader());
                    self.shader_of_bounded.push(number);
                }
            }
        }
        self.bounded.add_mesh(mesh);
        Ok(())
    }

    fn warn_of_flat_triangles(&mut self, mesh: &Mesh, span: Span) {
        let is_flat = |&&corners: &&[u32; 3]| {
            let corners = corners.map(|corner| mesh.positions[corner as usize]);
            geometry::Triangle { corners }.scaled_normal() == glam::DVec3::ZERO
        };
        let flat = mesh.triangles.iter().filter(is_flat).count();
        if flat > 0 {
            let triangles = mesh.triangles.len();
            self.diagnostics.push(
                Diagnostic::warning(
                    Code::FlatTriangles,
                    span,
                    format!("{flat} of this mesh's {triangles} triangles have no area"),
                )
                .label("they are never seen")
                .help("two of their corners are the same point, or all three lie on one line"),
            );
        }
    }

    fn first_shader(&mut self, shaders: &[Spanned<String>]) -> u32 {
        match shaders.first() {
            Some(name) => self.shaders.used(name),
            None => self.shaders.default_shader(),
        }
    }
}

/// The length of a plane's normal as Sunflow has it in the world: as it is written, or 1 where three points are given, and then multiplied by
/// the inverse transpose.
fn sunflow_normal_length(point: Triple, orientation: PlaneOrientation, to_world: &Transform) -> f32 {
    let local = match orientation {
        PlaneOrientation::Normal(normal) => dvec3(normal.value),
        PlaneOrientation::Points([second, third]) => {
            let [u, v] = [second, third].map(|other| dvec3(other.value) - dvec3(point));
            u.cross(v).normalize()
        }
    };
    let placed = to_world.inverse().map_or(local, |to_local| to_local.linear.transpose() * local);
    placed.length() as f32
}

/// Why a shape is not in the scene.
enum NotPlaced {
    TooFar,
    Because(Diagnostic),
}

fn check_reach(points: impl IntoIterator<Item = Vec3>) -> Result<(), NotPlaced> {
    let within = |point: Vec3| point.abs().cmple(Vec3::splat(LARGEST_COORDINATE)).all();
    if points.into_iter().all(within) { Ok(()) } else { Err(NotPlaced::TooFar) }
}

/// A mesh as its file gives it.
fn from_file(mesh: &scene_file::Mesh, dialect: Dialect) -> Mesh {
    let normals = match (&mesh.normals.value, mesh.form) {
        (_, MeshForm::FlatLines) | (PerVertex::None, _) => Corners::None,
        (PerVertex::Vertex(normals), _) => Corners::PerPoint(normals.iter().copied().map(Vec3::from).collect()),
        (PerVertex::FaceVarying(normals), _) => {
            Corners::PerTriangle(normals.iter().map(|corners| corners.map(Vec3::from)).collect())
        }
    };
    let uvs = match &mesh.uvs.value {
        PerVertex::None => match dialect {
            Dialect::Report => Corners::None,
            Dialect::Sunflow => Corners::Everywhere(Vec2::ZERO),
        },
        PerVertex::Vertex(uvs) => Corners::PerPoint(uvs.iter().copied().map(Vec2::from).collect()),
        PerVertex::FaceVarying(uvs) => {
            Corners::PerTriangle(uvs.iter().map(|corners| corners.map(Vec2::from)).collect())
        }
    };
    let positions = mesh.points.iter().copied().map(Vec3::from).collect();
    Mesh { positions, triangles: mesh.triangles.value.clone(), normals, uvs }
}

/// A mesh under a transform. Where that mirrors, each triangle is turned round, so that its front stays in front.
fn placed(mut mesh: Mesh, to_world: &Transform) -> Mesh {
    if *to_world == Transform::IDENTITY {
        return mesh;
    }
    for position in &mut mesh.positions {
        *position = to_world.point_f32(*position);
    }
    // Their lengths among each other stay as they are: a longer one counts for more where they are interpolated.
    let matrix = to_world.normals();
    let longest = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(|axis| axis.abs().max_element());
    let matrix = matrix * longest.into_iter().fold(0.0, f64::max).recip();
    let turned = |normal: Vec3| (matrix * normal.as_dvec3()).as_vec3();
    match &mut mesh.normals {
        Corners::None => {}
        Corners::Everywhere(normal) => *normal = turned(*normal),
        Corners::PerPoint(normals) => normals.iter_mut().for_each(|normal| *normal = turned(*normal)),
        Corners::PerTriangle(normals) => normals.iter_mut().for_each(|corners| *corners = corners.map(turned)),
    }
    if to_world.mirrors() {
        turn_round(&mut mesh);
    }
    mesh
}

/// Swaps the second and third corner of each triangle, with all that belongs to them.
fn turn_round(mesh: &mut Mesh) {
    mesh.triangles.iter_mut().for_each(|corners| corners.swap(1, 2));
    if let Corners::PerTriangle(normals) = &mut mesh.normals {
        normals.iter_mut().for_each(|corners| corners.swap(1, 2));
    }
    match &mut mesh.uvs {
        Corners::PerTriangle(uvs) => uvs.iter_mut().for_each(|corners| corners.swap(1, 2)),
        // The basis of the two edges, which have changed places.
        uvs @ Corners::None => *uvs = Corners::PerTriangle(vec![[Vec2::ZERO, Vec2::Y, Vec2::X]; mesh.triangles.len()]),
        Corners::PerPoint(_) | Corners::Everywhere(_) => {}
    }
}
