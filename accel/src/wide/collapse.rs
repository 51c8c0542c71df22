//! Which cells become slots of which wide node.
//!
//! A wide node has sixteen slots, and the boxes in them are tested at once; a slot that is empty is work for nothing. An octree's
//! cell rarely has eight eighths that hold something, and some hold much and others little. So a wide node is not one cell but a
//! *cut* through the octree below a cell: a big eighth may be shown as its own eighths, several small neighbours may share a slot.
//!
//! ```text
//!   cell    +-------+---+---+       slots: its eighths 0 and 1 together, the four of 2, two halves of 3 ... : eight of them
//!           |       | 3 | 3 |
//!           | 0   1 +-+-+---+       What may share a slot are the unions of eighths along the axes: 8 alone, 12 pairs, 6
//!           |       |2|2| 3 |       halves, and the whole: 3 x 3 x 3 = 27 (lower, upper, or both, on each axis).
//!           +-------+-+-+---+
//! ```
//!
//! The cheapest cut is found from the leaves up (dynamic programming): what is the cheapest way to show a union in at most k
//! slots? In one slot, it is a leaf or a wide node of its own, whichever is cheaper; in more, it is cut along an axis, and each
//! side takes some of the slots. The cost is the surface area heuristic: a ray that meets a box meets a box inside it with a
//! probability of the ratio of their surfaces (MacDonald and Booth 1990). (The cuts of wide trees by dynamic programming: Ylitie,
//! Karras and Laine, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, 2017; there over a binary tree.)

use geometry::Aabb;

use super::{
    cells::{Cell, Divided},
    layout::SLOTS,
};

/// What visiting a wide node costs: the unit.
const NODE: f32 = 1.0;
/// What a block of eight triangles costs.
const BLOCK: f32 = 0.56;
/// What asking one primitive costs.
const ASKED: f32 = 0.4;

/// A cost counted in primitives that are asked one by one: the unit that all accelerators share.
pub(super) fn in_primitives(cost: f32) -> f32 {
    cost / ASKED
}

/// The most primitives in a leaf.
pub(super) const MOST_IN_A_LEAF: u32 = 16;

/// What a leaf costs the rays that meet its box, times the box's half surface; infinite if it would hold too many.
pub(super) fn leaf_cost(bounds: Aabb, count: u32, asked: u32) -> f32 {
    if count > MOST_IN_A_LEAF {
        return f32::INFINITY;
    }
    let blocks = (count - asked).div_ceil(8);
    bounds.half_surface() * (BLOCK * blocks as f32 + ASKED * asked as f32)
}

/// What a wide node costs the rays that meet its box, times the box's half surface.
pub(super) fn node_cost(bounds: Aabb) -> f32 {
    bounds.half_surface() * NODE
}

/// What triangles cost whose boxes have so much half surface together.
pub(super) fn triangle_cost(half_surface: f32) -> f32 {
    BLOCK / 8.0 * half_surface
}

/// A union of a cell's eighths along the axes: 9 x + 3 y + z, each 0 (lower), 1 (upper) or 2 (both).
pub(super) type Union = usize;

/// All eighths.
pub(super) const WHOLE: Union = 26;

const UNIONS: usize = 27;

/// What a digit of a [`Union`] counts, for each axis.
const WEIGHT: [usize; 3] = [9, 3, 1];

/// The unions of more than one eighth, those with fewer "both" first: each comes after its parts.
const LARGER: [Union; 19] = [2, 5, 6, 7, 11, 14, 15, 16, 18, 19, 21, 22, 8, 17, 20, 23, 24, 25, 26];

/// Where a larger union stands in [`LARGER`].
const PLACE: [u8; UNIONS] = {
    let mut places = [u8::MAX; UNIONS];
    let mut place = 0;
    while place < LARGER.len() {
        places[LARGER[place]] = place as u8;
        place += 1;
    }
    places
};

/// Which eighth a union is, if it is one alone.
pub(super) fn lone_eighth(union: Union) -> Option<usize> {
    let digits = WEIGHT.map(|weight| union / weight % 3);
    digits.iter().all(|&digit| digit < 2).then(|| digits[0] << 2 | digits[1] << 1 | digits[2])
}

