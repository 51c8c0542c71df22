use std::num::NonZeroUsize;

use scene_format::{
    SceneFile,
    scene_file::{BucketOrder, Image, Statement},
};

use crate::LightSamples;

/// How a scene is to be rendered. The scene's own settings come from [`Settings::of`].
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The picture's width and height in pixels, each at least 1.
    pub size: [u32; 2],
    /// Renders only a part of the picture.
    pub crop: Option<Crop>,
    /// A pixel is cut into 2^aa x 2^aa zones; at most 8.
    pub aa: u32,
    /// Where pixels get more or fewer rays: the fewest are those of 2^least_aa x 2^least_aa zones.
    pub least_aa: u32,
    /// Rays in each zone, 1 to 65535: so the rays of a pixel can be counted in 32 bits.
    pub samples: u32,
    /// Which pixels get how many rays.
    pub allotment: Allotment,
    /// How far rays must be apart for a pixel to get more than the fewest, where rays are not shared out evenly: 0 to 1, which is
    /// white against black.
    pub contrast: f32,
    /// How many lights of a cluster are asked at a point.
    pub light_samples: LightSamples,
    /// Another seed is another picture of the same scene.
    pub seed: u32,
    /// The unit of work. No influence on the picture.
    pub buckets: Buckets,
    /// How many threads; all that the machine has unless given. No influence on the picture.
    pub threads: Option<NonZeroUsize>,
}

/// How a picture's rays are shared out among its pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Allotment {
    /// To all alike, as the report does.
    #[default]
    Even,
    /// More to those where there is more to be seen: between `least_aa` and `aa`, by `contrast`.
    Adaptive,
}

/// A part of a picture, in pixels from its top left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crop {
    /// The first column.
    pub x: u32,
    /// The first row.
    pub y: u32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Crop {
    /// Its pixels, row by row from the top.
    pub fn pixels(self) -> impl Iterator<Item = [u32; 2]> {
        let rows = self.y..self.y + self.height;
        rows.flat_map(move |y| (self.x..self.x + self.width).map(move |x| [x, y]))
    }

    /// Its pixels, so that those that follow each other lie near each other: by squares of 4 x 4, and in these by squares of 2 x 2.
    ///
    /// ```text
    ///    0  1  4  5 | 16 17 20 21      sixteen rays in a row are those of a square of pixels, whether each
    ///    2  3  6  7 | 18 19 22 23      has one, four, or sixteen of them
    ///    8  9 12 13 | 24 25 28 29
    ///   10 11 14 15 | 26 27 30 31
    /// ```
    pub(crate) fn pixels_by_squares(self) -> impl Iterator<Item = [u32; 2]> {
        const STEPS: [[u32; 2]; 4] = [[0, 0], [1, 0], [0, 1], [1, 1]];
        let rows = (0..self.height).step_by(4);
        let squares = rows.flat_map(move |y| (0..self.width).step_by(4).map(move |x| [x, y]));
        let within = squares.flat_map(|[x, y]| {
            let twos = STEPS.into_iter().map(move |[dx, dy]| [x + 2 * dx, y + 2 * dy]);
            twos.flat_map(|[x, y]| STEPS.into_iter().map(move |[dx, dy]| [x + dx, y + dy]))
        });
        within.filter(move |&[x, y]| x < self.width && y < self.height).map(move |[x, y]| [self.x + x, self.y + y])
    }

    /// Whether a pixel belongs to it.
    pub fn contains(self, [x, y]: [u32; 2]) -> bool {
        let within = |at: u32, start: u32, length: u32| at >= start && at - start < length;
        within(x, self.x, self.width) && within(y, self.y, self.height)
    }

    /// Where one of its pixels stands among them, row by row from the top.
    pub fn index(self, [x, y]: [u32; 2]) -> usize {
        (y - self.y) as usize * self.width as usize + (x - self.x) as usize
    }

    /// With so many pixels more on each side, as far as the picture goes.
    pub(crate) fn grown(self, by: u32, size: [u32; 2]) -> Self {
        let (x, y) = (self.x.saturating_sub(by), self.y.saturating_sub(by));
        let (right, bottom) = ((self.x + self.width + by).min(size[0]), (self.y + self.height + by).min(size[1]));
        Self { x, y, width: right - x, height: bottom - y }
    }

    /// The part of a larger area that falls to it, a part of `whole`: where it ends at the whole's border, up to the larger one's.
    pub(crate) fn reaching(self, whole: Self, larger: Self) -> Self {
        let start = |own: u32, whole: u32, larger: u32| if own == whole { larger } else { own };
        let (x, y) = (start(self.x, whole.x, larger.x), start(self.y, whole.y, larger.y));
        let right = start(self.x + self.width, whole.x + whole.width, larger.x + larger.width);
        let bottom = start(self.y + self.height, whole.y + whole.height, larger.y + larger.height);
        Self { x, y, width: right - x, height: bottom - y }
    }
}

