//! The texture coordinates of a plane: a picture laid on it, again and again.
//!
//! The idea: two vectors, [`crate::Plane::gradients`], say by how much `u` and `v` grow along each axis. A place's products with them are
//! how many copies of the picture lie between the plane's own point and the place; what is behind the point counts backwards.
//!
//! ```text
//!     |  copy  |  copy  |           u = g_u . offset,  without its whole part
//!   --+--------+--------+--
//!     |        | x      |           1.2 is 0.2, and -0.2 is 0.8: the picture does not turn round at 0
//!   --+--------a--------+--
//! ```
//!
//! **The contract** of [`crate::PlaneUv`]: of an offset from [`crate::Plane::point`], however far, `u` and `v` in `0..1` and never 1.
//!
//! **The laws** stand below from the easiest on. The hard cases: negative offsets (a fraction that keeps its sign mirrors the picture); a tiny
//! negative one, which is 1 when rounded; a million copies out, where the whole part has eaten the digits of an `f32`.
//! What they are held against are rational numbers, and roots of 256 bits.
//!
//! **Literature.** Heckbert: Survey of Texture Mapping, IEEE CG&A, 1986. Knuth: The Art of Computer Programming, volume 1, section 1.2.4,
//! on `x mod 1`. Pharr, Jakob, Humphreys: Physically Based Rendering, 4th ed. 2023, section 10.2.4 on planar mapping.
//!
//! **Exercises.** 1. Pass the kit up to `the_texture_repeats_backwards_too`. 2. Pass it all. 3. Mirror every other copy, so that no seam
//! shows; which laws does it break? 4. Beat the reference: is there a fraction without a branch that is never 1?
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`the_first_copy_begins_at_the_planes_point`] |
//! | u and v swapped | [`the_first_copy_begins_at_the_planes_point`] |
//! | v flipped | [`the_first_copy_begins_at_the_planes_point`] |
//! | the texture is not repeated | [`the_texture_repeats`] |
//! | the texture ends at its edge | [`the_texture_repeats`] |
//! | mirrored behind the point | [`the_texture_repeats_backwards_too`] |
//! | a fraction that keeps its sign | [`the_texture_repeats_backwards_too`] |
//! | a tiny negative fraction is 1 | [`coordinates_lie_in_the_texture`] |
//! | narrowed before the whole part is taken off | [`far_out_the_digits_are_kept`] |

use glam::{DVec3, Vec2};
use proptest::prelude::*;

use super::exact::{DOUBLE, Exact, Real, Vector, apart_on_circle, exact, real};
use super::plane::point_and_normal;
use super::sphere_uv::ROUNDING;
use super::{Counterexample, PlaneGiven, Trial, Verdict, drawn_planes, magnitude, planes};
use crate::{PLANE_TEXTURE_SIZE, PlaneUv};

/// The part: a plain function, the field `plane_uv` of [`crate::Kernels`].
pub type Part = PlaneUv;

/// Inside the first copy `u` and `v` are the shares of the two edges, to three digits.
pub fn the_first_copy_begins_at_the_planes_point(part: &Part, trial: &Trial) -> Verdict {
    trial.search((given(), 0.01..0.99_f64, 0.01..0.99_f64), |(given, u, v)| at(part, given, [*u, *v]))
}

/// Ahead of the point it is repeated.
pub fn the_texture_repeats(part: &Part, trial: &Trial) -> Verdict {
    trial.search((given(), 0.01..0.99_f64, 0.01..0.99_f64, 0..9_u8, 0..9_u8), |&(given, u, v, right, up)| {
        at(part, &given, [u + f64::from(right), v + f64::from(up)])
    })
}

/// Behind the point it is repeated in the same direction.
pub fn the_texture_repeats_backwards_too(part: &Part, trial: &Trial) -> Verdict {
    trial.search((given(), 0.01..0.99_f64, 0.01..0.99_f64, 0..9_u8, 0..9_u8), |&(given, u, v, left, down)| {
        at(part, &given, [u - f64::from(left), v - f64::from(down)])
    })
}

/// `0 <= u < 1` and `0 <= v < 1`, hardly before an edge as well.
pub fn coordinates_lie_in_the_texture(part: &Part, trial: &Trial) -> Verdict {
    let off = || prop_oneof![magnitude(1e-20, 1e3), magnitude(1e-20, 1e-3).prop_map(|off| -off)];
    trial.times(4).search((given(), off(), off()), |&(given, u, v)| {
        let Some(plane) = given.plane() else { return Ok(()) };
        let found = part(&plane, offset(&given, [u, v]));
        if (0.0..1.0).contains(&found.x) && (0.0..1.0).contains(&found.y) {
            return Ok(());
        }
        Err(Counterexample::new("0 <= u < 1 and 0 <= v < 1", format!("{found:?}")))
    })
}

/// A million copies out, five digits.
pub fn far_out_the_digits_are_kept(part: &Part, trial: &Trial) -> Verdict {
    let copies =
        || (100_000..1_000_000_i32, any::<bool>()).prop_map(|(copies, back)| if back { -copies } else { copies });
    trial.search((given(), 0.01..0.99_f64, 0.01..0.99_f64, copies(), copies()), |&(given, u, v, right, up)| {
        at_to(part, &given, [u + f64::from(right), v + f64::from(up)], 1e-5)
    })
}

/// To half an ulp of 1, and what `f64` loses of the offset and of edges that are nearly parallel.
pub fn coordinates_are_the_exact_ones_to_a_rounding(part: &Part, trial: &Trial) -> Verdict {
    trial.times(4).search((planes(), -1e3..1e3_f64, -1e3..1e3_f64), |&(aimed, u, v)| {
        let given = aimed.shape;
        let Some(plane) = given.plane() else { return Ok(()) };
        let offset = offset(&given, [u, v]);
        are_exact(part(&plane, offset), &given, &offset.into(), 0.0)
    })
}

