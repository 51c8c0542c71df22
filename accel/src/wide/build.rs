//! From primitives to what is traversed: codes, cells, cuts, then nodes and blocks in a row.

use geometry::{Aabb, Primitives};
use glam::Vec3;
use rayon::prelude::*;

use super::{
    Tree,
    cells::{Cell, Content, grow},
    collapse::{SLOTS, Shown, Union, WHOLE, covers, lone_eighth},
    layout::{Block, Link, Linked, Mixed, Node},
    morton,
};
use crate::ordinary::FARTHEST;

struct Shapes<'a>(&'a Primitives);

impl Content for Shapes<'_> {
    fn bounds(&self, primitive: u32) -> Aabb {
        self.0.bounds(primitive)
    }

    fn is_in_block(&self, primitive: u32) -> bool {
        // A kernel of someone else's may accept what the blocks' filter would leave out.
        self.0.kernels().triangle.is_none() && self.0.triangle(primitive).is_some()
    }
}

pub(super) fn build(primitives: &Primitives) -> Tree {
    let fits = |&number: &u32| {
        let bounds = primitives.bounds(number);
        // What reaches further stands beside the tree. Written so that a NaN does not fit.
        bounds.min.min_element() > -FARTHEST && bounds.max.max_element() < FARTHEST
    };
    let (inside, beside): (Vec<u32>, Vec<u32>) = (0..primitives.len()).into_par_iter().partition(fits);
    let bounds = inside
        .par_iter()
        .with_min_len(4096)
        .map(|&number| primitives.bounds(number))
        .reduce(|| Aabb::EMPTY, Aabb::union);
    let mut tree = Tree {
        root: Link::NOTHING,
        nodes: Vec::new(),
        blocks: Vec::new(),
        mixed: vec![Mixed::default()],
        asked: Vec::new(),
        beside,
        magnitude: bounds.magnitude(),
        depth: 0,
        leaves: 0,
        largest_leaf: 0,
        cost: 0.0,
    };
    if inside.is_empty() {
        return tree;
    }
    let row = morton::in_morton_order(&inside, |number| primitives.bounds(number), bounds);
    drop(inside);
    let root = grow(&row, 0, &Shapes(primitives));
    tree.cost = root.cost_of_a_ray();
    let row: Vec<u32> = row.into_iter().map(|coded| coded.primitive).collect();
    let mut layout = Layout { primitives, row: &row, tree: &mut tree, block_numbers: Vec::new() };
    match layout.link(Slot { cell: &root, union: WHOLE }, 0) {
        Some(link) => {
            layout.tree.root = link;
            layout.fill_blocks();
        }
        // More than the links can name: 10^9 blocks. What stands beside the tree is found, too.
        None => {
            tree = Tree { nodes: Vec::new(), blocks: Vec::new(), asked: Vec::new(), ..tree };
            tree.beside = (0..primitives.len()).collect();
        }
    }
    tree
}

/// What is shown in one slot of a node.
#[derive(Clone, Copy)]
struct Slot<'a> {
    cell: &'a Cell,
    /// Of the cell's eighths; of a cell that is not divided, the whole.
    union: Union,
}

impl Slot<'_> {
    fn cells(self) -> impl Iterator<Item = Self> {
        let eighth = move |place| self.cell.divided.as_ref()?.eighth(place).filter(|_| covers(self.union, place));
        let itself = if self.cell.divided.is_none() { Some(self.cell) } else { None };
        (0..8).filter_map(eighth).chain(itself).map(|cell| Slot { cell, union: WHOLE })
    }

    fn bounds(self) -> Aabb {
        self.cells().fold(Aabb::EMPTY, |all, slot| all.union(slot.cell.bounds))
    }

    /// Whether it is a leaf.
    fn is_leaf(self) -> bool {
        self.cell.divided.as_ref().is_none_or(|divided| divided.cuts.shown(self.union, 1) == Shown::Leaf)
    }
}

struct Layout<'a> {
    primitives: &'a Primitives,
    /// The primitives in the order of the cells.
    row: &'a [u32],
    tree: &'a mut Tree,
    /// The triangles of each block; `u32::MAX` where there is none.
    block_numbers: Vec<[u32; 8]>,
}

