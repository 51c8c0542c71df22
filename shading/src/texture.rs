use glam::Vec2;

use crate::{Color, srgb};

/// A colour for each place of a surface.
pub trait Texture: Send + Sync {
    /// The colour at the texture coordinates, which are computed only if the texture asks. `v = 0` is the bottom; outside 0..1
    /// the texture repeats.
    fn color(&self, uv: &dyn Fn() -> Vec2) -> Color;
}

/// One colour everywhere: never asks where.
impl Texture for Color {
    fn color(&self, _uv: &dyn Fn() -> Vec2) -> Color {
        *self
    }
}

/// An 8-bit sRGB picture, mixed bilinearly in linear light, repeated without a seam.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageTexture {
    width: usize,
    height: usize,
    /// Row by row from the top, as files hold them.
    texels: Vec<[u8; 3]>,
}

impl ImageTexture {
    /// A picture from its texels, row by row from the top; `None` if they are not `width * height`, or none.
    pub fn new(width: usize, height: usize, texels: Vec<[u8; 3]>) -> Option<Self> {
        (!texels.is_empty() && width.checked_mul(height) == Some(texels.len())).then_some(Self {
            width,
            height,
            texels,
        })
    }

    /// The memory that the texels take.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.texels[..])
    }

    /// The width and height in texels, each at least 1.
    pub fn size(&self) -> [usize; 2] {
        [self.width, self.height]
    }

    /// A texel as the file has it, 8-bit sRGB; columns count from the left, rows from the top.
    ///
    /// # Panics
    /// If there is no such column or row.
    pub fn texel_bytes(&self, column: usize, row: usize) -> [u8; 3] {
        self.texels[row * self.width + column]
    }
}

impl Texture for ImageTexture {
    /// The mean of the four nearest texels' centres, by distance:
    ///
    /// ```text
    ///   +---+---+     a texel's centre is at (i + 0.5) / width
    ///   | a | b |     uv between four centres: (1-fx)(1-fy) a + fx (1-fy) b + (1-fx) fy c + fx fy d
    ///   +---+---+
    ///   | c | d |
    ///   +---+---+
    /// ```
    fn color(&self, uv: &dyn Fn() -> Vec2) -> Color {
        let uv = uv();
        let (left, right, fx) = neighbours(uv.x, self.width);
        let (top, bottom, fy) = neighbours(1.0 - uv.y, self.height);
        let linear = srgb::linear_bytes();
        let texel = |column, row| Color::from(self.texel_bytes(column, row).map(|byte| linear[usize::from(byte)]));
        let upper = texel(left, top) * (1.0 - fx) + texel(right, top) * fx;
        let lower = texel(left, bottom) * (1.0 - fx) + texel(right, bottom) * fx;
        upper * (1.0 - fy) + lower * fy
    }
}

/// The two texels whose centres lie around a coordinate, and the second one's share. NaN counts as 0.
fn neighbours(coordinate: f32, count: usize) -> (usize, usize, f32) {
    let place = (coordinate - coordinate.floor()) * count as f32 - 0.5;
    let first = place.floor();
    // From -1 to `count`: one step is enough, and cheaper than a division.
    let wrap = |index: isize| match index {
        ..0 => count - 1,
        _ if index as usize >= count => 0,
        _ => index as usize,
    };
    (wrap(first as isize), wrap(first as isize + 1), if place.is_nan() { 0.0 } else { place - first })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Black and white above, red and blue below.
    fn four() -> ImageTexture {
        ImageTexture::new(2, 2, vec![[0, 0, 0], [255, 255, 255], [255, 0, 0], [0, 0, 255]]).unwrap()
    }

    fn at(u: f32, v: f32) -> [f32; 3] {
        four().color(&|| Vec2::new(u, v)).to_array()
    }

    #[test]
    fn v_zero_is_the_bottom_and_u_runs_to_the_right() {
        assert_eq!(at(0.25, 0.25), [1.0, 0.0, 0.0]);
        assert_eq!(at(0.75, 0.25), [0.0, 0.0, 1.0]);
        assert_eq!(at(0.25, 0.75), [0.0, 0.0, 0.0]);
        assert_eq!(at(0.75, 0.75), [1.0, 1.0, 1.0]);
    }

    #[test]
    fn between_centres_texels_mix_in_linear_light() {
        assert_eq!(at(0.5, 0.75), [0.5, 0.5, 0.5]);
        assert_eq!(at(0.5, 0.5), [0.5, 0.25, 0.5]);
    }

    #[test]
    fn the_texture_repeats_without_a_seam() {
        assert_eq!(at(1.25, -0.75), at(0.25, 0.25));
        assert_eq!(at(0.0, 0.75), at(1.0, 0.75));
        assert_eq!(at(0.0, 0.75), [0.5, 0.5, 0.5]);
    }

    #[test]
    fn what_is_not_a_number_has_a_colour_too() {
        for odd in [f32::NAN, f32::INFINITY, 1e30] {
            assert!(at(odd, odd).iter().all(|channel| (0.0..=1.0).contains(channel)));
        }
    }

    #[test]
    fn a_texel_takes_three_bytes() {
        assert_eq!(four().bytes(), 12);
    }

    #[test]
    fn texels_must_fill_the_picture() {
        assert_eq!(ImageTexture::new(2, 2, vec![[0; 3]; 3]), None);
        assert_eq!(ImageTexture::new(0, 0, Vec::new()), None);
    }
}
