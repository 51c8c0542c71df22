//! The lighting `sunflow`, by its formulas: each expected colour is worked out beside it.

use render::{Assembled, Modules};
use shading::Color;
use tests::Rendering;

/// The picture's one pixel, looking down from (0, 0, 5).
fn seen(scene: &str) -> Color {
    seen_by("camera { type pinhole eye 0 0 5 target 0 0 0 up 0 1 0 fov 1 aspect 1 }", scene)
}

/// The picture's one pixel.
fn seen_by(camera: &str, scene: &str) -> Color {
    let text = format!("image {{ resolution 1 1 }} {camera} {scene}");
    let rendering = Rendering { modules: Modules::default().lit_as_by_sunflow(), ..Rendering::of(text) };
    rendering.film().pixels[0]
}

#[track_caller]
fn assert_seen(scene: &str, expected: f32) {
    assert_grey(seen(scene), expected);
}

#[track_caller]
fn assert_grey(Color { r, g, b }: Color, expected: f32) {
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
    // The point is a thousandth above the floor: 0.2 x 1000 / (4 pi^2 4.999^2)
    assert_seen(&format!("{LIGHT}{DIFFUSE}{FLOOR}"), 0.202_723);
}

#[test]
fn a_plane_s_normal_twice_as_long_is_lit_twice_as_brightly() {
    // And starts its rays twice as far off: 0.2 x 2 x 1000 / (4 pi^2 4.998^2)
    assert_seen(&format!("{LIGHT}{DIFFUSE}object {{ shader s type plane p 0 0 0 n 0 0 2 }}"), 0.405_609);
}

#[test]
fn a_highlight_is_normalised() {
    // Light, viewer and normal are one line: 0.1 (6 + 2) / (2 pi) x 1000 / (4 pi 4.999^2)
    let phong = "shader { name s type phong diff 0 0 0 spec 0.1 0.1 0.1 6 samples 0 }";
    assert_seen(&format!("{LIGHT}{phong}{FLOOR}"), 0.405_447);
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

/// What is [`seen`], in red.
fn red(scene: &str) -> f32 {
    seen(scene).r
}

#[test]
fn light_falls_on_a_point_a_thousandth_above_the_surface() {
    // The light stands 0.1 above the floor, so 0.099 above that point: 0.2 x 0.01 / (4 pi^2 0.099^2). Above the floor itself: 2 % less.
    let light = "light { type point color 1 1 1 power 0.01 p 0 0 0.1 }";
    assert_seen(&format!("{light}{DIFFUSE}{FLOOR}"), 0.005_169);
}

#[test]
fn what_is_nearer_than_a_thousandth_casts_no_shadow() {
    // A leaf between the floor and its low light, 0.04 wide: at half a thousandth it lies below the start of the shadow ray, though the way
    // from the floor itself would meet it, 5 / 0.1 x 0.0005 aside; at two thousandths it is met, 5 / 0.099 x 0.001 aside.
    let light = "light { type point color 1 1 1 power 1000 p 5 0 0.1 }";
    let with = |height: f32, aside: f32| {
        let (left, right) = (aside - 0.01, aside + 0.03);
        seen(&format!(
            "{light}{DIFFUSE}{FLOOR} object {{ shader s type generic-mesh points 3 {left} -9 {height} {right} 0 {height} {left} 9 {height}
             triangles 1 0 1 2 normals none uvs none }}"
        ))
    };
    let without = seen(&format!("{light}{DIFFUSE}{FLOOR}"));
    assert_ne!(without, Color::BLACK);
    assert_eq!(with(0.0005, 0.025), without);
    assert_eq!(with(0.002, 0.0505), Color::BLACK);
}

#[test]
fn a_refracted_ray_starts_a_thousandth_below_and_so_misses_a_thinner_pane() {
    // Two panes of glass 0.0015 apart, over a wall of 0.5: the first is entered, and left again at the second: 0.96 twice. Half a thousandth apart, the
    // second is behind the refracted ray's start.
    let panes = |apart: f32| {
        format!(
            "shader {{ name g type glass eta 1.5 color 1 1 1 }} shader {{ name w type constant color 0.5 0.5 0.5 }}
             object {{ shader g type plane p 0 0 2 n 0 0 1 }} object {{ shader g type plane p 0 0 {} n 0 0 -1 }}
             object {{ shader w type plane p 0 0 0 n 0 0 1 }}",
            2.0 - apart
        )
    };
    assert_seen(&panes(0.0015), 0.5 * 0.96 * 0.96);
    assert_seen(&panes(0.0005), 0.5 * 0.96);
}

