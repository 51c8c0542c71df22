//! The kit of the whole bucket renderer.
//!
//! **The idea.** Pixels do not know each other, so they can be rendered in any order and by any number of threads. A picture is cut into
//! buckets; each thread takes the next one until none is left.
//!
//! ```text
//!   +----+----+--+    the last column and row of buckets are cut off: their pixels end with the picture
//!   | 0  | 1  | 4|
//!   +----+----+--+    film: row by row from the top
//!   | 3  | 2  | 5|
//!   +----+----+--+
//! ```
//!
//! **The contract.** A [`Renderer`] makes a [`Film`] of a [`Scene`] and [`Settings`]: the settings' window, each pixel the mean over its rays,
//! the same bits for any number of threads and any buckets. It calls `on_bucket` after each bucket, one call at a time, and breaks off when that
//! says so. [`Pixels`] computes a pixel; [`Scene::tiles`] gives the buckets in order. (All pixels get as many rays here; adaptive pictures are
//! another task.)
//!
//! **Hard cases.** Buckets larger than the picture, and of one pixel. A crop, whose pixels are counted in the whole picture and keep their
//! random numbers. More threads than buckets. Rays that are no number, told with their place.
//!
//! **How it is tested.** Pictures whose answer is known on paper, and for the rest a loop over all pixels: [`one_by_one`].
//!
//! **Literature.** Appel: The Notion of Quantitative Invisibility, 1967, to see what a pixel once cost. Pharr, Jakob, Humphreys: Physically
//! Based Rendering, 4th ed. 2023, appendix B.6 (parallel image tiles). Blumofe and Leiserson: Scheduling Multithreaded Computations by Work
//! Stealing, JACM 1999.
//!
//! **Exercises.** Pass the kit with one loop up to the buckets' laws. Then with threads. Measure two threads against one: when is it less than
//! twice as fast, and why? Give each thread a row of buckets beforehand and compare. Beat [`crate::render`], which traces neighbours' rays together.
//!
//! | mistake | law that names it |
//! |---|---|
//! | no picture | [`a_picture_has_the_size_that_is_asked_for`] |
//! | width and height exchanged | [`a_picture_has_the_size_that_is_asked_for`] |
//! | a bucket lost | [`no_pixel_is_left_out`] |
//! | border pixels of buckets lost | [`no_pixel_is_left_out`] |
//! | buckets that are cut off are left out | [`no_pixel_is_left_out`] |
//! | film rows swapped | [`what_is_above_is_above`] |
//! | a bucket's columns swapped | [`what_is_on_the_left_is_on_the_left`] |
//! | only a pixel's first ray | [`a_pixel_is_the_mean_of_its_rays`] |
//! | pixels counted in the bucket | [`buckets_have_no_influence_on_the_picture`] |
//! | seeds shared by threads | [`threads_have_no_influence_on_the_picture`] |
//! | a crop's pixels counted from its corner | [`a_crop_is_a_part_of_the_whole`] |
//! | nothing is told | [`every_pixel_is_told_once_with_its_colour`] |
//! | progress that ends before the end | [`progress_rises_to_the_total`] |
//! | the order of the buckets ignored | [`one_thread_takes_the_buckets_in_their_order`] |
//! | not to be broken off | [`a_rendering_can_be_broken_off`] |
//! | rays not counted | [`rays_are_counted`] |
//! | lost rays not told | [`lost_rays_are_told_with_their_places`] |

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use geometry::conformance::{Counterexample, Trial, Verdict, same};
use proptest::prelude::*;
use scene_format::{NoFiles, scene_file::BucketOrder};
use shading::Color;

#[cfg(doc)]
use crate::Pixels;
use crate::{Assembled, Buckets, Crop, Film, FinishedBucket, Lighting, Modules, Renderer, Scene, Settings};
use crate::{assemble, one_by_one};

/// Nothing but the background.
const EMPTY: &str =
    "camera { type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov 60 aspect 1 } background { color 0.25 0.5 0.75 }";

