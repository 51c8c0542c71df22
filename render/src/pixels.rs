use std::ops::ControlFlow;

use shading::Color;

use crate::{
    Film, FinishedBucket, LostRays, RayCounts, Scene, Settings, camera_rays::CameraRays, passes::Plan, renderer::Even,
};

/// Computes a picture's pixels, one by one: for a renderer of one's own, which decides on threads, on buckets and on what is told.
///
/// Each thread has its own; they share nothing. A pixel has the same bits whichever thread asks for it, and when. (All pixels get as many
/// rays; [`crate::Allotment::Adaptive`] is not heeded.)
pub struct Pixels<'a> {
    settings: &'a Settings,
    camera_rays: CameraRays<'a>,
}

impl<'a> Pixels<'a> {
    /// Those of a picture of a scene.
    pub fn new(scene: &'a Scene, settings: &'a Settings) -> Self {
        Self { settings, camera_rays: CameraRays::new(scene, settings) }
    }

    /// The colour of a pixel, counted in the whole picture: the mean over its rays.
    pub fn color(&mut self, pixel: [u32; 2]) -> Color {
        let plan = Even { settings: self.settings };
        let mut made = Color::BLACK;
        let mut add = |_, color| plan.add(&mut made, color);
        let (sample, indices) = plan.rays(pixel);
        self.camera_rays.ask(0, sample, indices, &mut add);
        self.camera_rays.tell(&mut add);
        plan.color(pixel, &made)
    }

    /// The rays traced since this was last asked, and the camera rays lost.
    pub fn take_counts(&mut self) -> (RayCounts, LostRays) {
        self.camera_rays.take_counts()
    }
}

/// The renderer as it is first written: one thread, row by row, the whole picture a single bucket. The truth that others are held against.
pub fn one_by_one(
    scene: &Scene,
    settings: &Settings,
    on_bucket: &(dyn Fn(&FinishedBucket<'_>) -> ControlFlow<()> + Sync),
) -> Option<Film> {
    let window = settings.window();
    let mut pixels = Pixels::new(scene, settings);
    let colors: Vec<Color> = window.pixels().map(|pixel| pixels.color(pixel)).collect();
    let told = FinishedBucket { area: window, pixels: &colors, finished: 1, total: 1 };
    if on_bucket(&told).is_break() {
        return None;
    }
    let (rays, lost) = pixels.take_counts();
    Some(Film { width: window.width, height: window.height, pixels: colors, rays, lost: lost.in_window(window) })
}
