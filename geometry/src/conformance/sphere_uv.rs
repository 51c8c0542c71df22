//! The texture coordinates of a sphere: where a direction from its centre falls in a picture that is wrapped around it.
//!
//! The idea: longitude and latitude, as on a globe whose axis is z. `u` runs once around from +x over +y, `v` from pole to pole.
//!
//! ```text
//!            z                 u = atan2(y, x) / 2 pi         in 0..1, the seam at +x
//!            |  /p             v = angle from z / pi          0 at +z, 1 at -z
//!            | /
//!            |/___ y           0      1/4     1/2     3/4     1
//!            /                 +x     +y      -x      -y      +x
//!           x
//! ```
//!
//! **The contract** of [`crate::SphereUv`]: of a direction of any length but 0, `u` in `0..1` and never 1, `v` in `0..=1`. An ellipsoid
//! asks for the direction in the space in which it is the unit sphere.
//!
//! **The laws** stand below from the easiest on. The hard cases: the seam, on which a tiny negative angle must not become 1; the poles, where
//! `acos` loses half of the digits. What they are held against are angles of 256 bits.
//!
//! **Literature.** Blinn, Newell: Texture and Reflection in Computer Generated Images, CACM, 1976. Snyder: Map Projections, A
//! Working Manual, USGS, 1987, section 12, on this projection. Kahan: How Futile are Mindless Assessments of Roundoff, 2006, section
//! 12, on angles. Pharr, Jakob, Humphreys: Physically Based Rendering, 4th ed. 2023, section 6.2.3.
//!
//! **Exercises.** 1. Pass the kit up to `the_directions_length_does_not_matter`. 2. Pass it all. 3. The texels at the poles are squeezed:
//! map with equal areas instead (`v = (1 - z) / 2`); which laws does it break? 4. Beat the reference: an `atan2` of your own.
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`u_runs_around_from_x_over_y`] |
//! | u mirrored | [`u_runs_around_from_x_over_y`] |
//! | u begins on the other side | [`u_runs_around_from_x_over_y`] |
//! | y is up | [`u_runs_around_from_x_over_y`] |
//! | negative angles are left negative | [`u_runs_around_from_x_over_y`] |
//! | v flipped | [`v_runs_from_the_pole_above_to_the_one_below`] |
//! | v is the height | [`v_runs_from_the_pole_above_to_the_one_below`] |
//! | the direction is taken for a unit vector | [`the_directions_length_does_not_matter`] |
//! | u of the seam is 1 | [`coordinates_lie_in_the_texture`] |
//! | acos for v | [`v_keeps_its_digits_near_the_poles`] |
//! | an angle in f32 | [`coordinates_are_the_exact_ones_to_a_rounding`] |

use glam::{DVec3, Vec2};
use proptest::prelude::*;

use super::exact::{Real, SINGLE, Vector, apart_on_circle, exact, pi, real};
use super::{Counterexample, Trial, Verdict, magnitude, unit_vector};
use crate::SphereUv;

/// The part: a plain function, the field `sphere_uv` of [`crate::Kernels`].
pub type Part = SphereUv;

/// `u`, to three digits, away from the poles.
pub fn u_runs_around_from_x_over_y(part: &Part, trial: &Trial) -> Verdict {
    trial.search((0.0..0.999_f64, -0.8..0.8_f64), |&(u, z)| {
        let (sin, cos) = libm::sincos(u * std::f64::consts::TAU);
        let direction = DVec3::new(cos, sin, 0.0) * (1.0 - z * z).sqrt() + DVec3::Z * z;
        let found = part(direction);
        // The seam is a law of its own.
        if (f64::from(found.x) - u).abs() < DRAWN || (u < DRAWN && apart_on_circle(found.x, &real(&exact(u))) < DRAWN) {
            return Ok(());
        }
        Err(Counterexample::new(format!("u = {u} of {direction:?}"), format!("{found:?}")))
    })
}

/// `v`, to three digits.
pub fn v_runs_from_the_pole_above_to_the_one_below(part: &Part, trial: &Trial) -> Verdict {
    trial.search((0.0..1.0_f64, 0.0..6.3_f64), |&(v, around)| {
        let (sin, cos) = libm::sincos(v * std::f64::consts::PI);
        let (y, x) = libm::sincos(around);
        let direction = DVec3::new(x, y, 0.0) * sin + DVec3::Z * cos;
        let found = part(direction);
        if (f64::from(found.y) - v).abs() < DRAWN {
            return Ok(());
        }
        Err(Counterexample::new(format!("v = {v} of {direction:?}"), format!("{found:?}")))
    })
}

/// The same for twice the direction, and a thousandth of it.
pub fn the_directions_length_does_not_matter(part: &Part, trial: &Trial) -> Verdict {
    trial.search((unit_vector(), magnitude(1e-3, 1e3)), |&(direction, length)| {
        let (expected, found) = (part(direction), part(direction * length));
        if (expected.y - found.y).abs() < DRAWN as f32 && apart_on_circle(found.x, &real(&exact(expected.x))) < DRAWN {
            return Ok(());
        }
        let expected = format!("{expected:?} of {:?}, as of {direction:?}", direction * length);
        Err(Counterexample::new(expected, format!("{found:?}")))
    })
}

