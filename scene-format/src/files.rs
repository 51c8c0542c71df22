/// Where a scene's includes and textures come from: a disk, a test's table, a web page.
pub trait Files {
    /// The bytes of the file at `path`, which is relative to wherever the caller's scene lives, or absolute. Parts are
    /// separated by `/`.
    ///
    /// # Errors
    /// [`FileError`], when there is no such file or it cannot be read.
    fn read(&self, path: &str) -> Result<Vec<u8>, FileError>;
}

/// Why a file could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileError {
    /// There is no file of that name: the next search directory may have it.
    NotFound,
    /// There is one, and it cannot be read; the reason, as the system words it.
    Unreadable(String),
}

/// No files at all: for scenes that stand alone.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Files for NoFiles {
    fn read(&self, _path: &str) -> Result<Vec<u8>, FileError> {
        Err(FileError::NotFound)
    }
}
