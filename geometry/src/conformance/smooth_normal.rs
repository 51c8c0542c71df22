//! The normal to shade a triangle with, between those of its corners: a few triangles look round.
//!
//! The idea: the weighted mean of the corners' normals, which is shorter than they are, made a unit vector again.
//!
//! ```text
//!      \    |    /          a mean of unit vectors lies on the chord, not on the circle: without the last step a highlight
//!       a___x___b           is darkest in the middle of each triangle
//! ```
//!
//! **The contract** of [`crate::SmoothNormal`]: corners' normals of any length, the longer ones counting for more; a unit vector, or `None` where
//! nothing is left to give a direction.
//!
//! **The laws** stand below from the easiest on. The hard cases: normals that cancel, and a weight of 0 for the only one that is not zero.
//!
//! **Literature.** Phong: Illumination for Computer Generated Pictures, CACM, 1975. Gouraud: Continuous Shading of Curved Surfaces,
//! 1971. Max: Weights for Computing Vertex Normals from Facet Normals, Journal of Graphics Tools, 1999. Woo, Pearce, Ouellette: It's
//! Really Not a Rendering Bug, You See..., IEEE CG&A, 1996, on the shadow's edge that remains.
//!
//! **Exercises.** 1. Pass the kit. 2. Interpolate the angle instead of the chord; can you see it? 3. Beat the reference.
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`at_a_corner_it_points_as_the_corners`] |
//! | the corners one place on | [`at_a_corner_it_points_as_the_corners`] |
//! | the nearest corner's | [`between_the_corners_it_points_as_their_weighted_mean`] |
//! | not renormalised | [`it_is_a_unit_vector`] |
//! | renormalised by a rough root | [`it_is_a_unit_vector`] |
//! | NaN where normals cancel | [`where_normals_cancel_there_is_none`] |
//! | each corner normalised first | [`a_longer_normal_counts_for_more`] |

use glam::{DVec3, Vec3};
use proptest::prelude::*;

use super::{Counterexample, Trial, Verdict, magnitude, unit_vector};
use crate::SmoothNormal;

/// The part: a plain function, the field `smooth_normal` of [`crate::Kernels`].
pub type Part = SmoothNormal;

/// `u = v = 0` is the first corner, `u = 1` the second, `v = 1` the third.
pub fn at_a_corner_it_points_as_the_corners(part: &Part, trial: &Trial) -> Verdict {
    trial.search((normals(), 0..3_usize), |&(normals, corner)| {
        let [u, v] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]][corner];
        points_as_the_mean(part, normals, u, v, 1e-3)
    })
}

/// Between them each counts by its weight.
pub fn between_the_corners_it_points_as_their_weighted_mean(part: &Part, trial: &Trial) -> Verdict {
    trial.search((normals(), weights()), |&(normals, (u, v))| points_as_the_mean(part, normals, u, v, 1e-3))
}

/// Its length is 1, to two roundings.
pub fn it_is_a_unit_vector(part: &Part, trial: &Trial) -> Verdict {
    trial.search((normals(), weights()), |&(normals, (u, v))| match part(normals, u, v) {
        Some(found) if (found.as_dvec3().length() - 1.0).abs() > 2.0 * f64::from(f32::EPSILON) => {
            Err(Counterexample::new("a vector of length 1", format!("{found:?}, of length {}", found.length())))
        }
        _ => Ok(()),
    })
}

/// Where the mean is 0, there is no normal: the surface's own is taken.
pub fn where_normals_cancel_there_is_none(part: &Part, trial: &Trial) -> Verdict {
    trial.search((unit_vector(), 0..3_usize), |&(normal, kind)| {
        let normal = normal.as_vec3();
        let (normals, u, v) = [
            ([Vec3::ZERO; 3], 0.25, 0.5),
            ([normal, -normal, normal], 0.5, 0.0),
            ([Vec3::ZERO, normal, normal], 0.0, 0.0),
        ][kind];
        let found = part(normals, u, v);
        if found.is_none() {
            Ok(())
        } else {
            Err(Counterexample::new(format!("None of {normals:?}"), format!("{found:?}")))
        }
    })
}

/// Lengths are weights: what a mesh gives is not normalised before it is interpolated.
pub fn a_longer_normal_counts_for_more(part: &Part, trial: &Trial) -> Verdict {
    let long = (normals(), [magnitude(0.1, 10.0), magnitude(0.1, 10.0), magnitude(0.1, 10.0)], weights());
    trial.search(long, |&(normals, lengths, (u, v))| {
        let mut normals = normals;
        normals.iter_mut().zip(lengths).for_each(|(normal, length)| *normal *= length as f32);
        points_as_the_mean(part, normals, u, v, 1e-3)
    })
}

/// To two roundings.
pub fn it_points_as_the_exact_mean(part: &Part, trial: &Trial) -> Verdict {
    trial.times(4).search((normals(), weights()), |&(normals, (u, v))| {
        points_as_the_mean(part, normals, u, v, 2.0 * f64::from(f32::EPSILON))
    })
}

crate::kit! { $crate
    /// Names the laws of a smooth normal as tests of a [`crate::SmoothNormal`]: `geometry::smooth_normal_conformance!(my_normal);`.
    smooth_normal_conformance, Part, smooth_normal;
    at_a_corner_it_points_as_the_corners: "nothing is returned yet: (1 - u - v) of the first normal, u of the second, v of the third; or a weight goes to another corner";
    between_the_corners_it_points_as_their_weighted_mean: "the normals are not interpolated: one corner's is taken for all";
    it_is_a_unit_vector: "the mean is not made a unit vector again";
    where_normals_cancel_there_is_none: "the mean is divided by its length although that is 0";
    a_longer_normal_counts_for_more: "each normal is made a unit vector before the mean is taken";
    it_points_as_the_exact_mean: "a step that cancels is taken in f32";
}

/// Unit vectors less than about a right angle apart.
fn normals() -> impl Strategy<Value = [Vec3; 3]> {
    let off = || [-0.5..0.5_f64, -0.5..0.5, -0.5..0.5].prop_map(DVec3::from);
    (unit_vector(), [off(), off(), off()])
        .prop_map(|(normal, offs)| offs.map(|off| (normal + off).normalize().as_vec3()))
}

fn weights() -> impl Strategy<Value = (f32, f32)> {
    (0.0_f32..1.0, 0.0_f32..1.0).prop_map(|(a, v)| (a * (1.0 - v), v))
}

fn points_as_the_mean(part: &Part, normals: [Vec3; 3], u: f32, v: f32, tolerance: f64) -> Verdict {
    let found = part(normals, u, v);
    let [a, b, c] = normals.map(|normal| normal.as_dvec3());
    let (u, v) = (f64::from(u), f64::from(v));
    let mean = (a * (1.0 - u - v) + b * u + c * v).normalize();
    if found.is_some_and(|found| (found.as_dvec3().normalize_or_zero() - mean).length() <= tolerance) {
        return Ok(());
    }
    Err(Counterexample::new(format!("{mean:?}, to {tolerance:e}"), format!("{found:?}")))
}
