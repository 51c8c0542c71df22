//! Pairs of small pictures, made by whole-number arithmetic, on which our FLIP is held against its authors' program.

use render::{Film, LostRays, RayCounts};
use shading::{Color, srgb};

/// Two pictures to compare, and how far the authors' program may be off.
pub(crate) struct Pair {
    pub(crate) name: String,
    pub(crate) reference: Picture,
    pub(crate) test: Picture,
    pub(crate) tolerance: Tolerance,
}

/// By how much FLIP in f32 may differ from ours, in f64.
///
/// The authors' program finds "edges" of some 2^-23, its roundings, where a picture is flat, in place of 0. An error is c^(1 - f), and f is the root
/// of the strength of an edge by sqrt(2). So f may be off by sqrt(k 2^-24 / sqrt(2)), and the error by c ln(1/c) times that, where c ln(1/c) is 1/e at
/// most: 1.5e-4 for k = 4. Where both pictures have edges everywhere the root does not magnify anything.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance {
    /// In each pixel.
    pub(crate) pixel: f64,
    /// In the mean.
    pub(crate) mean: f64,
}

/// Where a picture is flat: k = 4. Measured: 1.2e-4 and 1.4e-5.
const FLAT: Tolerance = Tolerance { pixel: 1.5e-4, mean: 2e-5 };

/// Where there are edges everywhere: measured 1.5e-6 and 3.1e-8.
const BUSY: Tolerance = Tolerance { pixel: 2e-6, mean: 1e-7 };

/// A picture in sRGB bytes.
#[derive(Clone)]
pub(crate) struct Picture {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) bytes: Vec<u8>,
}

impl Picture {
    fn of([width, height]: [u32; 2], pixel: impl Fn(u32, u32) -> [u8; 3]) -> Self {
        let bytes = (0..width * height).flat_map(|number| pixel(number % width, number / width)).collect();
        Self { width, height, bytes }
    }

    /// What a renderer would have to make of it.
    pub(crate) fn film(&self) -> Film {
        let (pixels, _) = self.bytes.as_chunks();
        let pixels = pixels.iter().map(|rgb: &[u8; 3]| Color::from(rgb.map(srgb::decode_byte))).collect();
        Film { width: self.width, height: self.height, pixels, rays: RayCounts::default(), lost: LostRays::default() }
    }
}

pub(crate) fn generated() -> Vec<Pair> {
    let colors = |x, y| [9 * x as u8, 7 * y as u8, 5 * (x + y) as u8];
    let turned = |x, y| {
        let [r, g, b] = colors(x, y);
        [b, r, g]
    };
    let noisy = |x, y| {
        let grain = noise(0)(x, y);
        [0, 1, 2].map(|channel| colors(x, y)[channel].saturating_add(grain[channel] / 4))
    };
    let edge = |at| move |x, _| [if x < at { 40 } else { 200 }; 3];
    let firefly = |x, y| [if (x, y) == (7, 7) { 255 } else { 30 }; 3];
    let stripes = |width| move |x, _| [if x / width % 2 == 0 { 90 } else { 160 }; 3];
    vec![
        pair("white, black", FLAT, [1, 1], plain([255; 3]), plain([0; 3])),
        pair("green, blue", FLAT, [3, 2], plain([0, 255, 0]), plain([0, 0, 255])),
        pair("two greys", FLAT, [5, 1], plain([128; 3]), plain([129; 3])),
        pair("a shifted edge", FLAT, [23, 9], edge(11), edge(12)),
        pair("a firefly", FLAT, [15, 15], plain([30; 3]), firefly),
        pair("stripes", FLAT, [64, 3], stripes(2), stripes(8)),
        pair("other colours", BUSY, [28, 21], colors, turned),
        pair("noise on colours", BUSY, [28, 21], colors, noisy),
        pair("noise, other noise", BUSY, [31, 17], noise(1), noise(2)),
    ]
}

fn pair(
    name: &str,
    tolerance: Tolerance,
    size: [u32; 2],
    reference: impl Fn(u32, u32) -> [u8; 3],
    test: impl Fn(u32, u32) -> [u8; 3],
) -> Pair {
    Pair { name: name.to_owned(), reference: Picture::of(size, reference), test: Picture::of(size, test), tolerance }
}

fn plain(color: [u8; 3]) -> impl Fn(u32, u32) -> [u8; 3] {
    move |_, _| color
}

/// Bytes that look random.
fn noise(seed: u32) -> impl Fn(u32, u32) -> [u8; 3] {
    move |x, y| {
        let place = x.wrapping_mul(0x9E37_79B1) ^ y.wrapping_mul(0x85EB_CA77) ^ seed.wrapping_mul(0xC2B2_AE3D);
        let mixed = (place ^ place >> 15).wrapping_mul(0x27D4_EB2F);
        let [_, r, g, b] = (mixed ^ mixed >> 15).to_le_bytes();
        [r, g, b]
    }
}
