/// Which random number is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sample {
    /// Chosen by the user: another seed is another picture of the same scene.
    pub seed: u32,
    /// The pixel, from the top left.
    pub pixel: [u32; 2],
    /// The ray's number in the pixel.
    pub index: u32,
    /// What it is for: 0 and 1 the place in the pixel, 2 and 3 the place on the lens.
    pub dimension: u32,
}

/// A number in 0..1 (1 excluded) as a function of which is wanted: no state, so that the picture depends on no order.
pub type Sampler = fn(Sample) -> f32;

/// Independent uniform random numbers: the report's stochastic sampling.
pub fn jitter(sample: Sample) -> f32 {
    let words = [sample.seed, sample.pixel[0], sample.pixel[1], sample.index, sample.dimension];
    let bits = words.into_iter().fold(0x9E37_79B9, |hash: u32, word| scramble(hash ^ word).wrapping_add(0x9E37_79B9));
    // 24 bits fill an f32's significand: the largest is 1 - 2^-24.
    (bits >> 8) as f32 * (1.0 / (1 << 24) as f32)
}

/// Each zone's middle, however many samples it has; the lens as [`jitter`] does it. Sunflow's, without its jitter.
pub fn centred(sample: Sample) -> f32 {
    if sample.dimension < 2 { 0.5 } else { jitter(sample) }
}

/// Spreads each bit over all others. (Wellons 2018, "lowbias32".)
pub(crate) fn scramble(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x7FEB_352D);
    bits ^= bits >> 15;
    bits = bits.wrapping_mul(0x846C_A68B);
    bits ^ bits >> 16
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Chi-square over 64 x 64 squares of neighbouring dimensions, and of neighbouring pixels. 4095 degrees of freedom have a
    /// mean of 4095 and a standard deviation of 90.5: five of them are allowed.
    #[test]
    fn neighbours_are_independent_and_uniform() {
        let sample = |x, dimension| jitter(Sample { seed: 1, pixel: [x % 512, x / 512], index: 3, dimension });
        assert_uniform("two dimensions of a pixel", |x| [sample(x, 0), sample(x, 1)]);
        assert_uniform("two neighbouring pixels", |x| [sample(2 * x, 0), sample(2 * x + 1, 0)]);
    }

    fn assert_uniform(what: &str, pair: impl Fn(u32) -> [f32; 2]) {
        let count = 1 << 17;
        let mut cells = vec![0_u32; 4096];
        for [a, b] in (0..count).map(pair) {
            assert!((0.0..1.0).contains(&a) && (0.0..1.0).contains(&b), "{what}");
            cells[(a * 64.0) as usize * 64 + (b * 64.0) as usize] += 1;
        }
        let expected = f64::from(count) / 4096.0;
        let chi_square: f64 = cells.iter().map(|&n| (f64::from(n) - expected).powi(2) / expected).sum();
        assert!((chi_square - 4095.0).abs() < 5.0 * 90.5, "{what}: {chi_square}");
    }
}
