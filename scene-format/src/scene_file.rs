//! What a `.sc` file says, as plain data: nothing is looked up, converted or drawn here.

mod camera;
mod color;
mod image;
mod light;
mod object;
mod shader;
mod transform;

pub use camera::{Camera, CameraPlacement, Lens};
pub use color::{Color, Paint};
pub use image::{Bucket, BucketOrder, Image, TraceDepths};
pub use light::{Light, LightKind};
pub use object::{Instance, Mesh, MeshForm, Object, PerVertex, PlaneOrientation, Shape, SphereForm};
pub use shader::{Absorption, Shader, ShaderKind};
pub use transform::{Transform, TransformStep};

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
pub enum Statement {
    /// `image { ... }`
    Image(Image),
    /// `bucket SIZE ORDER`
    Bucket(Bucket),
    /// `trace-depths { ... }`
    TraceDepths(TraceDepths),
    /// `background { color ... }`
    Background(Color),
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
    /// A statement that is read over: its words are kept so that it can be printed back.
    Other(Other),
}

/// A file that an `include` brought in.
#[derive(Clone, Debug, PartialEq)]
pub struct Included {
    /// Its path, found by the search path: its directory is searched for textures and further includes.
    pub path: String,
    /// What it says.
    pub scene: SceneFile,
}

/// Something that girasol knows but does not render: kept word for word.
#[derive(Clone, Debug, PartialEq)]
pub struct Other {
    /// The first word: `gi`, `photons`, `modifier` ...; in an object or light, its type.
    pub keyword: Spanned<String>,
    /// All further words, braces included, as the reader cuts them (quotes removed).
    pub words: Vec<String>,
}
