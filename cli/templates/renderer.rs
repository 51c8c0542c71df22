//! Renders the whole picture: which thread renders which pixels, and who is told.

use std::ops::ControlFlow;

use render::{Film, FinishedBucket, LostRays, RayCounts, Scene, Settings};
use shading::Color;

/// Renders a scene as the settings say, and tells of each bucket when it is done; `None` if it is told to break off.
///
/// A stub: black, and nobody is told.
pub fn render(
    _scene: &Scene,
    settings: &Settings,
    _on_bucket: &(dyn Fn(&FinishedBucket<'_>) -> ControlFlow<()> + Sync),
) -> Option<Film> {
    let window = settings.window();
    let pixels = vec![Color::BLACK; window.width as usize * window.height as usize];
    let (rays, lost) = (RayCounts::default(), LostRays::default());
    Some(Film { width: window.width, height: window.height, pixels, rays, lost })
}
