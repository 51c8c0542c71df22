//! From what a file says to what can be rendered.

mod camera;
mod color;
mod curved;
mod files;
mod lights;
mod objects;
mod picture;
mod placement;
mod shaders;
mod spectrum;

use std::collections::{BTreeMap, BTreeSet};

use accel::Accelerator;
use geometry::{Plane, Primitives};
use scene_format::{
    Code, Diagnostic, Files, SceneFile, SearchPath, Severity, Span, Spanned,
    scene_file::{self, Shape, Statement},
};
use shading::{Bounces, Color, PointLight, SoftShadows};

use crate::{Camera, Dialect, Modules, Raster, Scene, Settings};
use color::linear;
use files::MeshFiles;
use shaders::ShaderTable;
pub use shaders::ShadingNeeds;

/// The most reflections, and the most refractions, of one ray: each takes a part of its thread's stack.
const MOST_BOUNCES: u32 = 128;

/// How a scene is lit beyond what its file says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lighting {
    /// The share of a surface's colour that shows in a scene without lights.
    pub ambient: f32,
    /// Makes many lights of each.
    pub soft_shadows: Option<SoftShadows>,
}

impl Default for Lighting {
    /// The report's dim ambient light, and hard shadows.
    fn default() -> Self {
        Self { ambient: 0.05, soft_shadows: None }
    }
}

/// What came of putting a scene together.
pub struct Assembled {
    /// The scene.
    pub scene: Scene,
    /// How its own file wants it rendered.
    pub settings: Settings,
    /// What there is to say about it.
    pub warnings: Vec<Diagnostic>,
    /// What its shaders need.
    pub shading: ShadingNeeds,
}

/// Puts a scene together: resolves names, applies transforms, reads textures and builds the accelerators, each with the module
/// that `modules` names. What no object uses is not made.
///
/// # Errors
/// All that keeps the scene from being rendered, and the warnings with it: no camera, a texture that cannot be read, a
/// transform without inverse ...
pub fn assemble(
    file: &SceneFile,
    modules: &Modules,
    lighting: &Lighting,
    files: &dyn Files,
) -> Result<Assembled, Vec<Diagnostic>> {
    let mut parts = Parts {
        modules,
        shaders: ShaderTable::new(modules, search_path(file, &["texturepath"]), files),
        mesh_files: MeshFiles::new(search_path(file, &["includepath", "texturepath"]), files, modules.limits),
        names: BTreeSet::new(),
        geometries: BTreeMap::new(),
        diagnostics: Vec::new(),
        camera: None,
        camera_span: Span::default(),
        bounded: Primitives::default().with_kernels(modules.kernels),
        planes: Vec::new(),
        shader_of_bounded: Vec::new(),
        shader_of_planes: Vec::new(),
        lights: Vec::new(),
        background: Color::BLACK,
        // Sunflow's default depths.
        bounces: Bounces::of_camera_ray(4, 4),
    };
    parts.shaders.expect(file);
    parts.read(file);
    parts.finish(lighting, Settings::of(file))
}

/// Where files are looked for: beside each file that was read, and where statements of some kinds say.
fn search_path(file: &SceneFile, kinds: &[&str]) -> SearchPath {
    fn add(path: &mut SearchPath, name: &str, scene: &SceneFile, kinds: &[&str]) {
        path.add_directory_of(name);
        for statement in &scene.statements {
            match &statement.value {
                Statement::TexturePath(directory) if kinds.contains(&"texturepath") => path.add(directory, name),
                Statement::IncludePath(directory) if kinds.contains(&"includepath") => path.add(directory, name),
                Statement::Include { file: Some(included), .. } => add(path, &included.path, &included.scene, kinds),
                _ => {}
            }
        }
    }
    let mut path = SearchPath::new();
    add(&mut path, "", file, kinds);
    path
}

/// A scene in the making.
struct Parts<'a> {
    modules: &'a Modules,
    shaders: ShaderTable<'a>,
    mesh_files: MeshFiles<'a>,
    /// All names given so far. Of two things with one name, whatever they are, the first holds, as in Sunflow.
    names: BTreeSet<&'a str>,
    /// The shapes that instances can show again, by the names of their objects.
    geometries: BTreeMap<&'a str, &'a Spanned<Shape>>,
    diagnostics: Vec<Diagnostic>,
    camera: Option<Box<dyn Camera>>,
    /// Where the camera stands in the source.
    camera_span: Span,
    bounded: Primitives,
    planes: Vec<Plane>,
    shader_of_bounded: Vec<u32>,
    shader_of_planes: Vec<u32>,
    lights: Vec<PointLight>,
    background: Color,
    bounces: Bounces,
}