/// The tiles that a picture is rendered in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Buckets {
    /// Their edge in pixels, at least 1.
    pub size: u32,
    /// Their order.
    pub order: BucketOrder,
    /// Whether the order runs backwards.
    pub reversed: bool,
}

impl Default for Buckets {
    fn default() -> Self {
        Self { size: 32, order: BucketOrder::Hilbert, reversed: false }
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            size: [640, 480],
            crop: None,
            aa: 0,
            least_aa: 0,
            samples: 1,
            allotment: Allotment::default(),
            contrast: 0.1,
            light_samples: LightSamples::default(),
            seed: 0,
            buckets: Buckets::default(),
            threads: None,
        }
    }
}

impl Settings {
    /// What a scene's own `image` and `bucket` statements ask for, includes among them; the last one holds.
    ///
    /// Of the two `aa` numbers the larger counts, the smaller only where rays are not shared out evenly; below zero it is taken as zero. Numbers are clamped as Sunflow clamps them:
    /// `aa` to 5, `samples` to 1..256, `contrast` to 0..1, buckets to 16..512.
    pub fn of(scene: &SceneFile) -> Self {
        let mut settings = Self::default();
        settings.read(scene);
        settings
    }

    fn read(&mut self, scene: &SceneFile) {
        for statement in &scene.statements {
            match &statement.value {
                Statement::Image(image) => self.read_image(image),
                Statement::Bucket(bucket) => {
                    self.buckets = Buckets {
                        size: bucket.size.clamp(16, 512),
                        order: bucket.order.value,
                        reversed: bucket.reversed,
                    };
                }
                Statement::Include { file: Some(included), .. } => self.read(&included.scene),
                _ => {}
            }
        }
    }

    fn read_image(&mut self, image: &Image) {
        if let Some(size) = image.resolution {
            self.size = size.value;
        }
        if let Some([min, max]) = image.aa.map(|aa| aa.value) {
            let clamped = |aa: i32| aa.clamp(0, 5).unsigned_abs();
            (self.least_aa, self.aa) = (clamped(min.min(max)), clamped(min.max(max)));
        }
        if let Some(contrast) = image.contrast {
            self.contrast = contrast.clamp(0.0, 1.0);
        }
        if let Some(samples) = image.samples {
            self.samples = samples.clamp(1, 256);
        }
    }

    /// The part to render: the crop, or the whole picture.
    pub fn window(&self) -> Crop {
        self.crop.unwrap_or(Crop { x: 0, y: 0, width: self.size[0], height: self.size[1] })
    }

    /// The fewest camera rays that a pixel gets where rays are not shared out evenly. Two, at the least: one would show no difference.
    pub fn least_rays(&self) -> u32 {
        ((1 << (2 * self.least_aa.min(self.aa))) * self.samples).max(2)
    }

    /// Camera rays for each pixel; where they are not shared out evenly, the most.
    pub fn rays_per_pixel(&self) -> u32 {
        (1 << (2 * self.aa)) * self.samples
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crop_s_pixels_stand_by_squares_each_once() {
        for (width, height) in [(1, 1), (3, 9), (4, 4), (8, 4), (13, 6)] {
            let crop = Crop { x: 5, y: 2, width, height };
            let mut found: Vec<_> = crop.pixels_by_squares().collect();
            found.sort_unstable_by_key(|&[x, y]| [y, x]);
            assert_eq!(found, crop.pixels().collect::<Vec<_>>(), "{width} x {height}");
        }
    }

    #[test]
    fn pixels_by_squares_run_as_drawn() {
        let crop = Crop { x: 0, y: 0, width: 8, height: 4 };
        let order: Vec<_> = crop.pixels_by_squares().collect();
        let numbers: Vec<_> = crop.pixels().map(|place| order.iter().position(|&other| other == place)).collect();
        let drawn = [
            [0, 1, 4, 5, 16, 17, 20, 21],
            [2, 3, 6, 7, 18, 19, 22, 23],
            [8, 9, 12, 13, 24, 25, 28, 29],
            [10, 11, 14, 15, 26, 27, 30, 31],
        ];
        assert_eq!(numbers, drawn.concat().into_iter().map(Some).collect::<Vec<_>>());
    }
}
