use super::mesh::short;
use std::fmt::Write;

/// The 64 places of a 4 x 4 x 4 grid spaced 1.5 around the origin, with each place's steps along the axes, 0..=3.
fn grid() -> impl Iterator<Item = ([u32; 3], [f64; 3])> {
    (0..64).map(|i| [i / 16, i / 4 % 4, i % 4]).map(|steps| (steps, steps.map(|step| 1.5 * f64::from(step) - 2.25)))
}

/// 64 spheres of radius 0.5, coloured by their place: red along x, green along y, blue along z.
pub(super) fn spheres() -> String {
    let mut text = include_str!("../../scenes/spheres64.sc").to_owned();
    for ([i, j, k], center) in grid() {
        let [red, green, blue] = [i, j, k].map(|step| short(0.15 + 0.8 * f64::from(step) / 3.0, 3));
        let [x, y, z] = center.map(|c| short(c, 2));
        let _ = write!(
            text,
            "\nshader {{\n  name color{i}{j}{k}\n  type phong\n  diff {{ \"sRGB nonlinear\" {red} {green} {blue} }}\n  \
             spec {{ \"sRGB nonlinear\" 0.5 0.5 0.5 }} 40\n  samples 0\n}}\nobject {{\n  shader color{i}{j}{k}\n  type \
             sphere\n  name sphere{i}{j}{k}\n  c {x} {y} {z}\n  r 0.5\n}}\n"
        );
    }
    text
}

/// The globes, without lights.
pub(super) fn worlds_dark() -> String {
    format!("{}{}", include_str!("../../scenes/worlds-dark.sc"), worlds())
}

/// The globes under three lights.
pub(super) fn worlds_lit() -> String {
    format!("{}{}", include_str!("../../scenes/worlds.sc"), worlds())
}

/// Camera, shader and 64 globes of radius 0.6 with slanted axes, each turned to another side.
fn worlds() -> String {
    let mut text = include_str!("../../scenes/worlds-common.sc").to_owned();
    for ([i, j, k], center) in grid() {
        let turn = (i * 37 + j * 101 + k * 67) % 360;
        let [x, y, z] = center.map(|c| short(c, 2));
        let _ = write!(
            text,
            "\nobject {{\n  shader globe\n  transform {{\n    scale 0.6 0.6 -0.6\n    rotatez {turn}\n    rotatey 23\n    \
             translate {x} {y} {z}\n  }}\n  type sphere\n  name world{i}{j}{k}\n}}\n"
        );
    }
    text
}
