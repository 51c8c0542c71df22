use std::collections::BTreeMap;

use scene_format::scene_file::{Mesh, Triple};
use scene_format::{Code, Diagnostic, FileError, Files, Limits, MeshFileError, SearchPath, Spanned, read_mesh};

/// The meshes and particles that a scene takes from other files: each mesh is read once.
pub(super) struct MeshFiles<'a> {
    path: SearchPath,
    files: &'a dyn Files,
    limits: Limits,
    meshes: BTreeMap<String, Mesh>,
}

impl<'a> MeshFiles<'a> {
    pub(super) fn new(path: SearchPath, files: &'a dyn Files, limits: Limits) -> Self {
        Self { path, files, limits, meshes: BTreeMap::new() }
    }

    /// The mesh of a file.
    pub(super) fn mesh(&mut self, name: &Spanned<String>) -> Result<Mesh, Diagnostic> {
        if let Some(mesh) = self.meshes.get(&name.value) {
            return Ok(mesh.clone());
        }
        let bytes = self.bytes(name, "mesh")?;
        let mesh = read_mesh(name, &bytes, &self.limits).map_err(|error| {
            let code = if matches!(error, MeshFileError::OverLimit(_)) { Code::OverLimit } else { Code::UnusableFile };
            Diagnostic::error(code, name.span, format!("the mesh `{}` cannot be used", name.value))
                .label(error.to_string())
        })?;
        self.meshes.insert(name.value.clone(), mesh.clone());
        Ok(mesh)
    }

    /// The points of a file that holds nothing but their coordinates.
    pub(super) fn points(&self, name: &Spanned<String>, little_endian: bool) -> Result<Vec<Triple>, Diagnostic> {
        let bytes = self.bytes(name, "particles")?;
        let unusable = |why: &str| {
            let message = format!("the particles `{}` cannot be used", name.value);
            Diagnostic::error(Code::UnusableFile, name.span, message).label(why)
        };
        let (numbers, rest) = bytes.as_chunks::<4>();
        let (points, odd) = numbers.as_chunks::<3>();
        if !rest.is_empty() || !odd.is_empty() {
            return Err(unusable("its length is no multiple of 12 bytes, the size of a point"));
        }
        if points.len() > self.limits.elements {
            let message = format!("an object may have at most {} elements", self.limits.elements);
            return Err(Diagnostic::error(Code::OverLimit, name.span, message));
        }
        let number = if little_endian { f32::from_le_bytes } else { f32::from_be_bytes };
        let points: Vec<Triple> = points.iter().map(|point| point.map(number)).collect();
        if points.as_flattened().iter().all(|coordinate| coordinate.is_finite()) {
            Ok(points)
        } else {
            Err(unusable("a coordinate is not finite: perhaps `little_endian` is missing behind the name, or too much"))
        }
    }

    fn bytes(&self, name: &Spanned<String>, what: &str) -> Result<Vec<u8>, Diagnostic> {
        let (_, bytes) = self.path.find(name, self.files).map_err(|error| match error {
            FileError::NotFound => {
                let message = format!("there is no file `{}`", name.value);
                Diagnostic::error(Code::FileNotFound, name.span, message)
                    .label(format!("the {what} should be there"))
                    .help("`includepath DIRECTORY` before the object adds a directory to look in")
            }
            FileError::Unreadable(reason) => {
                let message = format!("the file `{}` cannot be read", name.value);
                Diagnostic::error(Code::UnusableFile, name.span, message).label(reason)
            }
        })?;
        if bytes.len() > self.limits.bytes {
            let message = format!("a file may have at most {} bytes", self.limits.bytes);
            return Err(Diagnostic::error(Code::OverLimit, name.span, message));
        }
        Ok(bytes)
    }
}
