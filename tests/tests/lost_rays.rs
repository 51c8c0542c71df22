//! What is no number never gets into a picture unseen: the ray counts as black, is counted, and its place is told.

use std::num::NonZeroUsize;

use render::{Allotment, Buckets, Crop, Film, Modules, Settings, Shaders};
use shading::{Color, Shader, ShadingPoint};
use tests::{Folder, Rendering};

/// A ball in the middle of 24 x 18 pixels, four rays each.
const BALL: &str = "image { resolution 24 18 aa 1 1 samples 1 }
    camera { type pinhole eye 0 -5 0 target 0 0 0 up 0 0 1 fov 40 aspect 1.333 }
    background { color 0.25 0.5 0.75 }
    shader { name s type constant color 0.5 0.5 0.5 }
    object { shader s type sphere c 0 0 0 r 1 }";

/// A student's shader: the root of a number that is negative on the right.
struct Root;

impl Shader for Root {
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        Color::new(0.5, (-at.surface.position.x).sqrt(), 0.5)
    }
}

/// A shader for which there is no such place.
struct NoRoot;

impl Shader for NoRoot {
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        let x = at.surface.position.x;
        if x > 0.0 { Color::BLACK } else { Color::new(0.5, (-x).sqrt(), 0.5) }
    }
}

fn with(constant: fn(Color) -> Box<dyn Shader>) -> Rendering {
    let modules = Modules { shaders: Shaders { constant, ..Shaders::default() }, ..Modules::default() };
    Rendering { modules, ..Rendering::of(BALL) }
}

fn broken(change: impl FnOnce(Settings) -> Settings) -> Film {
    with(|_| Box::new(Root)).film_with(change)
}

#[test]
fn a_ray_that_is_no_number_counts_as_black_and_is_told() {
    let film = broken(|settings| settings);
    let expected = with(|_| Box::new(NoRoot)).film();
    assert_eq!(film.pixels, expected.pixels);
    assert!(expected.lost.pixels.is_empty());
    // On the ball and right of the middle.
    let right = |&[x, y]: &[u32; 2]| (12..24).contains(&x) && y < 18;
    assert!(film.lost.pixels.len() > 20 && film.lost.pixels.iter().all(right), "{:?}", film.lost);
    let pixels = film.lost.pixels.len() as u64;
    assert!(film.lost.count > pixels && film.lost.count <= 4 * pixels, "{:?}", film.lost);
    assert!(film.lost.pixels.is_sorted_by_key(|&[x, y]| [y, x]));
}

#[test]
fn lost_rays_do_not_depend_on_threads_and_buckets() {
    let expected = broken(|settings| settings);
    for (threads, size) in [(1, 1), (2, 7), (5, 100)] {
        let buckets = Buckets { size, ..Buckets::default() };
        let film = broken(|settings| Settings { threads: NonZeroUsize::new(threads), buckets, ..settings });
        assert_eq!(film, expected, "{threads} threads, buckets of {size}");
    }
}

#[test]
fn a_crop_tells_the_lost_rays_of_its_own_pixels_where_they_are_in_the_whole() {
    let crop = Crop { x: 13, y: 6, width: 5, height: 4 };
    let whole = broken(|settings| settings).lost.pixels;
    let inside = |&[x, y]: &[u32; 2]| (13..18).contains(&x) && (6..10).contains(&y);
    let expected: Vec<_> = whole.into_iter().filter(inside).collect();
    assert!(!expected.is_empty());
    for allotment in [Allotment::Even, Allotment::Adaptive] {
        let film = broken(|settings| Settings { crop: Some(crop), allotment, aa: 1, samples: 1, ..settings });
        assert!(film.pixels.iter().all(|pixel| pixel.to_array().iter().all(|channel| channel.is_finite())));
        assert_eq!(film.lost.pixels, expected, "{allotment:?}");
    }
}

/// So bright a light that the sum over a pixel's rays would overflow.
const EXTREME: &str = "image { resolution 24 18 }
    camera { type pinhole eye 0 -5 0 target 0 0 0 up 0 0 1 fov 40 aspect 1.333 }
    light { type point color 1e30 1 1 power 100 p 0 -5 0 }
    shader { name s type constant color 0.5 0.5 0.5 }
    object { shader s type sphere c 0 0 0 r 1 }";

#[test]
fn the_program_says_where_and_shows_it() {
    let folder = Folder::for_program(env!("CARGO_BIN_EXE_girasol-under-test")).with("extreme.sc", EXTREME);
    let said = folder.run(&["render", "extreme.sc", "--show-nan", "-o", "marked.png"]);
    assert_eq!(said.code, Some(0), "{}", said.stderr);
    assert!(
        said.stderr.contains("rays is no number: pixels (") && said.stderr.contains("--show-nan"),
        "{}",
        said.stderr
    );
    let marked = image::load_from_memory(&folder.read("marked.png")).unwrap().into_rgb8();
    assert_eq!(marked.get_pixel(12, 9).0, [255, 0, 255]);
    assert_eq!(marked.get_pixel(0, 0).0, [0, 0, 0]);
    // In a crop the places are those of the whole.
    let crop = folder.run(&["render", "extreme.sc", "--show-nan", "--crop", "12,9,2,2", "-o", "crop.png"]);
    assert!(
        crop.stderr.contains("the light of 4 rays is no number: pixels (12, 9), (13, 9), (12, 10) ..."),
        "{}",
        crop.stderr
    );
    let crop = image::load_from_memory(&folder.read("crop.png")).unwrap().into_rgb8();
    assert!(crop.pixels().all(|pixel| pixel.0 == [255, 0, 255]));
}

#[test]
fn a_sound_scene_is_not_warned_of() {
    let folder = Folder::for_program(env!("CARGO_BIN_EXE_girasol-under-test")).with("ball.sc", BALL);
    let ended = folder.run(&["render", "ball.sc", "-o", "ball.png"]);
    assert_eq!(ended.code, Some(0));
    assert!(!ended.stderr.contains("no number"), "{}", ended.stderr);
}
