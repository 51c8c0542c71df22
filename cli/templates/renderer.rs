//! Renders the whole picture: which thread renders which pixels, and who is told.

use std::ops::ControlFlow;

use render::{Film, FinishedBucket, Scene, Settings};

/// Renders a scene as the settings say, and tells of each bucket when it is done; `None` if it is told to break off.
///
/// A stub: no picture, and nobody is told.
pub fn render(
    _scene: &Scene,
    _settings: &Settings,
    _on_bucket: &(dyn Fn(&FinishedBucket<'_>) -> ControlFlow<()> + Sync),
) -> Option<Film> {
    None
}