/// Ground in the lower half, without light: it shows its own colour.
const GROUND: &str = "camera { type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov 90 aspect 1 } background { color 0 0 1 }
    shader { name ground type constant color { \"sRGB linear\" 1 0 0 } } object { shader ground type plane p 0 0 -1 n 0 0 1 }";

/// A wall in the left half.
const WALL: &str = "camera { type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov 90 aspect 1 } background { color 0 0 1 }
    shader { name wall type constant color { \"sRGB linear\" 0 1 0 } } object { shader wall type plane p -1 0 0 n 1 0 0 }";

/// Something of everything that draws random numbers or traces rays.
const EVERYTHING: &str = "trace-depths { diff 1 refl 2 refr 3 } background { color 0.2 0.3 0.4 }
    camera { type thinlens eye 0 -6 2.5 target 0 0 0.8 up 0 0 1 fov 45 aspect 1.333 fdist 6 lensr 0.2 sides 0 rotation 0 }
    light { type point color 1 1 1 power 30 p 3 -5 6 } light { type point color 0.5 0.2 0.1 power 20 p -3 -5 6 }
    shader { name matt type phong diff 0.6 0.5 0.4 spec 0.5 0.5 0.5 30 samples 0 } shader { name mirror type mirror refl 0.8 0.7 0.6 }
    shader { name glass type glass eta 1.5 color 0.9 0.9 0.9 }
    object { shader matt type plane p 0 0 0 n 0 0 1 } object { shader mirror type sphere c 1 1 1 r 1 }
    object { shader glass type sphere c -0.8 -0.5 0.7 r 0.7 }";

/// So bright a light that the sum over a pixel's rays would overflow, on the ball in the middle.
const EXTREME: &str = "camera { type pinhole eye 0 -5 0 target 0 0 0 up 0 0 1 fov 40 aspect 1 } light { type point color 1e30 1 1 power 100 p 0 -5 0 }
    shader { name s type constant color 0.5 0.5 0.5 } object { shader s type sphere c 0 0 0 r 1 }";

/// A scene of the kit, with our own parts.
fn scene(text: &str) -> Scene {
    let parsed = scene_format::parse("kit.sc", text, &NoFiles);
    let lighting = Lighting { ambient: 1.0, soft_shadows: Some(shading::SoftShadows { along_edge: 2, spacing: 0.2 }) };
    match assemble(&parsed.scene, &Modules::default(), &lighting, &NoFiles) {
        Ok(Assembled { scene, .. }) => scene,
        Err(problems) => panic!("the kit's own scene: {problems:?}"),
    }
}

/// Pictures of up to 24 x 18 pixels in buckets of 1 to 30, by one thread.
pub fn pictures() -> impl Strategy<Value = Settings> {
    let buckets = (1..30_u32, prop::sample::select(BucketOrder::ALL.to_vec()), any::<bool>())
        .prop_map(|(size, order, reversed)| Buckets { size, order, reversed });
    ([1..25_u32, 1..19_u32], 0..2_u32, 1..3_u32, any::<u32>(), buckets).prop_map(
        |(size, aa, samples, seed, buckets)| Settings {
            size,
            aa,
            samples,
            seed,
            buckets,
            threads: NonZeroUsize::new(1),
            ..Settings::default()
        },
    )
}

/// Those of at least 8 x 8 pixels, a single ray each.
fn large() -> impl Strategy<Value = Settings> {
    (pictures(), [8..25_u32, 8..19_u32]).prop_map(|(settings, size)| Settings { size, aa: 0, samples: 1, ..settings })
}

fn go_on(_: &FinishedBucket<'_>) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn film(renderer: &Renderer, scene: &Scene, settings: &Settings) -> Result<Film, Box<Counterexample>> {
    renderer(scene, settings, &go_on).ok_or_else(|| Counterexample::new("a picture", "None"))
}

/// The truth.
fn right(scene: &Scene, settings: &Settings) -> Result<Film, Box<Counterexample>> {
    film(&(one_by_one as Renderer), scene, settings)
}

/// The verdict on a picture, told by its first wrong pixel.
fn equal(expected: &Film, found: &Film) -> Verdict {
    same(&[expected.width, expected.height], &[found.width, found.height])?;
    same(&expected.pixels.len(), &found.pixels.len())?;
    let wrong = expected.pixels.iter().zip(&found.pixels).position(|(expected, found)| expected != found);
    wrong.map_or(Ok(()), |at| {
        let place = [at as u32 % expected.width, at as u32 / expected.width];
        Err(Counterexample::new(
            format!("{:?} at pixel {place:?}", expected.pixels[at]),
            format!("{:?}", found.pixels[at]),
        ))
    })
}

/// A law on few pictures: they cost more than other cases.
fn few(trial: &Trial) -> Trial {
    Trial { cases: trial.cases.div_ceil(8), ..*trial }
}

/// Columns, rows, and as many pixels as there are.
pub fn a_picture_has_the_size_that_is_asked_for(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EMPTY);
    few(trial).search(pictures(), |settings| {
        let Film { width, height, pixels, .. } = film(renderer, &scene, settings)?;
        let [columns, rows] = settings.size;
        same(&(columns, rows, (columns * rows) as usize), &(width, height, pixels.len()))
    })
}

/// Where there is nothing, each pixel is the background.
pub fn no_pixel_is_left_out(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EMPTY);
    few(trial).search(pictures(), |settings| {
        let background =
            film(&(one_by_one as Renderer), &scene, &Settings { size: [1, 1], ..settings.clone() })?.pixels[0];
        let found = film(renderer, &scene, settings)?;
        equal(&Film { pixels: vec![background; found.pixels.len()], ..found.clone() }, &found)
    })
}

/// The verdict on two pixels of a picture, counted as shares of it from the upper left.
fn shows(renderer: &Renderer, settings: &Settings, scene: &Scene, places: [(f32, f32, Color); 2]) -> Verdict {
    let found = film(renderer, scene, settings)?;
    places.into_iter().try_for_each(|(x, y, expected)| {
        let [column, row] = [(x, found.width), (y, found.height)].map(|(share, count)| (share * count as f32) as usize);
        let at = row * found.width as usize + column;
        let color = found.pixels.get(at).copied().unwrap_or(Color::BLACK);
        let expected = format!("{expected:?} at pixel {:?}", [column, row]);
        let found = format!("{color:?} at pixel {:?}", [column, row]);
        same(&expected, &found)
    })
}

const RED: Color = Color::new(1.0, 0.0, 0.0);
const GREEN: Color = Color::new(0.0, 1.0, 0.0);
const BLUE: Color = Color::new(0.0, 0.0, 1.0);

/// Rows count from the top: the sky is in the first, the ground in the last.
pub fn what_is_above_is_above(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(GROUND);
    few(trial).search(large(), |settings| shows(renderer, settings, &scene, [(0.5, 0.1, BLUE), (0.5, 0.99, RED)]))
}

/// Columns count from the left: the wall is there, and nothing on the right.
pub fn what_is_on_the_left_is_on_the_left(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(WALL);
    few(trial).search(large(), |settings| shows(renderer, settings, &scene, [(0.0, 0.3, GREEN), (0.99, 0.3, BLUE)]))
}

/// In one bucket, by one thread.
pub fn a_pixel_is_the_mean_of_its_rays(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EVERYTHING);
    few(trial).search(pictures(), |settings| {
        let buckets = Buckets { size: 100, ..settings.buckets };
        let settings = Settings { buckets, ..settings.clone() };
        equal(&right(&scene, &settings)?, &film(renderer, &scene, &settings)?)
    })
}

/// Neither their size nor their order, to the last bit.
pub fn buckets_have_no_influence_on_the_picture(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EVERYTHING);
    few(trial).search(pictures(), |settings| equal(&right(&scene, settings)?, &film(renderer, &scene, settings)?))
}

