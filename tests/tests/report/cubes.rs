//! Section 2.3.3: the cube.

use super::{WHITE, assert_close, flat, texel, textured};

#[test]
fn every_face_shows_the_whole_texture_upright_and_unmirrored() {
    // Outward normal, and what is up in the face's picture: +z on the walls, as a room's walls stand.
    let faces = [
        ([1, 0, 0], [0, 0, 1]),
        ([-1, 0, 0], [0, 0, 1]),
        ([0, 1, 0], [0, 0, 1]),
        ([0, -1, 0], [0, 0, 1]),
        ([0, 0, 1], [0, 1, 0]),
        ([0, 0, -1], [0, -1, 0]),
    ];
    for ([x, y, z], [up_x, up_y, up_z]) in faces {
        // From 10 away the face at 9.5 fills the picture when tan(fov / 2) = 0.5 / 9.5: each of the 3 x 3 pixels looks into the
        // middle of a texel.
        let film = textured(
            3,
            3,
            &format!(
                "image {{ resolution 3 3 }}
                 camera {{ type pinhole eye {} {} {} target 0 0 0 up {up_x} {up_y} {up_z} fov 6.02558 aspect 1 }}
                 object {{ shader textured transform {{ translate 0 0 0 }} type box }}",
                10 * x,
                10 * y,
                10 * z
            ),
        )
        .film();
        for (index, &pixel) in (0..).zip(&film.pixels) {
            assert_close(pixel, texel(index % 3, 2 - index / 3), 1e-4);
        }
    }
}

#[test]
fn a_cube_has_side_1_around_the_origin() {
    let cube = WHITE.to_owned() + "object { shader white type box }";
    for (x, color) in [(0.49, 1.0), (0.51, 0.0), (-0.49, 1.0), (-0.51, 0.0)] {
        // Along each axis, beside another axis.
        assert_close(flat([x, -9.0, 0.0], [x, 0.0, 0.0], &cube), [color; 3], 0.0);
        assert_close(flat([0.0, x, 9.0], [0.0, x, 0.0], &cube), [color; 3], 0.0);
        assert_close(flat([9.0, 0.0, x], [0.0, 0.0, x], &cube), [color; 3], 0.0);
    }
}

#[test]
fn a_cube_is_placed_by_its_transform() {
    // Turned by 45 degrees its edge stands sqrt(1/2) = 0.7071 from the axis.
    let cube = WHITE.to_owned() + "object { shader white transform { rotatez 45 translate 3 0 0 } type box }";
    for (x, color) in [(0.70, 1.0), (0.72, 0.0)] {
        assert_close(flat([3.0 + x, -9.0, 0.0], [3.0 + x, 0.0, 0.0], &cube), [color; 3], 0.0);
    }
}

#[test]
fn a_cube_is_twelve_triangles() {
    let rendering = tests::Rendering::of(super::look([9.0; 3], [0.0; 3]) + WHITE + "object { shader white type box }");
    let assembled = rendering.assemble();
    assert_eq!(assembled.scene.inventory(&assembled.settings).bounded.total(), 12);
}
