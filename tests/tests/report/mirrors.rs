//! Section 3.3.4: the mirror, how often rays bounce, and what a ray sees that meets nothing.

use super::{assert_close, constant, flat, lit};

#[test]
fn a_mirror_shows_its_share_of_what_it_reflects() {
    let scene = constant("paint", "1 0.5 0.25")
        + "shader { name mirror type mirror refl 0.9 0.6 0.2 } object { shader mirror type plane p 0 0 0 n 0 0 1 }
           object { shader paint type sphere c 3 0 4 r 0.5 }";
    // From (-3, 0, 4) by way of the origin to (3, 0, 4).
    assert_close(flat([-3.0, 0.0, 4.0], [0.0; 3], &scene), [0.9, 0.3, 0.05], 1e-6);
}

#[test]
fn a_mirror_is_not_lit_itself() {
    let scene = "shader { name mirror type mirror refl 1 1 1 } object { shader mirror type plane p 0 0 0 n 0 0 1 }
        light { type point color 1 1 1 power 20 p 0 0 5 }";
    assert_close(lit([-3.0, 0.0, 4.0], [0.0; 3], scene), [0.0; 3], 0.0);
}

/// Two mirrors of share 1/2 at z = 0 and 10, and a white wall at x = 40. From (0, 0, 5) a ray that falls by `slope` for each unit of x
/// meets a mirror after 5 units of height and after each further 10.
fn corridor(slope: f64, depths: &str) -> shading::Color {
    let scene = constant("white", "1 1 1")
        + "shader { name mirror type mirror refl 0.5 0.5 0.5 }
           object { shader mirror type plane p 0 0 0 n 0 0 1 } object { shader mirror type plane p 0 0 10 n 0 0 1 }
           object { shader white type plane p 40 0 0 n 1 0 0 }"
        + depths;
    flat([0.0, 0.0, 5.0], [1.0, 0.0, 5.0 - slope], &scene)
}

#[test]
fn each_reflection_takes_its_share() {
    // Over 40 units: 20 of height are 2 reflections, 40 are 4.
    assert_close(corridor(0.0, ""), [1.0; 3], 0.0);
    assert_close(corridor(0.5, ""), [0.25; 3], 1e-6);
    assert_close(corridor(1.0, ""), [0.0625; 3], 1e-6);
}

#[test]
fn reflections_past_the_depth_are_black() {
    assert_close(corridor(0.5, "trace-depths { diff 1 refl 2 refr 4 }"), [0.25; 3], 1e-6);
    assert_close(corridor(0.5, "trace-depths { diff 1 refl 1 refr 4 }"), [0.0; 3], 0.0);
    // 50 of height are 5 reflections: one more than the default.
    assert_close(corridor(1.25, ""), [0.0; 3], 0.0);
    assert_close(corridor(1.25, "trace-depths { diff 1 refl 5 refr 4 }"), [0.03125; 3], 1e-6);
}

#[test]
fn a_ray_that_meets_nothing_sees_the_background() {
    assert_close(flat([0.0; 3], [0.0, 1.0, 0.0], ""), [0.0; 3], 0.0);
    assert_close(flat([0.0; 3], [0.0, 1.0, 0.0], "background { color 0.1 0.2 0.3 }"), [0.1, 0.2, 0.3], 1e-7);
}

#[test]
fn so_does_a_reflected_one() {
    let scene = "background { color 0.1 0.2 0.3 } shader { name mirror type mirror refl 0.5 0.5 0.5 }
        object { shader mirror type plane p 0 0 0 n 0 0 1 }";
    assert_close(flat([-3.0, 0.0, 4.0], [0.0; 3], scene), [0.05, 0.1, 0.15], 1e-7);
}

#[test]
fn colours_are_linear_or_srgb_as_they_say() {
    // sRGB 0.5 is ((0.5 + 0.055) / 1.055)^2.4 = 0.214041.
    let background = "background { color { \"sRGB nonlinear\" 0.5 0 1 } }";
    assert_close(flat([0.0; 3], [0.0, 1.0, 0.0], background), [0.214_041, 0.0, 1.0], 1e-6);
    let background = "background { color { \"sRGB linear\" 0.5 0 1 } }";
    assert_close(flat([0.0; 3], [0.0, 1.0, 0.0], background), [0.5, 0.0, 1.0], 1e-7);
}
