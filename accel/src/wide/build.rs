//! From primitives to what is traversed: codes, cells, cuts, then nodes and blocks in a row.

use geometry::{Aabb, Primitives};
use glam::Vec3;
use rayon::prelude::*;

use super::{
    Tree,
    cells::Cell,
    cheapest::{Grown, cheapest, is_in_block},
    collapse::{SLOTS, Shown, Union, WHOLE, covers, lone_eighth},
    layout::{Block, Link, Linked, Mixed, Node},
    morton::Grid,
};
use crate::ordinary::FARTHEST;

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
        references: 0,
        cost: 0.0,
    };
    if inside.is_empty() {
        return tree;
    }
    let Grown { row, root } = cheapest(primitives, &inside, Grid::around(bounds));
    drop(inside);
    tree.cost = root.cost_of_a_ray();
    tree.references = row.len();
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
        self.tree.leaves += 1;
        let (mut triangles, mut asked) = (Vec::new(), Vec::new());
        for &number in numbers {
            let among = if is_in_block(self.primitives, number) { &mut triangles } else { &mut asked };
            // Pieces of one triangle are asked once.
            if !among.contains(&number) {
                among.push(number);
            }
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::Mesh;

    /// Rows of triangles, each so long and so wide, slanting a little more than the last.
    fn triangles(count: u32, length: f32, width: f32) -> Primitives {
        let start = |number: u32| Vec3::new((number % 97) as f32, (number / 97 % 89) as f32, (number % 13) as f32);
        let way = |number: u32| Vec3::new(1.0, (number % 101) as f32 / 50.0 - 1.0, 1.0);
        let triangle = |number: u32| {
            let (start, way) = (start(number), length * way(number));
            [start, start + way, start + way + width * Vec3::X]
        };
        let mut primitives = Primitives::default();
        primitives.add_mesh(Mesh {
            positions: (0..count).flat_map(triangle).collect(),
            triangles: (0..count).map(|number| [3 * number, 3 * number + 1, 3 * number + 2]).collect(),
            ..Mesh::default()
        });
        primitives
    }

    /// All that is traversed.
    fn bits(tree: &Tree) -> Vec<u32> {
        let nodes = tree.nodes.iter().flat_map(|node| {
            let planes = node.planes.as_flattened().as_flattened().iter().map(|plane| plane.to_bits());
            planes.chain(node.links.map(Link::bits))
        });
        let blocks = tree.blocks.iter().flat_map(|block| {
            let corners = block.corners.as_flattened().as_flattened().iter().map(|corner| corner.to_bits());
            corners.chain(block.primitives)
        });
        [tree.root.bits(), tree.cost.to_bits()].into_iter().chain(nodes).chain(blocks).collect()
    }

    #[test]
    fn the_tree_does_not_depend_on_the_number_of_threads() {
        // The first as they are; of the second, most are cut in pieces.
        for (primitives, is_cut) in [(triangles(20_000, 0.5, 0.5), false), (triangles(20_000, 20.0, 0.01), true)] {
            let with = |threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("some threads");
                pool.install(|| build(&primitives))
            };
            let alone = with(1);
            assert_eq!(alone.references > 20_000, is_cut, "{}", alone.references);
            for threads in [2, 5] {
                assert!(bits(&with(threads)) == bits(&alone), "{threads} threads");
            }
        }
    }
}
