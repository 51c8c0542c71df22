//! Section 2.3.1: the sphere and its texture, turned and stretched by its transform.

use std::f64::consts::PI;

use super::{Triple, assert_close, flat, lit, look, seen, texel, textured};

/// A point of the unit sphere: `theta` from +z, `phi` from +x over +y, in degrees.
fn on_sphere(theta: f64, phi: f64) -> Triple {
    let (theta, phi) = (theta * PI / 180.0, phi * PI / 180.0);
    [theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()]
}

/// What is seen at a point of the unit sphere from straight above it.
fn texture_at(point: Triple, transform: &str) -> shading::Color {
    let camera = look(point.map(|x| 10.0 * x), [0.0; 3]);
    seen(&textured(4, 2, &format!("{camera} object {{ shader textured {transform} type sphere }}")))
}

// The texture has 4 x 2 texels. u = phi / 360 degrees and v = theta / 180 degrees: the middles of the texels lie at phi = 45, 135,
// 225 and 315, the lower row's at theta = 45 and the upper one's at 135.

const NOT_MOVED: &str = "transform { translate 0 0 0 }";

#[test]
fn a_texture_lies_around_the_axis() {
    for (column, row) in (0..4).flat_map(|column| (0..2).map(move |row| (column, row))) {
        let point = on_sphere(45.0 + 90.0 * f64::from(row), 45.0 + 90.0 * f64::from(column));
        assert_close(texture_at(point, NOT_MOVED), texel(column, row), 1e-4);
    }
}

#[test]
fn a_texture_turns_with_the_sphere() {
    // Turned by 90 degrees about z, what was at phi = 45 is at 135.
    for column in 0..4 {
        let point = on_sphere(45.0, 45.0 + 90.0 * f64::from(column));
        assert_close(texture_at(point, "transform { rotatez 90 }"), texel((column + 3) % 4, 0), 1e-4);
    }
    // Turned over about x, phi becomes -phi and theta 180 - theta.
    for column in 0..4 {
        let point = on_sphere(45.0, 45.0 + 90.0 * f64::from(column));
        assert_close(texture_at(point, "transform { rotatex 180 }"), texel(3 - column, 1), 1e-4);
    }
}

#[test]
fn a_sphere_by_centre_and_radius_is_textured_alike() {
    let point = on_sphere(45.0, 135.0);
    let [x, y, z] = [5.0, 6.0, 7.0];
    let camera = look([x + 10.0 * point[0], y + 10.0 * point[1], z + 10.0 * point[2]], [x, y, z]);
    let rendering = textured(4, 2, &format!("{camera} object {{ shader textured type sphere c {x} {y} {z} r 2 }}"));
    assert_close(seen(&rendering), texel(1, 0), 1e-4);
}

#[test]
fn a_sphere_reaches_as_far_as_its_radius() {
    let sphere = super::WHITE.to_owned() + "object { shader white type sphere c 1 2 3 r 2 }";
    // Rays along +y that pass the centre at a distance of 2, give or take a hundredth.
    for (offset, color) in [(1.99, 1.0), (2.01, 0.0)] {
        assert_close(flat([1.0 + offset, -9.0, 3.0], [1.0 + offset, 2.0, 3.0], &sphere), [color; 3], 0.0);
        assert_close(flat([1.0, -9.0, 3.0 - offset], [1.0, 2.0, 3.0 - offset], &sphere), [color; 3], 0.0);
    }
}

#[test]
fn an_unevenly_scaled_sphere_is_an_ellipsoid() {
    let ellipsoid =
        super::WHITE.to_owned() + "object { shader white transform { scale 3 1 2 translate 5 0 0 } type sphere }";
    for (x, z, color) in [(2.99, 0.0, 1.0), (3.01, 0.0, 0.0), (0.0, 1.99, 1.0), (0.0, 2.01, 0.0), (2.5, 1.5, 0.0)] {
        assert_close(flat([5.0 + x, -9.0, z], [5.0 + x, 0.0, z], &ellipsoid), [color; 3], 0.0);
    }
}

#[test]
fn an_ellipsoid_s_normals_go_through_the_inverse_transpose() {
    // Stretched by 2 along x, the point at 45 degrees is (2, 1, 0) / sqrt(2), and its normal (1/2, 1, 0) made unit: (1, 2, 0) /
    // sqrt(5). A light 5 units along that normal, of power 10: n.l = 1, 1 - 5 / 10. The transform itself would give n.l = 4/5.
    let (point, normal) = ([2.0 / 2f64.sqrt(), 1.0 / 2f64.sqrt(), 0.0], [1.0 / 5f64.sqrt(), 2.0 / 5f64.sqrt(), 0.0]);
    let [x, y, z] = std::array::from_fn(|axis| point[axis] + 5.0 * normal[axis]);
    let scene = super::WHITE.to_owned()
        + "object { shader white transform { scale 2 1 1 } type sphere }"
        + &format!("light {{ type point color 1 1 1 power 10 p {x} {y} {z} }}");
    assert_close(lit([x, y, z], point, &scene), [0.5; 3], 1e-5);
}

#[test]
fn an_ellipsoid_s_texture_is_stretched_with_it() {
    // theta = 45, phi = 45 of the unit sphere: texel (0, 0) at twice the x.
    let [x, y, z] = on_sphere(45.0, 45.0);
    let camera = look([2.0 * x + 3.0, y + 3.0, z + 4.0], [2.0 * x, y, z]);
    let rendering = textured(4, 2, &(camera + "object { shader textured transform { scale 2 1 1 } type sphere }"));
    assert_close(seen(&rendering), texel(0, 0), 1e-4);
}
