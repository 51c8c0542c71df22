//! The lighting `sunflow`, by its formulas: each expected colour is worked out beside it.

use render::{Assembled, Modules};
use shading::Color;
use tests::Rendering;

/// The picture's one pixel, looking down from (0, 0, 5).
fn seen(scene: &str) -> Color {
    let text = format!(
        "image {{ resolution 1 1 }}
         camera {{ type pinhole eye 0 0 5 target 0 0 0 up 0 1 0 fov 1 aspect 1 }}
         {scene}"
    );
    let rendering = Rendering { modules: Modules::default().lit_as_by_sunflow(), ..Rendering::of(text) };
    rendering.film().pixels[0]
}

#[track_caller]
fn assert_seen(scene: &str, expected: f32) {
    let Color { r, g, b } = seen(scene);
    assert!(
        [r, g, b].iter().all(|channel| (channel - expected).abs() <= 2e-5 * expected),
        "{r} {g} {b}, not {expected}"
    );
}

const LIGHT: &str = "light { type point color 1 1 1 power 1000 p 0 0 5 }";
const DIFFUSE: &str = "shader { name s type diffuse diff 0.2 0.2 0.2 }";
const FLOOR: &str = "object { shader s type plane p 0 0 0 n 0 0 1 }";

#[test]
fn a_matt_surface_shows_its_colour_by_pi_and_the_light_s_flux_by_the_sphere_around_it() {
    // 0.2 x 1000 / (4 pi^2 5^2)
    assert_seen(&format!("{LIGHT}{DIFFUSE}{FLOOR}"), 0.202_642);
}

#[test]
fn a_plane_s_normal_twice_as_long_is_lit_twice_as_brightly() {
    assert_seen(&format!("{LIGHT}{DIFFUSE}object {{ shader s type plane p 0 0 0 n 0 0 2 }}"), 0.405_285);
}

#[test]
fn a_highlight_is_normalised() {
    // Light, viewer and normal are one line: 0.1 (6 + 2) / (2 pi) x 1000 / (4 pi 5^2)
    let phong = "shader { name s type phong diff 0 0 0 spec 0.1 0.1 0.1 6 samples 0 }";
    assert_seen(&format!("{LIGHT}{phong}{FLOOR}"), 0.405_285);
}

#[test]
fn constant_needs_no_light_and_all_else_is_black_without() {
    assert_seen(&format!("shader {{ name s type constant color 0.5 0.5 0.5 }}{FLOOR}"), 0.5);
    assert_eq!(seen(&format!("{DIFFUSE}{FLOOR}")), Color::BLACK);
}

#[test]
fn mirrors_see_a_black_background() {
    let mirror = "background { color 1 1 1 } shader { name s type mirror refl 1 1 1 }";
    assert_eq!(seen(&format!("{mirror}{FLOOR}")), Color::BLACK);
    assert_seen(mirror, 1.0);
}

#[test]
fn glass_drops_its_inner_reflection_and_colours_at_each_passage() {
    // Straight through a ball onto a wall of 0.5: kt = 0.96 twice, the colour 0.9 twice; the first reflection goes to black.
    let ball = "shader { name g type glass eta 1.5 color 0.9 0.9 0.9 } object { shader g type sphere c 0 0 2 r 1 }";
    let wall = format!("shader {{ name s type constant color 0.5 0.5 0.5 }}{FLOOR}");
    assert_seen(&format!("{ball}{wall}"), 0.5 * 0.96 * 0.96 * 0.9 * 0.9);
}

#[test]
fn glass_casts_a_full_shadow() {
    // The ball is beside the view, between the light and what is seen.
    let light = "light { type point color 1 1 1 power 1000 p 4 0 4 }";
    let ball = "shader { name g type glass eta 1.5 color 1 1 1 } object { shader g type sphere c 2 0 2 r 0.5 }";
    assert_eq!(seen(&format!("{light}{DIFFUSE}{FLOOR}{ball}")), Color::BLACK);
    assert_ne!(seen(&format!("{light}{DIFFUSE}{FLOOR}")), Color::BLACK);
}

#[test]
fn glossy_reflections_are_missed_aloud() {
    let phong = |end: &str| {
        let text = format!(
            "camera {{ type pinhole eye 0 0 5 target 0 0 0 up 0 1 0 fov 1 aspect 1 }}
             shader {{ name s type phong diff 0 0 0 spec 0.1 0.1 0.1 6 {end} }}{FLOOR}"
        );
        let Rendering { text, files, lighting, .. } = Rendering::of(text);
        let parsed = scene_format::parse("test.sc", &text, &files);
        let modules = Modules::default().lit_as_by_sunflow();
        let Ok(Assembled { warnings, .. }) = render::assemble(&parsed.scene, &modules, &lighting, &files) else {
            panic!("the scene is sound")
        };
        warnings.iter().map(|warning| warning.message.clone()).collect::<Vec<_>>()
    };
    assert_eq!(phong("samples 0"), Vec::<String>::new());
    for end in ["", "samples 16"] {
        assert_eq!(phong(end), ["`s` is rendered without glossy reflections"]);
    }
}
