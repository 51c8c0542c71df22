//! Section 2.2: the point light and the ambient light.

use render::{Lighting, Modules};
use tests::Rendering;

use super::{assert_close, constant, lit, look, seen};

/// A white floor at z = 0.
fn floor() -> String {
    constant("white", "1 1 1") + "object { shader white type plane p 0 0 0 n 0 0 1 }\n"
}

const FROM_ABOVE: [f64; 3] = [0.0, -1.0, 1.0];
const ORIGIN: [f64; 3] = [0.0, 0.0, 0.0];

#[test]
fn light_falls_off_linearly_with_the_distance() {
    // 1 - 5 / 20 = 0.75, times the light's colour.
    let light = "light { type point color 0.5 0.25 1 power 20 p 0 0 5 }";
    assert_close(lit(FROM_ABOVE, ORIGIN, &(floor() + light)), [0.375, 0.1875, 0.75], 1e-6);
}

#[test]
fn light_ends_at_the_distance_of_its_power() {
    let light = "light { type point color 1 1 1 power 5 p 0 0 5 }";
    assert_close(lit(FROM_ABOVE, ORIGIN, &(floor() + light)), [0.0; 3], 0.0);
}

#[test]
fn slanting_light_is_thinned_by_the_cosine() {
    // From (3, 0, 4): d = 5, n.l = 4 / 5: 0.75 x 0.8.
    let light = "light { type point color 1 1 1 power 20 p 3 0 4 }";
    assert_close(lit(FROM_ABOVE, ORIGIN, &(floor() + light)), [0.6; 3], 1e-6);
}

#[test]
fn lights_add_up() {
    // 0.75 in red, and 1 - 10 / 20 = 0.5 in green.
    let lights = "light { type point color 1 0 0 power 20 p 0 0 5 } light { type point color 0 1 0 power 20 p 0 0 10 }";
    assert_close(lit(FROM_ABOVE, ORIGIN, &(floor() + lights)), [0.75, 0.5, 0.0], 1e-6);
}

#[test]
fn a_light_below_the_floor_does_not_light_it() {
    let light = "light { type point color 1 1 1 power 20 p 0 0 -5 }";
    assert_close(lit(FROM_ABOVE, ORIGIN, &(floor() + light)), [0.0; 3], 0.0);
}

#[test]
fn the_reports_first_falloff_is_logarithmic() {
    // P / (ln(d + 1) + 1) at d = e - 1: 2 / 2 = 1.
    let text = look(FROM_ABOVE, ORIGIN) + &floor() + "light { type point color 1 0.5 0.25 power 2 p 0 0 1.718281828 }";
    let modules = Modules { falloff: shading::logarithmic_falloff, ..Modules::default() };
    assert_close(seen(&Rendering { modules, ..Rendering::of(text) }), [1.0, 0.5, 0.25], 1e-6);
}

#[test]
fn without_lights_a_twentieth_of_the_linear_colour_shows() {
    let scene = constant("paint", "0.4 0.8 1") + "object { shader paint type plane p 0 0 0 n 0 0 1 }";
    assert_close(lit(FROM_ABOVE, ORIGIN, &scene), [0.02, 0.04, 0.05], 1e-7);
}

#[test]
fn the_share_of_ambient_light_can_be_chosen() {
    let text = look(FROM_ABOVE, ORIGIN) + &floor();
    let lighting = Lighting { ambient: 0.25, ..Lighting::default() };
    assert_close(seen(&Rendering { lighting, ..Rendering::of(text) }), [0.25; 3], 1e-7);
}

#[test]
fn a_light_takes_the_place_of_the_ambient_light_even_where_it_does_not_reach() {
    let light = "light { type point color 1 1 1 power 1 p 0 0 5 }";
    assert_close(lit(FROM_ABOVE, ORIGIN, &(floor() + light)), [0.0; 3], 0.0);
}
