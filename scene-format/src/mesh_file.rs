//! Meshes from other files than scenes: OBJ, STL, PLY and Sunflow's own `.ra3`.
//!
//! The readers are our own: a few short files that give a line with each error, never trust a count, and keep to the caller's
//! [`Limits`]; the libraries for these formats allocate what a header announces.

mod obj;
mod ply;
mod polygon;
mod ra3;
mod smooth;
mod stl;

use crate::Limits;
use crate::scene_file::Mesh;
pub use smooth::smooth_normals;

/// Why a file is no mesh that can be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MeshFileError {
    /// Its name has no ending that is known.
    #[error("a mesh's file ends in .obj, .stl, .ply or .ra3")]
    UnknownEnding,
    /// Something is wrong with it.
    #[error("{0}")]
    Broken(String),
    /// Something is wrong in a line of it.
    #[error("line {line}: {reason}")]
    BrokenLine {
        /// The line, from 1.
        line: usize,
        /// What.
        reason: String,
    },
    /// It has more elements than is allowed.
    #[error("it has more than {0} elements")]
    OverLimit(usize),
}

/// The mesh of a file, by the ending of its name: polygons are cut into triangles, and every index is below the number of points.
///
/// # Errors
/// [`MeshFileError`], when the bytes are not of that format, or hold more than the limits allow.
pub fn read_mesh(name: &str, bytes: &[u8], limits: &Limits) -> Result<Mesh, MeshFileError> {
    let ending = name.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
    let most = limits.elements;
    let mesh = match ending.as_str() {
        "obj" => obj::read(bytes, most)?,
        "stl" => stl::read(bytes, most)?,
        "ply" => ply::read(bytes, most)?,
        "ra3" => ra3::read(bytes, most)?,
        _ => return Err(MeshFileError::UnknownEnding),
    };
    let points = mesh.points.len();
    match mesh.triangles.as_flattened().iter().find(|&&corner| corner as usize >= points) {
        Some(corner) => Err(MeshFileError::Broken(format!("a corner is point {corner}, and there are {points}"))),
        None => Ok(mesh),
    }
}

fn broken<T>(reason: impl Into<String>) -> Result<T, MeshFileError> {
    Err(MeshFileError::Broken(reason.into()))
}

fn broken_line<T>(line: usize, reason: impl Into<String>) -> Result<T, MeshFileError> {
    Err(MeshFileError::BrokenLine { line, reason: reason.into() })
}

/// Adds an element, if there may be one more.
fn push<T>(list: &mut Vec<T>, element: T, most: usize) -> Result<(), MeshFileError> {
    if list.len() >= most {
        return Err(MeshFileError::OverLimit(most));
    }
    list.push(element);
    Ok(())
}

/// A number of a text file.
fn number(word: Option<&str>, line: usize) -> Result<f32, MeshFileError> {
    match word.map(crate::number::float) {
        Some(Ok(number)) => Ok(number),
        Some(Err(_)) => broken_line(line, format!("`{}` is not a finite number", word.unwrap_or_default())),
        None => broken_line(line, "a number is missing"),
    }
}

/// Reads values of a fixed size from bytes.
struct Bytes<'b>(&'b [u8]);

impl Bytes<'_> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (value, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*value)
    }

    /// A little-endian float, which must be finite.
    fn float(&mut self) -> Option<f32> {
        self.take().map(f32::from_le_bytes).filter(|number| number.is_finite())
    }

    fn floats<const N: usize>(&mut self) -> Option<[f32; N]> {
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            *number = self.float()?;
        }
        Some(numbers)
    }
}
