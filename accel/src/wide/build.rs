//! From primitives to what is traversed: codes, cells, cuts, then nodes and blocks in a row.

use geometry::{Aabb, Primitives};
use glam::Vec3;
use rayon::prelude::*;

use super::{
    Tree,
    cheapest::{Grown, cheapest},
    layout::{Block, Link, Mixed},
    morton::Grid,
    rows::Rows,
    step::Step,
};
use crate::ordinary::FARTHEST;

pub(super) fn build(primitives: &Primitives, step: Step) -> Tree {
    // What reaches further stands beside the tree. Written so that a NaN does not fit.
    let fits = |bounds: Aabb| bounds.min.min_element() > -FARTHEST && bounds.max.max_element() < FARTHEST;
    let around = |number: u32| Some(primitives.bounds(number)).filter(|&bounds| fits(bounds));
    let all = (0..primitives.len()).into_par_iter().with_min_len(4096);
    let both = |a: (Aabb, u32), b: (Aabb, u32)| (a.0.union(b.0), a.1 + b.1);
    let (bounds, count) = all.clone().filter_map(around).map(|bounds| (bounds, 1)).reduce(|| (Aabb::EMPTY, 0), both);
    let (inside, beside): (Vec<u32>, Vec<u32>) = if count == primitives.len() {
        (all.collect(), Vec::new())
    } else {
        all.partition(|&number| around(number).is_some())
    };
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
    let Grown { row, root } = cheapest(primitives, &inside, Grid::around(bounds), step);
    drop(inside);
    tree.references = row.len();
    match Rows::of(&root, primitives, &row, step) {
        Some((link, rows)) => {
            let cost = rows.cost_of_a_ray(bounds);
            let Rows { nodes, block_numbers, mixed, asked, depth, leaves, largest_leaf, .. } = rows;
            let blocks =
                || block_numbers.par_iter().with_min_len(512).map(|numbers| block(primitives, numbers)).collect();
            // To free the cells takes as long as a tenth of the rest.
            let (blocks, ()) = rayon::join(blocks, || drop(root));
            Tree { root: link, nodes, blocks, mixed, asked, depth, leaves, largest_leaf, cost, ..tree }
        }
        // More than the links can name: 10^9 blocks. What stands beside the tree is found, too.
        None => Tree { beside: (0..primitives.len()).collect(), ..tree },
    }
}

/// The corners of triangles side by side.
fn block(primitives: &Primitives, numbers: &[u32; 8]) -> Block {
    let mut block = Block { primitives: *numbers, ..Block::EMPTY };
    for (lane, &number) in numbers.iter().enumerate().filter(|&(_, &number)| number != u32::MAX) {
        let corners = primitives.triangle(number).map_or([Vec3::NAN; 3], |triangle| triangle.corners);
        for (rows, corner) in block.corners.iter_mut().zip(corners) {
            for axis in 0..3 {
                rows[axis][lane] = corner[axis];
            }
        }
    }
    block
}

#[cfg(test)]
mod tests {
    use super::super::collapse::in_primitives;
    use super::*;
    use geometry::{Mesh, Sphere};

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

    /// Of a tree large enough to be laid out in parts.
    #[test]
    fn every_primitive_stands_in_one_leaf() {
        let count = 60_000;
        let mut primitives = triangles(count, 0.5, 0.5);
        for number in 0..count {
            let center = Vec3::new((number % 97) as f32, (number / 97 % 89) as f32, (number % 13) as f32);
            primitives.add_sphere(Sphere { center, radius: 0.25 });
        }
        let tree = build(&primitives, Step::ThinInPieces);
        let mut seen = vec![0; primitives.len() as usize];
        let mut links = vec![tree.root];
        while let Some(link) = links.pop() {
            if link.is_node() {
                links.extend(tree.nodes[link.bits() as usize].links);
            } else {
                let (blocks, asked) = tree.leaf(link);
                let in_lanes = tree.blocks[blocks].iter().flat_map(|block| block.primitives);
                let taken = in_lanes.filter(|&number| number != u32::MAX);
                taken.chain(asked.iter().copied()).for_each(|number| seen[number as usize] += 1);
            }
        }
        assert_eq!(seen.iter().position(|&times| times != 1), None);
    }

    /// What the search promised is what is laid out.
    #[test]
    fn the_tree_costs_what_its_cuts_were_chosen_for() {
        let primitives = triangles(30_000, 0.5, 0.5);
        let numbers: Vec<u32> = (0..30_000).collect();
        let bounds = numbers.iter().map(|&number| primitives.bounds(number)).fold(Aabb::EMPTY, Aabb::union);
        let Grown { root, .. } = cheapest(&primitives, &numbers, Grid::around(bounds), Step::CheapestCuts);
        let promised = in_primitives(root.cost / bounds.half_surface());
        let cost = build(&primitives, Step::CheapestCuts).cost;
        // The same sum in another order: a rounding for each of some thousand terms.
        assert!((cost - promised).abs() < 1e-3 * promised, "{cost} {promised}");
        assert!(build(&primitives, Step::OneLevel).cost > promised);
    }

    /// All three waste more than a tenth. Of the first, pieces save a fourteenth; of the second, an eighth; of the third, a third.
    #[test]
    fn thin_triangles_are_cut_where_that_saves_a_tenth() {
        for (length, width, is_cut) in [(4.0, 1.0, false), (8.0, 2.0, true), (20.0, 0.01, true)] {
            let primitives = triangles(20_000, length, width);
            let (whole, best) = (build(&primitives, Step::CheapestCuts), build(&primitives, Step::ThinInPieces));
            assert_eq!(best.references > whole.references, is_cut, "{length} x {width}");
            assert_eq!(best.cost < 0.9 * whole.cost, is_cut, "{length} x {width}");
            assert!(is_cut || bits(&best) == bits(&whole), "{length} x {width}");
        }
    }

    #[test]
    fn the_tree_does_not_depend_on_the_number_of_threads() {
        // The first as they are; of the second, most are cut in pieces.
        for (primitives, is_cut) in [(triangles(20_000, 0.5, 0.5), false), (triangles(20_000, 20.0, 0.01), true)] {
            let with = |threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("some threads");
                pool.install(|| build(&primitives, Step::ThinInPieces))
            };
            let alone = with(1);
            assert_eq!(alone.references > 20_000, is_cut, "{}", alone.references);
            for threads in [2, 5] {
                assert!(bits(&with(threads)) == bits(&alone), "{threads} threads");
            }
        }
    }
}