/// However many there are, to the last bit.
pub fn threads_have_no_influence_on_the_picture(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EVERYTHING);
    few(trial).search((pictures(), 2..5_usize, 1..6_u32), |(settings, threads, size)| {
        let buckets = Buckets { size: *size, ..settings.buckets };
        let settings = Settings { threads: NonZeroUsize::new(*threads), buckets, ..settings.clone() };
        equal(&right(&scene, &settings)?, &film(renderer, &scene, &settings)?)
    })
}

/// A picture and a part of it.
fn cropped() -> impl Strategy<Value = Settings> {
    (pictures(), 0.0..1.0, 0.0..1.0, 0.0..1.0, 0.0..1.0).prop_map(|(settings, x, y, width, height)| {
        let part = |at: f64, length: f64, whole: u32| {
            let start = (at * f64::from(whole)) as u32;
            (start, 1 + (length * f64::from(whole - start - 1)) as u32)
        };
        let ((x, width), (y, height)) = (part(x, width, settings.size[0]), part(y, height, settings.size[1]));
        Settings { crop: Some(Crop { x, y, width, height }), ..settings }
    })
}

/// Its pixels have the colours that they have in the whole.
pub fn a_crop_is_a_part_of_the_whole(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EVERYTHING);
    few(trial).search(cropped(), |settings| {
        let whole = right(&scene, &Settings { crop: None, ..settings.clone() })?;
        let window = settings.window();
        let at = |[x, y]: [u32; 2]| whole.pixels[(y * whole.width + x) as usize];
        let pixels = window.pixels().map(at).collect();
        let expected = Film { width: window.width, height: window.height, pixels, ..whole.clone() };
        equal(&expected, &film(renderer, &scene, settings)?)
    })
}

