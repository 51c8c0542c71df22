use glam::DVec2;

use super::{Sample, hash};

/// Points that keep apart in every way of halving the unit square: the first two dimensions of Sobol's sequence, scrambled and shuffled
/// anew for each pixel and purpose. (Sobol' 1967; Owen: Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences, 1995; by hashing as in Burley:
/// Practical Hash-based Owen Scrambling, JCGT 9(4), 2020.)
///
/// Of the first 2^k points, and of each 2^k that follow, one falls into each of 2^k equal boxes, whichever way the square is cut into them:
///
/// ```text
///   +-+-+-+-+   +---+---+   +-------+
///   | |.| | |   |  .|   |   |  .    |      four points, and the three ways to cut the square into four
///   |.| | | |   |. _|___|   |._____ |
///   | | | |.|   |   |  .|   |_____ .|
///   | | |.| |   |   |.  |   |    .  |
///   +-+-+-+-+   +---+---+   +-------+
/// ```
pub fn sobol(sample: Sample) -> DVec2 {
    let Sample { seed, pixel: [x, y], purpose, .. } = sample;
    let set = hash([seed, x, y, purpose.number()]);
    let index = shuffle(sample.index, hash([set, 0]));
    let first = scrambled(index.reverse_bits(), hash([set, 1]));
    let second = scrambled(second_dimension(index), hash([set, 2]));
    DVec2::new(f64::from(first), f64::from(second)) * (1.0 / 4_294_967_296.0)
}

/// Owen's scrambling of a binary fraction: each bit is flipped or not, by chance, depending on all the higher ones.
fn scrambled(fraction: u32, seed: u32) -> u32 {
    laine_karras(fraction.reverse_bits(), seed).reverse_bits()
}

/// Another order of the whole numbers that keeps each 2^k beginning with a multiple of 2^k together.
fn shuffle(index: u32, seed: u32) -> u32 {
    scrambled(index, seed)
}

/// A random permutation of 32 bits in which each depends on the lower ones alone. (Laine and Karras: Stratified Sampling for Stochastic
/// Transparency, 2011; the constants by Vegdahl: Building a Better LK Hash, 2021.)
fn laine_karras(mut bits: u32, seed: u32) -> u32 {
    bits ^= bits.wrapping_mul(0x3D20_ADEA);
    bits = bits.wrapping_add(seed);
    bits = bits.wrapping_mul((seed >> 16) | 1);
    bits ^= bits.wrapping_mul(0x0552_6C56);
    bits ^ bits.wrapping_mul(0x53A2_2864)
}

/// Sobol's second dimension: its generator matrix is Pascal's triangle modulo 2, each column made of the one before.
fn second_dimension(mut index: u32) -> u32 {
    let mut fraction = 0;
    let mut column = 1 << 31;
    while index > 0 {
        if index & 1 == 1 {
            fraction ^= column;
        }
        column ^= column >> 1;
        index >>= 1;
    }
    fraction
}
