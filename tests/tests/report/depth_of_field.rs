//! Section 2.1: the thin lens.
//!
//! The camera looks along +y at a white quad at distance 10 that covers all of x > 0. The picture is 20 units wide there, one for
//! each of its 20 columns; x = 0 is the border between columns 9 and 10.

use render::{Crop, Settings};
use tests::Rendering;

use super::WHITE;

fn half_white(lens: &str) -> Rendering {
    Rendering::flat(format!(
        "{WHITE} image {{ resolution 20 20 samples 64 }}
         camera {{ type thinlens eye 0 0 0 target 0 1 0 up 0 0 1 fov 90 aspect 1 {lens} }}
         object {{ shader white type generic-mesh
             points 4  0 10 -50  50 10 -50  50 10 50  0 10 50  triangles 2  0 1 2  0 2 3  normals none uvs none }}"
    ))
}

/// The mean of the red channel over a column.
fn column(rendering: &Rendering, x: u32) -> f64 {
    let film = rendering.film_with(|settings| Settings {
        crop: Some(Crop { x, y: 0, width: 1, height: 20 }),
        aa: 2,
        samples: 256,
        ..settings
    });
    film.pixels.iter().map(|pixel| f64::from(pixel.r)).sum::<f64>() / 20.0
}

#[test]
fn what_lies_in_the_plane_of_focus_is_sharp() {
    // Every ray of a pixel meets its own square of the plane, from whichever place on the lens it comes.
    let film = half_white("fdist 10 lensr 2").film();
    for (index, pixel) in film.pixels.iter().enumerate() {
        assert_eq!(pixel.r, if index % 20 < 10 { 0.0 } else { 1.0 }, "pixel {index}");
    }
}

#[test]
fn what_lies_twice_as_far_is_blurred_by_the_radius_of_the_lens() {
    // A ray from o on the lens through p in the plane at 5 meets the plane at 10 in o + 2 (p - o) = 2 p - o: by at most 1 beside
    // where the pinhole's ray would meet it. So only the two columns beside the edge are mixed.
    let film = half_white("fdist 5 lensr 1").film();
    for (index, pixel) in film.pixels.iter().enumerate() {
        match index % 20 {
            0..=8 => assert_eq!(pixel.r, 0.0, "pixel {index}"),
            11..=19 => assert_eq!(pixel.r, 1.0, "pixel {index}"),
            _ => assert!(pixel.r > 0.0 && pixel.r < 1.0, "pixel {index}: {pixel:?}"),
        }
    }
}

#[test]
fn a_lens_without_radius_is_a_pinhole() {
    assert!(!half_white("fdist 5 lensr 0").assemble().scene.camera().has_lens());
    let film = half_white("fdist 5 lensr 0").film();
    assert!(film.pixels.iter().enumerate().all(|(index, pixel)| pixel.r == f32::from(index % 20 >= 10)));
}

// Column 10 sees s - o with s evenly in 0..1 and o the place on the lens: black is P(o > s), which over all s is
// E max(o, 0) = E|o| / 2. With 20 x 16 x 256 rays the standard deviation is below sqrt(0.25 / 81920) = 0.0017; four are allowed.
const FOUR_SIGMA: f64 = 0.007;

#[test]
fn the_lens_is_a_disc_without_sides() {
    // E|o| = 4 / (3 pi) in the unit disc.
    let white = column(&half_white("fdist 5 lensr 1"), 10);
    assert!((white - (1.0 - 2.0 / (3.0 * std::f64::consts::PI))).abs() < FOUR_SIGMA, "{white}");
}

#[test]
fn the_lens_is_a_polygon_with_sides() {
    // Four sides, the first corner to the right: a diamond, whose width falls linearly from the middle. E|o| = 1 / 3.
    let white = column(&half_white("fdist 5 lensr 1 sides 4"), 10);
    assert!((white - (1.0 - 1.0 / 6.0)).abs() < FOUR_SIGMA, "{white}");
}

#[test]
fn rotation_turns_the_polygon() {
    // The square with corners at radius 1, now upright, reaches from -sqrt(1/2) to sqrt(1/2): E|o| / 2 = sqrt(1/2) / 4 = 0.17678,
    // only 0.01 more than the diamond's: half of that is allowed.
    let white = column(&half_white("fdist 5 lensr 1 sides 4 rotation 45"), 10);
    assert!((white - (1.0 - 0.176_777)).abs() < 0.005, "{white}");
}
