//! Section 2.3.4: the infinite plane and its repeated texture.

use tests::Rendering;

use super::{Triple, WHITE, assert_close, look, seen, texel, textured};

fn texture_at(eye: Triple, target: Triple, plane: &str) -> shading::Color {
    seen(&textured(2, 2, &format!("{} object {{ shader textured type plane {plane} }}", look(eye, target))))
}

#[test]
fn a_plane_repeats_its_texture_every_10_units() {
    // With normal +z: u along +x, v along +y, from the plane's point (1, 2). The middles of the 2 x 2 texels lie at 2.5 and 7.5.
    for (x, y, column, row) in [
        (2.5, 2.5, 0, 0),
        (7.5, 2.5, 1, 0),
        (2.5, 7.5, 0, 1),
        (12.5, 2.5, 0, 0),
        (2.5, 27.5, 0, 1),
        (-2.5, 2.5, 1, 0),
        (-997.5, -992.5, 0, 1),
    ] {
        let target = [x + 1.0, y + 2.0, 3.0];
        let found = texture_at([target[0], target[1] - 1.0, 8.0], target, "p 1 2 3 n 0 0 5");
        assert_close(found, texel(column, row), 2e-3);
    }
}

#[test]
fn a_texture_stands_upright_on_a_wall() {
    // A wall that looks along +z in a scene whose y points up is the same plane; one along +x: v along +y, u = y x x = -z.
    assert_close(texture_at([9.0, 2.5, -7.5], [0.0, 2.5, -7.5], "p 0 0 0 n 1 0 0"), texel(1, 0), 1e-4);
    assert_close(texture_at([9.0, 7.5, -2.5], [0.0, 7.5, -2.5], "p 0 0 0 n 1 0 0"), texel(0, 1), 1e-4);
}

#[test]
fn three_points_span_the_texture() {
    // From (1, 1): u along (4, 0), v along (1, 3). u = 1/4, v = 3/4 is (1 + 1 + 0.75, 1 + 2.25).
    let plane = "p 1 1 0 p 5 1 0 p 2 4 0";
    let at = |x: f64, y: f64| texture_at([x, y - 1.0, 5.0], [x, y, 0.0], plane);
    assert_close(at(2.75, 3.25), texel(0, 1), 1e-4);
    // u = 3/4, v = 1/4: (1 + 3 + 0.25, 1 + 0.75).
    assert_close(at(4.25, 1.75), texel(1, 0), 1e-4);
    // One copy further along both: (+ 4 + 1, + 3).
    assert_close(at(9.25, 4.75), texel(1, 0), 1e-4);
}

#[test]
fn a_plane_reaches_the_horizon() {
    // 1 above the floor, looking level: the lower half sees it, 16 rows of 32, the last one 32 units away.
    let text = format!(
        "{WHITE} image {{ resolution 1 32 }}
         camera {{ type pinhole eye 0 0 1 target 0 1 1 up 0 0 1 fov 90 aspect 1 }}
         object {{ shader white type plane p 0 0 0 n 0 0 1 }}"
    );
    let film = Rendering::flat(text).film();
    assert!(film.pixels.iter().enumerate().all(|(row, pixel)| pixel.r == f32::from(row >= 16)), "{film:?}");
}

#[test]
fn a_plane_is_lit_by_a_normal_of_any_length() {
    let scene = |n: &str| {
        format!(
            "{} {WHITE} light {{ type point color 1 1 1 power 20 p 0 0 5 }} object {{ shader white type plane p 0 0 0 n {n} }}",
            look([0.0, -1.0, 5.0], [0.0; 3])
        )
    };
    for n in ["0 0 1", "0 0 -1", "0 0 0.001", "0 0 40000"] {
        assert_close(seen(&Rendering::of(scene(n))), [0.75; 3], 1e-6);
    }
}
