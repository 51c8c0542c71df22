//! Sections 3.3.1 and 3.3.2: constant and phong.
//!
//! A floor at z = 0 under a light at (0, 0, 5) of power 20: at the origin E = 1 - 5 / 20 = 0.75 and l = (0, 0, 1).

use super::{Triple, assert_close, lit};

/// Looked at along v = (0.6, 0, 0.8).
const ASLANT: Triple = [6.0, 0.0, 8.0];

fn origin(eye: Triple, shader: &str, more: &str) -> shading::Color {
    let scene = format!(
        "shader {{ name paint {shader} }} object {{ shader paint type plane p 0 0 0 n 0 0 1 }}
         light {{ type point color 1 0.5 1 power 20 p 0 0 5 }} {more}"
    );
    lit(eye, [0.0; 3], &scene)
}

#[test]
fn constant_is_lit_like_a_matt_surface() {
    assert_close(origin(ASLANT, "type constant color 0.8 0.4 0.2", ""), [0.6, 0.15, 0.15], 1e-6);
    let matt = origin(ASLANT, "type phong diff 0.8 0.4 0.2 spec 0 0 0 10 samples 0", "");
    assert_eq!(origin(ASLANT, "type constant color 0.8 0.4 0.2", ""), matt);
}

#[test]
fn constant_has_no_highlight() {
    // Looked at along the mirrored light, it is no brighter.
    assert_close(origin([0.0, 0.0, 9.0], "type constant color 0.8 0.4 0.2", ""), [0.6, 0.15, 0.15], 1e-6);
}

#[test]
fn constant_is_shadowed() {
    let sphere = "object { shader paint type sphere c 0 0 3 r 0.5 }";
    assert_close(origin(ASLANT, "type constant color 0.8 0.4 0.2", sphere), [0.0; 3], 0.0);
}

#[test]
fn phong_adds_a_highlight_around_the_mirrored_light() {
    // r = (0, 0, 1), r.v = 0.8, 0.8^10 = 0.107374.
    let phong = "type phong diff 0.8 0.4 0.2 spec 0.5 0.5 1 10 samples 0";
    let highlight = 0.75 * 0.107_374;
    let expected = [0.6 + 0.5 * highlight, 0.15 + 0.25 * highlight, 0.15 + highlight];
    assert_close(origin(ASLANT, phong, ""), expected, 1e-6);
    // Along r itself r.v = 1, whatever the exponent.
    assert_close(origin([0.0, 0.0, 4.0], phong, ""), [0.6 + 0.375, 0.15 + 0.1875, 0.15 + 0.75], 1e-6);
}

#[test]
fn a_larger_exponent_makes_the_highlight_narrower() {
    // 0.8^2.5 = 0.572433
    let phong = |exponent: &str| format!("type phong diff 0 0 0 spec 1 1 1 {exponent} samples 0");
    assert_close(origin(ASLANT, &phong("2.5"), ""), [0.75 * 0.572_433, 0.375 * 0.572_433, 0.75 * 0.572_433], 1e-6);
    // 0.8^1000 = 1e-97
    assert_close(origin(ASLANT, &phong("1000"), ""), [0.0; 3], 1e-9);
}

#[test]
fn there_is_no_highlight_in_a_shadow() {
    let phong = "type phong diff 0.8 0.4 0.2 spec 1 1 1 10 samples 0";
    assert_close(origin(ASLANT, phong, "object { shader paint type sphere c 0 0 3 r 0.5 }"), [0.0; 3], 0.0);
}

#[test]
fn a_surface_is_lit_on_the_viewer_s_side() {
    // From below the floor its lower side is seen, which the light above does not reach.
    let constant = "type constant color 1 1 1";
    assert_close(origin([6.0, 0.0, -8.0], constant, ""), [0.0; 3], 0.0);
    let below = "light { type point color 1 1 1 power 20 p 0 0 -5 }";
    assert_close(origin([6.0, 0.0, -8.0], constant, below), [0.75; 3], 1e-6);
}

#[test]
fn diffuse_is_phong_without_a_highlight() {
    let phong = origin(ASLANT, "type phong diff 0.8 0.4 0.2 spec 0 0 0 10 samples 0", "");
    assert_eq!(origin(ASLANT, "type diffuse diff 0.8 0.4 0.2", ""), phong);
}
