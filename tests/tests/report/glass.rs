//! Section 3.3.3: glass.
//!
//! A surface of glass at z = 0, its inside below; far below a red plane and far above a green one, which show their own colours.

use std::f64::consts::PI;

use tests::Rendering;

use super::{Triple, WHITE, assert_close, constant, flat, look, seen, textured};

fn glass(eye: Triple, glass: &str, object: &str) -> shading::Color {
    let scene = constant("red", "1 0 0")
        + &constant("green", "0 1 0")
        + &format!("shader {{ name glass type glass {glass} }}")
        + "object { shader red type plane p 0 0 -100 n 0 0 1 } object { shader green type plane p 0 0 100 n 0 0 1 }"
        + &format!("object {{ shader glass {object} }}");
    flat(eye, [0.0; 3], &scene)
}

const SURFACE: &str = "type plane p 0 0 0 n 0 0 1";

/// Where to stand to look at the origin at an angle from the normal, in degrees: above if it is less than 90.
fn at_angle(degrees: f64) -> Triple {
    let angle = degrees * PI / 180.0;
    [5.0 * angle.sin(), 0.0, 5.0 * angle.cos()]
}

#[test]
fn at_normal_incidence_fresnel_s_share_is_reflected() {
    // ((1.5 - 1) / (1.5 + 1))^2 = 0.04, from either side; 1/9 for 2.
    assert_close(glass(at_angle(0.0), "eta 1.5 color 1 1 1", SURFACE), [0.96, 0.04, 0.0], 1e-6);
    assert_close(glass(at_angle(180.0), "eta 1.5 color 1 1 1", SURFACE), [0.04, 0.96, 0.0], 1e-6);
    assert_close(glass(at_angle(0.0), "eta 2 color 1 1 1", SURFACE), [8.0 / 9.0, 1.0 / 9.0, 0.0], 1e-6);
}

#[test]
fn aslant_more_is_reflected() {
    // At 60 degrees: cos_i = 1/2, sin_t = sin 60 / 1.5 = 0.577350, cos_t = 0.816497.
    // r_s = (0.5 - 1.5 0.816497) / (0.5 + 1.5 0.816497) = -0.420204, r_p = (1.5 0.5 - 0.816497) / (1.5 0.5 + 0.816497) = -0.042449;
    // the mean of their squares is 0.089187.
    assert_close(glass(at_angle(60.0), "eta 1.5 color 1 1 1", SURFACE), [1.0 - 0.089_187, 0.089_187, 0.0], 1e-5);
}

#[test]
fn beyond_the_critical_angle_all_is_reflected() {
    // Inside, asin(1 / 1.5) = 41.8 degrees from the normal.
    assert_close(glass(at_angle(180.0 - 45.0), "eta 1.5 color 1 1 1", SURFACE), [1.0, 0.0, 0.0], 0.0);
    assert_close(glass(at_angle(180.0 - 42.0), "eta 1.5 color 1 1 1", SURFACE), [1.0, 0.0, 0.0], 0.0);
    let just_before = glass(at_angle(180.0 - 41.0), "eta 1.5 color 1 1 1", SURFACE);
    assert!(just_before.g > 0.5, "{just_before:?}");
}

#[test]
fn light_is_bent_towards_the_normal() {
    // From 60 degrees it goes on at asin(sin 60 / 1.5) = 35.264 degrees from the normal: 10 deeper at -10 tan 35.264 = -7.0711.
    let scene = |x: f64| {
        format!(
            "{WHITE} shader {{ name glass type glass eta 1.5 color 1 1 1 }} object {{ shader glass {SURFACE} }}
             object {{ shader white type sphere c {x} 0 -10 r 0.1 }}"
        )
    };
    assert_close(flat(at_angle(60.0), [0.0; 3], &scene(-7.0711)), [1.0 - 0.089_187; 3], 1e-5);
    assert_close(flat(at_angle(60.0), [0.0; 3], &scene(-17.32)), [0.0; 3], 0.0);
}