/// What is told of a bucket: its area, its colours, and the progress.
type Told = (Crop, Vec<Color>, usize, usize);

/// All that a renderer tells, in order.
fn told(renderer: &Renderer, scene: &Scene, settings: &Settings) -> Vec<Told> {
    let all = Mutex::new(Vec::new());
    renderer(scene, settings, &|bucket| {
        let FinishedBucket { area, pixels, finished, total } = *bucket;
        all.lock().unwrap_or_else(PoisonError::into_inner).push((area, pixels.to_vec(), finished, total));
        ControlFlow::Continue(())
    });
    all.into_inner().unwrap_or_else(PoisonError::into_inner)
}

/// The buckets that are told, put together, are the picture.
pub fn every_pixel_is_told_once_with_its_colour(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EVERYTHING);
    few(trial).search(cropped(), |settings| {
        let (window, expected) = (settings.window(), right(&scene, settings)?);
        let mut pixels = vec![None; expected.pixels.len()];
        for (area, colors, ..) in told(renderer, &scene, settings) {
            same(&((area.width * area.height) as usize), &colors.len())?;
            for (place, color) in area.pixels().zip(colors) {
                let is_new = window.contains(place) && pixels[window.index(place)].replace(color).is_none();
                same(
                    &format!("pixel {place:?} once"),
                    &format!("pixel {place:?} {}", if is_new { "once" } else { "again, or outside" }),
                )?;
            }
        }
        if let Some(at) = pixels.iter().position(Option::is_none) {
            let place = [window.x + at as u32 % window.width, window.y + at as u32 / window.width];
            return Err(Counterexample::new(format!("pixel {place:?} told"), "it is not"));
        }
        equal(&expected, &Film { pixels: pixels.into_iter().flatten().collect(), ..expected.clone() })
    })
}

/// 1, 2, 3 ... of as many as there are buckets.
pub fn progress_rises_to_the_total(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EMPTY);
    few(trial).search((pictures(), 1..4_usize), |(settings, threads)| {
        let settings = Settings { threads: NonZeroUsize::new(*threads), ..settings.clone() };
        let told = told(renderer, &scene, &settings);
        let expected = (1..=told.len()).map(|finished| (finished, told.len())).collect::<Vec<_>>();
        same(&expected, &told.into_iter().map(|(.., finished, total)| (finished, total)).collect())
    })
}

