//! The tree's nodes and leaves put in a row.

use geometry::{Aabb, Primitives};
use rayon::prelude::*;

use super::{
    cells::Cell,
    cheapest::is_in_block,
    collapse::{MOST_IN_A_LEAF, in_primitives, leaf_cost, node_cost},
    layout::{Link, Linked, Mixed, Node, SLOTS},
    slot::{Slot, cut},
    step::Step,
};

/// What is below a slot, in the order in which it stands in memory.
pub(super) struct Rows<'a> {
    step: Step,
    primitives: &'a Primitives,
    /// The primitives in the order of the cells.
    row: &'a [u32],
    pub(super) nodes: Vec<Node>,
    /// The triangles of each block; `u32::MAX` where there is none.
    pub(super) block_numbers: Vec<[u32; 8]>,
    pub(super) mixed: Vec<Mixed>,
    pub(super) asked: Vec<u32>,
    /// Levels of nodes.
    pub(super) depth: usize,
    pub(super) leaves: usize,
    pub(super) largest_leaf: usize,
    /// What all nodes and leaves cost, each times the half surface of its box.
    cost: f32,
    /// What is left to others.
    left: Vec<Left<'a>>,
}

/// A slot that is laid out by itself, later.
#[derive(Clone, Copy)]
struct Left<'a> {
    slot: Slot<'a>,
    depth: usize,
    /// The node and the place in it that it belongs to.
    node: usize,
    place: usize,
}

/// Slots with more references are laid out first, and what is below each of the others then by any thread. The order is the same for
/// any number of threads.
const WORTH_A_THREAD: u32 = 1 << 14;

/// So many slots are laid out before they are put together.
const LOT: usize = 64;

impl<'a> Rows<'a> {
    /// The whole tree, and the link to its root; `None` if it is more than links can name.
    pub(super) fn of(root: &'a Cell, primitives: &'a Primitives, row: &'a [u32], step: Step) -> Option<(Link, Self)> {
        let mut all = Self::empty(primitives, row, step);
        let least = if root.count > WORTH_A_THREAD { WORTH_A_THREAD } else { 0 };
        let link = all.link(Slot::whole(root), 0, least)?;
        let left = std::mem::take(&mut all.left);
        let apart = |left: &Left<'a>| {
            let mut part = Self::empty(primitives, row, step);
            part.link(left.slot, left.depth, 0).map(|link| (link, part))
        };
        // Some at a time, so that the memory of one lot serves the next.
        for lot in left.chunks(LOT) {
            let parts: Vec<_> = lot.par_iter().map(apart).collect();
            for (left, part) in lot.iter().zip(parts) {
                let (link, part) = part?;
                let link = all.append(link, part)?;
                all.nodes[left.node].set(left.place, left.slot.bounds(), link);
            }
        }
        all.block_numbers.shrink_to_fit();
        all.mixed.shrink_to_fit();
        all.asked.shrink_to_fit();
        all.nodes.shrink_to_fit();
        Some((link, all))
    }

    /// What a ray that meets the box around all costs, in tests of a primitive.
    pub(super) fn cost_of_a_ray(&self, bounds: Aabb) -> f32 {
        let surface = bounds.half_surface();
        if surface > 0.0 { in_primitives(self.cost / surface) } else { 0.0 }
    }

    fn empty(primitives: &'a Primitives, row: &'a [u32], step: Step) -> Self {
        Self {
            step,
            primitives,
            row,
            nodes: Vec::new(),
            block_numbers: Vec::new(),
            // The one that `Link::NOTHING` names.
            mixed: vec![Mixed::default()],
            asked: Vec::new(),
            depth: 0,
            leaves: 0,
            largest_leaf: 0,
            cost: 0.0,
            left: Vec::new(),
        }
    }

    /// Lays out a slot's content, and all below it but slots with no more than `least` references, which are left.
    fn link(&mut self, slot: Slot<'a>, depth: usize, least: u32) -> Option<Link> {
        let one_level = self.step == Step::OneLevel;
        let slot = if one_level { slot } else { slot.settled() };
        if slot.cell.divided.is_none() || (!one_level && slot.is_leaf()) {
            return self.leaf(slot);
        }
        let slots = if one_level { slot.eighths() } else { cut(slot, SLOTS) };
        self.cost += node_cost(slot.bounds());
        self.depth = self.depth.max(depth + 1);
        let node = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        for (place, slot) in slots.into_iter().flatten().enumerate() {
            let depth = depth + 1;
            if least > 0 && slot.count() <= least {
                self.left.push(Left { slot, depth, node, place });
                continue;
            }
            let link = self.link(slot, depth, least)?;
            self.nodes[node].set(place, slot.bounds(), link);
        }
        Link::to(Linked::Node(node as u32))
    }

    fn leaf(&mut self, slot: Slot) -> Option<Link> {
        self.leaves += 1;
        self.cost += leaf_cost(slot.bounds(), slot.count(), slot.asked());
        let first_asked = self.asked.len();
        let mut triangles = [u32::MAX; MOST_IN_A_LEAF as usize];
        let mut count = 0;
        for cell in slot.cells() {
            let first = cell.first as usize;
            for &number in &self.row[first..first + cell.count as usize] {
                if !is_in_block(self.primitives, number) {
                    self.asked.push(number);
                // Pieces of one triangle are asked once.
                } else if !triangles.contains(&number) {
                    triangles[count] = number;
                    count += 1;
                }
            }
        }
        let asked = self.asked.len() - first_asked;
        self.largest_leaf = self.largest_leaf.max(count + asked);
        let first_block = self.block_numbers.len() as u32;
        let blocks = count.div_ceil(8);
        self.block_numbers.extend(&triangles.as_chunks::<8>().0[..blocks]);
        let blocks = blocks as u32;
        if asked == 0 {
            return Link::to(Linked::Blocks { first: first_block, count: blocks });
        }
        let index = self.mixed.len() as u32;
        self.mixed.push(Mixed { first_block, blocks, first_asked: first_asked as u32, asked: asked as u32 });
        Link::to(Linked::Mixed(index))
    }

    /// Takes a part over; returns its root's new link.
    fn append(&mut self, root: Link, part: Self) -> Option<Link> {
        let (nodes, blocks) = (self.nodes.len() as u32, self.block_numbers.len() as u32);
        let (mixed, asked) = (self.mixed.len() as u32 - 1, self.asked.len() as u32);
        let moved = |link: Link| match link.linked() {
            _ if link == Link::NOTHING => Some(link),
            Linked::Node(index) => Link::to(Linked::Node(nodes.checked_add(index)?)),
            Linked::Blocks { first, count } => Link::to(Linked::Blocks { first: blocks.checked_add(first)?, count }),
            Linked::Mixed(index) => Link::to(Linked::Mixed(mixed.checked_add(index)?)),
        };
        for node in part.nodes {
            let mut links = node.links;
            for link in &mut links {
                *link = moved(*link)?;
            }
            self.nodes.push(Node { links, ..node });
        }
        self.block_numbers.extend(part.block_numbers);
        self.mixed.extend(part.mixed[1..].iter().map(|of_part| Mixed {
            first_block: of_part.first_block + blocks,
            first_asked: of_part.first_asked + asked,
            ..*of_part
        }));
        self.asked.extend(part.asked);
        self.depth = self.depth.max(part.depth);
        self.leaves += part.leaves;
        self.cost += part.cost;
        self.largest_leaf = self.largest_leaf.max(part.largest_leaf);
        moved(root)
    }
}
