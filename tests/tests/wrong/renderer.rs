use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use render::conformance::renderer as kit;
use render::{Buckets, Crop, Film, FinishedBucket, LostRays, Pixels, RayCounts, Renderer, Scene, Settings, Tile};
use shading::Color;

use crate::Kit;

type OnBucket<'a> = &'a (dyn Fn(&FinishedBucket<'_>) -> ControlFlow<()> + Sync);

/// What can be wrong in a bucket renderer.
#[derive(Clone, Copy, PartialEq)]
enum Mistake {
    None,
    Exchanged,
    BucketLost,
    BorderLost,
    CutOffLost,
    RowsSwapped,
    ColumnsSwapped,
    FirstRay,
    CountedInTheBucket,
    SeedsOfThreads,
    CountedInTheCrop,
    NothingTold,
    ProgressEndsEarly,
    OrderIgnored,
    NotToBeBrokenOff,
    NotCounted,
    LostNotTold,
}

/// The picture as it grows.
struct Growing {
    pixels: Vec<Color>,
    rays: RayCounts,
    lost: LostRays,
    finished: usize,
    broken_off: bool,
}

/// A bucket renderer as a student writes it: thread k of n takes every nth bucket from the kth on.
fn in_buckets(scene: &Scene, settings: &Settings, on_bucket: OnBucket<'_>, mistake: Mistake) -> Option<Film> {
    let window = settings.window();
    let mut tiles = scene.tiles(settings);
    match mistake {
        Mistake::BucketLost => drop(tiles.pop()),
        Mistake::OrderIgnored => tiles.reverse(),
        _ => {}
    }
    let count = window.width as usize * window.height as usize;
    let growing = Mutex::new(Growing {
        pixels: vec![Color::BLACK; count],
        rays: RayCounts::default(),
        lost: LostRays::default(),
        finished: 0,
        broken_off: false,
    });
    let threads = settings.threads.map_or(1, usize::from);
    std::thread::scope(|scope| {
        for thread in 0..threads {
            let (tiles, growing) = (&tiles, &growing);
            scope.spawn(move || {
                let own = tiles.iter().skip(thread).step_by(threads);
                take_buckets(scene, settings, on_bucket, mistake, (thread, tiles.len()), own, growing);
            });
        }
    });
    let Growing { pixels, rays, lost, broken_off, .. } = growing.into_inner().unwrap_or_else(PoisonError::into_inner);
    let (width, height) =
        if mistake == Mistake::Exchanged { (window.height, window.width) } else { (window.width, window.height) };
    (!broken_off).then(|| Film { width, height, pixels, rays, lost: lost.in_window(window) })
}

fn take_buckets<'t>(
    scene: &Scene,
    settings: &Settings,
    on_bucket: OnBucket<'_>,
    mistake: Mistake,
    (thread, total): (usize, usize),
    tiles: impl Iterator<Item = &'t Tile>,
    growing: &Mutex<Growing>,
) {
    let window = settings.window();
    let seed = settings.seed.wrapping_add(if mistake == Mistake::SeedsOfThreads { thread as u32 } else { 0 });
    let (aa, samples) = if mistake == Mistake::FirstRay { (0, 1) } else { (settings.aa, settings.samples) };
    let settings = Settings { seed, aa, samples, ..settings.clone() };
    let mut pixels = Pixels::new(scene, &settings);
    for tile in tiles {
        let area = bucket(window, settings.buckets, *tile);
        let size = settings.buckets.size;
        let is_cut_off = area.width < size && area.height < size && tile.column + tile.row > 0;
        if mistake == Mistake::CutOffLost && is_cut_off {
            continue;
        }
        let colors: Vec<Color> = area
            .pixels()
            .map(|[x, y]| match mistake {
                Mistake::BorderLost if x == area.x + size - 1 => Color::BLACK,
                Mistake::CountedInTheBucket => shifted(scene, &settings, [x, y], [area.x, area.y]),
                Mistake::CountedInTheCrop => shifted(scene, &settings, [x, y], [window.x, window.y]),
                _ => pixels.color([x, y]),
            })
            .collect();

        let mut growing = growing.lock().unwrap_or_else(PoisonError::into_inner);
        if growing.broken_off && mistake != Mistake::NotToBeBrokenOff {
            return;
        }
        let (rays, lost) = pixels.take_counts();
        if mistake != Mistake::NotCounted {
            growing.rays += rays;
        }
        if mistake != Mistake::LostNotTold {
            growing.lost.append(lost);
        }
        for (place, color) in area.pixels().zip(&colors) {
            let [x, y] = place;
            let place = match mistake {
                Mistake::RowsSwapped => [x, window.y + (window.y + window.height - 1 - y)],
                Mistake::ColumnsSwapped => [area.x + (area.x + area.width - 1 - x), y],
                _ => place,
            };
            let at = window.index(place);
            growing.pixels[at] = *color;
        }
        growing.finished += 1;
        let finished = growing.finished - usize::from(mistake == Mistake::ProgressEndsEarly);
        let told = FinishedBucket { area, pixels: &colors, finished, total };
        if mistake != Mistake::NothingTold && on_bucket(&told).is_break() {
            growing.broken_off = mistake != Mistake::NotToBeBrokenOff;
        }
    }
}

/// The colour of a pixel whose random numbers are those of another: the one so much further to the left and up.
fn shifted(scene: &Scene, settings: &Settings, pixel: [u32; 2], by: [u32; 2]) -> Color {
    // Another seed is as wrong as another pixel; at the corner neither is.
    let seed = settings.seed.wrapping_add(by[0] + 1000 * by[1]);
    Pixels::new(scene, &Settings { seed, ..settings.clone() }).color(pixel)
}

fn bucket(window: Crop, buckets: Buckets, tile: Tile) -> Crop {
    let (x, y) = (tile.column * buckets.size, tile.row * buckets.size);
    let (width, height) = (buckets.size.min(window.width - x), buckets.size.min(window.height - y));
    Crop { x: window.x + x, y: window.y + y, width, height }
}

macro_rules! with {
    ($mistake:ident) => {
        |scene, settings, on_bucket| in_buckets(scene, settings, on_bucket, Mistake::$mistake)
    };
}

#[test]
fn every_mistake_in_a_bucket_renderer_is_named() {
    let size = "a_picture_has_the_size_that_is_asked_for";
    let left_out = "no_pixel_is_left_out";
    Kit { page: "render/src/conformance/renderer.rs", laws: kit::LAWS }.catches([
        ("no picture", (|_, _, _| None) as Renderer, size),
        ("width and height exchanged", with!(Exchanged), size),
        ("a bucket lost", with!(BucketLost), left_out),
        ("border pixels of buckets lost", with!(BorderLost), left_out),
        ("buckets that are cut off are left out", with!(CutOffLost), left_out),
        ("film rows swapped", with!(RowsSwapped), "what_is_above_is_above"),
        ("a bucket's columns swapped", with!(ColumnsSwapped), "what_is_on_the_left_is_on_the_left"),
        ("only a pixel's first ray", with!(FirstRay), "a_pixel_is_the_mean_of_its_rays"),
        ("pixels counted in the bucket", with!(CountedInTheBucket), "buckets_have_no_influence_on_the_picture"),
        ("seeds shared by threads", with!(SeedsOfThreads), "threads_have_no_influence_on_the_picture"),
        ("a crop's pixels counted from its corner", with!(CountedInTheCrop), "a_crop_is_a_part_of_the_whole"),
        ("nothing is told", with!(NothingTold), "every_pixel_is_told_once_with_its_colour"),
        ("progress that ends before the end", with!(ProgressEndsEarly), "progress_rises_to_the_total"),
        ("the order of the buckets ignored", with!(OrderIgnored), "one_thread_takes_the_buckets_in_their_order"),
        ("not to be broken off", with!(NotToBeBrokenOff), "a_rendering_can_be_broken_off"),
        ("rays not counted", with!(NotCounted), "rays_are_counted"),
        ("lost rays not told", with!(LostNotTold), "lost_rays_are_told_with_their_places"),
    ]);
}

/// Without a mistake it is right: what the laws name is the mistake alone.
#[test]
fn a_student_s_bucket_renderer_passes() {
    for law in kit::LAWS {
        law.assert(with!(None));
    }
}
