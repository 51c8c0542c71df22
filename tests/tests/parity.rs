//! `girasol parity`: pictures lit as by Sunflow against references. Sunflow's own pictures are no part of this repository; `.ci/run` holds
//! girasol against them where they are there.

use std::io::Cursor;

use image::{ImageFormat, Rgb, RgbImage};
use tests::{Ended, Folder};

/// A ball of one colour before a background, 40 x 30: all else is flat.
const SCENE: &str = "image { resolution 40 30 }
camera { type pinhole eye 0 -5 0 target 0 0 0 up 0 0 1 fov 30 aspect 1.333 }
background { color 0.2 0.3 0.4 }
shader { name white type constant color 0.9 0.5 0.5 }
object { shader white type sphere c 0 0 0 r 1 }
";

fn folder() -> Folder {
    let folder = Folder::for_program(env!("CARGO_BIN_EXE_girasol-under-test"));
    for name in ["scenes", "references", "out"] {
        std::fs::create_dir(folder.path(name)).unwrap();
    }
    folder.with("scenes/ball.sc", SCENE)
}

fn parity(folder: &Folder) -> Ended {
    folder.run(&["parity", "scenes", "references", "--difference", "out", "--quiet"])
}

/// The scene's own picture, changed, as the reference.
fn against(change: impl FnOnce(&mut RgbImage)) -> (Ended, Folder) {
    let folder = folder();
    let rendered =
        folder.run(&["render", "scenes/ball.sc", "--lighting", "sunflow", "-o", "references/ball.png", "--quiet"]);
    assert_eq!(rendered.code, Some(0), "{}", rendered.stderr);
    let mut picture = image::load_from_memory(&folder.read("references/ball.png")).unwrap().into_rgb8();
    change(&mut picture);
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png).unwrap();
    let folder = folder.with("references/ball.png", bytes.get_ref());
    (parity(&folder), folder)
}

/// The first pixel of the middle row that shows the ball.
fn silhouette(picture: &RgbImage) -> [u32; 2] {
    let background = *picture.get_pixel(0, 15);
    [(0..40).find(|&x| *picture.get_pixel(x, 15) != background).unwrap(), 15]
}

#[test]
fn a_scene_agrees_with_its_own_picture() {
    let (ended, folder) = against(|_| {});
    assert_eq!(ended.code, Some(0), "{}", ended.stderr);
    assert!(
        ended.stdout.contains("| ball  |    100.000 |    100.000 |       0 |           0 | 0.00000 |"),
        "{}",
        ended.stdout
    );
    let difference = image::load_from_memory(&folder.read("out/ball.png")).unwrap().into_rgb8();
    assert!(difference.pixels().all(|pixel| *pixel == Rgb([0; 3])));
}

#[test]
fn a_pixel_that_is_off_where_there_is_no_edge_is_a_failure_that_names_it() {
    let (ended, folder) = against(|picture| picture.get_pixel_mut(20, 15).0[1] -= 3);
    assert_eq!(ended.code, Some(1), "{}", ended.stdout);
    // 1 of 1200 pixels, 3 of 255: 99.917 % and sqrt(9 / 3600) / 255.
    assert!(
        ended.stdout.contains("| ball  |     99.917 |    100.000 |       3 |           1 | 0.00020 |"),
        "{}",
        ended.stdout
    );
    assert!(ended.stdout.contains("| ball  | 20, 15 |"), "{}", ended.stdout);
    let difference = image::load_from_memory(&folder.read("out/ball.png")).unwrap().into_rgb8();
    assert_eq!(*difference.get_pixel(20, 15), Rgb([255, 0, 0]));
}

#[test]
fn a_pixel_beside_a_silhouette_is_no_excuse_where_the_silhouette_does_not_pass() {
    // The ball's first pixel in the reference is background: its ray runs a good part of a pixel inside.
    let (ended, _) = against(|picture| {
        let [x, y] = silhouette(picture);
        *picture.get_pixel_mut(x, y) = *picture.get_pixel(0, y);
    });
    assert_eq!(ended.code, Some(1), "{}", ended.stdout);
}

#[test]
fn a_silhouette_a_rounding_beside_a_ray_is_an_excuse() {
    // A wall whose edge is at x = 0.0004, a hundredth of a pixel (2 tan(15 degrees) x 5 / 39 = 0.0687) right of the middle of pixel 19:
    // that is 19.5 / 39 of the view, its very middle.
    let wall = "shader { name wall type constant color 0.9 0.1 0.1 }
        object { shader wall type generic-mesh points 3 0.0004 0 -90 90 0 -90 0.0004 0 90 triangles 1 0 1 2 normals none uvs none }";
    let scene = SCENE.replace("object { shader white type sphere c 0 0 0 r 1 }", wall);
    let moved = scene.replace("0.0004", "-0.0004");
    let folder = folder().with("scenes/ball.sc", &scene).with("moved.sc", &moved);
    let rendered = folder.run(&["render", "moved.sc", "--lighting", "sunflow", "-o", "references/ball.png", "--quiet"]);
    assert_eq!(rendered.code, Some(0), "{}", rendered.stderr);
    let changed = parity(&folder);
    // A column of 30 pixels, 2.5 % of all: too many, but each explained.
    assert_eq!(changed.code, Some(1));
    assert!(changed.stdout.contains("| ball  |     97.500 |"), "{}", changed.stdout);
    assert!(changed.stdout.contains("|           0 |"), "{}", changed.stdout);
}

#[test]
fn a_reference_that_is_missing_or_of_another_size_is_an_error_that_says_so() {
    let folder = folder();
    let missing = parity(&folder);
    assert_eq!(missing.code, Some(1));
    assert!(
        missing.stderr.contains("there is no such file") && missing.stderr.contains("ball.png"),
        "{}",
        missing.stderr
    );
    let (smaller, _) = against(|picture| *picture = RgbImage::new(40, 29));
    assert_eq!(smaller.code, Some(1));
    assert!(smaller.stderr.contains("40 x 29") && smaller.stderr.contains("40 x 30"), "{}", smaller.stderr);
    let no_folder = folder.run(&["parity", "scenes", "references", "--difference", "nowhere"]);
    assert!(no_folder.stderr.contains("no folder `nowhere`"), "{}", no_folder.stderr);
}
