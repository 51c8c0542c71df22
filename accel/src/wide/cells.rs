//! The octree itself: cells of the root cube that hold something.

use geometry::Aabb;

use super::{
    collapse::{Cuts, leaf_cost},
    layout::SLOTS,
    morton::{Coded, LEVELS},
};

/// A cell, with all below it.
///
/// Chains of cells with a single eighth that holds something are left out: a cell here is a leaf or has two eighths or more.
pub(super) struct Cell {
    /// Its references in the sorted row: from `first`, so many.
    pub(super) first: u32,
    pub(super) count: u32,
    /// How many of them are not of triangles that stand in blocks.
    pub(super) asked: u32,
    /// Tight around them; not the cube.
    pub(super) bounds: Aabb,
    /// What its content costs a ray, shown in one slot of a wide node.
    pub(super) cost: f32,
    /// How many slots of a node it can fill: a leaf one.
    pub(super) fills: u8,
    /// `None` in a leaf.
    pub(super) divided: Option<Box<Divided>>,
}

pub(super) struct Divided {
    /// Those of the eighths that hold something, in their order.
    pub(super) eighths: Vec<Cell>,
    /// Bits 2, 1, 0 of an eighth's place: the upper half in x, y, z. A bit is set for each place that is taken.
    pub(super) occupied: u8,
    /// How to cut it up cheapest.
    pub(super) cuts: Cuts,
    /// What its content costs a ray, shown in 1 to [`SLOTS`] slots of a wide node.
    pub(super) costs: [f32; SLOTS],
}

impl Divided {
    /// The cell at a place, if anything is there.
    pub(super) fn eighth(&self, place: usize) -> Option<&Cell> {
        let below = self.occupied & ((1 << place) - 1);
        (self.occupied >> place & 1 == 1).then(|| &self.eighths[below.count_ones() as usize])
    }
}

/// What stands in leaves: primitives, or pieces of them. The builder knows each by a number, its reference.
pub(super) trait Content: Sync {
    fn bounds(&self, reference: u32) -> Aabb;
    /// The primitive that it is, or is a piece of.
    fn primitive(&self, reference: u32) -> u32;
    /// Whether it is of a triangle that stands in a block.
    fn is_in_block(&self, reference: u32) -> bool;
}

/// A cell of so many triangles is not divided: they fill a block.
const LEAF: u32 = 8;

/// Cells of more primitives are worth a thread's while.
const WORTH_A_THREAD: usize = 2048;

/// The cell of a part of the sorted row that starts at `first`.
pub(super) fn grow(row: &[Coded], first: u32, content: &impl Content) -> Cell {
    let leaf = || leaf(row, first, content);
    if row.len() <= LEAF as usize {
        let cell = leaf();
        // What is asked one by one is not worth less than a block.
        if cell.count - cell.asked + LEAF * cell.asked <= LEAF {
            return cell;
        }
    }
    let places = eighths(row);
    let occupied = places.iter().rev().fold(0, |bits, &(start, end)| bits << 1 | u8::from(start < end));
    let grow = |(start, end): (usize, usize)| grow(&row[start..end], first + start as u32, content);
    let taken = places.into_iter().filter(|(start, end)| start < end);
    let eighths: Vec<Cell> = if row.len() > WORTH_A_THREAD {
        use rayon::prelude::*;
        taken.collect::<Vec<_>>().into_par_iter().map(grow).collect()
    } else {
        // Of just the size: most of what a build takes at its peak is cells.
        let mut eighths = Vec::with_capacity(occupied.count_ones() as usize);
        eighths.extend(taken.map(grow));
        eighths
    };
    let bounds = eighths.iter().fold(Aabb::EMPTY, |all, cell| all.union(cell.bounds));
    let asked = eighths.iter().map(|cell| cell.asked).sum();
    let mut divided = Box::new(Divided { eighths, occupied, cuts: Cuts::default(), costs: [0.0; SLOTS] });
    let fills = divided.find_cuts();
    Cell { first, count: row.len() as u32, asked, bounds, cost: divided.costs[0], fills, divided: Some(divided) }
}

fn leaf(row: &[Coded], first: u32, content: &impl Content) -> Cell {
    let mut bounds = Aabb::EMPTY;
    let mut asked = 0;
    for coded in row {
        bounds = bounds.union(content.bounds(coded.reference));
        asked += u32::from(!content.is_in_block(coded.reference));
    }
    let count = row.len() as u32;
    let cost = leaf_cost(bounds, count, asked);
    Cell { first, count, asked, bounds, cost, fills: 1, divided: None }
}

/// So many are counted sooner than searched.
const FEW: usize = 64;

/// Where each eighth of the smallest cell around a row starts and ends in it.
///
/// If all have one code, there is no such cell: the row is then cut into eight equal parts.
fn eighths(row: &[Coded]) -> [(usize, usize); 8] {
    let differ = row[0].code ^ row[row.len() - 1].code;
    if differ == 0 {
        return std::array::from_fn(|place| (row.len() * place / 8, row.len() * (place + 1) / 8));
    }
    // The highest level whose digits differ.
    let level = differ.ilog2() / 3;
    debug_assert!(level < LEVELS);
    let place_of = |coded: &Coded| (coded.code >> (3 * level) & 7) as usize;
    let mut counts = [0; 8];
    if row.len() <= FEW {
        row.iter().for_each(|coded| counts[place_of(coded)] += 1);
    }
    let mut start = 0;
    std::array::from_fn(|place| {
        let inside = if row.len() <= FEW {
            counts[place]
        } else {
            row[start..].partition_point(|coded| place_of(coded) <= place)
        };
        let end = start + inside;
        (std::mem::replace(&mut start, end), end)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_cut_at_the_highest_level_where_its_codes_differ() {
        let row: Vec<Coded> = [0b001_000_000, 0b001_010_000, 0b001_010_001, 0b001_111_111]
            .map(|code| Coded { code, reference: 0 })
            .into();
        let parts = eighths(&row);
        assert_eq!((parts[0], parts[1], parts[2], parts[7]), ((0, 1), (1, 1), (1, 3), (3, 4)));
    }

    #[test]
    fn equal_codes_are_cut_into_equal_parts() {
        let parts = eighths(&[Coded { code: 5, reference: 0 }; 20]);
        assert_eq!((parts[0], parts[7]), ((0, 2), (17, 20)));
    }
}
