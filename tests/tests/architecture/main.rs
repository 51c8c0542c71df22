//! Laws of the code itself, read from the manifests and the sources: what breaks one fails before it grows.

mod dependencies;
mod fixed_bits;
mod small_numbers;
mod sources;
mod unsafe_code;

use std::path::{Path, PathBuf};

use sources::Crate;

/// The house, from the ground up: a crate may know those on the floors below its own. Crates on one floor do not know each other.
const FLOORS: [&[&str]; 5] = [&["geometry"], &["accel", "shading", "scene-format"], &["render"], &["cli"], &["tests"]];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace is around this package").to_owned()
}

fn crates() -> Vec<Crate> {
    FLOORS.concat().into_iter().map(|name| Crate::read(&root(), name)).collect()
}
