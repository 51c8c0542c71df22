//! The sRGB curve (IEC 61966-2-1), between encoded values, which files hold, and linear ones, which light adds up in.

use std::sync::LazyLock;

/// An encoded value as a linear one; both 0 to 1, clamped, and 0 for NaN. Right to 0.51 ulp.
pub fn decode(encoded: f32) -> f32 {
    if encoded.is_nan() { 0.0 } else { curve(f64::from(encoded.clamp(0.0, 1.0))) as f32 }
}

/// A byte as a linear value: right to 0.51 ulp.
pub fn decode_byte(encoded: u8) -> f32 {
    linear_bytes()[usize::from(encoded)]
}

/// The linear values of all bytes.
pub(crate) fn linear_bytes() -> &'static [f32; 256] {
    static LINEAR: LazyLock<[f32; 256]> =
        LazyLock::new(|| std::array::from_fn(|byte| curve(byte as f64 / 255.0) as f32));
    &LINEAR
}

/// A linear value as the nearest byte, of every value there is; below 0 and NaN are 0, above 1 is 255.
///
/// Nearest on the encoded scale: the byte is the number of steps, at the linear values of 0.5 / 255, 1.5 / 255 ..., that lie at or below.
pub fn encode_byte(linear: f32) -> u8 {
    static STEPS: LazyLock<Steps> = LazyLock::new(Steps::new);
    let Steps { steps, below } = &*STEPS;
    let byte = below[((linear * CELLS as f32) as usize).min(CELLS)];
    byte + u8::from(steps[usize::from(byte)] <= linear)
}

/// From 0 to 1 there are so many cells, none with more than one step in it: the two nearest steps are 3.03e-4 apart.
const CELLS: usize = 4096;

struct Steps {
    /// The steps, and a NaN: above 255 there is none.
    steps: [f32; 256],
    /// How many steps lie at or below the start of each cell, and below 1.
    below: [u8; CELLS + 1],
}

impl Steps {
    fn new() -> Self {
        let mut steps = [f32::NAN; 256];
        for (step, first) in steps[..255].iter_mut().enumerate() {
            *first = first_above(curve((step as f64 + 0.5) / 255.0));
        }
        let below = |cell| steps[..255].partition_point(|&step| step <= cell as f32 / CELLS as f32) as u8;
        Self { steps, below: std::array::from_fn(below) }
    }
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
    fn no_cell_has_two_steps_in_it() {
        let Steps { below, .. } = Steps::new();
        assert!(below.windows(2).all(|pair| pair[1] - pair[0] <= 1));
        assert_eq!((below[0], below[CELLS]), (0, 255));
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
