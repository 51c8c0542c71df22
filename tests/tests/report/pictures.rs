//! What is written: PNG and BMP in 8-bit sRGB, EXR with the linear values, each equal to the film when it is read back.

use render::Film;
use tests::{Folder, Rendering};

use super::constant;

const PROGRAM: &str = env!("CARGO_BIN_EXE_girasol-under-test");

/// A lit sphere over a floor, brighter than white in places.
fn scene() -> String {
    constant("bright", "3 1 0.2")
        + "image { resolution 23 17 aa 1 1 } camera { type pinhole eye 0 -6 3 target 0 0 0 up 0 0 1 fov 50 aspect 1.3529 }
           object { shader bright type sphere c 0 0 0 r 1 } object { shader bright type plane p 0 0 -1 n 0 0 1 }
           light { type point color 1 1 1 power 12 p 3 -4 5 }"
}

fn written_as(name: &str) -> (Film, image::DynamicImage) {
    let folder = Folder::for_program(PROGRAM).with("a.sc", scene());
    let ended = folder.run(&["render", "a.sc", "-o", name]);
    assert_eq!(ended.code, Some(0), "{}", ended.stderr);
    let picture = image::load_from_memory(&folder.read(name)).expect("the picture can be read back");
    let film = Rendering::of(scene()).film();
    assert_eq!((picture.width(), picture.height()), (film.width, film.height));
    (film, picture)
}

#[test]
fn a_png_holds_the_film_in_8_bit_srgb() {
    let (film, picture) = written_as("a.png");
    assert_eq!(picture.as_rgb8().expect("8 bits, no alpha").as_raw(), &film.to_srgb_bytes());
}

#[test]
fn a_bmp_holds_the_same() {
    let (film, picture) = written_as("a.bmp");
    assert_eq!(picture.as_rgb8().expect("8 bits, no alpha").as_raw(), &film.to_srgb_bytes());
}

#[test]
fn an_exr_holds_the_linear_values_bit_for_bit() {
    let (film, picture) = written_as("a.exr");
    let linear: Vec<f32> = film.pixels.iter().flat_map(|pixel| pixel.to_array()).collect();
    assert!(linear.iter().any(|&value| value > 1.0));
    assert_eq!(picture.into_rgb32f().into_raw(), linear);
}

#[test]
fn bytes_are_the_srgb_curve_of_the_linear_values() {
    let film = Rendering::of(scene()).film();
    for (byte, linear) in film.to_srgb_bytes().into_iter().zip(film.pixels.iter().flat_map(|pixel| pixel.to_array())) {
        // IEC 61966-2-1
        let linear = f64::from(linear.clamp(0.0, 1.0));
        let encoded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
        assert!((f64::from(byte) - 255.0 * encoded).abs() <= 0.51, "{linear} is not {byte}");
    }
}
