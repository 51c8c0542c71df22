//! The texture coordinates of a triangle between those of its corners.
//!
//! The idea: the weighted mean of the three corners', by the same weights that the hit has brought.
//!
//! ```text
//!            c  v = 1, the rest 0
//!           / \               uv = (1 - u - v) uv_a + u uv_b + v uv_c
//!          / x \
//!         a-----b  u = 1      the weights are areas over the whole: Möbius 1827
//! ```
//!
//! **The contract** of [`crate::TriangleUv`]: of the corners' coordinates, any numbers, the mean by the barycentric weights `u` and `v` of the
//! second and third corner. It is not wrapped or cut: a corner at 3.5 repeats the picture, and its texture sees to that.
//!
//! **The laws** stand below from the easiest on. The hard case: coordinates a million copies out, with triangles a texel large.
//!
//! **Literature.** Möbius: Der barycentrische Calcul, 1827. Shirley, Marschner: Fundamentals of Computer Graphics, 5th ed. 2021,
//! sections 2.9 and 11. Heckbert, Moreton: Interpolation for Polygon Texture Mapping and Shading, 1991, on why a rasteriser
//! needs a division where a ray tracer needs none.
//!
//! **Exercises.** 1. Pass the kit. 2. Give a quad of two triangles a picture whose seam does not bend at the diagonal. 3. Beat the
//! reference: in `f32`, and no law broken.
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`at_a_corner_it_is_the_corners`] |
//! | the corners one place on | [`at_a_corner_it_is_the_corners`] |
//! | u and v swapped | [`at_a_corner_it_is_the_corners`] |
//! | the weights themselves | [`at_a_corner_it_is_the_corners`] |
//! | v flipped | [`at_a_corner_it_is_the_corners`] |
//! | the nearest corner's | [`between_the_corners_it_is_their_weighted_mean`] |
//! | wrapped before the mean | [`coordinates_beyond_the_texture_are_kept`] |
//! | cut to the texture | [`coordinates_beyond_the_texture_are_kept`] |
//! | all in f32 | [`coordinates_are_the_exact_mean_to_a_rounding`] |

use glam::{DVec2, Vec2};
use proptest::prelude::*;

use super::{Counterexample, Trial, Verdict};
use crate::TriangleUv;

/// The part: a plain function, the field `triangle_uv` of [`crate::Kernels`].
pub type Part = TriangleUv;

/// `u = v = 0` is the first corner, `u = 1` the second, `v = 1` the third.
pub fn at_a_corner_it_is_the_corners(part: &Part, trial: &Trial) -> Verdict {
    trial.search((corners(0.05..0.95), 0..3_usize), |&(corners, corner)| {
        let [u, v] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]][corner];
        is_mean(part, corners, u, v, 1e-3)
    })
}

/// Between them each counts by its weight.
pub fn between_the_corners_it_is_their_weighted_mean(part: &Part, trial: &Trial) -> Verdict {
    trial.search((corners(0.05..0.95), weights()), |&(corners, (u, v))| is_mean(part, corners, u, v, 1e-3))
}

/// Coordinates below 0 and above 1 stay what they are.
pub fn coordinates_beyond_the_texture_are_kept(part: &Part, trial: &Trial) -> Verdict {
    trial.search((corners(-8.0..8.0), weights()), |&(corners, (u, v))| is_mean(part, corners, u, v, 1e-3))
}

/// To an ulp of the greatest of them, a million copies out as well.
pub fn coordinates_are_the_exact_mean_to_a_rounding(part: &Part, trial: &Trial) -> Verdict {
    let far = (corners(-1.0..1.0), [-1e6..1e6_f32, -1e6..1e6].prop_map(Vec2::from), weights());
    trial.times(4).search(far, |&(corners, far, (u, v))| {
        let corners = corners.map(|corner| corner + far);
        let greatest = corners.into_iter().fold(0.0, |greatest: f32, corner| greatest.max(corner.abs().max_element()));
        is_mean(part, corners, u, v, 0.51 * f64::from(f32::EPSILON) * f64::from(greatest))
    })
}

crate::kit! { $crate
    /// Names the laws of a triangle's texture coordinates as tests of a [`crate::TriangleUv`]: `geometry::triangle_uv_conformance!(my_uv);`.
    triangle_uv_conformance, Part, triangle_uv;
    at_a_corner_it_is_the_corners: "nothing is returned yet: (1 - u - v) of the first corner's, u of the second's, v of the third's; or a weight goes to another corner";
    between_the_corners_it_is_their_weighted_mean: "the coordinates are not interpolated: one corner's are taken for all";
    coordinates_beyond_the_texture_are_kept: "the coordinates are wrapped or cut here, where only the texture may do so: a triangle across an edge of the picture shows all of it, squeezed";
    coordinates_are_the_exact_mean_to_a_rounding: "the mean is taken in f32, with a rounding in each step";
}

fn corners(range: std::ops::Range<f32>) -> impl Strategy<Value = [Vec2; 3]> {
    let corner = move || [range.clone(), range.clone()].prop_map(Vec2::from);
    [corner(), corner(), corner()]
}

fn weights() -> impl Strategy<Value = (f32, f32)> {
    (0.0_f32..1.0, 0.0_f32..1.0).prop_map(|(a, v)| (a * (1.0 - v), v))
}

fn is_mean(part: &Part, corners: [Vec2; 3], u: f32, v: f32, tolerance: f64) -> Verdict {
    let found = part(corners, u, v);
    let [a, b, c]: [DVec2; 3] = corners.map(|corner| corner.as_dvec2());
    let (u, v) = (f64::from(u), f64::from(v));
    let mean = a * (1.0 - u - v) + b * u + c * v;
    // f64's own roundings are 2^29 times smaller than what is allowed.
    if (found.as_dvec2() - mean).abs().max_element() <= tolerance {
        return Ok(());
    }
    Err(Counterexample::new(format!("{mean:?}, to {tolerance:e}"), format!("{found:?}")))
}
