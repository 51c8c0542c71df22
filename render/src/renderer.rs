use std::ops::{ControlFlow, Range};

use shading::Color;

use crate::{
    Allotment, Crop, Film, Purpose, Sample, Scene, Settings, adaptive,
    passes::{Passes, Plan},
};

/// What is told of each bucket when it is done.
#[derive(Clone, Copy, Debug)]
pub struct FinishedBucket<'a> {
    /// Its pixels, counted in the whole picture.
    pub area: Crop,
    /// Their linear colours, row by row from the top. Where the picture takes two passes, those of the first are rough.
    pub pixels: &'a [Color],
    /// How many buckets are done, this one included; each counts once for each pass.
    pub finished: usize,
    /// How many there are, in all passes.
    pub total: usize,
}

/// Renders a scene as the settings say, and tells of each bucket when it is done; `None` if it is told to break off. The references are
/// [`render`] and, plain and slow, [`crate::one_by_one`].
pub type Renderer = fn(&Scene, &Settings, &(dyn Fn(&FinishedBucket<'_>) -> ControlFlow<()> + Sync)) -> Option<Film>;

/// Renders a scene. `on_bucket` is called after each bucket, one call at a time, from whichever thread has done it; when it
/// breaks off, the buckets under way are finished, no others are begun, and there is no picture.
///
/// The picture is the settings' window. It has the same bits whatever `settings.threads` and `settings.buckets` say.
pub fn render(
    scene: &Scene,
    settings: &Settings,
    on_bucket: &(dyn Fn(&FinishedBucket<'_>) -> ControlFlow<()> + Sync),
) -> Option<Film> {
    let window = settings.window();
    let (pixels, rays, lost) = match settings.allotment {
        Allotment::Adaptive if settings.least_rays() < settings.rays_per_pixel() => {
            adaptive::render(settings, Passes::new(scene, settings, on_bucket, 2))?
        }
        _ => {
            let plan = Even { settings };
            let pass = Passes::new(scene, settings, on_bucket, 1).pass(window, &plan)?;
            (pass.colors(&plan, window), pass.rays, pass.lost)
        }
    };
    Some(Film { width: window.width, height: window.height, pixels, rays, lost: lost.in_window(window) })
}

/// The mean over a pixel's rays: `samples` in each of its 2^aa x 2^aa zones, at random places of the zone.
///
/// ```text
///   +---+---+
///   |  .|.  |     aa 1, samples 1. A single ray has nothing to be averaged with:
///   +---+---+     it goes through the pixel's centre.
///   |.  |  .|
///   +---+---+
/// ```
pub(crate) struct Even<'a> {
    pub(crate) settings: &'a Settings,
}

impl Plan for Even<'_> {
    /// The sum over its rays.
    type Pixel = Color;

    fn rays(&self, pixel: [u32; 2]) -> (Sample, Range<u32>) {
        let Settings { seed, aa, .. } = *self.settings;
        let count = self.settings.rays_per_pixel();
        (Sample { seed, pixel, zones: 1 << aa, count, index: 0, purpose: Purpose::Pixel }, 0..count)
    }

    fn add(&self, total: &mut Color, color: Color) {
        *total += color;
    }

    fn color(&self, _pixel: [u32; 2], &total: &Color) -> Color {
        total / self.settings.rays_per_pixel() as f32
    }
}
