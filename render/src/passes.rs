use std::ops::{ControlFlow, Range};
use std::sync::{
    Mutex, PoisonError,
    atomic::{AtomicBool, AtomicUsize, Ordering},
};

use rayon::{ThreadPool, ThreadPoolBuilder};
use shading::Color;

use crate::{
    Crop, FinishedBucket, LostRays, RayCounts, Sample, Scene, Settings, Tile, buckets::bucket_pixels,
    camera_rays::CameraRays,
};

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

/// What a pass asks of each pixel, and what it makes of the answers.
pub(crate) trait Plan: Sync {
    /// What is made of a pixel; before the first of its rays, the default.
    type Pixel: Copy + Default + Send;

    /// The rays to trace: the pixel's samples, and which of them.
    fn rays(&self, pixel: [u32; 2]) -> (Sample, Range<u32>);

    /// Adds the light of the next ray.
    fn add(&self, made: &mut Self::Pixel, color: Color);

    /// The pixel's colour, after the last.
    fn color(&self, pixel: [u32; 2], made: &Self::Pixel) -> Color;
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
        Self { scene, settings, on_bucket, threads, tiles: scene.tiles(settings), planned, done: 0 }
    }

    /// Renders each pixel of `area`, which is the settings' window or reaches beyond it, and tells the colours of those in the window. `None`
    /// if that breaks it off.
    pub(crate) fn pass<P: Plan>(&mut self, area: Crop, plan: &P) -> Option<Pass<P::Pixel>> {
        let window = self.settings.window();
        let (tiles, total) = (self.tiles.len(), self.planned * self.tiles.len());
        let next = AtomicUsize::new(0);
        let pixels = vec![P::Pixel::default(); area.width as usize * area.height as usize];
        let empty = Pass { pixels, rays: RayCounts::default(), lost: LostRays::default() };
        let progress = Mutex::new((empty, 0));
        let broken_off = AtomicBool::new(false);

        // Each thread takes the next bucket in the order until none is left.
        let work = || {
            let mut camera_rays = CameraRays::new(self.scene, self.settings);
            while let Some(&tile) = self.tiles.get(next.fetch_add(1, Ordering::Relaxed)) {
                let bucket = bucket_pixels(window, self.settings.buckets.size, tile);
                let reaching = bucket.reaching(window, area);
                let made = bucket_of(reaching, plan, &mut camera_rays);
                let mut colors = Vec::with_capacity(made.len());
                bucket.pixels().for_each(|place| colors.push(plan.color(place, &made[reaching.index(place)])));

                let (pass, finished) = &mut *progress.lock().unwrap_or_else(PoisonError::into_inner);
                let (rays, lost) = camera_rays.take_counts();
                pass.rays += rays;
                pass.lost.append(lost);
                let width = reaching.width as usize;
                for (y, row) in (reaching.y..).zip(made.chunks_exact(width)) {
                    let start = area.index([reaching.x, y]);
                    pass.pixels[start..start + width].copy_from_slice(row);
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

impl<T> Pass<T> {
    /// The colours that its plan gives the pixels of its area.
    pub(crate) fn colors(&self, plan: &impl Plan<Pixel = T>, area: Crop) -> Vec<Color> {
        let mut colors = Vec::with_capacity(self.pixels.len());
        area.pixels().for_each(|place| colors.push(plan.color(place, &self.pixels[area.index(place)])));
        colors
    }
}

/// What a plan makes of a bucket's pixels, row by row from the top.
fn bucket_of<P: Plan>(area: Crop, plan: &P, camera_rays: &mut CameraRays<'_>) -> Vec<P::Pixel> {
    let mut made = vec![P::Pixel::default(); area.width as usize * area.height as usize];
    let mut add = |pixel: usize, color| plan.add(&mut made[pixel], color);
    area.pixels_by_squares().for_each(|pixel| {
        let (sample, indices) = plan.rays(pixel);
        camera_rays.ask(area.index(pixel), sample, indices, &mut add);
    });
    camera_rays.tell(&mut add);
    made
}
