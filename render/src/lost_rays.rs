use shading::Color;

use crate::Crop;

/// More light than this would overflow in the sum over a pixel's rays, which are counted in 32 bits.
const BRIGHTEST: f32 = f32::MAX / (1_u64 << 32) as f32;

/// The camera rays whose light cannot be shown: NaN, infinite, or beyond 7.9e28 in a channel. They count as black, so that one of them does
/// not take its pixel's others with it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LostRays {
    /// How many; with a crop also those beside it that adaptive rendering traces.
    pub count: u64,
    /// Their pixels, `[x, y]` in the whole picture, each once, row by row.
    pub pixels: Vec<[u32; 2]>,
}

impl LostRays {
    /// A ray's light as it enters its pixel. What cannot be shown is noted, and black.
    #[inline]
    pub(crate) fn checked(&mut self, color: Color, pixel: impl FnOnce() -> [u32; 2]) -> Color {
        let [r, g, b] = color.to_array().map(f32::abs);
        // Also false for NaN. Not &&: the comparisons are cheaper than branches on them.
        if (r <= BRIGHTEST) & (g <= BRIGHTEST) & (b <= BRIGHTEST) {
            return color;
        }
        self.lose(pixel())
    }

    #[cold]
    fn lose(&mut self, pixel: [u32; 2]) -> Color {
        self.count += 1;
        if self.pixels.last() != Some(&pixel) {
            self.pixels.push(pixel);
        }
        Color::BLACK
    }

    /// Those of both.
    pub fn append(&mut self, other: Self) {
        self.count += other.count;
        self.pixels.extend(other.pixels);
    }

    /// In order, whatever order they were rendered in, without the pixels outside a window.
    #[must_use]
    pub fn in_window(mut self, window: Crop) -> Self {
        self.pixels.retain(|&pixel| window.contains(pixel));
        self.pixels.sort_unstable_by_key(|&[x, y]| [y, x]);
        self.pixels.dedup();
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_that_can_be_added_up_passes_and_all_else_is_black() {
        let mut lost = LostRays::default();
        for fine in [0.0, -1.0, 1e28, -1e28, f32::MIN_POSITIVE] {
            assert_eq!(lost.checked(Color::new(0.5, fine, 0.5), || [3, 4]), Color::new(0.5, fine, 0.5));
        }
        assert_eq!(lost, LostRays::default());
        for odd in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e29, -1e29] {
            assert_eq!(lost.checked(Color::new(0.5, 0.5, odd), || [3, 4]), Color::BLACK);
        }
        assert_eq!(lost, LostRays { count: 5, pixels: vec![[3, 4]] });
    }

    #[test]
    fn pixels_are_told_once_in_order_and_in_the_window() {
        let mut lost = LostRays { count: 3, pixels: vec![[5, 2], [1, 3]] };
        lost.append(LostRays { count: 2, pixels: vec![[7, 2], [5, 2], [9, 9]] });
        let window = Crop { x: 0, y: 0, width: 8, height: 8 };
        assert_eq!(lost.in_window(window), LostRays { count: 5, pixels: vec![[5, 2], [7, 2], [1, 3]] });
    }
}
