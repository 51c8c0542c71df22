//! The options that decide how a scene is rendered, for every command that renders.

use std::num::NonZeroUsize;

use clap::{Args, ValueEnum};
use geometry::{Kernels, naive};
use render::{Allotment, Buckets, Crop, LightSamples, Lighting, Modules, Sampler, Settings};
use scene_format::scene_file::BucketOrder;
use shading::SoftShadows;

use crate::report::Failure;

/// The largest picture, along each edge.
const LARGEST_EDGE: u32 = 16_384;

#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "How to render")]
pub(crate) struct RenderOptions {
    /// The picture's size, instead of the scene's own.
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// Cut each pixel into 2^N x 2^N zones (0 to 8), instead of what the scene's `aa` says. With `--adaptive`, pixels get the rays of
    /// 2^LEAST x 2^LEAST to 2^N x 2^N zones.
    #[arg(long, value_name = "[LEAST,]N", value_parser = parse_aa)]
    aa: Option<AaOption>,
    /// Rays at random places of each zone (1 to 65535), instead of the scene's own.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=65535))]
    samples: Option<u32>,
    /// Where samples fall. [default: sobol; with `--lighting sunflow` in the middle of zones]
    #[arg(long, value_enum)]
    sampler: Option<SamplerName>,
    /// Give pixels more or fewer rays, between what the scene's two `aa` numbers say: the more, the farther the rays of their neighbours
    /// are apart. CONTRAST is how far they must be for more than the fewest, from 0 to 1, which is white against black: the smaller, the
    /// better the picture. [default: the scene's `contrast`, or 0.1]
    #[arg(long, value_name = "CONTRAST", num_args = 0..=1, require_equals = true, value_parser = parse_contrast)]
    adaptive: Option<Option<f32>>,
    /// How many threads to use. The picture does not depend on it. [default: all processors]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// The tiles that threads work on: their edge in pixels, and their order: hilbert, spiral, column, row, diagonal or random, each
    /// also with `reverse-` before it. The picture does not depend on it.
    #[arg(long, value_name = "SIZE[,ORDER]", value_parser = parse_buckets)]
    bucket: Option<BucketOption>,
    /// How to find what a ray meets first. The picture does not depend on it. [default: wide]
    #[arg(long, value_enum)]
    accelerator: Option<AcceleratorName>,
    /// How the wide octree decides whether a ray meets a triangle. [default: exact]
    #[arg(long, value_enum)]
    hits: Option<HitsName>,
    /// Render with the naive kernels of textbooks instead, to see what goes wrong: some, separated by commas, or all. The scene
    /// `scales` is hard for them; `girasol accuracy` measures them.
    #[arg(long, value_enum, value_name = "KERNEL,...", value_delimiter = ',')]
    naive: Vec<NaiveKernel>,
    /// How surfaces and lights work. `report`: as the report of 2010 describes. `sunflow`: as Sunflow 0.07.3 computes it, to be held
    /// against its pictures; without lights all is black. [default: report]
    #[arg(long, value_enum)]
    lighting: Option<LightingName>,
    /// How light falls off with the distance d from a light of power P: `linear` is max(0, 1 - d/P), `log` is P / (ln(d + 1) + 1).
    /// [default: linear; with `--lighting sunflow` the inverse square]
    #[arg(long, value_enum)]
    falloff: Option<FalloffName>,
    /// The share of a surface's colour that shows in a scene without lights, with the report's lighting. [default: 0.05]
    #[arg(long, value_name = "SHARE", value_parser = parse_share)]
    ambient: Option<f32>,
    /// Make of each light a cube of N x N x N lights, SPACING apart, so that shadows get soft edges. N is 1 to 8; without a
    /// value 3,0.1; `1` switches soft shadows off.
    #[arg(long, value_name = "N[,SPACING]", num_args = 0..=1, require_equals = true, default_missing_value = "3,0.1",
          value_parser = parse_soft_shadows)]
    soft_shadows: Option<SoftShadows>,
    /// How many lights of each such cube a ray asks at a point: `all`, a number, or `shared`: all at up to four rays a pixel, and
    /// for more so many that they together ask each four times. [default: shared]
    #[arg(long, value_name = "N", value_parser = parse_light_samples)]
    light_samples: Option<LightSamples>,
    /// Render only this part of the picture: its left column, top row, width and height in pixels.
    #[arg(long, value_name = "X,Y,W,H", value_parser = parse_crop)]
    crop: Option<Crop>,
    /// Choose other random numbers.
    #[arg(long, value_name = "N")]
    seed: Option<u32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum AcceleratorName {
    /// Ask every primitive.
    None,
    /// Cubes halved into eight, as in the report.
    Octree,
    /// The same cubes, gathered into nodes of sixteen boxes that are tested at once.
    Wide,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum HitsName {
    /// In 64 bits, as every other accelerator does: the same picture, bit for bit.
    Exact,
    /// In 32 bits, without gaps between triangles: faster. At an edge a ray may meet the neighbour instead.
    Watertight,
}

/// The samplers that can be named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SamplerName {
    /// A random place in each zone of a pixel; independent random numbers for everything else. The report's.
    Random,
    /// Points that keep apart: Sobol's sequence, scrambled by Owen's method.
    Sobol,
}

