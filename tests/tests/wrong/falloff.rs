use shading::{Falloff, conformance::falloff, linear_falloff};

use crate::Kit;

#[test]
fn every_mistake_in_a_falloff_is_named() {
    let evenly = "light_falls_evenly_from_all_to_nothing_at_its_power";
    let past = "past_its_power_a_light_gives_nothing";
    Kit { page: "shading/src/conformance/falloff.rs", laws: falloff::LAWS }.catches([
        ("nothing is returned", (|_, _| 0.0) as Falloff, evenly),
        ("falloff squared", |distance, power| linear_falloff(distance, power).powi(2), evenly),
        ("distance and power exchanged", |distance, power| linear_falloff(power, distance), evenly),
        ("falloff without clamp", |distance, power| 1.0 - distance / power, past),
        ("the absolute value instead of a clamp", |distance, power| (1.0 - distance / power).abs(), past),
        (
            "NaN at distance 0 without power",
            |distance, power| {
                let share = 1.0 - distance / power;
                if share < 0.0 { 0.0 } else { share }
            },
            "a_light_without_power_gives_nothing",
        ),
        (
            "NaN handed on",
            |distance, power| if power == 0.0 || distance >= power { 0.0 } else { 1.0 - distance / power },
            "no_share_is_below_0_or_nan",
        ),
        ("infinite at distance 0", |distance, power| power / (distance * distance), evenly),
        (
            "rounded more than it must be",
            |distance, power| if power > 0.0 { (1.0 - distance * (1.0 / power)).max(0.0) } else { 0.0 },
            "a_share_is_exact_to_4_5e_8",
        ),
    ]);
}
