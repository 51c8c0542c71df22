use std::borrow::Cow;

use geometry::{Corners, Ellipsoid, Kernels, Mesh, Plane, Sphere, Transform, unit_cube};
use glam::{DVec3, Vec2, Vec3};
use scene_format::{
    Code, Diagnostic, Severity, Span, Spanned,
    scene_file::{
        self, Instance, MeshForm, Object, ParticleSource, PerVertex, PlaneOrientation, Shape, SphereForm, Triple,
    },
    smooth_normals,
};

use crate::Dialect;

use super::{Parts, curved, placement::dvec3, placement::invertible};

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
        if let Some(to_world) = self.place(object.transform.as_ref()) {
            self.add_shape(&object.shape, &object.shaders, &to_world);
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
        if let Some(to_world) = self.place(instance.transform.as_ref()) {
            self.add_shape(shape, &instance.shaders, &to_world);
        }
    }

    /// Where a transform puts an object. What it squeezes flat is left out, as in Sunflow, with a warning.
    fn place(&mut self, written: Option<&Spanned<scene_file::Transform>>) -> Option<Transform> {
        let placed = invertible(written).map_err(|error| {
            let warning = Diagnostic { severity: Severity::Warning, ..error };
            self.diagnostics.push(warning.label("it has no inverse: the object is left out"));
        });
        placed.ok()
    }

    fn add_shape(&mut self, shape: &Spanned<Shape>, shaders: &[Spanned<String>], to_world: &Transform) {
        let (before, planes_before) = (self.bounded.len(), self.planes.len());
        let added = match &shape.value {
            Shape::Sphere(form) => self.add_sphere(*form, shaders, to_world),
            Shape::Plane { point, orientation } => {
                self.add_plane(point.value, *orientation, shaders, to_world, shape.span)
            }
            Shape::Box => {
                self.add_mesh(placed(unit_cube(), to_world, &self.modules.kernels), None, shaders, shape.span)
            }
            Shape::Mesh(mesh) => self.add_mesh(
                placed(from_file(mesh, self.modules.dialect), to_world, &self.modules.kernels),
                mesh.face_shaders.as_ref().map(|shaders| shaders.as_slice()),
                shaders,
                shape.span,
            ),
            Shape::FileMesh { file, smooth } => self.add_file_mesh(file, *smooth, shaders, to_world),
            Shape::Bezier(mesh) => {
                let count = curved::triangles_of(curved::patches_of(mesh), &mesh.subdivision);
                self.add_made(count, || curved::bezier(mesh), shaders, to_world, shape.span)
            }
            Shape::Teapot(subdivision) => {
                let count = curved::triangles_of(curved::TEAPOT_PATCHES, subdivision);
                self.add_made(count, || curved::teapot(subdivision), shaders, to_world, shape.span)
            }
            Shape::Gumbo(subdivision) => {
                let count = curved::triangles_of(curved::GUMBO_PATCHES, subdivision);
                self.add_made(count, || curved::gumbo(subdivision), shaders, to_world, shape.span)
            }
            Shape::Cylinder => self.add_made(Some(0), curved::cylinder, shaders, to_world, shape.span),
            Shape::Torus { radii } => {
                self.add_made(Some(0), || curved::torus(radii.value), shaders, to_world, shape.span)
            }
            Shape::Sphereflake { level, axis, radius } => {
                let level = self.flake_level(*level);
                let axis = axis.map_or([0.0, 0.0, 1.0], |axis| axis.value);
                let radius = radius.map_or(1.0, |radius| radius.value);
                self.check_count(curved::spheres_of(level), shape.span)
                    .and_then(|()| self.add_balls(&curved::sphereflake(level, axis, radius), shaders, to_world))
            }
            Shape::Particles { centers, count, radius } => {
                let count = count.map_or(usize::MAX, |count| count.value as usize);
                self.add_particles(centers, count, radius.value.into(), shaders, to_world)
            }
            Shape::Unrendered(_) | Shape::Unknown(_) => return,
        };
        if added.is_ok() && (before, planes_before) == (self.bounded.len(), self.planes.len()) {
            self.diagnostics.push(
                Diagnostic::warning(Code::EmptyMesh, shape.span, "there is nothing in this object")
                    .label("it has no triangle, and no sphere with a radius"),
            );
        }
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

    /// How often a flake is grown: each step has nine times the spheres of the one before, a third as large.
    fn flake_level(&mut self, asked: Option<Spanned<u32>>) -> u32 {
        let Some(asked) = asked else { return 2 };
        if asked.value > curved::DEEPEST_FLAKE {
            let deepest = curved::DEEPEST_FLAKE;
            self.diagnostics.push(
                Diagnostic::warning(Code::OverLimit, asked.span, format!("a flake is grown {deepest} times at most"))
                    .label(format!("{} times are asked for", asked.value))
                    .help("the smallest spheres have 1/729 of the first one's radius then"),
            );
        }
        asked.value.min(curved::DEEPEST_FLAKE)
    }

    fn add_sphere(
        &mut self,
        form: SphereForm,
        shaders: &[Spanned<String>],
        to_world: &Transform,
    ) -> Result<(), NotPlaced> {
        let place = match form {
            SphereForm::Unit => *to_world,
            SphereForm::CenterRadius { radius, .. } if radius.value == 0.0 => return Ok(()),
            SphereForm::CenterRadius { center, radius } => Transform::scale(DVec3::splat(radius.value.into()))
                .then(&Transform::translation(dvec3(center.value)))
                .then(to_world),
        };
        let shader = self.first_shader(shaders);
        self.add_ball(place, shader)
    }

    /// Adds the sphere of radius 1, placed by a transform.
    fn add_ball(&mut self, place: Transform, shader: u32) -> Result<(), NotPlaced> {
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
        self.shader_of_bounded.push(shader);
        Ok(())
    }

    /// Adds spheres, centre and radius each.
    fn add_balls(
        &mut self,
        spheres: &[(DVec3, f64)],
        shaders: &[Spanned<String>],
        to_world: &Transform,
    ) -> Result<(), NotPlaced> {
        let shader = self.first_shader(shaders);
        for (center, radius) in spheres {
            let place = Transform::scale(DVec3::splat(*radius)).then(&Transform::translation(*center)).then(to_world);
            self.add_ball(place, shader)?;
        }
        Ok(())
    }

    fn add_particles(
        &mut self,
        centers: &ParticleSource,
        count: usize,
        radius: f64,
        shaders: &[Spanned<String>],
        to_world: &Transform,
    ) -> Result<(), NotPlaced> {
        let points = match centers {
            ParticleSource::Points(points) => Cow::Borrowed(points.as_slice()),
            ParticleSource::File { name, little_endian } => {
                Cow::Owned(self.mesh_files.points(name, little_endian.is_some()).map_err(NotPlaced::Because)?)
            }
        };
        let balls: Vec<_> = points.iter().take(count).map(|center| (dvec3(*center), radius)).collect();
        self.add_balls(&balls, shaders, to_world)
    }

    fn add_file_mesh(
        &mut self,
        file: &Spanned<String>,
        smooth: Option<Spanned<bool>>,
        shaders: &[Spanned<String>],
        to_world: &Transform,
    ) -> Result<(), NotPlaced> {
        let mut mesh = self.mesh_files.mesh(file).map_err(NotPlaced::Because)?;
        if smooth.is_some_and(|smooth| smooth.value) && *mesh.normals == PerVertex::None {
            smooth_normals(&mut mesh);
        }
        self.add_mesh(
            placed(from_file(&mesh, self.modules.dialect), to_world, &self.modules.kernels),
            None,
            shaders,
            file.span,
        )
    }

    /// Adds a mesh that is made here, of so many triangles.
    fn add_made(
        &mut self,
        count: Option<usize>,
        make: impl FnOnce() -> Mesh,
        shaders: &[Spanned<String>],
        to_world: &Transform,
        span: Span,
    ) -> Result<(), NotPlaced> {
        self.check_count(count, span)?;
        self.add_mesh(placed(make(), to_world, &self.modules.kernels), None, shaders, span)
    }

    /// Whether an object may have so many elements; `None` is more than can be counted.
    fn check_count(&self, count: Option<usize>, span: Span) -> Result<(), NotPlaced> {
        let most = self.modules.limits.elements;
        if count.is_some_and(|count| count <= most) {
            return Ok(());
        }
        let message = format!("an object may have at most {most} elements");
        let error = Diagnostic::error(Code::OverLimit, span, message).label(match count {
            Some(count) => format!("this one would have {count}"),
            None => "this one would have more than can be counted".to_owned(),
        });
        Err(NotPlaced::Because(error.help("a smaller `subdivs` or `level` is enough for any picture")))
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
            geometry::Triangle { corners }.scaled_normal() == DVec3::ZERO
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
fn placed(mut mesh: Mesh, to_world: &Transform, kernels: &Kernels) -> Mesh {
    if *to_world == Transform::IDENTITY {
        return mesh;
    }
    for position in &mut mesh.positions {
        *position = to_world.point_f32(*position);
    }
    // Their lengths among each other stay as they are: a longer one counts for more where they are interpolated.
    let matrix = kernels.matrix_of_normals(to_world);
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
