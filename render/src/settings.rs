use std::num::NonZeroUsize;

use scene_format::{
    SceneFile,
    scene_file::{BucketOrder, Image, Statement},
};

use crate::LightSamples;

/// How a scene is to be rendered. The scene's own settings come from [`Settings::of`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    /// The picture's width and height in pixels, each at least 1.
    pub size: [u32; 2],
    /// Renders only a part of the picture.
    pub crop: Option<Crop>,
    /// A pixel is cut into 2^aa x 2^aa zones; at most 8.
    pub aa: u32,
    /// Rays in each zone, 1 to 65535: so the rays of a pixel can be counted in 32 bits.
    pub samples: u32,
    /// How many lights of a cluster are asked at a point.
    pub light_samples: LightSamples,
    /// Another seed is another picture of the same scene.
    pub seed: u32,
    /// The unit of work. No influence on the picture.
    pub buckets: Buckets,
    /// How many threads; all that the machine has unless given. No influence on the picture.
    pub threads: Option<NonZeroUsize>,
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
            samples: 1,
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
    /// Of the two `aa` numbers the larger counts; below zero it is taken as zero. Numbers are clamped as Sunflow clamps them:
    /// `aa` to 5, `samples` to 1..256, buckets to 16..512.
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
            self.aa = min.max(max).clamp(0, 5).unsigned_abs();
        }
        if let Some(samples) = image.samples {
            self.samples = samples.clamp(1, 256);
        }
    }

    /// The part to render: the crop, or the whole picture.
    pub fn window(&self) -> Crop {
        self.crop.unwrap_or(Crop { x: 0, y: 0, width: self.size[0], height: self.size[1] })
    }

    /// Camera rays for each pixel.
    pub fn rays_per_pixel(&self) -> u32 {
        (1 << (2 * self.aa)) * self.samples
    }
}