impl SamplerName {
    /// The sampler of that name.
    pub(crate) fn sampler(self) -> Sampler {
        match self {
            Self::Random => render::random,
            Self::Sobol => render::sobol,
        }
    }
}

/// A kernel of [`geometry::naive`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum NaiveKernel {
    /// The quadratic formula in single precision.
    Sphere,
    /// An inverse matrix in single precision.
    Ellipsoid,
    /// Möller and Trumbore's test with its epsilon, in single precision.
    Triangle,
    /// Rays nearly parallel to a plane miss it.
    Plane,
    /// The slab test without care for zeros and rounding, in the plain octree.
    Box,
    /// Shadow rays and others start 0.0001 off the surface.
    Offset,
    /// All of these.
    All,
}

impl NaiveKernel {
    /// Puts it in its place.
    fn put_into(self, modules: Modules) -> Modules {
        let Modules { kernels, .. } = modules;
        let naive = naive::kernels();
        let kernels = match self {
            Self::Sphere => Kernels { sphere: naive.sphere, ..kernels },
            Self::Ellipsoid => Kernels { ellipsoid: naive.ellipsoid, ..kernels },
            Self::Triangle => Kernels { triangle: naive.triangle, ..kernels },
            Self::Plane => Kernels { plane: naive.plane, ..kernels },
            Self::Box => Kernels { aabb: naive.aabb, ..kernels },
            Self::Offset => kernels,
            Self::All => naive,
        };
        let ray_origin = match self {
            Self::Offset | Self::All => naive::offset_along_normal,
            _ => modules.ray_origin,
        };
        // The wide octree packs its boxes and has a test of its own for them.
        let accelerator = match self {
            Self::Box | Self::All => accel::octree,
            _ => modules.accelerator,
        };
        Modules { kernels, ray_origin, accelerator, ..modules }
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum LightingName {
    Report,
    Sunflow,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum FalloffName {
    Linear,
    Log,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct BucketOption {
    size: u32,
    order: Option<(BucketOrder, bool)>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct AaOption {
    least: u32,
    most: u32,
}

impl RenderOptions {
    /// The parts to render with.
    pub(crate) fn modules(&self, modules: Modules) -> Modules {
        let modules = match self.lighting {
            None | Some(LightingName::Report) => modules,
            Some(LightingName::Sunflow) => modules.lit_as_by_sunflow(),
        };
        let modules = self.naive.iter().fold(modules, |modules, kernel| kernel.put_into(modules));
        let accelerator = match (self.accelerator, self.hits) {
            (None, None) => modules.accelerator,
            (Some(AcceleratorName::None), _) => accel::none,
            (Some(AcceleratorName::Octree), _) => accel::octree,
            (_, Some(HitsName::Watertight)) => accel::wide_watertight,
            (Some(AcceleratorName::Wide), _) | (None, Some(HitsName::Exact)) => accel::wide,
        };
        let falloff = match self.falloff {
            None => modules.falloff,
            Some(FalloffName::Linear) => shading::linear_falloff,
            Some(FalloffName::Log) => shading::logarithmic_falloff,
        };
        let sampler = self.sampler.map_or(modules.sampler, SamplerName::sampler);
        Modules { accelerator, falloff, sampler, ..modules }
    }

    /// The light to render with; `soft_shadows` is what the scene itself wants.
    pub(crate) fn lighting(&self, soft_shadows: Option<SoftShadows>) -> Lighting {
        let soft_shadows = self.soft_shadows.or(soft_shadows).filter(|soft| soft.along_edge > 1);
        let default = Lighting::default();
        Lighting { ambient: self.ambient.unwrap_or(default.ambient), soft_shadows }
    }

    /// The scene's own settings, with what the command line says instead.
    pub(crate) fn settings(&self, scene: &Settings) -> Result<Settings, Failure> {
        if let (Some(LightingName::Sunflow), Some(_)) = (self.lighting, self.ambient) {
            return Err(Failure::new("`--ambient` has no meaning with `--lighting sunflow`")
                .help("in Sunflow nothing shows where no light reaches: leave one of the two out, or put a light into the scene"));
        }
        let size = self.size.unwrap_or(scene.size);
        if let Some(crop) = self.crop {
            let fits = |start: u32, length: u32, edge: u32| start.checked_add(length).is_some_and(|end| end <= edge);
            if !fits(crop.x, crop.width, size[0]) || !fits(crop.y, crop.height, size[1]) {
                let Crop { x, y, width, height } = crop;
                return Err(Failure::new(format!(
                    "the crop {x},{y},{width},{height} reaches beyond the picture of {} x {} pixels",
                    size[0], size[1]
                ))
                .help("--crop takes the left column, the top row, the width and the height, counted from 0"));
            }
        }
        let aa = self.aa.unwrap_or(AaOption { least: scene.least_aa.min(scene.aa), most: scene.aa });
        let buckets = match self.bucket {
            None => scene.buckets,
            Some(BucketOption { size, order: None }) => Buckets { size, ..scene.buckets },
            Some(BucketOption { size, order: Some((order, reversed)) }) => Buckets { size, order, reversed },
        };
        Ok(Settings {
            size,
            crop: self.crop,
            aa: aa.most,
            least_aa: aa.least,
            allotment: if self.adaptive.is_some() { Allotment::Adaptive } else { scene.allotment },
            contrast: self.adaptive.flatten().unwrap_or(scene.contrast),
            samples: self.samples.unwrap_or(scene.samples),
            light_samples: self.light_samples.unwrap_or(scene.light_samples),
            seed: self.seed.unwrap_or(scene.seed),
            buckets,
            threads: self.threads.or(scene.threads),
        })
    }

    /// How many threads to use, where that is said.
    pub(crate) fn threads(&self) -> Option<NonZeroUsize> {
        self.threads
    }

    /// The same options without those that choose parts.
    pub(crate) fn without_parts(&self) -> Self {
        let none = Self::default();
        Self {
            lighting: none.lighting,
            naive: none.naive,
            accelerator: none.accelerator,
            hits: none.hits,
            falloff: none.falloff,
            sampler: none.sampler,
            ..self.clone()
        }
    }

    /// The same options with another accelerator.
    pub(crate) fn with_accelerator(&self, accelerator: AcceleratorName) -> Self {
        Self { accelerator: Some(accelerator), ..self.clone() }
    }
}

fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let edge = |part: &str| part.trim().parse().ok().filter(|edge| (1..=LARGEST_EDGE).contains(edge));
    let sizes = text.split_once(['x', 'X']).and_then(|(width, height)| Some([edge(width)?, edge(height)?]));
    sizes.ok_or_else(|| format!("a size is a width and a height of 1 to {LARGEST_EDGE} pixels, as in 640x480"))
}

fn parse_aa(text: &str) -> Result<AaOption, String> {
    let number = |text: &str| text.trim().parse().ok().filter(|aa| (0..=8).contains(aa));
    let (least, most) = text.split_once(',').unwrap_or(("0", text));
    match (number(least), number(most)) {
        (Some(least), Some(most)) if least <= most => Ok(AaOption { least, most }),
        _ => Err("a number from 0 to 8, or two, the smaller one first, as in 2 or 0,2".to_owned()),
    }
}

fn parse_contrast(text: &str) -> Result<f32, String> {
    let contrast = text.parse().ok().filter(|&contrast| contrast > 0.0 && contrast <= 1.0);
    contrast.ok_or_else(|| "a contrast is a number above 0, up to 1".to_owned())
}

fn parse_crop(text: &str) -> Result<Crop, String> {
    let numbers: Option<Vec<u32>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[x, y, width, height]) if width > 0 && height > 0 => Ok(Crop { x, y, width, height }),
        _ => Err("a crop is a left column, a top row, a width and a height, as in 100,50,320,240".to_owned()),
    }
}

fn parse_buckets(text: &str) -> Result<BucketOption, String> {
    let (size, order) = match text.split_once(',') {
        Some((size, order)) => (size, Some(order.trim())),
        None => (text, None),
    };
    let size = size.trim().parse().ok().filter(|size| (1..=LARGEST_EDGE).contains(size));
    let size = size.ok_or_else(|| format!("a bucket's edge is 1 to {LARGEST_EDGE} pixels, as in 32 or 32,spiral"))?;
    let order = order.map(parse_order).transpose()?;
    Ok(BucketOption { size, order })
}

fn parse_order(text: &str) -> Result<(BucketOrder, bool), String> {
    let (name, reversed) = match text.strip_prefix("reverse-") {
        Some(name) => (name, true),
        None => (text, false),
    };
    let order = BucketOrder::from_name(name).ok_or(
        "the orders are hilbert, spiral, column, row, diagonal and random, each also with `reverse-` before it",
    )?;
    Ok((order, reversed))
}

fn parse_soft_shadows(text: &str) -> Result<SoftShadows, String> {
    let (along_edge, spacing) = match text.split_once(',') {
        Some((along_edge, spacing)) => (along_edge, spacing.trim().parse().ok()),
        None => (text, Some(SoftShadows::default().spacing)),
    };
    let along_edge = along_edge.trim().parse().ok().filter(|along_edge| (1..=8).contains(along_edge));
    match (along_edge, spacing) {
        (Some(along_edge), Some(spacing)) if spacing > 0.0 && f32::is_finite(spacing) => {
            Ok(SoftShadows { along_edge, spacing })
        }
        _ => Err("soft shadows are 1 to 8 lights along an edge, and their distance, as in 3,0.1".to_owned()),
    }
}

fn parse_light_samples(text: &str) -> Result<LightSamples, String> {
    match text {
        "all" => Ok(LightSamples::All),
        "shared" => Ok(LightSamples::Shared),
        _ => text.parse().map(LightSamples::Each).map_err(|_| "`all`, `shared`, or a number from 1".to_owned()),
    }
}

fn parse_share(text: &str) -> Result<f32, String> {
    let share = text.parse().ok().filter(|share| (0.0..=1.0).contains(share));
    share.ok_or_else(|| "a share is a number from 0 to 1".to_owned())
}

/// A time limit.
pub(crate) fn parse_positive_seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|&seconds: &f64| seconds > 0.0 && seconds < 1e9);
    seconds.ok_or_else(|| "a number of seconds greater than 0".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::num::NonZeroU32;

    #[test]
    fn sizes_crops_and_buckets_are_read() {
        assert_eq!(parse_size("640x480"), Ok([640, 480]));
        assert_eq!(parse_aa("2"), Ok(AaOption { least: 0, most: 2 }));
        assert_eq!(parse_aa("1,3"), Ok(AaOption { least: 1, most: 3 }));
        assert_eq!(parse_contrast("0.05"), Ok(0.05));
        assert_eq!(parse_light_samples("all"), Ok(LightSamples::All));
        assert_eq!(parse_light_samples("2"), Ok(LightSamples::Each(NonZeroU32::MIN.saturating_add(1))));
        assert_eq!(parse_crop("1, 2,3,4"), Ok(Crop { x: 1, y: 2, width: 3, height: 4 }));
        assert_eq!(parse_buckets("16"), Ok(BucketOption { size: 16, order: None }));
        let spiral = BucketOption { size: 16, order: Some((BucketOrder::Spiral, true)) };
        assert_eq!(parse_buckets("16,reverse-spiral"), Ok(spiral));
        assert_eq!(parse_soft_shadows("5"), Ok(SoftShadows { along_edge: 5, spacing: 0.1 }));
    }

    #[test]
    fn nonsense_is_turned_down() {
        for size in ["", "640", "0x480", "640x-1", "99999x1", "4294967297x1"] {
            assert!(parse_size(size).is_err(), "{size}");
        }
        for aa in ["", "9", "-1", "2,1", "0,9", "0,1,2", "x"] {
            assert!(parse_aa(aa).is_err(), "{aa}");
        }
        for contrast in ["", "0", "-1", "1.5", "nan", "x"] {
            assert!(parse_contrast(contrast).is_err(), "{contrast}");
        }
        for samples in ["", "0", "-1", "some", "4294967296"] {
            assert!(parse_light_samples(samples).is_err(), "{samples}");
        }
        for crop in ["", "1,2,3", "1,2,0,4", "1,2,3,4,5", "a,b,c,d"] {
            assert!(parse_crop(crop).is_err(), "{crop}");
        }
        for bucket in ["0", "16,", "16,snail", "x", "16,reverse"] {
            assert!(parse_buckets(bucket).is_err(), "{bucket}");
        }
        for soft in ["0", "9", "3,-1", "3,nan", "3,inf", ","] {
            assert!(parse_soft_shadows(soft).is_err(), "{soft}");
        }
        for seconds in ["0", "-1", "nan", "inf", "x"] {
            assert!(parse_positive_seconds(seconds).is_err(), "{seconds}");
        }
    }

    #[test]
    fn a_crop_outside_the_picture_is_an_error_even_where_the_sum_overflows() {
        let crop =
            |x, width| RenderOptions { crop: Some(Crop { x, y: 0, width, height: 1 }), ..RenderOptions::default() };
        assert!(crop(600, 40).settings(&Settings::default()).is_ok());
        assert!(crop(600, 41).settings(&Settings::default()).is_err());
        assert!(crop(u32::MAX, 2).settings(&Settings::default()).is_err());
    }
}
