use std::fs;
use std::path::{Path, PathBuf};

use scene_format::{FileError, Files};

/// The folder of scenes and reference pictures that are no part of this repository: what `GIRASOL_SHARED` names. Says so, and is
/// `None`, where it names nothing.
///
/// # Panics
/// If it names no folder: what was asked for must not be skipped.
#[expect(clippy::print_stdout, reason = "whoever runs the tests must know what was left out")]
pub fn shared_folder() -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("GIRASOL_SHARED").map(PathBuf::from) else {
        println!("skipped: set GIRASOL_SHARED to the folder of the course's scenes");
        return None;
    };
    assert!(folder.is_dir(), "GIRASOL_SHARED is {}, which is no folder", folder.display());
    Some(folder)
}

/// The `.sc` files of a folder, at least one, in order.
///
/// # Panics
/// If there is none, or the folder cannot be read.
pub fn scenes_of(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let paths = entries.map(|entry| entry.unwrap().path());
    let mut scenes: Vec<_> = paths.filter(|path| path.extension().is_some_and(|ending| ending == "sc")).collect();
    assert!(!scenes.is_empty(), "{}", folder.display());
    scenes.sort();
    scenes
}

/// The files of a folder.
pub struct Beside(pub PathBuf);

impl Files for Beside {
    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        fs::read(self.0.join(path)).map_err(|_| FileError::NotFound)
    }
}