crate::kit! { $crate
    /// Names the laws of a plane's texture coordinates as tests of a [`crate::PlaneUv`]: `geometry::plane_uv_conformance!(my_uv);`.
    plane_uv_conformance, Part, plane_uv;
    the_first_copy_begins_at_the_planes_point: "nothing is returned yet: u is the product of the first gradient and the offset, v of the second; or one is counted from the other edge";
    the_texture_repeats: "the whole part is not taken off, or what is beyond the edge is cut to it";
    the_texture_repeats_backwards_too: "a negative coordinate's fraction is negative (x - trunc(x)), or its absolute value is taken: floor it is";
    coordinates_lie_in_the_texture: "a tiny negative number less its floor is 1 when rounded, and 1 is 0 of the next copy";
    far_out_the_digits_are_kept: "the product is narrowed to f32 before the whole part is taken off";
    coordinates_are_the_exact_ones_to_a_rounding: "the product is taken in f32";
}

/// What laws about easy cases ask of a coordinate: three digits.
const DRAWN: f64 = 1e-3;

fn given() -> impl Strategy<Value = PlaneGiven> {
    drawn_planes(0.5..1.0, 1.0..2.0, 1.0).prop_map(|aimed| aimed.shape)
}

/// The offset to a place so many copies from the plane's point.
fn offset(given: &PlaneGiven, [u, v]: [f64; 2]) -> DVec3 {
    let Some(plane) = given.plane() else { return DVec3::ZERO };
    let [along_u, along_v] = plane.gradients();
    // The edges are the gradients' dual basis in the plane.
    let cross = along_u.cross(along_v);
    let length_squared = cross.length_squared();
    (along_v.cross(cross) * u + cross.cross(along_u) * v) / length_squared
}

fn at(part: &Part, given: &PlaneGiven, copies: [f64; 2]) -> Verdict {
    at_to(part, given, copies, DRAWN)
}

fn at_to(part: &Part, given: &PlaneGiven, copies: [f64; 2], tolerance: f64) -> Verdict {
    let Some(plane) = given.plane() else { return Ok(()) };
    let offset = offset(given, copies);
    let found = part(&plane, offset);
    let expected = copies.map(|copies| copies - copies.floor());
    let off = |found: f32, expected: f64| (f64::from(found) - expected).abs();
    if off(found.x, expected[0]) < tolerance && off(found.y, expected[1]) < tolerance {
        return Ok(());
    }
    let expected = format!("u = {}, v = {} at the offset {offset:?}, to {tolerance:e}", expected[0], expected[1]);
    Err(Counterexample::new(expected, format!("{found:?}")))
}

/// The coordinates of an offset that is known to `error`.
///
/// # Errors
///
/// If they are others.
pub fn are_exact(found: Vec2, given: &PlaneGiven, offset: &Vector, error: f64) -> Verdict {
    for (gradient, coordinate) in gradients(given).into_iter().zip(found.to_array()) {
        let [x, y, z] = [0, 1, 2].map(|axis| &gradient[axis] * real(&offset.0[axis]));
        let truth = x + y + z;
        let steepness = DVec3::from(gradient.each_ref().map(|x| x.to_f64().value())).length();
        let error = 16.0 * DOUBLE * (error + offset.approximate().length()) * steepness * shear(given);
        let off = apart_on_circle(coordinate, &truth);
        if off > ROUNDING + error {
            let expected = format!("{}, without its whole part", truth.to_f64().value());
            return Err(Counterexample::new(expected, format!("{coordinate}, off by {off:e}")));
        }
    }
    Ok(())
}

/// What `u` and `v` grow by along each axis.
fn gradients(plane: &PlaneGiven) -> [[Real; 3]; 2] {
    match *plane {
        PlaneGiven::ByNormal { normal, .. } => {
            let n = Vector::from(normal);
            let is_floor = normal.y.abs() > normal.x.abs().max(normal.z.abs());
            let up = if is_floor { -DVec3::Z * f64::from(normal.y.signum()) } else { DVec3::Y };
            // v = up less its part along n, u = v x n; both of length 1, over the texture's size.
            let squared = n.dot(&n);
            let share = n.dot(&up.into()) / squared;
            let v = Vector::from(up).minus(&Vector(n.0.clone().map(|x| x * &share)));
            let size = |v: &Vector| real(&v.dot(v)).sqrt() * real(&exact(PLANE_TEXTURE_SIZE));
            [v.cross(&n), v].map(|v| v.0.each_ref().map(|x: &Exact| real(x) / size(&v)))
        }
        PlaneGiven::ByPoints { .. } => {
            let [u, v] = edges(plane);
            let (_, cross) = point_and_normal(plane);
            let squared = real(&cross.dot(&cross));
            [v.cross(&cross), cross.cross(&u)].map(|v| v.0.map(|x| real(&x) / &squared))
        }
    }
}

fn edges(plane: &PlaneGiven) -> [Vector; 2] {
    match *plane {
        PlaneGiven::ByNormal { .. } => [DVec3::X, DVec3::Y].map(Vector::from),
        PlaneGiven::ByPoints { point, along_u, along_v } => {
            [along_u, along_v].map(|end| Vector::from(end).minus(&point.into()))
        }
    }
}

/// How much the edges of a plane by three points cancel in its normal: one over the sine between them.
fn shear(plane: &PlaneGiven) -> f64 {
    let [u, v] = edges(plane).map(|edge| edge.approximate());
    u.length() * v.length() / u.cross(v).length()
}
