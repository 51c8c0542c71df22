//! Sections 2.2 and 3.2: what casts a shadow.
//!
//! A floor at z = 0, a light at (0, 0, 5) of power 20, and something on the axis between or around them; the ray looks at the origin
//! from the side. Lit, the origin shows 1 - 5 / 20 = 0.75.

use super::{assert_close, constant, lit};

const SHADERS: &str = "shader { name glass type glass eta 1.5 color 1 1 1 }
    shader { name mirror type mirror refl 1 1 1 }
    shader { name phong type phong diff 1 1 1 spec 1 1 1 10 samples 0 }\n";

fn origin_with(object: &str) -> shading::Color {
    let floor = constant("constant", "1 1 1") + SHADERS + "object { shader constant type plane p 0 0 0 n 0 0 1 }\n";
    let light = "light { type point color 1 1 1 power 20 p 0 0 5 }\n";
    lit([0.0, -4.0, 1.0], [0.0, 0.0, 0.0], &(floor + light + object))
}

#[test]
fn what_is_opaque_casts_a_shadow() {
    for shader in ["constant", "phong", "mirror"] {
        let shadow = origin_with(&format!("object {{ shader {shader} type sphere c 0 0 3 r 0.5 }}"));
        assert_close(shadow, [0.0; 3], 0.0);
    }
}

#[test]
fn every_shape_casts_a_shadow() {
    for shape in [
        "type sphere c 0 0 3 r 0.5",
        "transform { scale 0.5 1 0.2 translate 0 0 3 } type sphere",
        "transform { translate 0 0 3 } type box",
        "type generic-mesh points 3  -1 -1 3  1 -1 3  0 2 3  triangles 1  0 1 2  normals none uvs none",
        "type plane p 0 0 3 n 0 0 1",
    ] {
        assert_close(origin_with(&format!("object {{ shader constant {shape} }}")), [0.0; 3], 0.0);
    }
}

#[test]
fn what_stands_beside_the_light_s_way_casts_none() {
    assert_close(origin_with("object { shader constant type sphere c 1 0 3 r 0.5 }"), [0.75; 3], 1e-6);
}

#[test]
fn what_stands_behind_the_light_casts_none() {
    assert_close(origin_with("object { shader constant type sphere c 0 0 7 r 0.5 }"), [0.75; 3], 1e-6);
    assert_close(origin_with("object { shader constant type plane p 0 0 7 n 0 0 1 }"), [0.75; 3], 1e-6);
}

#[test]
fn what_stands_behind_the_surface_casts_none() {
    assert_close(origin_with("object { shader constant type sphere c 0 0 -3 r 0.5 }"), [0.75; 3], 1e-6);
}

#[test]
fn glass_casts_none() {
    assert_close(origin_with("object { shader glass type sphere c 0 0 3 r 0.5 }"), [0.75; 3], 1e-6);
    assert_close(origin_with("object { shader glass type plane p 0 0 3 n 0 0 1 }"), [0.75; 3], 1e-6);
}

#[test]
fn what_stands_behind_glass_still_casts_one() {
    let both =
        "object { shader glass type sphere c 0 0 2 r 0.5 } object { shader constant type sphere c 0 0 3.5 r 0.5 }";
    assert_close(origin_with(both), [0.0; 3], 0.0);
}

#[test]
fn a_body_shades_its_own_far_side() {
    // The south pole of a sphere below the light.
    let scene = constant("white", "1 1 1")
        + "object { shader white type sphere c 0 0 0 r 1 } light { type point color 1 1 1 power 20 p 0 0 5 }";
    assert_close(lit([0.0, -1.0, -4.0], [0.0, 0.0, -1.0], &scene), [0.0; 3], 0.0);
    // At the north pole d = 4: 1 - 4 / 20.
    assert_close(lit([0.0, -1.0, 4.0], [0.0, 0.0, 1.0], &scene), [0.8; 3], 1e-6);
}
