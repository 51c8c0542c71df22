use std::ops::ControlFlow;

use shading::Color;

use crate::{Allotment, Crop, Film, Purpose, Sample, Scene, Settings, adaptive, passes::Passes, tracer::Tracer};

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
    let pass = match settings.allotment {
        Allotment::Adaptive if settings.least_rays() < settings.rays_per_pixel() => {
            adaptive::render(settings, Passes::new(scene, settings, on_bucket, 2))?
        }
        _ => {
            let color = |pixel, tracer: &Tracer<'_>| pixel_color(settings, pixel, tracer);
            Passes::new(scene, settings, on_bucket, 1).pass(window, color, |&color| color)?
        }
    };
    let lost = pass.lost.in_window(window);
    Some(Film { width: window.width, height: window.height, pixels: pass.pixels, rays: pass.rays, lost })
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
fn pixel_color(settings: &Settings, pixel: [u32; 2], tracer: &Tracer<'_>) -> Color {
    let count = settings.rays_per_pixel();
    let first =
        Sample { seed: settings.seed, pixel, zones: 1 << settings.aa, count, index: 0, purpose: Purpose::Pixel };
    let total: Color = (0..count).map(|index| tracer.camera_ray(Sample { index, ..first })).sum();
    total / count as f32
}
