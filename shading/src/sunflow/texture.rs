use std::sync::LazyLock;

use glam::Vec2;

use crate::{Color, ImageTexture, Texture, srgb};

/// An 8-bit picture as Sunflow looks it up: flat at each texel and steep between two.
#[derive(Clone, Debug, PartialEq)]
pub struct SmoothTexture {
    /// Its texels.
    pub picture: ImageTexture,
}

impl Texture for SmoothTexture {
    /// The first and last texels' centres lie at 0 and 1, so one texel's width is lost where the texture repeats. Between two
    /// centres, the share of the second at t is `t^2 (3 - 2 t)`.
    fn color(&self, uv: &dyn Fn() -> Vec2) -> Color {
        let uv = uv();
        let [width, height] = self.picture.size();
        let (left, right, fx) = neighbours(uv.x, width);
        let (bottom, top, fy) = neighbours(uv.y, height);
        let linear = linear_bytes();
        // Rows are held from the top.
        let row = |from_bottom: usize| {
            let bytes = |column| self.picture.texel_bytes(column, height - 1 - from_bottom);
            let texel = |column| bytes(column).map(|byte| linear[usize::from(byte)]).into();
            mix(texel(left), texel(right), fx)
        };
        mix(row(bottom), row(top), fy)
    }
}

fn mix(a: Color, b: Color, share: f32) -> Color {
    a * (1.0 - share) + b * share
}

/// A texel's channel in linear light, for all bytes, rounded to 8 bits once more: Sunflow keeps it so, and loses the darkest tones.
fn linear_bytes() -> &'static [f32; 256] {
    static LINEAR: LazyLock<[f32; 256]> =
        LazyLock::new(|| srgb::linear_bytes().map(|linear| (linear * 255.0).round() / 255.0));
    &LINEAR
}

/// The two texels whose centres lie around a coordinate, and the second one's share. NaN counts as 0.
fn neighbours(coordinate: f32, count: usize) -> (usize, usize, f32) {
    let place = (coordinate - coordinate.floor()) * (count - 1) as f32;
    // A processor has an instruction for 32 bits either way.
    let first = place as i32;
    let t = if place.is_nan() { 0.0 } else { place - first as f32 };
    let first = first as usize;
    (first, if first + 1 < count { first + 1 } else { 0 }, t * t * (3.0 - 2.0 * t))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Black and white above, red and blue below.
    fn at(u: f32, v: f32) -> [f32; 3] {
        let texels = vec![[0, 0, 0], [255, 255, 255], [255, 0, 0], [0, 0, 255]];
        let picture = ImageTexture::new(2, 2, texels).unwrap();
        SmoothTexture { picture }.color(&|| Vec2::new(u, v)).to_array()
    }

    #[test]
    fn corners_show_the_corner_texels_and_v_zero_is_the_bottom() {
        assert_eq!(at(0.0, 0.0), [1.0, 0.0, 0.0]);
        assert_eq!(at(0.999_999_9, 0.0)[2], 1.0);
        assert_eq!(at(0.0, 0.999_999_9), [0.0, 0.0, 0.0]);
    }

    #[test]
    fn between_texels_the_change_is_smooth() {
        // 0.25^2 (3 - 0.5) = 0.15625
        assert_eq!(at(0.25, 0.0), [0.843_75, 0.0, 0.156_25]);
        assert_eq!(at(0.5, 0.5), [0.5, 0.25, 0.5]);
        assert_eq!(at(-1.75, 3.0), at(0.25, 0.0), "it repeats");
    }

    #[test]
    fn dark_tones_are_rounded_to_eight_bits_of_linear_light() {
        assert_eq!(
            [0, 6, 7, 17, 18].map(|byte: usize| linear_bytes()[byte]),
            [0.0, 0.0, 1.0 / 255.0, 1.0 / 255.0, 2.0 / 255.0]
        );
    }

    #[test]
    fn what_is_not_a_number_has_a_colour_too() {
        for odd in [f32::NAN, f32::INFINITY, 1e30] {
            assert!(at(odd, odd).iter().all(|channel| (0.0..=1.0).contains(channel)));
        }
    }
}
