//! The sRGB curve (IEC 61966-2-1), between encoded values, which files hold, and linear ones, which light adds up in.

use std::sync::LazyLock;

/// An encoded value as a linear one; both 0 to 1, clamped, and 0 for NaN. Right to 0.51 ulp.
pub fn decode(encoded: f32) -> f32 {
    if encoded.is_nan() { 0.0 } else { curve(f64::from(encoded.clamp(0.0, 1.0))) as f32 }
}

/// A byte as a linear value: right to 0.51 ulp.
pub fn decode_byte(encoded: u8) -> f32 {
    static LINEAR: LazyLock<[f32; 256]> =
        LazyLock::new(|| std::array::from_fn(|byte| curve(byte as f64 / 255.0) as f32));
    LINEAR[usize::from(encoded)]
}

/// A linear value as the nearest byte, of every value there is; below 0 and NaN are 0, above 1 is 255.
///
/// Nearest on the encoded scale: the byte is the number of steps, at the linear values of 0.5 / 255, 1.5 / 255 ..., that lie at or below.
pub fn encode_byte(linear: f32) -> u8 {
    static STEPS: LazyLock<[f32; 255]> =
        LazyLock::new(|| std::array::from_fn(|step| first_above(curve((step as f64 + 0.5) / 255.0))));
    STEPS.partition_point(|&step| step <= linear) as u8
}

fn curve(encoded: f64) -> f64 {
    if encoded <= 0.04045 { encoded / 12.92 } else { libm::pow((encoded + 0.055) / 1.055, 2.4) }
}

/// The least `f32` that is not below a number.
fn first_above(number: f64) -> f32 {
    let nearest = number as f32;
    if f64::from(nearest) < number { nearest.next_up() } else { nearest }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_comes_back() {
        for byte in 0..=255 {
            assert_eq!(encode_byte(decode_byte(byte)), byte);
        }
    }

    #[test]
    fn known_values() {
        assert_eq!((decode(0.0), decode(1.0)), (0.0, 1.0));
        assert!((decode(0.5) - 0.214_041_14).abs() < 1e-7);
        assert_eq!(encode_byte(0.5), 188);
        assert_eq!(encode_byte(0.18), 118);
    }

    #[test]
    fn what_lies_outside_is_clamped() {
        assert_eq!([-1.0, f32::NAN, 2.0, f32::INFINITY].map(encode_byte), [0, 0, 255, 255]);
    }
}