/// As [`Scene::tiles`] gives them.
pub fn one_thread_takes_the_buckets_in_their_order(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EMPTY);
    few(trial).search(cropped(), |settings| {
        let (window, size) = (settings.window(), settings.buckets.size);
        let corner = |tile: &crate::Tile| [window.x + tile.column * size, window.y + tile.row * size];
        let expected: Vec<_> = scene.tiles(settings).iter().map(corner).collect();
        same(&expected, &told(renderer, &scene, settings).iter().map(|(area, ..)| [area.x, area.y]).collect())
    })
}

/// Then there is no picture, and no other bucket is begun.
pub fn a_rendering_can_be_broken_off(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EMPTY);
    few(trial).search(pictures(), |settings| {
        let calls = Mutex::new(0);
        let film = renderer(&scene, settings, &|_| {
            *calls.lock().unwrap_or_else(PoisonError::into_inner) += 1;
            ControlFlow::Break(())
        });
        same(&(true, 1), &(film.is_none(), calls.into_inner().unwrap_or_else(PoisonError::into_inner)))
    })
}

/// Of each kind, as many as there were.
pub fn rays_are_counted(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EVERYTHING);
    few(trial).search((cropped(), 1..3_usize), |(settings, threads)| {
        let settings = Settings { threads: NonZeroUsize::new(*threads), ..settings.clone() };
        same(&right(&scene, &settings)?.rays, &film(renderer, &scene, &settings)?.rays)
    })
}

/// A ray that is no number is black, counted, and told with its pixel, in order, each pixel once.
pub fn lost_rays_are_told_with_their_places(renderer: &Renderer, trial: &Trial) -> Verdict {
    let scene = scene(EXTREME);
    few(trial).search((cropped(), 1..3_usize), |(settings, threads)| {
        let settings = Settings { threads: NonZeroUsize::new(*threads), ..settings.clone() };
        same(&right(&scene, &settings)?.lost, &film(renderer, &scene, &settings)?.lost)
    })
}

geometry::kit! { $crate
    /// Names the laws of the whole bucket renderer as tests: of a [`Renderer`](crate::Renderer).
    renderer_conformance, Renderer, renderer;
    a_picture_has_the_size_that_is_asked_for: "nothing is returned yet: begin with a `Film` of the window's size, each pixel by `Pixels::color`";
    no_pixel_is_left_out: "a loop over a bucket ends one too early, or a bucket that the picture's edge cuts off is left out";
    what_is_above_is_above: "the film's rows count from the top, and so do pixels: no row is turned over";
    what_is_on_the_left_is_on_the_left: "a pixel's place in the film is row times width plus column";
    a_pixel_is_the_mean_of_its_rays: "rays are added and not divided by their number, or not all are asked for";
    buckets_have_no_influence_on_the_picture: "a pixel is counted in its bucket instead of the whole picture: its random numbers go by its place";
    threads_have_no_influence_on_the_picture: "threads share a generator or have seeds of their own, or write to the same pixels";
    a_crop_is_a_part_of_the_whole: "pixels are counted from the crop's corner instead of the whole picture's";
    every_pixel_is_told_once_with_its_colour: "`on_bucket` is not called, or with places that count from the crop's corner";
    progress_rises_to_the_total: "`finished` is counted outside the lock that calls `on_bucket`, or by each thread alone";
    one_thread_takes_the_buckets_in_their_order: "the buckets are not those of `Scene::tiles`, or are taken from its end";
    a_rendering_can_be_broken_off: "what `on_bucket` returns is not looked at";
    rays_are_counted: "`Pixels::take_counts` is not asked, or by one thread alone";
    lost_rays_are_told_with_their_places: "what `Pixels::take_counts` tells of lost rays is not put together, or not in order: `LostRays::in_window`";
}
