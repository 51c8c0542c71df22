//! Sunflow's shaders on a little stage, where the answer is known by hand.

use std::f32::consts::PI;
use std::sync::Arc;

use geometry::Surface;
use glam::{Vec2, Vec3};
use shading::conformance::{Lamp, Stage};
use shading::sunflow::{Constant, Glass, LongNormal, Mirror, Phong, Shiny};
use shading::{Absorption, Bounces, Color, LightFormula, Phong as ReportPhong, Shader};

/// A floor seen along a unit direction; from below it is the inside.
pub(crate) fn floor(direction: Vec3) -> Stage {
    Stage {
        direction,
        distance: 2.0,
        surface: Surface::rounded(Vec3::ZERO, 0.0, Vec3::Z),
        uv: Vec2::ZERO,
        bounces: Bounces::of_camera_ray(1, 1),
        lamps: [None, None],
        blocker: None,
        ambient: 0.0,
    }
}

/// Seen aslant, where each coordinate may be off by an eighth.
fn rough_floor() -> Stage {
    let stage = floor(Vec3::new(0.6, 0.0, -0.8));
    Stage { surface: Surface { error: Vec3::splat(0.125), ..stage.surface }, ..stage }
}

/// From the origin, 60 degrees away from the floor's normal.
fn aslant() -> Vec3 {
    Vec3::new(0.75_f32.sqrt(), 0.0, 0.5)
}

const GLASS: Glass = Glass { eta: 1.5, color: Color::WHITE, absorption: None };

/// Bright above and black below: what glass reflects of it, seen from above, or lets through, seen from below.
fn bright_above(direction: Vec3) -> Color {
    Color::grey(if direction.z > 0.0 { 1.0 } else { 0.0 })
}

/// The other way around.
fn bright_below(direction: Vec3) -> Color {
    bright_above(-direction)
}

#[track_caller]
fn assert_shows(stage: &Stage, shader: &dyn Shader, expected: f32) {
    let shown = stage.shown_under(bright_above, shader).color.to_array()[0];
    assert!((shown - expected).abs() < 1e-6, "{shown} instead of {expected}");
}

#[test]
fn glass_seen_straight_reflects_four_percent() {
    // ((1 - eta) / (1 + eta))^2
    assert_shows(&floor(-Vec3::Z), &GLASS, 0.04);
    // From inside all but that is let through, and nothing reflected.
    assert_shows(&floor(Vec3::Z), &GLASS, 0.96);
    let below = floor(Vec3::Z).shown_under(bright_below, &GLASS);
    assert_eq!(below.color, Color::BLACK);
}

#[test]
fn at_brewsters_angle_only_light_across_is_reflected() {
    // tan = eta; half of ((eta^2 - 1) / (eta^2 + 1))^2, the other half has nothing to reflect.
    let eta = 1.5_f32;
    let across = (eta * eta - 1.0) / (eta * eta + 1.0);
    assert_shows(&floor(Vec3::new(eta, 0.0, -1.0).normalize()), &GLASS, 0.5 * across * across);
}

#[test]
fn at_other_angles_both_are_reflected_as_fresnel_says() {
    // cos 0.6 outside, 0.845905 inside: ((0.6 - 1.268857) / (0.6 + 1.268857))^2 and ((0.9 - 0.845905) / (0.9 + 0.845905))^2
    assert_shows(&floor(Vec3::new(0.8, 0.0, -0.6)), &GLASS, 0.064_525);
}

#[test]
fn glass_refracts_by_snells_law_and_reflects_all_beyond_the_critical_angle() {
    let way = |direction: Vec3| floor(direction).shown(&GLASS).rays[0].0.direction;
    let sine = |direction: Vec3| direction.x;
    let outside = Vec3::new(0.6, 0.0, -0.8);
    assert!((sine(way(outside)) - 0.6 / 1.5).abs() < 1e-6 && way(outside).z < 0.0);
    let inside = Vec3::new(0.4, 0.0, 0.84_f32.sqrt());
    assert!((sine(way(inside)) - 0.6).abs() < 1e-6 && way(inside).z > 0.0);
    let beyond = floor(Vec3::new(0.8, 0.0, 0.6)).shown(&GLASS);
    assert_eq!(beyond.rays.len(), 1);
    assert!((beyond.rays[0].0.direction - Vec3::new(0.8, 0.0, -0.6)).length() < 1e-6);
}

#[test]
fn glass_absorbs_on_the_way_inside_alone() {
    let absorption = Some(Absorption { distance: 2.0, color: Color::grey(0.5) });
    let dark = Glass { absorption, ..GLASS };
    assert_shows(&floor(-Vec3::Z), &dark, 0.04);
    // 2 of 2 units, and half of it lost: exp(-1/2)
    assert_shows(&floor(Vec3::Z), &dark, 0.96 * (-0.5_f32).exp());
}

#[test]
fn a_highlight_of_sunflows_has_its_factor() {
    // Light and viewer straight above: E (specular (n + 2) / (2 pi) + diffuse / pi)
    let lamp = Lamp { position: Vec3::Z, color: Color::WHITE, power: 1.0 };
    let stage = Stage { lamps: [Some(lamp), None], ..floor(-Vec3::Z) };
    let shader = Phong { diffuse: Arc::new(Color::grey(0.25)), specular: Color::grey(0.5), exponent: 6.0 };
    let arriving = lamp.arriving(1.0).to_array()[0];
    let expected = arriving * (0.5 * 8.0 / (2.0 * PI) + 0.25 / PI);
    let shown = stage.shown(&shader).color.to_array()[0];
    assert!((shown - expected).abs() < 1e-6 * expected, "{shown} instead of {expected}");
}

