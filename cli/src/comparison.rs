//! How far a picture is from another of the same scene, pixel by pixel, on the 8-bit scale.

use image::RgbImage;

/// By how much a channel may differ without a reason, of 255.
pub(crate) const CLOSE: u8 = 2;

/// Where the colours around a pixel span no more than this in any channel, of 255, there is no edge.
const SMOOTH: u8 = 6;

/// How a picture differs from its reference.
pub(crate) struct Comparison {
    width: u32,
    /// The largest difference in a channel of each pixel, row by row.
    differences: Vec<u8>,
    /// The pixels, `[x, y]`, that are not [`CLOSE`] and that no edge explains.
    pub(crate) unexplained: Vec<[u32; 2]>,
    /// The root of the mean square over all channels, 1 being white against black.
    pub(crate) rmse: f64,
}

impl Comparison {
    /// Of two pictures of one size; `None` if they are not.
    pub(crate) fn of(ours: &RgbImage, reference: &RgbImage) -> Option<Self> {
        if ours.dimensions() != reference.dimensions() {
            return None;
        }
        let differences: Vec<u8> = ours.pixels().zip(reference.pixels()).map(|(a, b)| difference(a.0, b.0)).collect();
        let off = ours.enumerate_pixels().zip(&differences).filter(|&(_, &off)| off > CLOSE);
        let unexplained = off.map(|((x, y, _), _)| [x, y]).filter(|&at| !edge_explains(ours, reference, at)).collect();
        let squares = ours.iter().zip(reference.iter()).map(|(&a, &b)| {
            let difference = f64::from(a.abs_diff(b)) / 255.0;
            difference * difference
        });
        let rmse = (squares.sum::<f64>() / ours.len() as f64).sqrt();
        Some(Self { width: ours.width(), differences, unexplained, rmse })
    }

    /// The share of pixels of which no channel differs by more.
    pub(crate) fn share_within(&self, most: u8) -> f64 {
        self.differences.iter().filter(|&&off| off <= most).count() as f64 / self.differences.len() as f64
    }

    /// The largest difference in a channel of any pixel.
    pub(crate) fn largest(&self) -> u8 {
        self.differences.iter().copied().max().unwrap_or(0)
    }

    /// Black where the pictures are equal, the lighter the more they differ, white from 32 of 255 on; what no edge explains is red.
    pub(crate) fn picture(&self) -> RgbImage {
        let height = self.differences.len() as u32 / self.width;
        let mut picture = RgbImage::from_fn(self.width, height, |x, y| {
            let off = self.differences[(y * self.width + x) as usize];
            image::Rgb([off.saturating_mul(8); 3])
        });
        for &[x, y] in &self.unexplained {
            picture.put_pixel(x, y, image::Rgb([255, 0, 0]));
        }
        picture
    }
}

/// The largest difference of two pixels' channels.
fn difference(one: [u8; 3], other: [u8; 3]) -> u8 {
    (0..3).map(|channel| one[channel].abs_diff(other[channel])).max().unwrap_or(0)
}

/// Whether a border of a body, a shadow or a texel explains that a pixel differs: it passes here in one of the pictures, and lies a part of
/// a pixel aside in the other, so that this one's colour is made of those that the first shows here and around.
fn edge_explains(one: &RgbImage, other: &RgbImage, at: [u32; 2]) -> bool {
    is_mixed_from(one, other, at) || is_mixed_from(other, one, at)
}

/// Whether the colour of a pixel lies, channel by channel, in the range that another picture has at that pixel and the eight around it,
/// and there is an edge.
fn is_mixed_from(picture: &RgbImage, other: &RgbImage, [x, y]: [u32; 2]) -> bool {
    let here = picture.get_pixel(x, y).0;
    let range = |channel: usize| {
        let values = around(other, x, y).map(move |color| color[channel]);
        values.clone().min().zip(values.max()).unwrap_or_default()
    };
    let ranges = [0, 1, 2].map(range);
    let has_edge = ranges.iter().any(|&(least, most)| most - least > SMOOTH);
    let lies_in = |(channel, (least, most)): (u8, (u8, u8))| {
        (least.saturating_sub(CLOSE)..=most.saturating_add(CLOSE)).contains(&channel)
    };
    has_edge && here.into_iter().zip(ranges).all(lies_in)
}

/// A pixel and those around it.
fn around(picture: &RgbImage, x: u32, y: u32) -> impl Iterator<Item = [u8; 3]> + Clone {
    let near = |at: u32, count: u32| at.saturating_sub(1)..=(at + 1).min(count - 1);
    let columns = near(x, picture.width());
    near(y, picture.height()).flat_map(move |y| columns.clone().map(move |x| picture.get_pixel(x, y).0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::Rgb;

    /// 6 x 3 pixels, dark at the left and light from a column on.
    fn edge_at(column: u32) -> RgbImage {
        RgbImage::from_fn(6, 3, |x, _| Rgb([if x < column { 10 } else { 200 }; 3]))
    }

    fn unexplained(ours: &RgbImage, reference: &RgbImage) -> Vec<[u32; 2]> {
        Comparison::of(ours, reference).unwrap().unexplained
    }

    #[test]
    fn an_edge_may_lie_a_pixel_aside_and_no_farther() {
        assert_eq!(unexplained(&edge_at(3), &edge_at(2)), Vec::<[u32; 2]>::new());
        // Of two columns, that which touches neither picture's other side ... there is none: each lies beside one of the edges.
        assert_eq!(unexplained(&edge_at(4), &edge_at(1)), [[2, 0], [2, 1], [2, 2]]);
    }

    #[test]
    fn a_colour_that_the_other_picture_has_nowhere_near_is_not_explained() {
        let mut odd = edge_at(3);
        odd.put_pixel(3, 1, Rgb([200, 200, 90]));
        odd.put_pixel(2, 1, Rgb([10, 210, 10]));
        assert_eq!(unexplained(&odd, &edge_at(3)), [[2, 1]], "90 lies between 10 and 200, 210 does not");
    }

    #[test]
    fn smooth_areas_explain_nothing() {
        let smooth = |add: u8| RgbImage::from_fn(6, 3, |x, _| Rgb([100 + x as u8 + add; 3]));
        assert_eq!(unexplained(&smooth(3), &smooth(0)).len(), 18);
        assert_eq!(unexplained(&smooth(2), &smooth(0)).len(), 0);
    }

    #[test]
    fn shares_and_the_mean_are_of_all_pixels_and_channels() {
        let black = RgbImage::new(2, 2);
        let mut other = black.clone();
        other.put_pixel(0, 0, Rgb([0, 5, 0]));
        other.put_pixel(1, 1, Rgb([2, 0, 1]));
        let found = Comparison::of(&other, &black).unwrap();
        assert_eq!([found.share_within(1), found.share_within(2), found.share_within(5)], [0.5, 0.75, 1.0]);
        assert_eq!(found.largest(), 5);
        // sqrt((25 + 4 + 1) / 12) / 255
        assert!((found.rmse - 0.006_200_5).abs() < 1e-7, "{}", found.rmse);
        assert_eq!(found.picture().get_pixel(1, 1).0, [16; 3]);
        assert_eq!(found.picture().get_pixel(0, 0).0, [255, 0, 0]);
        assert!(Comparison::of(&black, &RgbImage::new(2, 1)).is_none());
    }
}
