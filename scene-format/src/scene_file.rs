//! What a `.sc` file says, as plain data: nothing is looked up, converted or drawn here.

mod camera;
mod color;
mod image;
mod light;
mod object;
mod shader;
mod transform;
mod unrendered;

pub use camera::{Camera, CameraPlacement, Lens, View};
pub use color::{Color, Paint};
pub use image::{Bucket, BucketOrder, Image, TraceDepths};
pub use light::Light;
pub use object::{BezierMesh, Instance, Mesh, MeshForm, Object, ParticleSource, PerVertex, PlaneOrientation};
pub use object::{Shape, SphereForm, Subdivision};
pub use shader::{Absorption, Shader, ShaderKind};
pub use transform::{Transform, TransformStep};
pub use unrendered::{Field, Unknown, Unrendered, Value};

use crate::span::Spanned;

/// Three numbers: a point or a vector, x y z.
pub type Triple = [f32; 3];

/// A whole scene: its statements in the order of the file. Where two set the same thing, the later one holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneFile {
    /// The statements, with the range of the whole statement.
    pub statements: Vec<Spanned<Statement>>,
}

/// One top-level statement.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there are few of them beside the numbers that they hold in vectors")]
pub enum Statement {
    /// `image { ... }`
    Image(Image),
    /// `bucket SIZE ORDER`
    Bucket(Bucket),
    /// `trace-depths { ... }`
    TraceDepths(TraceDepths),
    /// `background { color ... }`
    Background(Spanned<Color>),
    /// `camera { ... }`
    Camera(Camera),
    /// `shader { ... }`
    Shader(Shader),
    /// `object { ... }`
    Object(Object),
    /// `instance { ... }`
    Instance(Instance),
    /// `light { ... }`
    Light(Light),
    /// `texturepath DIRECTORY`
    TexturePath(Spanned<String>),
    /// `includepath DIRECTORY`
    IncludePath(Spanned<String>),
    /// `include FILE`, with what that file holds; `None` when there is none.
    Include {
        /// The name as written.
        path: Spanned<String>,
        /// The file that was found for it.
        file: Option<Included>,
    },
    /// `modifier { name NAME type KIND ... }`: not rendered.
    Modifier {
        /// `name NAME`
        name: Spanned<String>,
        /// What it does.
        kind: Kind,
    },
    /// `gi { type KIND ... }`: not rendered.
    Gi(Kind),
    /// `photons { ... }`: not rendered.
    Photons(Unrendered),
    /// `lightserver { ... }`, an old form of `gi`, `photons` and `trace-depths`: not rendered.
    LightServer(Unrendered),
    /// `override SHADER PHOTONS`: not rendered.
    Override {
        /// The shader that every surface should have.
        shader: Spanned<String>,
        /// Whether photons see it, too.
        photons: Spanned<bool>,
    },
    /// `accel NAME`: without effect.
    Accelerator(Spanned<String>),
    /// `filter NAME [ SIZE SIZE ]`, an old form outside `image`: without effect.
    Filter {
        /// Its name.
        name: Spanned<String>,
        /// Its width and height in pixels.
        size: Option<Spanned<[f32; 2]>>,
    },
    /// A statement that nobody knows.
    Unknown(Unknown),
}

/// What a block does that is of a type of Sunflow's, or of none.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A type of Sunflow's.
    Unrendered(Unrendered),
    /// A type that nobody knows.
    Unknown(Unknown),
}

/// A file that an `include` brought in.
#[derive(Clone, Debug, PartialEq)]
pub struct Included {
    /// Its path, found by the search path: its directory is searched for textures and further includes.
    pub path: String,
    /// What it says.
    pub scene: SceneFile,
}
