use geometry::conformance::times;
use proptest::prelude::*;
use shading::{
    conformance::{absorbed, lit_from},
    linear_falloff, logarithmic_falloff,
    sunflow::inverse_square_falloff,
};

use crate::exact::{Real, approximate, is_right, pi, real};

proptest! {
    #![proptest_config(times(16))]

    /// 3/4 u: half an ulp of the quotient below 1/2, and of the difference below 1.
    #[test]
    fn linear_falloff_is_exact_to_4_5e_8((distance, power) in lit_from()) {
        let truth = (real(1.0) - real(distance) / real(power)).max(Real::ZERO);
        let off = approximate(&(real(linear_falloff(distance, power)) - truth)).abs();
        prop_assert!(off <= 4.5e-8, "off by {}", off);
    }

    #[test]
    fn logarithmic_falloff_is_exact_to_half_an_ulp((distance, power) in lit_from()) {
        let truth = real(power) / (real(distance).ln_1p() + real(1.0));
        is_right(logarithmic_falloff(distance, power), &truth)?;
    }

    #[test]
    fn inverse_square_falloff_is_exact_to_half_an_ulp((distance, power) in lit_from()) {
        prop_assume!(distance > 0.0);
        let truth = real(power) / (real(4.0) * pi() * real(distance) * real(distance));
        is_right(inverse_square_falloff(distance, power), &truth)?;
    }

    #[test]
    fn what_glass_lets_through_is_exact_to_half_an_ulp((absorption, length) in absorbed()) {
        let left = absorption.transmittance(length).to_array();
        for (left, channel) in left.into_iter().zip(absorption.color.to_array()) {
            let truth = (real(length) / real(absorption.distance) * (real(channel) - real(1.0))).exp();
            is_right(left, &truth)?;
        }
    }
}