/// The union that is one eighth alone.
fn lone(place: usize) -> Union {
    WEIGHT[0] * (place >> 2 & 1) + WEIGHT[1] * (place >> 1 & 1) + WEIGHT[2] * (place & 1)
}

/// Whether an eighth is in a union.
pub(super) fn covers(union: Union, place: usize) -> bool {
    (0..3).all(|axis| {
        let digit = union / WEIGHT[axis] % 3;
        digit == 2 || digit == place >> (2 - axis) & 1
    })
}

/// The cheapest ways to show the larger unions of a cell.
#[derive(Default)]
pub(super) struct Cuts {
    /// For each of [`LARGER`] and each number of slots less 1.
    ways: [[Way; SLOTS]; LARGER.len()],
}

/// A way to show a union in so many slots. One byte.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug)]
pub(super) struct Way(u8);

/// A [`Way`], taken apart.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Shown {
    /// In one slot, as a leaf.
    Leaf,
    /// In one slot, as a wide node of its own.
    Node,
    /// Cut in two, the lower part in so many slots of them.
    Cut { lower: Union, upper: Union, lower_slots: usize },
    /// With one slot fewer.
    Fewer,
}

impl Way {
    const LEAF: Self = Self(0);
    const NODE: Self = Self(1);
    const FEWER: Self = Self(2);

    fn cut(axis: usize, lower_slots: usize) -> Self {
        Self((3 + axis * (SLOTS + 1) + lower_slots) as u8)
    }

    fn of(self, union: Union) -> Shown {
        match self {
            Self::LEAF => Shown::Leaf,
            Self::NODE => Shown::Node,
            Self::FEWER => Shown::Fewer,
            Self(byte) => {
                let cut = usize::from(byte) - 3;
                let (lower, upper) = parts(union, cut / (SLOTS + 1));
                Shown::Cut { lower, upper, lower_slots: cut % (SLOTS + 1) }
            }
        }
    }
}

/// A union's two halves on an axis on which it is both.
const fn parts(union: Union, axis: usize) -> (Union, Union) {
    (union - 2 * WEIGHT[axis], union - WEIGHT[axis])
}

/// The axes on which a union is both, with its lower and its upper half.
fn halves(union: Union) -> impl Iterator<Item = (usize, Union, Union)> {
    HALVES[union].iter().flatten().map(|&[axis, lower, upper]| (axis as usize, lower as usize, upper as usize))
}

const HALVES: [[Option<[u8; 3]>; 3]; UNIONS] = {
    let mut halves = [[None; 3]; UNIONS];
    let mut union = 0;
    while union < UNIONS {
        let mut axis = 0;
        while axis < 3 {
            if union / WEIGHT[axis] % 3 == 2 {
                let (lower, upper) = parts(union, axis);
                halves[union][axis] = Some([axis as u8, lower as u8, upper as u8]);
            }
            axis += 1;
        }
        union += 1;
    }
    halves
};

impl Cuts {
    /// How a larger union is best shown in at most so many slots.
    pub(super) fn shown(&self, union: Union, slots: usize) -> Shown {
        self.ways[usize::from(PLACE[union])][slots - 1].of(union)
    }
}

/// What is in a union, and the cheapest cost of showing it in at most 0 to [`SLOTS`] slots.
#[derive(Clone, Copy)]
struct Shape {
    bounds: Aabb,
    count: u32,
    asked: u32,
    costs: [f32; SLOTS + 1],
    /// So many slots of a node it can fill: more cost the same.
    fills: usize,
}

impl Shape {
    /// Nothing: shown in no slot at no cost.
    const EMPTY: Self = Self { bounds: Aabb::EMPTY, count: 0, asked: 0, costs: [0.0; SLOTS + 1], fills: 0 };

    fn of(cell: &Cell) -> Self {
        let mut costs = [f32::INFINITY; SLOTS + 1];
        costs[1..].copy_from_slice(&cell.divided.as_ref().map_or([cell.cost; SLOTS], |divided| divided.costs));
        Self { bounds: cell.bounds, count: cell.count, asked: cell.asked, costs, fills: usize::from(cell.fills) }
    }
}

