use glam::Vec3;
use proptest::prelude::*;
use shading::{
    conformance::{Arriving, arriving, nearly_critical},
    optics::{border, reflect},
};

use crate::exact::{Real, SINGLE, Vector, approximate, real};
use geometry::conformance::{times, unit_vector};

/// What a unit vector's rounding is worth as an angle: half an ulp below 1 in each of three coordinates, u sqrt(3) / 2.
const ROUNDING: f64 = 0.87 * SINGLE;

/// The exact cosine of the way in, the square of the cosine of the way out, and the refracted direction.
fn exact_refraction(arriving: &Arriving) -> (Real, Real, Vector) {
    let (d, n) = (Vector::unit(arriving.direction), Vector::unit(arriving.normal));
    let eta = real(arriving.eta);
    let cos_in = -d.dot(&n);
    let cos_out_squared = real(1.0) - &eta * &eta * (real(1.0) - &cos_in * &cos_in);
    let cos_out = if cos_out_squared > Real::ZERO { cos_out_squared.sqrt() } else { Real::ZERO };
    let refracted = d.times(&eta).plus(&n.times(&(eta * &cos_in - cos_out)));
    (cos_in, cos_out_squared, refracted)
}

/// Fresnel's share for unpolarised light.
fn exact_reflectance(eta: f32, cos_in: &Real, cos_out: &Real) -> Real {
    let eta = real(eta);
    let share = |a: &Real, b: &Real| {
        let ratio = (a - b) / (a + b);
        &ratio * &ratio
    };
    (share(&(&eta * cos_in), cos_out) + share(&(&eta * cos_out), cos_in)) / real(2.0)
}

fn refraction_is_right(arriving: &Arriving) -> Result<(), TestCaseError> {
    let (cos_in, cos_out_squared, refracted) = exact_refraction(arriving);
    // Flatter than that, f64 does not know the side that the ray comes from, nor nearer to the critical angle whether it gets out.
    prop_assume!(cos_in > real(f64::exp2(-50.0)));
    let steepest = f64::from(arriving.eta * arriving.eta).max(1.0);
    prop_assume!(approximate(&cos_out_squared).abs() > f64::exp2(-50.0) * steepest);
    let border = border(arriving.direction, arriving.normal, arriving.eta);
    prop_assert_eq!(border.refracted.is_some(), cos_out_squared > Real::ZERO);
    let Some(claim) = border.refracted else {
        prop_assert_eq!(border.reflectance, 1.0);
        return Ok(());
    };
    let cos_out = cos_out_squared.sqrt();
    let seen_by_f64 = f64::exp2(-49.0) * steepest / approximate(&cos_out);
    let angle = refracted.distance(claim);
    prop_assert!(angle <= ROUNDING + seen_by_f64, "off by {} u", angle / SINGLE);
    prop_assert!(angle <= 8.0 * SINGLE / approximate(&cos_out));
    let truth = exact_reflectance(arriving.eta, &cos_in, &cos_out);
    let off = approximate(&(real(border.reflectance) - truth)).abs();
    let seen_by_f64 = seen_by_f64 * 8.0 / approximate(&cos_in);
    prop_assert!(off <= 0.51 * SINGLE + seen_by_f64, "{} is off by {} u", border.reflectance, off / SINGLE);
    Ok(())
}

proptest! {
    #![proptest_config(times(16))]

    #[test]
    fn a_refracted_direction_and_its_share_are_exact_to_a_rounding(arriving in arriving()) {
        refraction_is_right(&arriving)?;
    }

    #[test]
    fn within_eight_roundings_of_the_critical_angle_they_are_as_exact_as_f64_sees(arriving in nearly_critical()) {
        refraction_is_right(&arriving)?;
    }

    #[test]
    fn a_mirrored_direction_is_exact_to_a_rounding(arriving in arriving(), back in any::<bool>()) {
        let (direction, normal) = (arriving.direction, if back { -arriving.normal } else { arriving.normal });
        let (d, n) = (Vector::unit(direction), Vector::unit(normal));
        let mirrored = d.plus(&n.times(&(real(-2.0) * d.dot(&n))));
        let angle = mirrored.distance(reflect(direction, normal));
        prop_assert!(angle <= ROUNDING + f64::exp2(-50.0), "off by {} u", angle / SINGLE);
    }

    #[test]
    fn no_more_is_reflected_than_arrives(direction in unit_vector(), normal in unit_vector(), eta in 0.1_f32..10.0) {
        let border = border(direction.as_vec3(), normal.as_vec3(), eta);
        prop_assert!((0.0..=1.0).contains(&border.reflectance));
        prop_assert!(border.refracted.is_none_or(|refracted: Vec3| refracted.is_normalized()));
    }
}