/// What a light at 60 degrees from the normal brings to the floor, and what a shader makes of that.
fn lit_from_the_side(shader: &dyn Shader) -> [f32; 2] {
    let lamp = Lamp { position: aslant(), color: Color::WHITE, power: 1.0 };
    let stage = Stage { lamps: [Some(lamp), None], ..floor(-Vec3::Z) };
    [lamp.arriving(1.0), stage.shown_under(bright_above, shader).color].map(|color| color.to_array()[0])
}

#[test]
fn light_from_the_side_counts_by_its_cosine_and_its_way_from_the_mirrored_one() {
    let shader = Phong { diffuse: Arc::new(Color::grey(0.25)), specular: Color::grey(0.5), exponent: 6.0 };
    let [arriving, shown] = lit_from_the_side(&shader);
    // The cosine is 1/2 for both.
    let expected = 0.5 * arriving * (0.25 / PI + 0.5 * 8.0 / (2.0 * PI) * 0.5_f32.powi(6));
    assert!((shown - expected).abs() < 1e-6, "{shown} instead of {expected}");
}

#[test]
fn a_shiny_surface_is_matt_under_a_mirror_of_its_colour() {
    let shader = Shiny { diffuse: Arc::new(Color::grey(0.25)), reflection: 0.5 };
    let [arriving, shown] = lit_from_the_side(&shader);
    let expected = 0.25 * 0.5 * arriving / PI + 0.125;
    assert!((shown - expected).abs() < 1e-6, "{shown} instead of {expected}");
    // Unlit, and seen at 60 degrees: 0.125 + 0.875 (1 - 1/2)^5
    assert_shows(&floor(aslant().with_z(-0.5)), &shader, 0.125 + 0.875 / 32.0);
    assert_eq!(shader.asks_lights(), Some(LightFormula::Sunflow));
}

#[test]
fn a_mirror_of_sunflows_reflects_more_at_grazing_angles() {
    let mirror = Mirror { reflection: Color::grey(0.25) };
    assert_shows(&floor(-Vec3::Z), &mirror, 0.25);
    assert_shows(&floor(aslant().with_z(-0.5)), &mirror, 0.25 + 0.75 / 32.0);
}

#[test]
fn a_constant_surface_of_sunflows_needs_no_light() {
    assert_shows(&floor(-Vec3::Z), &Constant { color: Color::grey(0.3) }, 0.3);
}

#[test]
fn rays_start_on_the_side_that_they_go_to() {
    let mut starts: Vec<f32> = rough_floor().shown(&GLASS).rays.iter().map(|(ray, _)| ray.origin.z).collect();
    starts.sort_by(f32::total_cmp);
    assert!((starts[0] + 0.125).abs() < 1e-6 && (starts[1] - 0.125).abs() < 1e-6, "{starts:?}");
}

#[test]
fn all_that_is_reflected_inside_has_the_bodys_colour_and_what_absorption_leaves() {
    let absorption = Some(Absorption { distance: 2.0, color: Color::grey(0.5) });
    let dark = Glass { absorption, color: Color::grey(0.25), ..GLASS };
    let shown = floor(Vec3::new(0.8, 0.0, 0.6)).shown_under(bright_below, &dark).color.to_array()[0];
    assert!((shown - 0.25 * (-0.5_f32).exp()).abs() < 1e-6, "{shown}");
}

#[test]
fn a_normal_twice_as_long_lights_twice_as_brightly_and_turns_mirrored_rays_too_far() {
    let long = |shader: Box<dyn Shader>| LongNormal { shader, length: 2.0 };
    let matt = || Phong { diffuse: Arc::new(Color::grey(0.25)), specular: Color::BLACK, exponent: 1.0 };
    assert_eq!(lit_from_the_side(&long(Box::new(matt())))[1], 2.0 * lit_from_the_side(&matt())[1]);
    let shown = rough_floor().shown(&long(Box::new(Mirror { reflection: Color::WHITE })));
    let ray = shown.rays[0].0;
    // 2 (v.n) n - v, with v.n = 1.6; and twice as far off, along a normal twice as long.
    assert!(ray.direction.distance(Vec3::new(0.6, 0.0, 2.0 * 3.2 - 0.8).normalize()) < 1e-6, "{}", ray.direction);
    assert!((ray.origin.z - 4.0 * 0.125).abs() < 1e-6, "{}", ray.origin);
    assert!(long(Box::new(matt())).casts_shadow());
    let clear = shading::Glass { eta: 1.5, color: Color::WHITE, absorption: None };
    assert!(!long(Box::new(clear)).casts_shadow());
}

#[test]
fn matt_surfaces_say_by_which_formula_they_ask() {
    let (diffuse, specular, exponent) = (Arc::new(Color::WHITE), Color::BLACK, 1.0);
    let report = ReportPhong { diffuse: diffuse.clone(), specular, exponent };
    assert_eq!(report.asks_lights(), Some(LightFormula::Report));
    assert_eq!(shading::Constant { color: Color::WHITE }.asks_lights(), Some(LightFormula::Report));
    assert_eq!(Phong { diffuse, specular, exponent }.asks_lights(), Some(LightFormula::Sunflow));
}
