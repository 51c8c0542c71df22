//! Section 2.1: where the pinhole camera stands and what it sees.

use tests::Rendering;

use super::WHITE;

/// The pixels (column, row) that see a small sphere of radius 0.5, in a picture of 8 x 4 pixels.
fn pixels_that_see(camera: &str, [x, y, z]: [f64; 3]) -> Vec<(u32, u32)> {
    let scene = format!(
        "{WHITE} image {{ resolution 8 4 }} camera {{ type pinhole {camera} }}
         object {{ shader white type sphere c {x} {y} {z} r 0.5 }}"
    );
    let film = Rendering::flat(scene).film();
    let places = (0..4).flat_map(|row| (0..8).map(move |column| (column, row)));
    places.zip(&film.pixels).filter(|(_, pixel)| pixel.r > 0.0).map(|(place, _)| place).collect()
}

// The camera stands at (1, 2, 3) and looks along +x; z is up, so right is -y. With fov 90 the image plane at distance 1 is
// 2 wide; with aspect 2 it is 1 high. The centre of pixel (6, 1) lies (2 (6.5 / 8) - 1) 1 = 0.625 to the right of the axis and
// (1 - 2 (1.5 / 4)) 0.5 = 0.125 above it: at distance 10 that is the point (11, 2 - 6.25, 3 + 1.25). A pixel is 2.5 wide there.

#[test]
fn a_pixel_looks_through_its_centre_in_the_frame_of_eye_target_and_up() {
    let camera = "eye 1 2 3 target 4 2 3 up 0 0 1 fov 90 aspect 2";
    assert_eq!(pixels_that_see(camera, [11.0, -4.25, 4.25]), [(6, 1)]);
}

#[test]
fn up_turned_over_turns_the_picture_over() {
    let camera = "eye 1 2 3 target 4 2 3 up 0 0 -1 fov 90 aspect 2";
    assert_eq!(pixels_that_see(camera, [11.0, -4.25, 4.25]), [(8 - 1 - 6, 4 - 1 - 1)]);
}

#[test]
fn fov_is_the_full_horizontal_angle_in_degrees() {
    // tan(126.869898 / 2) = 2: everything is twice as far from the axis.
    let camera = "eye 1 2 3 target 4 2 3 up 0 0 1 fov 126.869898 aspect 2";
    assert_eq!(pixels_that_see(camera, [11.0, 2.0 - 12.5, 3.0 + 2.5]), [(6, 1)]);
}

#[test]
fn aspect_gives_the_height_whatever_the_resolution() {
    // Aspect 0.5: the image plane is 4 high, so a pixel is four times as high.
    let camera = "eye 1 2 3 target 4 2 3 up 0 0 1 fov 90 aspect 0.5";
    assert_eq!(pixels_that_see(camera, [11.0, -4.25, 3.0 + 5.0]), [(6, 1)]);
}

#[test]
fn shift_moves_the_image_plane_at_distance_1() {
    // (0.625 + 0.3, 0.125 - 0.2) 10 = (9.25, -0.75)
    let camera = "eye 1 2 3 target 4 2 3 up 0 0 1 fov 90 aspect 2 shift 0.3 -0.2";
    assert_eq!(pixels_that_see(camera, [11.0, 2.0 - 9.25, 3.0 - 0.75]), [(6, 1)]);
}

#[test]
fn a_transform_places_a_camera_that_looks_down_its_own_negative_z() {
    // Not turned: right is +x, up +y.
    let camera = "transform { translate 1 2 3 } fov 90 aspect 2";
    assert_eq!(pixels_that_see(camera, [1.0 + 6.25, 2.0 + 1.25, 3.0 - 10.0]), [(6, 1)]);
}