impl<'a> Parts<'a> {
    fn read(&mut self, file: &'a SceneFile) {
        for statement in &file.statements {
            match &statement.value {
                Statement::Camera(camera) => self.set_camera(camera, statement.span),
                Statement::Shader(shader) if self.is_new(Some(&shader.name)) => self.shaders.declare(shader),
                Statement::Object(object) if self.is_new(object.name.as_ref()) => self.add_object(object),
                Statement::Instance(instance) if self.is_new(instance.name.as_ref()) => self.add_instance(instance),
                Statement::Light(light) => self.lights.extend(lights::point_light(light, self.modules.falloff)),
                Statement::Background(color) => self.background = linear(color),
                Statement::TraceDepths(depths) => self.set_depths(*depths, statement.span),
                Statement::Include { file: Some(included), .. } => self.read(&included.scene),
                Statement::Include { file: None, .. }
                | Statement::Shader(_)
                | Statement::Object(_)
                | Statement::Instance(_)
                | Statement::Image(_)
                | Statement::Bucket(_)
                | Statement::TexturePath(_)
                | Statement::IncludePath(_)
                | Statement::Modifier { .. }
                | Statement::Gi(_)
                | Statement::Photons(_)
                | Statement::LightServer(_)
                | Statement::Override { .. }
                | Statement::Accelerator(_)
                | Statement::Filter { .. }
                | Statement::Unknown(_) => {}
            }
        }
    }

    /// Takes a name, if it is free. What has no name is always new.
    fn is_new(&mut self, name: Option<&'a Spanned<String>>) -> bool {
        name.is_none_or(|name| self.names.insert(&name.value))
    }

    fn set_depths(&mut self, depths: scene_file::TraceDepths, span: Span) {
        let reflections = depths.reflection.map_or(self.bounces.reflections, |depth| depth.value);
        let refractions = depths.refraction.map_or(self.bounces.refractions, |depth| depth.value);
        if reflections.max(refractions) > MOST_BOUNCES {
            self.diagnostics.push(
                Diagnostic::warning(Code::TooManyBounces, span, format!("rays bounce at most {MOST_BOUNCES} times"))
                    .label(format!("{} times are asked for", reflections.max(refractions)))
                    .help("a few are enough: 4 are the default"),
            );
        }
        self.bounces = Bounces::of_camera_ray(reflections.min(MOST_BOUNCES), refractions.min(MOST_BOUNCES));
    }

    /// Takes a camera; of several the last one, as Sunflow does.
    fn set_camera(&mut self, camera: &scene_file::Camera, span: Span) {
        match camera::camera(camera, self.modules) {
            Ok(None) => {}
            Ok(Some(camera)) => {
                if self.camera.replace(camera).is_some() {
                    let message = "this camera is not used: a later one takes its place";
                    let warning = Diagnostic::warning(Code::Ignored, self.camera_span, message);
                    self.diagnostics.push(warning.note(span, "the later one"));
                }
                self.camera_span = span;
            }
            Err(diagnostic) => self.diagnostics.push(diagnostic),
        }
    }

    fn finish(mut self, lighting: &Lighting, settings: Settings) -> Result<Assembled, Vec<Diagnostic>> {
        self.diagnostics.append(&mut self.shaders.diagnostics);
        let failed = self.diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error);
        if self.camera.is_none() && !failed {
            self.diagnostics.push(
                Diagnostic::error(Code::NoCamera, Span::default(), "the scene has no camera")
                    .label("nothing here says where it is seen from")
                    .help(
                        "add a camera: camera { type pinhole eye 0 -10 5 target 0 0 0 up 0 0 1 fov 60 aspect 1.333 }",
                    ),
            );
        }
        let failed = self.diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error);
        let Some(camera) = self.camera.filter(|_| !failed) else { return Err(self.diagnostics) };

        let ShaderTable { made: shaders, .. } = &self.shaders;
        let shading = self.shaders.needs();
        let (mut lights, mut clusters) = (Vec::new(), Vec::new());
        for light in self.lights {
            let start = lights.len();
            match lighting.soft_shadows {
                None => lights.push(light),
                Some(soft) => lights.extend((self.modules.soft_shadows)(light, soft)),
            }
            clusters.push(start..lights.len());
        }
        let casts_shadow = |number: u32| shaders[self.shader_of_bounded[number as usize] as usize].casts_shadow();
        let all_cast_shadows = (0..self.bounded.len()).all(casts_shadow);
        let blockers: Option<Box<dyn Accelerator>> = (!lights.is_empty() && !all_cast_shadows)
            .then(|| (self.modules.accelerator)(self.bounded.subset(casts_shadow)));
        let (secondary_background, raster) = match self.modules.dialect {
            Dialect::Report => (self.background, Raster::BetweenEdges),
            Dialect::Sunflow => (Color::BLACK, Raster::Sunflow),
        };
        let scene = Scene {
            camera,
            accelerator: (self.modules.accelerator)(self.bounded.clone()),
            blockers,
            bounded: self.bounded,
            planes: self.planes,
            shaders: self.shaders.made,
            shader_of: [self.shader_of_bounded, self.shader_of_planes].concat(),
            lights,
            clusters,
            ambient: lighting.ambient,
            background: self.background,
            secondary_background,
            raster,
            bounces: self.bounces,
            ray_origin: self.modules.ray_origin,
            sampler: self.modules.sampler,
            bucket_order: self.modules.bucket_order,
            renderer: self.modules.render,
        };
        Ok(Assembled { scene, settings, warnings: self.diagnostics, shading })
    }
}
