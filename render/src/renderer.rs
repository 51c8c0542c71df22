use std::ops::ControlFlow;
use std::sync::{
    Mutex, PoisonError,
    atomic::{AtomicUsize, Ordering},
};

use rayon::ThreadPoolBuilder;
use shading::Color;

use crate::{Crop, Film, Purpose, Sample, Scene, Settings, Tile, buckets::bucket_pixels, tracer::Tracer};

/// What is told of each bucket when it is done.
#[derive(Clone, Copy, Debug)]
pub struct FinishedBucket<'a> {
    /// Its pixels, counted in the whole picture.
    pub area: Crop,
    /// Their linear colours, row by row from the top.
    pub pixels: &'a [Color],
    /// How many buckets are done, this one included.
    pub finished: usize,
    /// How many there are.
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
    let tiles = ordered_tiles(scene, settings, window);
    let next = AtomicUsize::new(0);
    let progress = Mutex::new((Film::black(window.width, window.height), 0));

    // Each thread takes the next bucket in the order until none is left.
    let work = || {
        while let Some(&tile) = tiles.get(next.fetch_add(1, Ordering::Relaxed)) {
            let area = bucket_pixels(window, settings.buckets.size, tile);
            let tracer = Tracer::new(scene, settings);
            let pixels = render_area(settings, area, &tracer);
            let (film, finished) = &mut *progress.lock().unwrap_or_else(PoisonError::into_inner);
            film.rays += tracer.rays();
            film.place(&pixels, area, window);
            *finished += 1;
            let told = FinishedBucket { area, pixels: &pixels, finished: *finished, total: tiles.len() };
            if on_bucket(&told).is_break() {
                next.store(tiles.len(), Ordering::Relaxed);
            }
        }
    };
    let threads = settings.threads.map_or(0, usize::from);
    match ThreadPoolBuilder::new().num_threads(threads).build() {
        Ok(pool) => {
            pool.broadcast(|_| work());
        }
        // Where there are no threads to be had, this one does it all.
        Err(_) => work(),
    }
    let (film, finished) = progress.into_inner().unwrap_or_else(PoisonError::into_inner);
    (finished == tiles.len()).then_some(film)
}

fn ordered_tiles(scene: &Scene, settings: &Settings, window: Crop) -> Vec<Tile> {
    let buckets = settings.buckets;
    let count = |pixels: u32| pixels.div_ceil(buckets.size);
    let mut tiles = (scene.bucket_order)(buckets.order, count(window.width), count(window.height));
    if buckets.reversed {
        tiles.reverse();
    }
    tiles
}

fn render_area(settings: &Settings, area: Crop, tracer: &Tracer<'_>) -> Vec<Color> {
    let rows = area.y..area.y + area.height;
    rows.flat_map(|y| (area.x..area.x + area.width).map(move |x| [x, y]))
        .map(|pixel| pixel_color(settings, pixel, tracer))
        .collect()
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
    let sample =
        |index| Sample { seed: settings.seed, pixel, zones: 1 << settings.aa, count, index, purpose: Purpose::Pixel };
    let total: Color = (0..count).map(|index| tracer.camera_ray(sample(index))).sum();
    total / count as f32
}

impl Film {
    /// Puts a bucket's pixels in their place.
    fn place(&mut self, pixels: &[Color], area: Crop, window: Crop) {
        let rows = pixels.chunks_exact(area.width as usize);
        for (y, row) in (area.y - window.y..).zip(rows) {
            let start = y as usize * window.width as usize + (area.x - window.x) as usize;
            self.pixels[start..start + row.len()].copy_from_slice(row);
        }
    }
}
