use geometry::{
    Surface,
    conformance::{times, wild_numbers},
};
use glam::Vec3;
use proptest::prelude::*;
use shading::{
    Color, Facing, FacingLanes, LightFormula, PointLight, Shader, ShadingPoint,
    conformance::{Stage, absorbed, lit_from},
    linear_falloff, logarithmic_falloff,
    sunflow::inverse_square_falloff,
};

use crate::exact::{Real, approximate, is_right, pi, real};
use crate::sunflow::floor;

/// Asks whether the way to a place is free.
struct Towards(Vec3);

impl Shader for Towards {
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        at.world.blocked(&at.ray_towards(self.0));
        Color::BLACK
    }
}

#[test]
fn a_ray_towards_a_target_starts_on_its_side_and_is_there_at_1() {
    let stage = floor(-Vec3::Z);
    let stage = Stage { surface: Surface { position: Vec3::ONE, error: Vec3::splat(0.125), ..stage.surface }, ..stage };
    for (target, side) in [(Vec3::new(4.0, 3.0, 9.0), 1.0), (Vec3::new(0.5, 0.5, 0.5), -1.0)] {
        let ray = stage.shown(&Towards(target)).segments[0];
        assert!((ray.origin - (Vec3::ONE + side * 0.125 * Vec3::Z)).length() < 1e-6, "{}", ray.origin);
        assert!((ray.origin + ray.direction).distance(target) < 1e-6);
    }
}

fn places() -> impl Strategy<Value = Vec3> {
    let number = || prop_oneof![8 => -4.0_f32..4.0, 1 => Just(0.0), 1 => wild_numbers()];
    [number(), number(), number()].prop_map(Vec3::from)
}

fn facings() -> impl Strategy<Value = Facing> {
    (places(), places(), places(), places()).prop_map(|(position, start, normal, outward)| Facing {
        position,
        start,
        normal,
        outward,
    })
}

proptest! {
    #![proptest_config(times(16))]

    #[test]
    fn lights_of_many_points_are_those_of_each(
        points in prop::collection::vec((facings(), places(), 0.0_f32..20.0), 0..=4),
        formula in prop_oneof![Just(LightFormula::Report), Just(LightFormula::Sunflow)],
    ) {
        let light = |position, power| PointLight { position, color: Color::WHITE, power, falloff: linear_falloff };
        let (mut lanes, mut lights) = (FacingLanes::<4>::NONE, [light(Vec3::ZERO, 0.0); 4]);
        let mut expected = Vec::new();
        for (lane, &(point, position, power)) in points.iter().enumerate() {
            lights[lane] = light(position, power);
            lanes.put(lane, &point);
            expected.extend(formula.arriving(&point, &lights[lane]).map(|arriving| (lane, arriving)));
        }
        let mut found = Vec::new();
        formula.arriving_lanes(&lanes, points.len(), |lane| &lights[lane], |lane, incident, segment| {
            found.push((lane, (incident, segment)));
        });
        // By what is written of them, in which all NaN are equal.
        prop_assert_eq!(format!("{found:?}"), format!("{expected:?}"));
    }

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