#[test]
fn its_colour_tints_what_passes_and_what_is_reflected() {
    assert_close(glass(at_angle(0.0), "eta 1.5 color 0.5 0.25 1", SURFACE), [0.96 * 0.5, 0.04 * 0.25, 0.0], 1e-6);
}

#[test]
fn its_colour_counts_at_each_surface() {
    let slab = "transform { scaleu 2 } type box";
    assert_close(glass(at_angle(10.0), "eta 1 color 0.5 1 1", slab), [0.25, 0.0, 0.0], 1e-6);
}

#[test]
fn it_absorbs_by_the_length_of_the_way_inside() {
    // Straight through a cube of side 2: t / distance = 2 / 4. Red: exp(-0.5 (1 - 0.6)) = exp(-0.2) = 0.818731.
    let slab = "transform { scaleu 2 } type box";
    let absorbing = "eta 1 color 1 1 1 absorption.distance 4 absorption.color 0.6 1 1";
    assert_close(glass(at_angle(0.0), absorbing, slab), [0.818_731, 0.0, 0.0], 1e-6);
    // At 45 degrees the way is sqrt(2) times as long through a wide slab: exp(-0.282843) = 0.753638.
    let wide = "transform { scale 50 50 2 } type box";
    assert_close(glass(at_angle(45.0), absorbing, wide), [0.753_638, 0.0, 0.0], 1e-6);
}

#[test]
fn with_eta_1_it_cannot_be_seen() {
    let scene = |object: &str| {
        let camera =
            "image { resolution 32 24 } camera { type pinhole eye 0 -6 3 target 0 0 0 up 0 0 1 fov 50 aspect 1.3333 }";
        let glass = "shader { name glass type glass eta 1 color 1 1 1 }";
        textured(4, 4, &format!("{camera} {glass} object {{ shader textured type plane p 0 0 -2 n 0 0 1 }} {object}"))
    };
    let without = scene("").film();
    for shape in ["type sphere c 0 0 0 r 1", "transform { rotatez 30 scaleu 2 } type box"] {
        let with = scene(&format!("object {{ shader glass {shape} }}")).film();
        assert!(with.rays.secondary > 0);
        for (with, without) in with.pixels.iter().zip(&without.pixels) {
            assert_close(*with, without.to_array().map(f64::from), 1e-4);
        }
    }
}

#[test]
fn refractions_past_the_depth_are_black() {
    // A cube has two surfaces to pass.
    let through = |depths: &str| {
        let scene = constant("red", "1 0 0")
            + depths
            + "shader { name glass type glass eta 1 color 1 1 1 } object { shader red type plane p 0 0 -100 n 0 0 1 }
               object { shader glass type box }";
        flat(at_angle(10.0), [0.0; 3], &scene)
    };
    assert_close(through("trace-depths { diff 1 refl 4 refr 2 }"), [1.0, 0.0, 0.0], 1e-6);
    assert_close(through("trace-depths { diff 1 refl 4 refr 1 }"), [0.0; 3], 0.0);
    assert_close(through(""), [1.0, 0.0, 0.0], 1e-6);
}

#[test]
fn a_scene_with_glass_but_without_lights_needs_no_second_accelerator() {
    let text = |light: &str| {
        look([9.0; 3], [0.0; 3])
            + "shader { name glass type glass eta 1.5 color 1 1 1 } object { shader glass type sphere c 0 0 0 r 1 }"
            + light
    };
    let blockers = |text: String| {
        let assembled = Rendering::of(text).assemble();
        assembled.scene.inventory(&assembled.settings).blockers
    };
    assert!(blockers(text("")).is_none());
    assert!(blockers(text("light { type point color 1 1 1 power 9 p 9 9 9 }")).is_some());
    assert_eq!(seen(&Rendering::of(text(""))), shading::Color::BLACK);
}
