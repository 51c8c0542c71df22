//! The matrix that moves normals when a map moves points.
//!
//! The idea: a normal is perpendicular to what lies in the surface, and must be so afterwards. What turns and moves moves both alike; what
//! stretches does not.
//!
//! ```text
//!      \  n                    \  M n is not perpendicular any more
//!    \  \                    __ \                          (N n).(M t) = 0 for all t with n.t = 0:
//!      \ \     x: times 3      ''--__                      N is the inverse transpose of M, up to a factor
//!        \
//! ```
//!
//! **The contract** of [`crate::NormalMatrix`]: up to a *positive* factor, the inverse transpose of the map's linear part. Outward normals stay
//! outward where the map mirrors. It exists for maps that flatten space, too: of cofactors instead of an inverse.
//!
//! **The laws** stand below from the easiest on, each about a vector in a surface and its normal.
//!
//! **Literature.** Turkowski: Properties of Surface-Normal Transformations, Graphics Gems, 1990. Hughes et al.: Computer Graphics,
//! Principles and Practice, 3rd ed. 2013, section 11.2. Shirley, Marschner: Fundamentals of Computer Graphics, 5th ed. 2021, section 7.2.2.
//!
//! **Exercises.** 1. Pass the kit with `inverse().transpose()` as far as it goes. 2. Pass it all. 3. Beat the reference.
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`a_turn_turns_normals_as_points`] |
//! | the transpose | [`a_turn_turns_normals_as_points`] |
//! | the inverse instead of the inverse transpose | [`a_turn_turns_normals_as_points`] |
//! | the map itself | [`a_normal_stays_perpendicular_to_its_surface`] |
//! | cofactors without their sign under a mirror | [`a_mirror_keeps_normals_outward`] |
//! | an inverse that does not exist | [`a_map_that_flattens_space_has_normals`] |

use glam::{DMat3, DVec3};
use proptest::prelude::*;

use super::{Counterexample, Trial, Verdict, drawn_ellipsoids, frame, unit_vector};
use crate::{NormalMatrix, Transform};

/// The part: a plain function, the field `normal_matrix` of [`crate::Kernels`].
pub type Part = NormalMatrix;

/// A map that only turns and moves.
pub fn a_turn_turns_normals_as_points(part: &Part, trial: &Trial) -> Verdict {
    trial.search((frame(), unit_vector(), unit_vector()), |&(linear, translation, normal)| {
        let found = part(&Transform { linear, translation }) * normal;
        let expected = linear * normal;
        if (found.normalize_or_zero() - expected).length() < 1e-6 {
            return Ok(());
        }
        Err(Counterexample::new(format!("a vector along {expected:?}"), format!("{found:?}")))
    })
}

/// Stretched and sheared: what lies in the surface, and its normal.
pub fn a_normal_stays_perpendicular_to_its_surface(part: &Part, trial: &Trial) -> Verdict {
    let cases = (maps(), frame());
    trial.search(cases, |&(map, surface)| {
        let found = part(&map) * surface.z_axis;
        for along in [surface.x_axis, surface.y_axis] {
            let cosine = found.normalize_or_zero().dot(map.direction(along).normalize());
            if cosine.abs() >= 1e-6 || found == DVec3::ZERO {
                let expected = format!("perpendicular to {:?}, in the surface", map.direction(along));
                return Err(Counterexample::new(expected, format!("{found:?}")));
            }
        }
        Ok(())
    })
}

/// A normal points to the side that it pointed to: `N n` and `M n` are less than a right angle apart.
pub fn a_mirror_keeps_normals_outward(part: &Part, trial: &Trial) -> Verdict {
    trial.search((maps(), unit_vector()), |&(map, normal)| {
        let found = part(&map) * normal;
        if found.dot(map.direction(normal)) > 0.0 {
            return Ok(());
        }
        Err(Counterexample::new(format!("on the side of {:?}", map.direction(normal)), format!("{found:?}")))
    })
}

/// A drawing of a body on a wall has the wall's normal.
pub fn a_map_that_flattens_space_has_normals(part: &Part, trial: &Trial) -> Verdict {
    trial.search((frame(), frame(), 0.5..2.0_f64, 0.5..2.0_f64), |&(wall, turn, width, height)| {
        let linear = wall * DMat3::from_diagonal(DVec3::new(width, height, 0.0)) * turn.transpose();
        let found = part(&Transform { linear, translation: DVec3::ZERO }) * turn.z_axis;
        if found.normalize_or_zero().cross(wall.z_axis).length() < 1e-6 && found.is_finite() && found != DVec3::ZERO {
            return Ok(());
        }
        Err(Counterexample::new(format!("a vector along {:?}", wall.z_axis), format!("{found:?}")))
    })
}

crate::kit! { $crate
    /// Names the laws of a map of normals as tests of a [`crate::NormalMatrix`]: `geometry::normal_matrix_conformance!(my_matrix);`.
    normal_matrix_conformance, Part, normal_matrix;
    a_turn_turns_normals_as_points: "nothing is returned yet: of a turn, the map's own linear part will do; or it is inverted or transposed, but not both";
    a_normal_stays_perpendicular_to_its_surface: "normals are moved as points are; the inverse transpose keeps them perpendicular";
    a_mirror_keeps_normals_outward: "cofactors are the inverse transpose times the determinant, whose sign turns normals inward where it is negative";
    a_map_that_flattens_space_has_normals: "the inverse is asked for of a map that has none; its cofactors are always there";
}

/// Maps that turn, stretch, shear and mirror.
fn maps() -> impl Strategy<Value = Transform> {
    drawn_ellipsoids(2.0..3.0, 0.0..0.1).prop_map(|aimed| aimed.shape)
}
