//! The order of an octree's leaves, before there is an octree.
//!
//! A point's Morton code names the cell that it is in, on every level at once: three bits a level, one for each axis, from the root
//! down. Sorted by their codes, the primitives of every cell stand in one row.
//!
//! ```text
//!   x 1 0 ...  ->  1.. 0..        level 1: eighth 0b101 (upper x, lower y, upper z)
//!   y 0 1 ...  ->  .0. .1.        level 2: eighth 0b010 of that one
//!   z 1 0 ...  ->  ..1 ..0
//! ```
//!
//! (Morton 1966; octrees from sorted codes: Lauterbach et al., Fast BVH Construction on GPUs, 2009.)

use geometry::Aabb;
use glam::Vec3;
use rayon::prelude::*;

/// Levels that a code tells apart: 3 x 21 bits.
pub(super) const LEVELS: u32 = 21;

/// A primitive with the code of its centre.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Coded {
    pub(super) code: u64,
    pub(super) primitive: u32,
}

/// The primitives with these boxes in the order of their codes, equal codes by number. The root is the cube around `bounds`.
pub(super) fn in_morton_order(numbers: &[u32], bounds_of: impl Fn(u32) -> Aabb + Sync, bounds: Aabb) -> Vec<Coded> {
    let half = 0.5 * bounds.extent().max_element();
    let lowest = bounds.center() - half;
    let per_unit = (1 << LEVELS) as f32 / (2.0 * half).max(f32::MIN_POSITIVE);
    let coded = |&primitive: &u32| {
        let place = (bounds_of(primitive).center() - lowest) * per_unit;
        Coded { code: code(place), primitive }
    };
    let mut all: Vec<Coded> = numbers.par_iter().with_min_len(4096).map(coded).collect();
    sort(&mut all);
    all
}

/// The code of the cell of the finest level that a point is in. A point outside counts as in the nearest.
fn code(place: Vec3) -> u64 {
    let along = |place: f32| spread((place as u64).min((1 << LEVELS) - 1));
    along(place.x) << 2 | along(place.y) << 1 | along(place.z)
}

/// The lowest 21 bits, three places apart.
fn spread(bits: u64) -> u64 {
    let bits = (bits | bits << 32) & 0x001F_0000_0000_FFFF;
    let bits = (bits | bits << 16) & 0x001F_0000_FF00_00FF;
    let bits = (bits | bits << 8) & 0x100F_00F0_0F00_F00F;
    let bits = (bits | bits << 4) & 0x10C3_0C30_C30C_30C3;
    (bits | bits << 2) & 0x1249_2492_4924_9249
}

/// Bits that one pass of the sort looks at: three levels and two thirds, as many counters as stay in the nearest cache.
const DIGIT: u32 = 11;

/// Radix sort. The highest digit cuts the row into parts that threads sort each for itself, from the lowest digit up.
fn sort(all: &mut Vec<Coded>) {
    let mut sorted = vec![Coded::default(); all.len()];
    let highest = (3 * LEVELS).div_ceil(DIGIT) - 1;
    let starts = pass(all, &mut sorted, highest * DIGIT);
    let mut parts = Vec::with_capacity(starts.len());
    let (mut rest, mut spare, mut start) = (&mut sorted[..], &mut all[..], 0);
    for end in starts.into_iter().skip(1).chain([rest.len()]) {
        let (part, later) = rest.split_at_mut(end - start);
        let (spare_part, spare_later) = spare.split_at_mut(end - start);
        (rest, spare, start) = (later, spare_later, end);
        if part.len() > 1 {
            parts.push((part, spare_part));
        }
    }
    parts.into_par_iter().for_each(|(part, spare)| sort_below(part, spare, highest));
    *all = sorted;
}

/// Sorts by the digits below one.
fn sort_below(part: &mut [Coded], spare: &mut [Coded], digits: u32) {
    // Clearing and adding up the counters of every digit costs more than to compare a few.
    if part.len() < 1 << DIGIT {
        part.sort_unstable_by_key(|coded| (coded.code, coded.primitive));
        return;
    }
    let (mut from, mut to) = (&mut *part, &mut *spare);
    for digit in 0..digits {
        pass(from, to, digit * DIGIT);
        (from, to) = (to, from);
    }
    if digits % 2 == 1 {
        part.copy_from_slice(spare);
    }
}

/// One pass: moves all to where their digit belongs, those of equal digits in the order they had. Returns where each digit starts.
fn pass(from: &[Coded], to: &mut [Coded], shift: u32) -> Vec<usize> {
    let digit = |coded: &Coded| (coded.code >> shift) as usize & ((1 << DIGIT) - 1);
    let mut starts = vec![0; 1 << DIGIT];
    for coded in from {
        starts[digit(coded)] += 1;
    }
    let mut start = 0;
    for count in &mut starts {
        start += std::mem::replace(count, start);
    }
    let mut next = starts.clone();
    for coded in from {
        let place = &mut next[digit(coded)];
        to[*place] = *coded;
        *place += 1;
    }
    starts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_codes_digits_are_the_eighths_from_the_root_down() {
        let half = (1 << (LEVELS - 1)) as f32;
        assert_eq!(code(Vec3::new(half, 0.0, half)) >> (3 * LEVELS - 3), 0b101);
        assert_eq!(code(Vec3::new(half, 0.5 * half, half)) >> (3 * LEVELS - 6), 0b101_010);
        assert_eq!(code(Vec3::splat(-1.0)), 0);
        assert_eq!(code(Vec3::splat(1e30)), (1 << 63) - 1);
    }

    #[test]
    fn the_sort_is_by_code_then_by_number() {
        // Many in one part, so that both ways to sort are taken; low bits differ, and some codes are equal.
        let code = |i: u32| {
            if i.is_multiple_of(3) { u64::from(i) << 40 } else { u64::from(i.wrapping_mul(2_654_435_761) >> 12) }
        };
        let mut all: Vec<Coded> = (0..20_000).map(|i| Coded { code: code(i), primitive: i }).collect();
        let mut expected = all.clone();
        expected.sort_by_key(|coded| (coded.code, coded.primitive));
        sort(&mut all);
        assert_eq!(all, expected);
    }
}
