use std::path::Path;

use super::Girasol;
use crate::parts::Part;

/// What a new crate for a part is made of.
pub(crate) struct Template {
    /// What the part is called in a sentence.
    pub(crate) called: &'static str,
    /// The file of the stub, without its ending.
    pub(crate) module: &'static str,
    /// The function in it that takes the reference's place.
    function: &'static str,
    /// The crate that the kit belongs to.
    pub(crate) kit: &'static str,
    /// The macro that names the laws as tests.
    tests: &'static str,
    place: Place,
    /// The stub, and the task with hints and papers, as Markdown.
    texts: [&'static str; 2],
}

/// Where in `Modules` the part has its place: the field.
#[derive(Clone, Copy)]
enum Place {
    Modules(&'static str),
    Kernels(&'static str),
    Shaders(&'static str),
}

/// girasol's own crates.
const CRATES: [&str; 6] = ["accel", "cli", "geometry", "render", "scene-format", "shading"];

/// The version of glam that girasol's types are made of.
const GLAM: &str = "0.34.2";

/// A stub and its task.
macro_rules! texts {
    ($name:literal) => {
        [
            include_str!(concat!("../../templates/", $name, ".rs")),
            include_str!(concat!("../../templates/", $name, ".md")),
        ]
    };
}

impl Template {
    /// The template of a part.
    pub(crate) fn of(part: Part) -> Self {
        match part {
            Part::Accelerator => Self {
                called: "octree",
                module: "octree",
                function: "build",
                kit: "accel",
                tests: "accel::conformance",
                place: Place::Modules("accelerator"),
                texts: texts!("accelerator"),
            },
            Part::Sphere => Self {
                called: "sphere",
                module: "sphere",
                function: "intersect",
                kit: "geometry",
                tests: "geometry::sphere_conformance",
                place: Place::Kernels("sphere"),
                texts: texts!("sphere"),
            },
            Part::Ellipsoid => Self {
                called: "ellipsoid",
                module: "ellipsoid",
                function: "intersect",
                kit: "geometry",
                tests: "geometry::ellipsoid_conformance",
                place: Place::Kernels("ellipsoid"),
                texts: texts!("ellipsoid"),
            },
            Part::Triangle => Self {
                called: "triangle",
                module: "triangle",
                function: "intersect",
                kit: "geometry",
                tests: "geometry::triangle_conformance",
                place: Place::Kernels("triangle"),
                texts: texts!("triangle"),
            },
            Part::Plane => Self {
                called: "plane",
                module: "plane",
                function: "intersect",
                kit: "geometry",
                tests: "geometry::plane_conformance",
                place: Place::Kernels("plane"),
                texts: texts!("plane"),
            },
            Part::Box => Self {
                called: "box test",
                module: "cuboid",
                function: "clip",
                kit: "geometry",
                tests: "geometry::aabb_conformance",
                place: Place::Kernels("aabb"),
                texts: texts!("box"),
            },
            Part::SphereUv => Self {
                called: "mapping of spheres",
                module: "sphere_uv",
                function: "uv",
                kit: "geometry",
                tests: "geometry::sphere_uv_conformance",
                place: Place::Kernels("sphere_uv"),
                texts: texts!("sphere-uv"),
            },
            Part::PlaneUv => Self {
                called: "mapping of planes",
                module: "plane_uv",
                function: "uv",
                kit: "geometry",
                tests: "geometry::plane_uv_conformance",
                place: Place::Kernels("plane_uv"),
                texts: texts!("plane-uv"),
            },
            Part::TriangleUv => Self {
                called: "mapping of triangles",
                module: "triangle_uv",
                function: "uv",
                kit: "geometry",
                tests: "geometry::triangle_uv_conformance",
                place: Place::Kernels("triangle_uv"),
                texts: texts!("triangle-uv"),
            },
            Part::SmoothNormal => Self {
                called: "smooth normal",
                module: "smooth_normal",
                function: "normal",
                kit: "geometry",
                tests: "geometry::smooth_normal_conformance",
                place: Place::Kernels("smooth_normal"),
                texts: texts!("smooth-normal"),
            },
            Part::NormalMatrix => Self {
                called: "map of normals",
                module: "normal_matrix",
                function: "normals",
                kit: "geometry",
                tests: "geometry::normal_matrix_conformance",
                place: Place::Kernels("normal_matrix"),
                texts: texts!("normal-matrix"),
            },
            Part::RayOrigin => Self {
                called: "origin of rays",
                module: "ray_origin",
                function: "origin_towards",
                kit: "geometry",
                tests: "geometry::ray_origin_conformance",
                place: Place::Modules("ray_origin"),
                texts: texts!("ray-origin"),
            },
            Part::Constant => Self {
                called: "constant shader",
                module: "constant",
                function: "shader",
                kit: "shading",
                tests: "shading::constant_conformance",
                place: Place::Shaders("constant"),
                texts: texts!("constant"),
            },
            Part::Phong => Self {
                called: "phong shader",
                module: "phong",
                function: "shader",
                kit: "shading",
                tests: "shading::phong_conformance",
                place: Place::Shaders("phong"),
                texts: texts!("phong"),
            },
            Part::Mirror => Self {
                called: "mirror",
                module: "mirror",
                function: "shader",
                kit: "shading",
                tests: "shading::mirror_conformance",
                place: Place::Shaders("mirror"),
                texts: texts!("mirror"),
            },
            Part::Glass => Self {
                called: "glass",
                module: "glass",
                function: "shader",
                kit: "shading",
                tests: "shading::glass_conformance",
                place: Place::Shaders("glass"),
                texts: texts!("glass"),
            },
            Part::Texture => Self {
                called: "texture",
                module: "texture",
                function: "texture",
                kit: "shading",
                tests: "shading::texture_conformance",
                place: Place::Modules("texture"),
                texts: texts!("texture"),
            },
            Part::Falloff => Self {
                called: "falloff of light",
                module: "falloff",
                function: "falloff",
                kit: "shading",
                tests: "shading::falloff_conformance",
                place: Place::Modules("falloff"),
                texts: texts!("falloff"),
            },
            Part::SoftShadows => Self {
                called: "soft shadows",
                module: "soft_shadows",
                function: "cluster",
                kit: "shading",
                tests: "shading::soft_shadows_conformance",
                place: Place::Modules("soft_shadows"),
                texts: texts!("soft-shadows"),
            },
            Part::Camera => Self {
                called: "camera",
                module: "camera",
                function: "camera",
                kit: "render",
                tests: "render::camera_conformance",
                place: Place::Modules("camera"),
                texts: texts!("camera"),
            },
            Part::Sampler => Self {
                called: "sampler",
                module: "sampler",
                function: "sampler",
                kit: "render",
                tests: "render::sampler_conformance",
                place: Place::Modules("sampler"),
                texts: texts!("sampler"),
            },
            Part::BucketOrder => Self {
                called: "order of buckets",
                module: "bucket_order",
                function: "order",
                kit: "render",
                tests: "render::bucket_order_conformance",
                place: Place::Modules("bucket_order"),
                texts: texts!("bucket-order"),
            },
            Part::Renderer => Self {
                called: "bucket renderer",
                module: "renderer",
                function: "render",
                kit: "render",
                tests: "render::renderer_conformance",
                place: Place::Modules("render"),
                texts: texts!("renderer"),
            },
            Part::Parser => Self {
                called: "parser",
                module: "parser",
                function: "parse",
                kit: "scene-format",
                tests: "scene_format::parser_conformance",
                place: Place::Modules("parse"),
                texts: texts!("parser"),
            },
        }
    }

    pub(crate) fn stub(&self) -> &'static str {
        self.texts[0]
    }

    pub(crate) fn task(&self) -> &'static str {
        self.texts[1]
    }

    /// Its manifest. `[workspace]` keeps it apart from any workspace around it.
    pub(crate) fn manifest(name: &str, folder: &Path, girasol: &Girasol) -> String {
        let dependency = |krate: &&str| format!("{krate} = {}\n", girasol.dependency(krate, folder));
        let dependencies: String = CRATES.iter().map(dependency).collect();
        format!(
            "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\npublish = false\n\n\
             [workspace]\n\n# What `cli` is made of: whatever of it a part needs is there.\n\
             [dependencies]\n{dependencies}glam = \"{GLAM}\"\n\n\
             # As girasol itself is built: tests try many cases.\n\
             [profile.dev]\nopt-level = 2\ndebug = \"line-tables-only\"\n\n\
             [profile.dev.package]\nproptest.debug-assertions = false\nmoxcms.opt-level = 0\npxfm.opt-level = 0\n\n\
             [profile.release]\ncodegen-units = 1\nlto = \"thin\"\n\n\
             [profile.release.package]\nmoxcms.opt-level = 0\npxfm.opt-level = 0\n"
        )
    }

    /// The whole program.
    pub(crate) fn main(&self, krate: &str) -> String {
        let function = format!("{krate}::{}", self.function);
        let (uses, modules) = match self.place {
            Place::Modules(field) => {
                ("use render::Modules;", format!("cli::run(Modules {{ {field}: {function}, ..Modules::default() }})"))
            }
            Place::Kernels(field) => (
                "use geometry::Kernels;\nuse render::Modules;",
                format!(
                    "let kernels = Kernels {{ {field}: Some({function}), ..Kernels::default() }};\n    \
                     cli::run(Modules {{ kernels, ..Modules::default() }})"
                ),
            ),
            Place::Shaders(field) => (
                "use render::{Modules, Shaders};",
                format!(
                    "let shaders = Shaders {{ {field}: {function}, ..Shaders::default() }};\n    \
                     cli::run(Modules {{ shaders, ..Modules::default() }})"
                ),
            ),
        };
        format!(
            "//! girasol with its own {}.\n\nuse std::process::ExitCode;\n\n{uses}\n\nfn main() -> ExitCode {{\n    {modules}\n}}\n",
            self.called
        )
    }

    pub(crate) fn library(&self) -> String {
        let Self { module, function, called, .. } = self;
        format!(
            "//! My own {called}. The task stands in README.md.\n\nmod {module};\n\npub use {module}::{function};\n"
        )
    }

    pub(crate) fn tests(&self, krate: &str) -> String {
        format!("//! A test for each law.\n\n{}!({krate}::{});\n", self.tests, self.function)
    }
}
