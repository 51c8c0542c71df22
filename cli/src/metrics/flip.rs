//! FLIP, a model of what is seen on flipping between two pictures on a screen.
//!
//! Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020, "FLIP: A Difference Evaluator for Alternating Images",
//! Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 15. Two pipelines, joined at the end:
//!
//! ```text
//!                  +-> blur each channel as the eye does -> L*a*b*, Hunt -> distance -> redistribute -> colour difference c
//!   RGB -> YCxCz --+
//!                  +-> Y alone: edges, points ----------------------------> distance ------------------> feature difference f
//!
//!   error of a pixel = c^(1 - f)
//! ```
//!
//! A difference in colour counts more where an edge or a point appears or vanishes. The constants and the extent of the filters are
//! those of the authors' program, the paper's erratum included (Y is brought to 0..1 by dividing by 116, not 100). It is for pictures as
//! screens show them; there is another one, HDR-FLIP, for all exposures of a picture.

mod blur;
mod color;
mod features;
mod plane;

use render::Film;

use super::{MetricError, check_sizes, heat};
use color::ColorModel;
use plane::Plane;

/// A usual screen: 3840 pixels over 0.7 m, seen from 0.7 m.
pub const PIXELS_PER_DEGREE: f64 = 67.0;

/// How visible the difference is, for each pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorMap {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// 0: cannot be seen, 1: the greatest that there is; row by row from the top.
    pub errors: Vec<f64>,
}

impl ErrorMap {
    /// The mean over the pixels: what FLIP's authors recommend as the one number for a pair of pictures. 0 without pixels.
    pub fn mean(&self) -> f64 {
        self.errors.iter().sum::<f64>() / self.errors.len().max(1) as f64
    }

    /// The map as a picture, in the colours of [`heat`]: three sRGB bytes a pixel, row by row from the top.
    pub fn to_srgb_bytes(&self) -> Vec<u8> {
        self.errors.iter().flat_map(|&error| heat(error)).collect()
    }
}

/// Compares what a screen shows of two pictures: their colours clamped to 0..1, NaN as 0, but not rounded to bytes.
///
/// `pixels_per_degree` is how fine the screen looks to its user, 1 to 1000, usually [`PIXELS_PER_DEGREE`]. The model is symmetric.
/// Beyond its border a picture goes on with the border's colour; so any size will do.
pub fn flip(one: &Film, other: &Film, pixels_per_degree: f64) -> Result<ErrorMap, MetricError> {
    check_sizes(one, other)?;
    if !(1.0..=1000.0).contains(&pixels_per_degree) {
        return Err(MetricError::PixelsPerDegree(pixels_per_degree));
    }
    let model = ColorModel::new();
    let size = ErrorMap { width: one.width, height: one.height, errors: Vec::new() };
    let one = opponent_channels(one, &model);
    let other = opponent_channels(other, &model);
    let colors = blur::color_differences(&one, &other, &model, pixels_per_degree);
    let features = features::differences(&one[0], &other[0], pixels_per_degree);
    let pairs = colors.into_iter().zip(features);
    Ok(ErrorMap { errors: pairs.map(|(color, feature)| libm::pow(color, 1.0 - feature)).collect(), ..size })
}

/// Y, Cx and Cz of a picture. Y's 0..1 becomes -16..100.
fn opponent_channels(film: &Film, model: &ColorModel) -> [Plane; 3] {
    let pixels = film.pixels.iter();
    let pixels: Vec<_> = pixels.map(|pixel| model.opponent(pixel.to_array().map(on_screen).into())).collect();
    [0, 1, 2].map(|channel| Plane {
        width: film.width as usize,
        values: pixels.iter().map(|pixel| pixel[channel]).collect(),
    })
}

/// What a screen can show of a linear value.
fn on_screen(linear: f32) -> f64 {
    if linear.is_nan() { 0.0 } else { f64::from(linear.clamp(0.0, 1.0)) }
}
