//! Reads and writes Sunflow's `.sc` scene files.
//!
//! [`parse`] turns text into a [`SceneFile`], plain data with a place in the source for all that a message may have to
//! point at, and a list of [`Diagnostic`]s. It goes on after an error, so that one run shows all of them. [`print()`] turns a
//! `SceneFile` back into text; [`format()`] lays a text out anew, comments and all. Every message has a [`Code`] that says what kind
//! of problem it is; how much a scene may ask for, the caller's [`Limits`] say. Nothing here touches a disk: includes come through the caller's [`Files`], and [`decode`]
//! makes text of a file's bytes.
//!
//! Conventions: all numbers are 32-bit floats as in Sunflow, and finite; angles are in degrees, lengths in the scene's own
//! unit; a [`Span`] counts bytes.

mod code;
#[cfg(feature = "conformance")]
pub mod conformance;
mod decode;
mod diagnostic;
mod files;
mod format;
mod grammar;
mod lexer;
mod limits;
mod mesh_file;
mod number;
mod parser;
mod print;
pub mod scene_file;
mod search_path;
mod span;

pub use code::Code;
pub use decode::{NotText, decode};
pub use diagnostic::{Diagnostic, Severity};
pub use files::{FileError, Files, NoFiles};
pub use format::format;
pub use limits::Limits;
pub use mesh_file::{MeshFileError, read_mesh, smooth_normals};
pub use parser::{parse, parse_within};
pub use print::print;
pub use scene_file::SceneFile;
pub use search_path::SearchPath;
pub use span::{FileId, LineColumn, Source, Sources, Span, Spanned};

/// What came of reading a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Parsed<'s> {
    /// All that could be read.
    pub scene: SceneFile,
    /// All that is to be said about it, in the order of the source.
    pub diagnostics: Vec<Diagnostic>,
    /// The files that took part, which the diagnostics' places refer to.
    pub sources: Sources<'s>,
}
