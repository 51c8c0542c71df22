use std::ops::ControlFlow;
use std::sync::{
    Mutex, PoisonError,
    atomic::{AtomicBool, AtomicUsize, Ordering},
};

use rayon::{ThreadPool, ThreadPoolBuilder};
use shading::Color;

use crate::{Crop, FinishedBucket, LostRays, RayCounts, Scene, Settings, Tile, buckets::bucket_pixels, tracer::Tracer};

/// Goes over a picture's buckets, once or more often, with all threads.
pub(crate) struct Passes<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    on_bucket: &'a (dyn Fn(&FinishedBucket<'_>) -> ControlFlow<()> + Sync),
    /// `None` where there are no threads to be had.
    threads: Option<ThreadPool>,
    tiles: Vec<Tile>,
    /// How many passes there will be, and how many there were.
    planned: usize,
    done: usize,
}

/// What a pass has made.
pub(crate) struct Pass<T> {
    /// Row by row from the top.
    pub(crate) pixels: Vec<T>,
    /// What it took.
    pub(crate) rays: RayCounts,
    /// In any order.
    pub(crate) lost: LostRays,
}

impl<'a> Passes<'a> {
    pub(crate) fn new(
        scene: &'a Scene,
        settings: &'a Settings,
        on_bucket: &'a (dyn Fn(&FinishedBucket<'_>) -> ControlFlow<()> + Sync),
        planned: usize,
    ) -> Self {
        let threads = ThreadPoolBuilder::new().num_threads(settings.threads.map_or(0, usize::from)).build().ok();
        Self { scene, settings, on_bucket, threads, tiles: ordered_tiles(scene, settings), planned, done: 0 }
    }

    /// Renders each pixel of `area`, which is the settings' window or reaches beyond it, and tells `color_of` each in the window. `None` if
    /// that breaks it off.
    pub(crate) fn pass<T: Copy + Default + Send>(
        &mut self,
        area: Crop,
        pixel: impl Fn([u32; 2], &Tracer<'_>) -> T + Sync,
        color_of: impl Fn(&T) -> Color + Sync,
    ) -> Option<Pass<T>> {
        let window = self.settings.window();
        let (tiles, total) = (self.tiles.len(), self.planned * self.tiles.len());
        let next = AtomicUsize::new(0);
        let pixels = vec![T::default(); area.width as usize * area.height as usize];
        let empty = Pass { pixels, rays: RayCounts::default(), lost: LostRays::default() };
        let progress = Mutex::new((empty, 0));
        let broken_off = AtomicBool::new(false);

        // Each thread takes the next bucket in the order until none is left.
        let work = || {
            while let Some(&tile) = self.tiles.get(next.fetch_add(1, Ordering::Relaxed)) {
                let bucket = bucket_pixels(window, self.settings.buckets.size, tile);
                let reaching = bucket.reaching(window, area);
                let tracer = Tracer::new(self.scene, self.settings);
                let made: Vec<T> = reaching.pixels().map(|place| pixel(place, &tracer)).collect();
                let seen = reaching.pixels().zip(&made).filter(|&(place, _)| bucket.contains(place));
                let colors: Vec<Color> = seen.map(|(_, made)| color_of(made)).collect();

                let (pass, finished) = &mut *progress.lock().unwrap_or_else(PoisonError::into_inner);
                pass.rays += tracer.rays();
                pass.lost.append(tracer.lost());
                for (made, place) in made.into_iter().zip(reaching.pixels()) {
                    pass.pixels[area.index(place)] = made;
                }
                *finished += 1;
                let finished_before = self.done * tiles;
                let told =
                    FinishedBucket { area: bucket, pixels: &colors, finished: finished_before + *finished, total };
                if (self.on_bucket)(&told).is_break() {
                    broken_off.store(true, Ordering::Relaxed);
                    next.store(tiles, Ordering::Relaxed);
                }
            }
        };
        match &self.threads {
            Some(threads) => drop(threads.broadcast(|_| work())),
            None => work(),
        }
        self.done += 1;
        let (pass, _) = progress.into_inner().unwrap_or_else(PoisonError::into_inner);
        (!broken_off.into_inner()).then_some(pass)
    }
}

fn ordered_tiles(scene: &Scene, settings: &Settings) -> Vec<Tile> {
    let (buckets, window) = (settings.buckets, settings.window());
    let count = |pixels: u32| pixels.div_ceil(buckets.size);
    let mut tiles = (scene.bucket_order)(buckets.order, count(window.width), count(window.height));
    if buckets.reversed {
        tiles.reverse();
    }
    tiles
}
