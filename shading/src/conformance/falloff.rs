//! The kit of the report's falloff: how light grows less with the distance.
//!
//! **The idea.** A light's power is the distance at which it ends, and up to there it falls evenly. (Real light falls with the square of the
//! distance; evenly is easier to place lights by.)
//!
//! ```text
//!   1 |\
//!     | \          max(0, 1 - d / P)
//!     |  \
//!   0 +---\------  d
//!     0    P
//! ```
//!
//! **The contract.** A [`Falloff`] makes the share of a light's colour that arrives, of the distance, 0 or greater, and the power.
//!
//! **Hard cases.** Distance and power nearly alike. A power of 0, also at distance 0. NaN and infinity: the answer is 0 where one is NaN, and
//! never below 0.
//!
//! **Literature.** The report's equations (1) and (2). Goldberg: What Every Computer Scientist Should Know About Floating-Point Arithmetic, 1991.
//!
//! **Exercises.** Pass the kit. Write the logarithmic falloff, and say which laws it keeps. Give the inverse square an end without a step.
//!
//! | mistake | law that names it |
//! |---|---|
//! | nothing is returned | [`light_falls_evenly_from_all_to_nothing_at_its_power`] |
//! | falloff squared | [`light_falls_evenly_from_all_to_nothing_at_its_power`] |
//! | distance and power exchanged | [`light_falls_evenly_from_all_to_nothing_at_its_power`] |
//! | falloff without clamp | [`past_its_power_a_light_gives_nothing`] |
//! | the absolute value instead of a clamp | [`past_its_power_a_light_gives_nothing`] |
//! | NaN at distance 0 without power | [`a_light_without_power_gives_nothing`] |
//! | NaN handed on | [`no_share_is_below_0_or_nan`] |
//! | infinite at distance 0 | [`light_falls_evenly_from_all_to_nothing_at_its_power`] |
//! | rounded more than it must be | [`a_share_is_exact_to_4_5e_8`] |

use geometry::conformance::{Counterexample, Trial, Verdict, wild_numbers};
use proptest::prelude::*;

use super::lit_from;
use crate::Falloff;

fn near(expected: f64, found: f32, exact: f64) -> Verdict {
    let is_near = (f64::from(found) - expected).abs() <= exact;
    if is_near { Ok(()) } else { Err(Counterexample::new(format!("{expected} to {exact}"), format!("{found}"))) }
}

/// All at the light itself, half at half its power.
pub fn light_falls_evenly_from_all_to_nothing_at_its_power(falloff: &Falloff, trial: &Trial) -> Verdict {
    let share = prop_oneof![Just(0.0_f32), Just(0.5), Just(1.0), 0.0_f32..1.0];
    trial.search((0.1_f32..100.0, share), |&(power, share)| {
        near(1.0 - f64::from(share), falloff(share * power, power), 1e-6)
    })
}

/// It does not become negative, nor come again.
pub fn past_its_power_a_light_gives_nothing(falloff: &Falloff, trial: &Trial) -> Verdict {
    trial.search((0.1_f32..100.0, 1.0_f32..10.0), |&(power, times)| near(0.0, falloff(times * power, power), 1e-6))
}

/// Not even at the light itself.
pub fn a_light_without_power_gives_nothing(falloff: &Falloff, trial: &Trial) -> Verdict {
    trial.search(prop_oneof![Just(0.0_f32), 0.0_f32..10.0], |&distance| near(0.0, falloff(distance, 0.0), 0.0))
}

/// Every falloff's law, whatever its formula: 0 or more, and 0 where the distance or the power is NaN.
pub fn no_share_is_below_0_or_nan(falloff: &Falloff, trial: &Trial) -> Verdict {
    trial.times(32).search((wild_numbers(), wild_numbers()), |&(distance, power)| {
        let share = falloff(distance, power);
        let is_told = share >= 0.0 && (share == 0.0 || !(distance.is_nan() || power.is_nan()));
        if is_told { Ok(()) } else { Err(Counterexample::new("0 or more, and 0 for NaN", format!("{share}"))) }
    })
}

/// 3/4 u, with u = 2^-24: half an ulp of the quotient below 1/2, and of the difference below 1. Held against `f64`, whose own rounding of the
/// quotient is 2^-53.
pub fn a_share_is_exact_to_4_5e_8(falloff: &Falloff, trial: &Trial) -> Verdict {
    trial.times(16).search(lit_from(), |&(distance, power)| {
        near((1.0 - f64::from(distance) / f64::from(power)).max(0.0), falloff(distance, power), 4.5e-8)
    })
}

geometry::kit! { $crate
    /// Names the laws of the report's falloff as tests: of a [`Falloff`](crate::Falloff).
    falloff_conformance, Falloff, falloff;
    light_falls_evenly_from_all_to_nothing_at_its_power: "nothing is returned yet: begin with `1.0 - distance / power`; or another power of it";
    past_its_power_a_light_gives_nothing: "`max(0, ...)` is missing";
    a_light_without_power_gives_nothing: "0 / 0 is NaN, and x / 0 infinite";
    no_share_is_below_0_or_nan: "a comparison that is false for NaN lets it through: ask for what is allowed, not for what is not";
    a_share_is_exact_to_4_5e_8: "one rounding too many, such as the reciprocal of the power";
}
