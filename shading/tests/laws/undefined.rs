//! NaN and infinity in every input: a defined answer, and no panic.

use geometry::conformance::{times, wild_numbers, wild_vectors};
use glam::Vec2;
use proptest::prelude::*;
use shading::{
    Absorption, Color, Falloff, ImageTexture, Texture, linear_falloff, logarithmic_falloff,
    optics::{border, reflect},
    srgb,
    sunflow::{SmoothTexture, inverse_square_falloff},
};

fn is_share(number: f32) -> bool {
    (0.0..=1.0).contains(&number)
}

proptest! {
    #![proptest_config(times(32))]

    #[test]
    fn a_mirror_makes_a_unit_vector_or_nan(direction in wild_vectors(), normal in wild_vectors()) {
        let mirrored = reflect(direction, normal);
        prop_assert!(mirrored.is_nan() || mirrored.is_normalized(), "{}", mirrored);
    }

    #[test]
    fn a_border_shares_all_the_light(direction in wild_vectors(), normal in wild_vectors(), eta in wild_numbers()) {
        let border = border(direction, normal, eta);
        prop_assert!(is_share(border.reflectance));
        prop_assert!(border.refracted.is_none_or(|refracted| refracted.is_normalized()), "{:?}", border);
        let has_nan = direction.is_nan() || normal.is_nan() || eta.is_nan();
        prop_assert!(!has_nan || border.refracted.is_none());
    }

    #[test]
    fn no_light_falls_off_below_nothing_or_to_nan(distance in wild_numbers(), power in wild_numbers()) {
        for falloff in [linear_falloff, logarithmic_falloff, inverse_square_falloff] as [Falloff; 3] {
            let share = falloff(distance, power);
            prop_assert!(share >= 0.0, "{}", share);
            prop_assert!(!(distance.is_nan() || power.is_nan()) || share == 0.0);
        }
    }

    #[test]
    fn glass_leaves_no_less_than_nothing_and_never_nan(
        distance in wild_numbers(), channels in prop::array::uniform3(wild_numbers()), length in wild_numbers(),
    ) {
        let left = Absorption { distance, color: Color::from(channels) }.transmittance(length).to_array();
        prop_assert!(left.iter().all(|&left| left >= 0.0), "{:?}", left);
    }

    #[test]
    fn every_number_has_a_byte_and_a_linear_value(number in wild_numbers()) {
        prop_assert!(is_share(srgb::decode(number)));
        if number.is_nan() || number <= 0.0 {
            prop_assert_eq!((srgb::encode_byte(number), srgb::decode(number)), (0, 0.0));
        }
        if number >= 1.0 {
            prop_assert_eq!((srgb::encode_byte(number), srgb::decode(number)), (255, 1.0));
        }
    }

    #[test]
    fn every_place_of_a_texture_has_a_colour(
        width in 1_usize..5, height in 1_usize..5, u in wild_numbers(), v in wild_numbers(), texel in any::<[u8; 3]>(),
    ) {
        let texels = (0..width * height).map(|i| texel.map(|byte| byte.wrapping_mul(i as u8))).collect();
        let picture = ImageTexture::new(width, height, texels).expect("full");
        let smooth = SmoothTexture { picture: picture.clone() };
        for texture in [&picture as &dyn Texture, &smooth] {
            let color = texture.color(&|| Vec2::new(u, v)).to_array();
            prop_assert!(color.into_iter().all(is_share), "{:?}", color);
        }
    }
}