#[test]
fn a_plane_s_normal_is_as_long_as_its_transform_leaves_it() {
    // Twice as large, the inverse transpose halves it; by three points it is 1 before.
    let floor = |transform: &str, plane: &str| {
        red(&format!("{LIGHT}{DIFFUSE}object {{ shader s transform {{ {transform} }} type plane {plane} }}"))
    };
    let plain = red(&format!("{LIGHT}{DIFFUSE}{FLOOR}"));
    let near = |found: f32, expected: f32| assert!((found / expected - 1.0).abs() < 1e-3, "{found}, not {expected}");
    near(floor("scaleu 2", "p 0 0 0 n 0 0 1"), 0.5 * plain);
    near(floor("scaleu 2", "p 0 0 0 n 0 0 3"), 1.5 * plain);
    near(floor("scale 1 1 0.5", "p 0 0 0 p 7 0 0 p 0 7 0"), 2.0 * plain);
    near(floor("rotatez 30", "p 0 0 0 n 0 0 1"), plain);
}

#[test]
fn a_long_normal_turns_mirrored_rays_too_far() {
    // Seen at 45 degrees (cosine c = 0.7071) with a normal of length 0.5, d = (s, 0, -s): 2 (0.5 c) 0.5 z + d = (s, 0, -0.5 s), still downwards,
    // where a unit normal would send it up to the wall on the right. What is below is black.
    let scene = |length: f32| {
        format!(
            "shader {{ name m type mirror refl 1 1 1 }} shader {{ name w type constant color 0.5 0.5 0.5 }}
             object {{ shader m type plane p 0 0 0 n 0 0 {length} }}
             object {{ shader w type generic-mesh points 3 5 -90 0 5 90 0 5 0 90 triangles 1 0 1 2 normals none uvs none }}"
        )
    };
    let camera = "camera { type pinhole eye -5 0 5 target 0 0 0 up 0 0 1 fov 1 aspect 1 }";
    assert_grey(seen_by(camera, &scene(1.0)), 0.5);
    assert_eq!(seen_by(camera, &scene(0.5)), Color::BLACK);
}

#[test]
fn shiny_is_matt_under_a_mirror_of_its_own_colour() {
    // The eye looks straight down at a diffuse 0.4 with refl 0.5, beneath a ceiling of constant 0.25 that the light is below: the mirror's c is
    // 0.4 x 0.5 = 0.2, at cosine 1. The matt part is 0.4 x 100 / (4 pi^2 4.999^2): the point is a thousandth above the floor.
    let shiny = "shader { name s type shiny diff 0.4 0.4 0.4 refl 0.5 }";
    let ceiling =
        "shader { name c type constant color 0.25 0.25 0.25 } object { shader c type plane p 0 0 6 n 0 0 -1 }";
    let light = "light { type point color 1 1 1 power 100 p 0 0 5 }";
    assert_seen(&format!("{light}{shiny}{ceiling}{FLOOR}"), 0.040_545 + 0.2 * 0.25);
    // Its texture is the mirror's colour, too: without light, white mirrors all of refl.
    let bright = shiny.replace("0.4 0.4 0.4", "1 1 1");
    assert_seen(&format!("{bright}{ceiling}{FLOOR}"), 0.5 * 0.25);
}

#[test]
fn longer_corner_normals_count_for_more() {
    // The floor's triangle is seen where its corners' weights are 1/2, 1/4, 1/4. Their normals: a z of length 1, and twice an x of length 3.
    // Their mean is (1.5, 0, 0.5), of length 1.58114: the cosine to the light above is 0.316228; all of length 1 would give 0.707107.
    let triangle = |transform: &str| {
        red(&format!(
            "{LIGHT}{DIFFUSE}object {{ shader s {transform} type generic-mesh points 3 0 -1 0 1 1 0 -1 1 0 triangles 1 0 1 2
             normals vertex 0 0 1 3 0 0 3 0 0 uvs none }}"
        ))
    };
    let expected = 0.202_723 * 0.316_228;
    for transform in ["", "transform { scaleu 1.5 }"] {
        let found = triangle(transform);
        assert!((found / expected - 1.0).abs() < 1e-4, "{found}, not {expected}");
    }
}

#[test]
fn what_has_no_shader_is_black() {
    let light = "light { type point color 1 1 1 power 1000 p 0 0 5 } background { color 1 1 1 }";
    let text = format!(
        "image {{ resolution 1 1 }} camera {{ type pinhole eye 0 0 5 target 0 0 0 up 0 1 0 fov 1 aspect 1 }} {light} {FLOOR}"
    );
    let Rendering { files, lighting, .. } = Rendering::of("");
    let parsed = scene_format::parse("test.sc", &text, &files);
    let modules = Modules::default().lit_as_by_sunflow();
    let Ok(Assembled { scene, settings, .. }) = render::assemble(&parsed.scene, &modules, &lighting, &files) else {
        panic!("a shader that is not there is no error")
    };
    let film = render::render(&scene, &settings, &|_| std::ops::ControlFlow::Continue(())).unwrap();
    assert_eq!(film.pixels, [Color::BLACK]);
}
