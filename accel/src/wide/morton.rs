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

/// What stands in leaves, by number, with the code of its centre.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Coded {
    pub(super) code: u64,
    pub(super) reference: u32,
}

/// The references with these boxes in the order of their codes, equal codes by number.
pub(super) fn in_morton_order(references: &[u32], bounds_of: impl Fn(u32) -> Aabb + Sync, grid: Grid) -> Vec<Coded> {
    let coded = |&reference: &u32| Coded { code: code(grid.cell(bounds_of(reference).center())), reference };
    let mut all: Vec<Coded> = references.par_iter().with_min_len(4096).map(coded).collect();
    sort(&mut all);
    all
}

/// The cells of the finest level: the root cube, cut in 2^21 along each axis.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    lowest: Vec3,
    per_unit: f32,
}

impl Grid {
    /// The root is the cube around a box.
    pub(super) fn around(bounds: Aabb) -> Self {
        let half = 0.5 * bounds.extent().max_element();
        Self { lowest: bounds.center() - half, per_unit: (1 << LEVELS) as f32 / (2.0 * half).max(f32::MIN_POSITIVE) }
    }

    /// The cell that a point is in, counted along x, y, z. A point outside counts as in the nearest.
    pub(super) fn cell(self, point: Vec3) -> [u32; 3] {
        ((point - self.lowest) * self.per_unit).to_array().map(|place| (place as u32).min((1 << LEVELS) - 1))
    }

    /// Where a cell begins on an axis.
    pub(super) fn plane(self, axis: usize, cell: u32) -> f32 {
        self.lowest[axis] + cell as f32 / self.per_unit
    }
}

fn code(cell: [u32; 3]) -> u64 {
    let [x, y, z] = cell.map(|along| spread(u64::from(along)));
    x << 2 | y << 1 | z
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
        part.sort_unstable_by_key(|coded| (coded.code, coded.reference));
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
        let grid = Grid::around(Aabb { min: Vec3::splat(2.0), max: Vec3::splat(4.0) });
        let code = |x, y, z| code(grid.cell(Vec3::new(x, y, z)));
        assert_eq!(code(3.0, 2.0, 3.0) >> (3 * LEVELS - 3), 0b101);
        assert_eq!(code(3.0, 2.5, 3.0) >> (3 * LEVELS - 6), 0b101_010);
        assert_eq!(code(-1.0, -1.0, -1.0), 0);
        assert_eq!(code(1e30, 1e30, 1e30), (1 << 63) - 1);
    }

    #[test]
    fn the_sort_is_by_code_then_by_number() {
        // Many in one part, so that both ways to sort are taken; low bits differ, and some codes are equal.
        let code = |i: u32| {
            if i.is_multiple_of(3) { u64::from(i) << 40 } else { u64::from(i.wrapping_mul(2_654_435_761) >> 12) }
        };
        let mut all: Vec<Coded> = (0..20_000).map(|i| Coded { code: code(i), reference: i }).collect();
        let mut expected = all.clone();
        expected.sort_by_key(|coded| (coded.code, coded.reference));
        sort(&mut all);
        assert_eq!(all, expected);
    }
}
