//! How far a picture is from another of the same scene, pixel by pixel, on the 8-bit scale.

use image::{Rgb, RgbImage};

/// How a picture differs from its reference.
pub(crate) struct Comparison {
    width: u32,
    /// The largest difference in a channel of each pixel, row by row.
    differences: Vec<u8>,
    /// The root of the mean square over all channels, 1 being white against black.
    pub(crate) rmse: f64,
}

impl Comparison {
    /// Of two pictures of one size; `None` if they are not.
    pub(crate) fn of(ours: &RgbImage, reference: &RgbImage) -> Option<Self> {
        if ours.dimensions() != reference.dimensions() {
            return None;
        }
        let differences = ours.pixels().zip(reference.pixels()).map(|(a, b)| difference(a.0, b.0)).collect();
        let squares = ours.iter().zip(reference.iter()).map(|(&a, &b)| {
            let difference = f64::from(a.abs_diff(b)) / 255.0;
            difference * difference
        });
        let rmse = (squares.sum::<f64>() / ours.len() as f64).sqrt();
        Some(Self { width: ours.width(), differences, rmse })
    }

    /// The share of pixels of which no channel differs by more.
    pub(crate) fn share_within(&self, most: u8) -> f64 {
        self.differences.iter().filter(|&&off| off <= most).count() as f64 / self.differences.len() as f64
    }

    /// The largest difference in a channel of any pixel.
    pub(crate) fn largest(&self) -> u8 {
        self.differences.iter().copied().max().unwrap_or(0)
    }

    /// The pixels, `[x, y]`, of which a channel differs by more, row by row.
    pub(crate) fn off_by_more_than(&self, most: u8) -> impl Iterator<Item = [u32; 2]> {
        let off = (0..).zip(&self.differences).filter(move |&(_, &off)| off > most);
        off.map(|(index, _): (u32, _)| [index % self.width, index / self.width])
    }

    /// Black where the pictures are equal, the lighter the more they differ, white from 32 of 255 on; pixels to be marked are red.
    pub(crate) fn picture(&self, marked: &[[u32; 2]]) -> RgbImage {
        let height = self.differences.len() as u32 / self.width;
        let mut picture = RgbImage::from_fn(self.width, height, |x, y| {
            let off = self.differences[(y * self.width + x) as usize];
            Rgb([off.saturating_mul(8); 3])
        });
        for &[x, y] in marked {
            picture.put_pixel(x, y, Rgb([255, 0, 0]));
        }
        picture
    }
}

/// The largest difference of two pixels' channels.
fn difference(one: [u8; 3], other: [u8; 3]) -> u8 {
    (0..3).map(|channel| one[channel].abs_diff(other[channel])).max().unwrap_or(0)
}

/// Whether a colour lies, channel by channel and give or take some, in the range of others, of which there is at least one.
pub(crate) fn lies_among(color: [u8; 3], others: &[[u8; 3]], give: u8) -> bool {
    (0..3).all(|channel| {
        let values = others.iter().map(|other| other[channel]);
        let range = values.clone().min().zip(values.max());
        range.is_some_and(|(least, most)| {
            (least.saturating_sub(give)..=most.saturating_add(give)).contains(&color[channel])
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_and_the_mean_are_of_all_pixels_and_channels() {
        let black = RgbImage::new(2, 2);
        let mut other = black.clone();
        other.put_pixel(0, 0, Rgb([0, 5, 0]));
        other.put_pixel(1, 1, Rgb([2, 0, 1]));
        let found = Comparison::of(&other, &black).unwrap();
        assert_eq!([found.share_within(1), found.share_within(2), found.share_within(5)], [0.5, 0.75, 1.0]);
        assert_eq!(found.largest(), 5);
        assert_eq!(found.off_by_more_than(1).collect::<Vec<_>>(), [[0, 0], [1, 1]]);
        // sqrt((25 + 4 + 1) / 12) / 255
        assert!((found.rmse - 0.006_200_5).abs() < 1e-7, "{}", found.rmse);
        let picture = found.picture(&[[0, 0]]);
        assert_eq!([picture.get_pixel(1, 1).0, picture.get_pixel(0, 0).0], [[16; 3], [255, 0, 0]]);
        assert!(Comparison::of(&black, &RgbImage::new(2, 1)).is_none());
    }

    #[test]
    fn a_colour_lies_among_others_channel_by_channel() {
        let others = [[10, 200, 0], [90, 100, 0]];
        assert!(lies_among([50, 150, 2], &others, 2));
        assert!(lies_among([8, 202, 0], &others, 2));
        assert!(!lies_among([50, 150, 3], &others, 2));
        assert!(!lies_among([50, 97, 0], &others, 2));
        assert!(!lies_among([0; 3], &[], 255));
    }
}