impl Layout<'_> {
    /// Lays out a slot's content, and all below it.
    fn link(&mut self, slot: Slot, depth: usize) -> Option<Link> {
        let slots = cut(slot, 1);
        // A union with one part empty is the other part.
        let slot = slots.iter().flatten().next().copied().unwrap_or(slot);
        if slot.is_leaf() {
            return self.leaf(slot);
        }
        self.tree.depth = self.tree.depth.max(depth + 1);
        let index = self.tree.nodes.len();
        self.tree.nodes.push(Node::EMPTY);
        for (place, slot) in cut(slot, SLOTS).into_iter().flatten().enumerate() {
            let link = self.link(slot, depth + 1)?;
            self.tree.nodes[index].set(place, slot.bounds(), link);
        }
        Link::to(Linked::Node(index as u32))
    }

    fn leaf(&mut self, slot: Slot) -> Option<Link> {
        let numbers = slot.cells().flat_map(|slot| {
            let first = slot.cell.first as usize;
            &self.row[first..first + slot.cell.count as usize]
        });
        let content = Shapes(self.primitives);
        self.tree.leaves += 1;
        let (triangles, asked): (Vec<u32>, Vec<u32>) = numbers.partition(|&&number| content.is_in_block(number));
        self.tree.largest_leaf = self.tree.largest_leaf.max(triangles.len() + asked.len());
        let first_block = self.block_numbers.len() as u32;
        for chunk in triangles.chunks(8) {
            self.block_numbers.push(std::array::from_fn(|lane| chunk.get(lane).copied().unwrap_or(u32::MAX)));
        }
        let blocks = self.block_numbers.len() as u32 - first_block;
        if asked.is_empty() {
            return Link::to(Linked::Blocks { first: first_block, count: blocks });
        }
        let first_asked = self.tree.asked.len() as u32;
        let index = self.tree.mixed.len() as u32;
        self.tree.mixed.push(Mixed { first_block, blocks, first_asked, asked: asked.len() as u32 });
        self.tree.asked.extend(asked);
        Link::to(Linked::Mixed(index))
    }

    fn fill_blocks(&mut self) {
        let fill = |numbers: &[u32; 8]| {
            let mut block = Block { primitives: *numbers, ..Block::EMPTY };
            for (lane, &number) in numbers.iter().enumerate().filter(|&(_, &number)| number != u32::MAX) {
                let corners = self.primitives.triangle(number).map_or([Vec3::NAN; 3], |triangle| triangle.corners);
                for (rows, corner) in block.corners.iter_mut().zip(corners) {
                    for axis in 0..3 {
                        rows[axis][lane] = corner[axis];
                    }
                }
            }
            block
        };
        self.tree.blocks = self.block_numbers.par_iter().with_min_len(512).map(fill).collect();
    }
}

/// The slots in which a slot's content is best shown, at most so many.
fn cut(slot: Slot, most: usize) -> [Option<Slot>; SLOTS] {
    let mut slots = [None; SLOTS];
    cut_into(slot, most, &mut slots.iter_mut());
    slots
}

fn cut_into<'a, 's>(slot: Slot<'a>, most: usize, slots: &mut impl Iterator<Item = &'s mut Option<Slot<'a>>>)
where
    'a: 's,
{
    let Some(divided) = &slot.cell.divided else {
        slots.next().expect("a slot for each").replace(slot);
        return;
    };
    if let Some(place) = lone_eighth(slot.union) {
        if let Some(cell) = divided.eighth(place) {
            cut_into(Slot { cell, union: WHOLE }, most, slots);
        }
        return;
    }
    match divided.cuts.shown(slot.union, most) {
        Shown::Leaf | Shown::Node => {
            slots.next().expect("a slot for each").replace(slot);
        }
        Shown::Fewer => cut_into(slot, most - 1, slots),
        Shown::Cut { lower, upper, lower_slots } => {
            for (union, most) in [(lower, lower_slots), (upper, most - lower_slots)] {
                if most > 0 {
                    cut_into(Slot { union, ..slot }, most, slots);
                }
            }
        }
    }
}
