//! What is traversed: wide nodes and blocks of triangles, laid out for one step of sixteen lanes and of eight.

use geometry::Aabb;
use glam::Vec3;

/// The boxes of a node: as many as there are lanes in a step.
pub(super) const SLOTS: usize = 16;

/// A cut of the octree: sixteen boxes side by side, and what is in each.
///
/// 448 bytes, seven cache lines: a row of sixteen numbers for each of the six planes, so that one load brings a plane of all the boxes.
#[derive(Clone)]
#[repr(C, align(64))]
pub(super) struct Node {
    /// For x, y, z: the lower planes, the upper planes.
    pub(super) planes: [[[f32; SLOTS]; 2]; 3],
    pub(super) links: [Link; SLOTS],
}

impl Node {
    /// With no slot taken: boxes that no ray meets.
    pub(super) const EMPTY: Self =
        Self { planes: [[[f32::INFINITY; SLOTS], [f32::NEG_INFINITY; SLOTS]]; 3], links: [Link::NOTHING; SLOTS] };

    pub(super) fn set(&mut self, slot: usize, bounds: Aabb, link: Link) {
        for axis in 0..3 {
            self.planes[axis][0][slot] = bounds.min[axis];
            self.planes[axis][1][slot] = bounds.max[axis];
        }
        self.links[slot] = link;
    }
}

/// Eight triangles side by side. 320 bytes: 40 for each triangle, five cache lines.
#[derive(Clone)]
#[repr(C, align(64))]
pub(super) struct Block {
    /// For each corner: x, y, z. A lane that is not taken has NaN, which no ray meets.
    pub(super) corners: [[[f32; 8]; 3]; 3],
    pub(super) primitives: [u32; 8],
}

impl Block {
    /// The corners of one of its triangles, their axes in an order.
    #[inline(always)]
    pub(super) fn corners_at(&self, lane: usize, [x, y, z]: [usize; 3]) -> [Vec3; 3] {
        let corner = |rows: &[[f32; 8]; 3]| Vec3::new(rows[x][lane & 7], rows[y][lane & 7], rows[z][lane & 7]);
        [corner(&self.corners[0]), corner(&self.corners[1]), corner(&self.corners[2])]
    }

    pub(super) const EMPTY: Self = Self { corners: [[[f32::NAN; 8]; 3]; 3], primitives: [u32::MAX; 8] };
}

/// A leaf that is more than blocks: the blocks, then what is asked one by one.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Mixed {
    pub(super) first_block: u32,
    pub(super) blocks: u32,
    pub(super) first_asked: u32,
    pub(super) asked: u32,
}

/// Names a node or a leaf, in 32 bits.
///
/// ```text
///   0nnn nnnn ...   node n            10mb bbbb ...   m + 1 blocks from b on            11ll llll ...   mixed leaf l
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Link(u32);

/// A [`Link`], taken apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Linked {
    Node(u32),
    Blocks { first: u32, count: u32 },
    Mixed(u32),
}

const LEAF: u32 = 1 << 31;
const MIXED: u32 = 1 << 30;
const TWO: u32 = 1 << 29;

impl Link {
    /// A mixed leaf with nothing in it.
    pub(super) const NOTHING: Self = Self(LEAF | MIXED);

    /// `None` if there are too many nodes or blocks for the bits.
    pub(super) fn to(linked: Linked) -> Option<Self> {
        match linked {
            Linked::Node(index) => (index < LEAF).then_some(Self(index)),
            Linked::Blocks { first, count } => {
                let two = if count == 2 { TWO } else { 0 };
                ((1..=2).contains(&count) && first < TWO).then_some(Self(LEAF | two | first))
            }
            Linked::Mixed(index) => (index < MIXED).then_some(Self(LEAF | MIXED | index)),
        }
    }

    #[inline(always)]
    pub(super) fn is_node(self) -> bool {
        self.0 < LEAF
    }

    #[inline(always)]
    pub(super) fn linked(self) -> Linked {
        if self.is_node() {
            Linked::Node(self.0)
        } else if self.0 & MIXED == 0 {
            Linked::Blocks { first: self.0 & (TWO - 1), count: 1 + (self.0 >> 29 & 1) }
        } else {
            Linked::Mixed(self.0 & (MIXED - 1))
        }
    }

    #[inline(always)]
    pub(super) fn bits(self) -> u32 {
        self.0
    }

    #[inline(always)]
    pub(super) fn from_bits(bits: u32) -> Self {
        Self(bits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_is_what_it_was_made_of() {
        let all = [
            Linked::Node(0),
            Linked::Node(LEAF - 1),
            Linked::Blocks { first: TWO - 1, count: 1 },
            Linked::Blocks { first: 7, count: 2 },
            Linked::Mixed(MIXED - 1),
        ];
        for linked in all {
            assert_eq!(Link::to(linked).map(Link::linked), Some(linked));
        }
        assert_eq!(Link::to(Linked::Blocks { first: TWO, count: 1 }), None);
    }

    #[test]
    fn a_node_and_a_block_take_the_room_they_are_said_to_take() {
        assert_eq!((size_of::<Node>(), size_of::<Block>()), (448, 320));
    }
}
