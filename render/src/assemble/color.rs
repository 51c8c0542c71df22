use scene_format::scene_file;
use shading::{Color, srgb};

use super::spectrum;

/// A colour of a scene file as linear sRGB.
pub(super) fn linear(color: &scene_file::Color) -> Color {
    match *color {
        scene_file::Color::Bare(rgb) | scene_file::Color::SrgbLinear(rgb) => rgb.into(),
        scene_file::Color::SrgbNonlinear(rgb) => rgb.map(srgb::decode).into(),
        scene_file::Color::Xyz(xyz) => from_xyz(xyz),
        scene_file::Color::Blackbody(kelvin) => from_xyz(spectrum::blackbody(kelvin)),
        scene_file::Color::Spectrum { range, ref values } => from_xyz(spectrum::sampled(range, values)),
    }
}

/// CIE XYZ to linear sRGB, white point D65 (IEC 61966-2-1).
fn from_xyz([x, y, z]: [f32; 3]) -> Color {
    Color::new(
        3.240_454_2 * x - 1.537_138_5 * y - 0.498_531_4 * z,
        -0.969_266 * x + 1.876_010_8 * y + 0.041_556 * z,
        0.055_643_4 * x - 0.204_025_9 * y + 1.057_225_2 * z,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_space_has_its_meaning() {
        let half = [0.5, 2.0, 0.0];
        assert_eq!(linear(&scene_file::Color::Bare(half)), Color::from(half));
        assert_eq!(linear(&scene_file::Color::SrgbLinear(half)), Color::from(half));
        let encoded = linear(&scene_file::Color::SrgbNonlinear(half));
        assert!((encoded.r - 0.214_041_14).abs() < 1e-7);
        assert_eq!((encoded.g, encoded.b), (1.0, 0.0), "clamped before decoding");
    }

    #[test]
    fn the_white_of_d65_is_white() {
        let white = linear(&scene_file::Color::Xyz([0.950_47, 1.0, 1.088_83]));
        assert!(white.to_array().iter().all(|channel| (channel - 1.0).abs() < 1e-4), "{white:?}");
    }
}
