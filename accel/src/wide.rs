//! The wide octree.

mod boxes;
mod build;
mod cells;
mod collapse;
mod layout;
mod morton;
mod simd;
mod traverse;
mod triangles;

use geometry::{Hit, Interval, Primitives, Ray};

use crate::{Accelerator, Statistics, none::closest_of};
use layout::{Block, Link, Mixed, Node};
use simd::{Isa, Portable};

/// Levels of wide nodes, at most: below the 21 levels of the Morton codes 11 of rows cut in eight (8^11 > 2^32), and in each cell a
/// node for a whole, a half and a pair.
const MOST_LEVELS: usize = 3 * (21 + 11);

/// What a ray can have to visit, at most: of each level the slots that it is not in.
const MOST_PENDING: usize = 7 * MOST_LEVELS + 1;

/// Builds the wide octree.
pub fn wide(primitives: Primitives) -> Box<dyn Accelerator> {
    let tree = build::build(&primitives);
    #[cfg(target_arch = "x86_64")]
    {
        if let Some(isa) = simd::Avx512::detect() {
            return Box::new(Wide { isa, primitives, tree });
        }
        if let Some(isa) = simd::Avx2::detect() {
            return Box::new(Wide { isa, primitives, tree });
        }
    }
    Box::new(Wide { isa: Portable, primitives, tree })
}

struct Tree {
    root: Link,
    nodes: Vec<Node>,
    blocks: Vec<Block>,
    /// The first is empty, and what [`Link::NOTHING`] names.
    mixed: Vec<Mixed>,
    /// The primitives of mixed leaves that are asked one by one.
    asked: Vec<u32>,
    /// Primitives that are not in the tree.
    beside: Vec<u32>,
    /// The greatest coordinate.
    magnitude: f32,
    /// Levels of nodes.
    depth: usize,
}

struct Wide<I> {
    isa: I,
    primitives: Primitives,
    tree: Tree,
}

/// Whether the bounds argued for hold for a ray: nothing in it is infinite or a NaN, and nothing overflows. Other rays ask every primitive.
fn is_ordinary(ray: &Ray) -> bool {
    const FARTHEST: f32 = (1_u64 << 40) as f32;
    let length = ray.direction.abs().max_element();
    // NaN compares false.
    ray.origin.abs().cmplt(glam::Vec3::splat(FARTHEST)).all()
        && ray.direction.abs().cmplt(glam::Vec3::splat(FARTHEST)).all()
        && length > 1.0 / FARTHEST
}

impl<I: Isa + Send + Sync> Accelerator for Wide<I> {
    fn closest(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        if !is_ordinary(ray) {
            return closest_of(&self.primitives, 0..self.primitives.len(), ray, within, None);
        }
        self.isa.vectorize(
            #[inline(always)]
            || traverse::closest(self.isa, &self.tree, &self.primitives, ray, within),
        )
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        if !is_ordinary(ray) {
            return (0..self.primitives.len()).any(|number| self.primitives.intersect(number, ray, within).is_some());
        }
        self.isa.vectorize(
            #[inline(always)]
            || traverse::any(self.isa, &self.tree, &self.primitives, ray, within),
        )
    }

    fn statistics(&self) -> Statistics {
        let Tree { nodes, blocks, mixed, asked, depth, .. } = &self.tree;
        Statistics {
            branches: nodes.len(),
            leaves: blocks.len(),
            depth: *depth,
            references: self.primitives.len() as usize,
            bytes: size_of_val(&nodes[..])
                + size_of_val(&blocks[..])
                + size_of_val(&mixed[..])
                + size_of_val(&asked[..]),
        }
    }
}
