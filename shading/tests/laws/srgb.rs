use geometry::conformance::times;
use proptest::prelude::*;
use shading::srgb::{decode, decode_byte, encode_byte};

use crate::exact::{Real, is_right, real};

/// A decimal number of the standard, exactly.
fn decimal(numerator: f64, denominator: f64) -> Real {
    real(numerator) / real(denominator)
}

/// IEC 61966-2-1.
fn exact_decode(encoded: &Real) -> Real {
    if *encoded <= decimal(4045.0, 100_000.0) {
        return encoded / decimal(1292.0, 100.0);
    }
    let base = (encoded + decimal(55.0, 1000.0)) / decimal(1055.0, 1000.0);
    base.powf(&decimal(24.0, 10.0))
}

#[test]
fn every_byte_is_decoded_to_half_an_ulp() {
    for byte in 0..=255 {
        is_right(decode_byte(byte), &exact_decode(&decimal(byte.into(), 255.0))).unwrap();
    }
}

/// So every linear value, of all 2^32, becomes the nearest byte on the encoded scale: encoding never falls (the next law), and each
/// byte begins with the first value above the middle between it and the one before.
#[test]
fn every_byte_begins_where_it_becomes_the_nearest() {
    for byte in 1..=255 {
        // Halving the bits of 0 to 1, which rise as the numbers do.
        let (mut below, mut at) = (0_u32, 1.0_f32.to_bits());
        while at - below > 1 {
            let middle = below + (at - below) / 2;
            if encode_byte(f32::from_bits(middle)) < byte { below = middle } else { at = middle }
        }
        let first = f32::from_bits(at);
        let middle = exact_decode(&(decimal(f64::from(byte) - 0.5, 255.0)));
        assert!(real(first.next_down()) < middle && middle <= real(first), "byte {byte} begins at {first}");
        assert_eq!((encode_byte(first.next_down()), encode_byte(first)), (byte - 1, byte));
    }
}

proptest! {
    #![proptest_config(times(8))]

    #[test]
    fn an_encoded_value_is_decoded_to_half_an_ulp(encoded in prop_oneof![0.0_f32..=1.0, 0.040_449_f32..0.040_451]) {
        is_right(decode(encoded), &exact_decode(&real(encoded)))?;
    }

    #[test]
    fn encoding_never_falls(a in -0.5_f32..1.5, b in -0.5_f32..1.5) {
        prop_assert!(a > b || encode_byte(a) <= encode_byte(b));
    }
}
