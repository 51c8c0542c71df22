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
pub fn sobol(first: Sample, points: &mut [DVec2]) {
    let Sample { seed, pixel: [x, y], purpose, index, .. } = first;
    let set = hash([seed, x, y, purpose.number()]);
    let [order, across, down] = [0, 1, 2].map(|number| hash([set, number]));
    accel::vectorize(
        #[inline(always)]
        || {
            for (block, points) in points.chunks_mut(LANES).enumerate() {
                let (mut xs, mut ys) = ([0; LANES], [0; LANES]);
                for lane in 0..LANES {
                    let index = index.wrapping_add((block * LANES + lane) as u32);
                    let fraction = laine_karras(index.reverse_bits(), order).reverse_bits();
                    xs[lane] = laine_karras(fraction, across).reverse_bits();
                    ys[lane] = laine_karras(second_dimension(fraction), down).reverse_bits();
                }
                for ((point, x), y) in points.iter_mut().zip(xs).zip(ys) {
                    *point = DVec2::new(f64::from(x), f64::from(y)) * (1.0 / 4_294_967_296.0);
                }
            }
        },
    );
}

/// So many points in the same steps, by a loop that the compiler makes vectors of.
const LANES: usize = 8;

/// A random permutation of 32 bits in which each depends on the lower ones alone: of a binary fraction whose first bit is lowest, Owen's
/// scrambling, by which each is flipped or not, by chance, depending on all the higher ones. Of a whole number whose last bit is highest it is
/// another order that keeps each 2^k beginning with a multiple of 2^k together. (Laine and Karras: Stratified Sampling for Stochastic
/// Transparency, 2011; the constants by Vegdahl: Building a Better LK Hash, 2021.)
#[inline(always)]
fn laine_karras(mut bits: u32, seed: u32) -> u32 {
    bits ^= bits.wrapping_mul(0x3D20_ADEA);
    bits = bits.wrapping_add(seed);
    bits = bits.wrapping_mul((seed >> 16) | 1);
    bits ^= bits.wrapping_mul(0x0552_6C56);
    bits ^ bits.wrapping_mul(0x53A2_2864)
}

/// Sobol's second dimension, the fraction's first bit lowest. (The first is the number itself.)
///
/// Its generator matrix is Pascal's triangle modulo 2: with the bits as coefficients of a polynomial, bit k becomes (1 + x)^k. That of a
/// polynomial `A + x^16 B` is `A' + (1 + x^16) B'`, A' and B' being what becomes of its halves, which are cut in half in turn: five steps.
#[inline(always)]
fn second_dimension(mut bits: u32) -> u32 {
    bits ^= (bits >> 16) & 0x0000_FFFF;
    bits ^= (bits >> 8) & 0x00FF_00FF;
    bits ^= (bits >> 4) & 0x0F0F_0F0F;
    bits ^= (bits >> 2) & 0x3333_3333;
    bits ^ ((bits >> 1) & 0x5555_5555)
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
                    let point = sample(seed, (block << k) + index).point(sobol);
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
                points[(sample(seed, index).point(sobol).x * f64::from(columns)) as usize] += 1;
                let (few, many) = ((index + 1) / columns, (index + 1).div_ceil(columns));
                assert!(points.iter().all(|&points| points == few || points == many), "{index}: {points:?}");
            }
        }
    }

    #[test]
    fn points_asked_for_together_are_those_asked_for_one_by_one() {
        for (first, count) in [(0, 1), (0, 3), (0, 4), (3, 5), (0, 16), (7, 37), (u32::MAX - 1, 4)] {
            let mut together = vec![DVec2::ZERO; count];
            sobol(sample(5, first), &mut together);
            let one_by_one = |number| sample(5, first.wrapping_add(number)).point(sobol);
            assert_eq!(together, (0..count as u32).map(one_by_one).collect::<Vec<_>>(), "{count} from {first} on");
        }
    }

    /// Published values: Joe and Kuo's table begins with these points.
    #[test]
    fn the_second_dimension_is_sobol_s() {
        let y = |index| f64::from(second_dimension(index).reverse_bits()) / 4_294_967_296.0;
        assert_eq!([0, 1, 2, 3, 4, 5, 6, 7].map(y), [0.0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875]);
    }

    #[test]
    fn scrambling_moves_each_bit_by_the_higher_ones_alone() {
        // Two fractions that first differ in bit k still do, and all bits above are alike.
        for (seed, k) in (0..32).flat_map(|k| [(1, k), (77, k)]) {
            let (one, other) = (0x1234_5678_u32, 0x1234_5678_u32 ^ (1 << k));
            let scrambled = |fraction: u32| laine_karras(fraction.reverse_bits(), hash([seed])).reverse_bits();
            let difference = scrambled(one) ^ scrambled(other);
            assert_eq!(difference.leading_zeros(), 31 - k, "bit {k}: {difference:x}");
        }
    }
}