/// `0 <= u < 1` and `0 <= v <= 1`, at the seam and the poles as well.
pub fn coordinates_lie_in_the_texture(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(directions(), |&direction| {
        let found = part(direction);
        if (0.0..1.0).contains(&found.x) && (0.0..=1.0).contains(&found.y) {
            return Ok(());
        }
        Err(Counterexample::new("0 <= u < 1 and 0 <= v <= 1", format!("{found:?}")))
    })
}

/// Close to z or -z, `v` grows as the distance from the axis; `acos` sees nothing of that below 1e-8, and little above.
pub fn v_keeps_its_digits_near_the_poles(part: &Part, trial: &Trial) -> Verdict {
    trial.search((magnitude(1e-9, 1e-5), 0.0..6.3_f64), |&(off, around)| {
        let (y, x) = libm::sincos(around);
        let direction = DVec3::new(x * off, y * off, 1.0);
        let (found, v) = (part(direction), off / std::f64::consts::PI);
        if (f64::from(found.y) - v).abs() < DRAWN * v {
            return Ok(());
        }
        Err(Counterexample::new(format!("v = {v:e} of {direction:?}"), format!("{found:?}")))
    })
}

/// To half an ulp of 1, and near a pole as exactly as the direction itself is known there.
pub fn coordinates_are_the_exact_ones_to_a_rounding(part: &Part, trial: &Trial) -> Verdict {
    trial.times(4).search(directions(), |&direction| {
        let exact = exact_sphere_uv(&direction.into());
        are_those(part(direction), &exact, 4.0 * f64::EPSILON)
    })
}

crate::kit! { $crate
    /// Names the laws of a sphere's texture coordinates as tests of a [`crate::SphereUv`]: `geometry::sphere_uv_conformance!(my_uv);`.
    sphere_uv_conformance, Part, sphere_uv;
    u_runs_around_from_x_over_y: "nothing is returned yet: u = atan2(y, x) / 2 pi, and one more where that is negative; or x and y are swapped, or the angle runs the other way";
    v_runs_from_the_pole_above_to_the_one_below: "v is counted from the bottom, or is the height z instead of the angle from the axis";
    the_directions_length_does_not_matter: "the direction is taken for a unit vector, by acos(z) or asin(y)";
    coordinates_lie_in_the_texture: "a tiny negative angle and one more is 1 when rounded, and 1 is 0 of the next copy";
    v_keeps_its_digits_near_the_poles: "v is made by acos, which loses half of the digits where its argument is nearly 1; atan2 does not";
    coordinates_are_the_exact_ones_to_a_rounding: "an angle is computed in f32";
}

/// What laws about easy cases ask of a coordinate: three digits.
const DRAWN: f64 = 1e-3;

/// Half a unit in the last place of the `f32` below 1: what rounding a coordinate costs.
pub const ROUNDING: f64 = 0.51 * SINGLE;

/// Everywhere, along the axes, at the seam and at the poles, by 1e-12 and more.
fn directions() -> impl Strategy<Value = DVec3> {
    let tiny = || (magnitude(1e-12, 1e-2), any::<bool>()).prop_map(|(off, back)| if back { -off } else { off });
    let seam = (tiny(), -1.0..1.0_f64).prop_map(|(y, z)| DVec3::new(1.0, y, z));
    let pole =
        (tiny(), tiny(), any::<bool>()).prop_map(|(x, y, below)| DVec3::new(x, y, if below { -1.0 } else { 1.0 }));
    prop_oneof![2 => unit_vector(), 1 => seam, 1 => pole]
}

/// `u` and `v` of a direction: u around z from +x over +y, v from +z down.
pub fn exact_sphere_uv(direction: &Vector) -> [Real; 2] {
    real_sphere_uv(direction.0.each_ref().map(real))
}

/// The same of a direction of 256 bits.
pub fn real_sphere_uv([x, y, z]: [Real; 3]) -> [Real; 2] {
    let angle = |y: &Real, x: &Real| if *y == Real::ZERO && *x == Real::ZERO { Real::ZERO } else { y.atan2(x) };
    let width = (&x * &x + &y * &y).sqrt();
    [angle(&y, &x) / (pi() + pi()), angle(&width, &z) / pi()]
}

/// The coordinates are the exact ones rounded, and what the point is off, in radii: around the axis the more, the nearer to it.
///
/// # Errors
///
/// If they are not.
pub fn are_those(found: Vec2, [u, v]: &[Real; 2], off: f64) -> Verdict {
    let nearest_pole = libm::sin(std::f64::consts::PI * v.to_f64().value());
    let around = apart_on_circle(found.x, u);
    let along = (real(&exact(found.y)) - v).to_f64().value().abs();
    if around <= ROUNDING + off / nearest_pole && along <= ROUNDING + off {
        return Ok(());
    }
    let expected = format!("u = {}, v = {}", u.to_f64().value(), v.to_f64().value());
    Err(Counterexample::new(expected, format!("{found:?}, off by {around:e} and {along:e}")))
}
