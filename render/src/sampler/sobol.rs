use glam::DVec2;

use super::{Sample, hash};

/// Points that keep apart whichever way the square is cut: the first two dimensions of Sobol's sequence, scrambled and shuffled anew for each
/// pixel and purpose. (Sobol': On the Distribution of Points in a Cube, 1967; Owen: Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences,
/// 1995; by hashing as in Burley: Practical Hash-based Owen Scrambling, JCGT 9(4), 2020.)
///
/// Of the first 2^k points, and of each 2^k that follow, one falls into each of 2^k equal boxes, for all boxes of 2^-i x 2^-j:
///
/// ```text
///   +-+-+-+-+   +-------+   +---+---+
///   | | |.| |   |    .  |   |   |.  |
///   | | | | |   +-------+   |   |   |     the same four points in four columns, four rows, two by two
///   |.| | | |   |.      |   |.  |   |
///   | | | | |   +-------+   +---+---+
///   | | | |.|   |      .|   |   |  .|
///   | | | | |   +-------+   |   |   |
///   | |.| | |   |  .    |   |  .|   |
///   +-+-+-+-+   +-------+   +---+---+
/// ```
///
/// So any number of points is spread evenly, zones of a pixel get equally many, and more points can follow later.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Purpose;

    fn sample(seed: u32, index: u32) -> Sample {
        Sample { seed, pixel: [3, 9], zones: 1, count: 1 << 20, index, purpose: Purpose::Lens }
    }

    #[test]
    fn each_box_of_every_shape_has_one_of_as_many_points() {
        for (seed, k, block) in [(0, 1, 0), (1, 2, 0), (2, 4, 0), (3, 4, 5), (4, 5, 1), (5, 8, 3)] {
            for across in 0..=k {
                let (columns, rows) = (1 << across, 1 << (k - across));
                let mut points = vec![0; 1 << k];
                for index in 0..1_u32 << k {
                    let point = sobol(sample(seed, (block << k) + index));
                    let [column, row] = [point.x * f64::from(columns), point.y * f64::from(rows)].map(|at| at as usize);
                    points[row * columns as usize + column] += 1;
                }
                assert!(points.iter().all(|&points| points == 1), "block {block} of {columns} x {rows}: {points:?}");
            }
        }
    }

    #[test]
    fn any_number_of_points_is_spread_evenly() {
        // Each 2^k points have one in each of 2^k columns: so of n points a column has n / 2^k, rounded up or down.
        for (seed, columns) in [(0, 2), (1, 4), (2, 16)] {
            let mut points = vec![0; columns as usize];
            for index in 0..200 {
                points[(sobol(sample(seed, index)).x * f64::from(columns)) as usize] += 1;
                let (few, many) = ((index + 1) / columns, (index + 1).div_ceil(columns));
                assert!(points.iter().all(|&points| points == few || points == many), "{index}: {points:?}");
            }
        }
    }

    /// Published values: Joe and Kuo's table begins with these points.
    #[test]
    fn the_second_dimension_is_sobol_s() {
        let found = [0, 1, 2, 3, 4, 5, 6, 7].map(|index| f64::from(second_dimension(index)) / 4_294_967_296.0);
        assert_eq!(found, [0.0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875]);
    }

    #[test]
    fn scrambling_moves_each_bit_by_the_higher_ones_alone() {
        // Two fractions that first differ in bit k still do, and all bits above are alike.
        for (seed, k) in (0..32).flat_map(|k| [(1, k), (77, k)]) {
            let (one, other) = (0x1234_5678_u32, 0x1234_5678_u32 ^ (1 << k));
            let difference = scrambled(one, hash([seed])) ^ scrambled(other, hash([seed]));
            assert_eq!(difference.leading_zeros(), 31 - k, "bit {k}: {difference:x}");
        }
    }
}
