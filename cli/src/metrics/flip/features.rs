//! FLIP's feature pipeline (section 4.2).

use std::f64::consts::FRAC_1_SQRT_2;

use super::plane::Plane;

/// The width of the edges that eyes look for, in degrees.
const EDGE_WIDTH: f64 = 0.082;

/// For each pixel, 0 to 1: by how much an edge or a point is stronger in one picture than in the other. From the channels Y.
pub(super) fn differences(one: &Plane, other: &Plane, pixels_per_degree: f64) -> Vec<f64> {
    let detectors = Detectors::new(pixels_per_degree);
    // Y on a scale of 0 to 1.
    let [one, other] = [one, other].map(|lightness| Plane {
        width: lightness.width,
        values: lightness.values.iter().map(|y| (y + 16.0) / 116.0).collect(),
    });
    let [edges, points] = [&detectors.slope, &detectors.curvature].map(|derivative| {
        let [one, other] = [&one, &other].map(|lightness| detectors.strength(lightness, derivative));
        one.into_iter().zip(other).map(|(one, other)| (one - other).abs()).collect::<Vec<_>>()
    });
    // A detector answers 1 at most along either axis, so sqrt(2) in all.
    edges.into_iter().zip(points).map(|(edge, point)| (FRAC_1_SQRT_2 * edge.max(point)).sqrt()).collect()
}

/// A Gaussian with its first two derivatives, as the eye's cells answer to edges and points.
struct Detectors {
    gaussian: Vec<f64>,
    slope: Vec<f64>,
    curvature: Vec<f64>,
}

impl Detectors {
    fn new(pixels_per_degree: f64) -> Self {
        let deviation = 0.5 * EDGE_WIDTH * pixels_per_degree;
        let radius = (3.0 * deviation).ceil() as i32;
        let sampled = |factor: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let places = (-radius..=radius).map(|pixel| f64::from(pixel) / deviation);
            balanced(places.map(|x| factor(x) * libm::exp(-0.5 * x * x)).collect())
        };
        Self { gaussian: sampled(&|_| 1.0), slope: sampled(&|x| -x), curvature: sampled(&|x| x * x - 1.0) }
    }

    /// How strongly each pixel answers: the length of the vector of the derivatives along x and y.
    fn strength(&self, lightness: &Plane, derivative: &[f64]) -> Vec<f64> {
        let along_x = lightness.filtered(derivative, &self.gaussian);
        let along_y = lightness.filtered(&self.gaussian, derivative);
        along_x.values.into_iter().zip(along_y.values).map(|(x, y)| (x * x + y * y).sqrt()).collect()
    }
}

/// The positive weights made to sum to 1, the negative ones to -1.
fn balanced(weights: Vec<f64>) -> Vec<f64> {
    let sum = |sign: f64| weights.iter().map(|weight| (sign * weight).max(0.0)).sum::<f64>();
    let (positive, negative) = (sum(1.0), sum(-1.0));
    weights.into_iter().map(|weight| weight / if weight > 0.0 { positive } else { negative }).collect()
}
