//! FLIP's colour pipeline (section 4.1).

use std::f64::consts::PI;

use glam::DVec3;

use super::color::{ColorModel, distance};
use super::plane::Plane;

/// A bell curve: FLIP's a and b.
struct Bell {
    amplitude: f64,
    /// In degrees squared.
    spread: f64,
}

/// How far the eye's blur of each channel reaches: lightness is seen finest, blue against yellow coarsest, and that as a sum of two.
const LIGHTNESS: Bell = Bell { amplitude: 1.0, spread: 0.0047 };
const RED_GREEN: Bell = Bell { amplitude: 1.0, spread: 0.0053 };
const BLUE_YELLOW: [Bell; 2] = [Bell { amplitude: 34.1, spread: 0.04 }, Bell { amplitude: 13.5, spread: 0.025 }];

/// Distances count by this power.
const POWER: f64 = 0.7;
/// This share of the greatest distance ...
const KNEE: f64 = 0.4;
/// ... becomes this error: eyes hardly tell one huge difference from another.
const ERROR_AT_KNEE: f64 = 0.95;

/// For each pixel, 0 to 1: how different the colours look once fine grains are lost to the eye.
pub(super) fn color_differences(
    one: &[Plane; 3],
    other: &[Plane; 3],
    model: &ColorModel,
    pixels_per_degree: f64,
) -> Vec<f64> {
    let kernels = Kernels::new(pixels_per_degree);
    let seen = |channels| {
        let rgb =
            kernels.blurred(channels).into_iter().map(|opponent| model.rgb(opponent).clamp(DVec3::ZERO, DVec3::ONE));
        rgb.map(|rgb| model.seen(rgb)).collect::<Vec<_>>()
    };
    // Of all of sRGB's colours, green and blue are the farthest apart.
    let greatest = libm::pow(distance(model.seen(DVec3::Y), model.seen(DVec3::Z)), POWER);
    let pairs = seen(one).into_iter().zip(seen(other));
    pairs.map(|(one, other)| redistributed(libm::pow(distance(one, other), POWER) / greatest)).collect()
}

/// ```text
///      1 |             ____---
///   0.95 |         _/'
///        |     _/'
///        | _/'                     from shares of the greatest difference to errors
///      0 +----------+--------
///        0         0.4      1
/// ```
fn redistributed(share: f64) -> f64 {
    if share < KNEE {
        share * (ERROR_AT_KNEE / KNEE)
    } else {
        ERROR_AT_KNEE + (share - KNEE) / (1.0 - KNEE) * (1.0 - ERROR_AT_KNEE)
    }
}

/// The blur of each channel along one axis. The eye's is round, and a round Gaussian is a product of one along x and one along y.
struct Kernels {
    lightness: Vec<f64>,
    red_green: Vec<f64>,
    blue_yellow: [Vec<f64>; 2],
}

impl Kernels {
    fn new(pixels_per_degree: f64) -> Self {
        // Three standard deviations of the widest.
        let deviation = (BLUE_YELLOW[0].spread / (2.0 * PI * PI)).sqrt();
        let radius = (3.0 * deviation * pixels_per_degree).ceil() as i32;
        let sampled = |bell: &Bell| -> Vec<f64> {
            (-radius..=radius).map(|pixel| bell.along_an_axis(f64::from(pixel) / pixels_per_degree)).collect()
        };
        let mut kernels = Self {
            lightness: sampled(&LIGHTNESS),
            red_green: sampled(&RED_GREEN),
            blue_yellow: BLUE_YELLOW.each_ref().map(sampled),
        };
        // A grey picture must stay as it is: all products of weights for x and y sum to 1, for both bells together.
        let sum = |kernel: &[f64]| kernel.iter().sum::<f64>();
        let [first, second] = kernels.blue_yellow.each_ref().map(|kernel| sum(kernel));
        let total = (first * first + second * second).sqrt();
        kernels.blue_yellow.iter_mut().for_each(|kernel| scale(kernel, 1.0 / total));
        for kernel in [&mut kernels.lightness, &mut kernels.red_green] {
            let total = sum(kernel);
            scale(kernel, 1.0 / total);
        }
        kernels
    }

    fn blurred(&self, [lightness, red_green, blue_yellow]: &[Plane; 3]) -> Vec<DVec3> {
        let blur = |plane: &Plane, kernel: &Vec<f64>| plane.filtered(kernel, kernel).values;
        let lightness = blur(lightness, &self.lightness);
        let red_green = blur(red_green, &self.red_green);
        let [first, second] = self.blue_yellow.each_ref().map(|kernel| blur(blue_yellow, kernel));
        (0..lightness.len()).map(|i| DVec3::new(lightness[i], red_green[i], first[i] + second[i])).collect()
    }
}

fn scale(kernel: &mut [f64], factor: f64) {
    kernel.iter_mut().for_each(|weight| *weight *= factor);
}

impl Bell {
    /// The factor of an axis in a sqrt(pi / b) exp(-pi^2 (x^2 + y^2) / b), which is the inverse Fourier transform of the contrast that the eye
    /// lets through, a exp(-b f^2) at f cycles a degree: the root of the front, and the exponential at that place, in degrees.
    fn along_an_axis(&self, degrees: f64) -> f64 {
        (self.amplitude * (PI / self.spread).sqrt()).sqrt() * libm::exp(-PI * PI * degrees * degrees / self.spread)
    }
}