impl Divided {
    /// Finds the cheapest cuts of a cell's unions, from those of its eighths, and what the whole costs; returns how many slots it fills.
    pub(super) fn find_cuts(&mut self) -> u8 {
        let mut shapes = Shapes { all: [Shape::EMPTY; UNIONS], of: std::array::from_fn(|union| union as u8) };
        for place in 0..8 {
            if let Some(cell) = self.eighth(place) {
                shapes.all[lone(place)] = Shape::of(cell);
            }
        }
        for (index, &union) in LARGER.iter().enumerate() {
            self.cuts.ways[index] = shapes.find_cheapest(union);
        }
        let whole = shapes.of(WHOLE);
        self.costs.copy_from_slice(&whole.costs[1..]);
        whole.fills as u8
    }
}

/// The shapes of a cell's unions.
struct Shapes {
    all: [Shape; UNIONS],
    /// Where each union's stands: where one part of it is empty, the other's.
    of: [u8; UNIONS],
}

impl Shapes {
    fn of(&self, union: Union) -> &Shape {
        &self.all[usize::from(self.of[union])]
    }

    /// Finds the cheapest ways to show a union, whose parts' are known.
    fn find_cheapest(&mut self, union: Union) -> [Way; SLOTS] {
        // Where one part is empty the other is the union, and is shown as it is.
        for (axis, lower, upper) in halves(union) {
            if self.of(lower).count == 0 || self.of(upper).count == 0 {
                let (full, lower_share) = if self.of(lower).count == 0 { (upper, 0) } else { (lower, 1) };
                self.of[union] = self.of[full];
                return std::array::from_fn(|slots| Way::cut(axis, lower_share * (slots + 1)));
            }
        }
        let mut costs = [f32::INFINITY; SLOTS + 1];
        let mut ways = [Way::LEAF; SLOTS];
        for (axis, lower, upper) in halves(union) {
            let (lower, upper) = (self.of(lower), self.of(upper));
            for lower_slots in 1..=lower.fills.min(SLOTS - 1) {
                for upper_slots in 1..=upper.fills.min(SLOTS - lower_slots) {
                    let (slots, cost) =
                        (lower_slots + upper_slots, lower.costs[lower_slots] + upper.costs[upper_slots]);
                    if cost < costs[slots] {
                        costs[slots] = cost;
                        ways[slots - 1] = Way::cut(axis, lower_slots);
                    }
                }
            }
        }
        let whole = halves(union).next().map_or(Shape::EMPTY, |(_, lower, upper)| {
            let (lower, upper) = (self.of(lower), self.of(upper));
            Shape {
                bounds: lower.bounds.union(upper.bounds),
                count: lower.count + upper.count,
                asked: lower.asked + upper.asked,
                costs,
                fills: SLOTS.min(lower.fills + upper.fills),
            }
        });
        let as_leaf = leaf_cost(whole.bounds, whole.count, whole.asked);
        let as_node = node_cost(whole.bounds) + costs[whole.fills];
        (costs[1], ways[0]) = if as_leaf <= as_node { (as_leaf, Way::LEAF) } else { (as_node, Way::NODE) };
        for slots in 2..=SLOTS {
            // Not where they are equal: a node of no surface, shown in one slot, would be shown as itself.
            if costs[slots - 1] < costs[slots] {
                costs[slots] = costs[slots - 1];
                ways[slots - 1] = Way::FEWER;
            }
        }
        self.all[union] = Shape { costs, ..whole };
        ways
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unions_parts_come_before_it() {
        for (index, &union) in LARGER.iter().enumerate() {
            for (_, lower, upper) in halves(union) {
                for part in [lower, upper] {
                    assert!(lone_eighth(part).is_some() || LARGER[..index].contains(&part), "{part} of {union}");
                }
            }
        }
        assert_eq!((0..UNIONS).filter(|&union| lone_eighth(union).is_some()).count() + LARGER.len(), UNIONS);
        assert!((0..8).all(|place| lone_eighth(lone(place)) == Some(place)));
    }

    #[test]
    fn a_way_is_what_it_was_made_of() {
        assert_eq!(Way::NODE.of(WHOLE), Shown::Node);
        assert_eq!(Way::cut(1, 3).of(WHOLE), Shown::Cut { lower: 20, upper: 23, lower_slots: 3 });
        assert_eq!(Way::cut(2, 8).of(2), Shown::Cut { lower: 0, upper: 1, lower_slots: 8 });
    }
}
