//! The report's octree: a cube around all primitives, halved along each axis into eight equal cubes, and these again.
//!
//! ```text
//!   +-------+-------+      A primitive stands in every cell that it touches. A ray visits the cells it passes, from near
//!   |       | o |   |      to far, and stops at the first hit that lies before the next cell.
//!   |       |---+---|
//!   |       |   |/ o|      Only the three planes through a cell's centre are ever looked at: they cut the ray's way through
//!   +-------+---/---+      the cell into at most four pieces, each in one eighth. (Whitted's and Glassner's octrees;
//!   |   o   |  /|   |      Glassner: Space Subdivision for Fast Ray Tracing, IEEE CG&A 1984.)
//!   |       | / |   |
//!   +-------+/------+
//!           ray
//! ```

mod ask;
mod build;
mod cost;
mod overlap;
mod traverse;

use geometry::{Aabb, Hit, Interval, Primitives, Ray};
use glam::Vec3;

use traverse::Visitor;

use crate::{
    Accelerator, Statistics, Visits,
    none::{any_of_all, closest_of, closest_of_all, visits_of_all},
    ordinary::is_ordinary,
};

/// Builds the octree.
pub fn octree(primitives: Primitives) -> Box<dyn Accelerator> {
    Box::new(build::build(primitives))
}

struct Octree {
    primitives: Primitives,
    /// Around all primitives: as tight as they are, not cubic.
    bounds: Aabb,
    root: Cell,
    /// The root is node 0.
    nodes: Vec<Node>,
    /// The leaves' primitives, leaf by leaf, each in rising order.
    references: Vec<u32>,
    depth: usize,
}

/// A cell's cube. Computed on the way down, by the same steps when building and when traversing.
#[derive(Clone, Copy)]
struct Cell {
    center: Vec3,
    /// Half the edge.
    half: f32,
}

enum Node {
    /// Divided: its eighths are eight nodes in a row. Bits 0, 1, 2 of an eighth's place: the upper half in x, y, z.
    /// A bit of `occupied` is set for each eighth that is not empty.
    Branch { first_child: u32, occupied: u8 },
    /// Not divided: its primitives are `references[first..first + count]`.
    Leaf { first: u32, count: u32 },
}

impl Cell {
    /// The cube around a box.
    fn around(bounds: Aabb) -> Self {
        Self { center: bounds.center(), half: 0.5 * bounds.extent().max_element() }
    }

    /// One of its eighths.
    fn eighth(self, place: usize) -> Self {
        let half = 0.5 * self.half;
        let towards = |bit: usize| if place >> bit & 1 == 1 { half } else { -half };
        Self { center: self.center + Vec3::new(towards(0), towards(1), towards(2)), half }
    }
}

impl Accelerator for Octree {
    fn closest(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        if !is_ordinary(ray) {
            return closest_of_all(&self.primitives, ray, within);
        }
        let mut nearest: Option<Hit> = None;
        self.traverse(ray, within, &mut |references: &[u32]| {
            nearest = closest_of(&self.primitives, references.iter().copied(), ray, within, nearest);
            nearest.map_or(within.max, |hit| hit.t)
        });
        nearest
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        if !is_ordinary(ray) {
            return any_of_all(&self.primitives, ray, within);
        }
        let mut found = false;
        self.traverse(ray, within, &mut |references: &[u32]| {
            found |= references.iter().any(|&number| self.primitives.intersect(number, ray, within).is_some());
            if found { f32::NEG_INFINITY } else { within.max }
        });
        found
    }

    fn visits(&self, ray: &Ray, within: Interval) -> Visits {
        if !is_ordinary(ray) {
            return visits_of_all(&self.primitives);
        }
        let mut counter = Counter { octree: self, ray, within, nearest: None, visits: Visits::default() };
        self.traverse(ray, within, &mut counter);
        counter.visits
    }

    fn statistics(&self) -> Statistics {
        let branches = self.nodes.iter().filter(|node| matches!(node, Node::Branch { .. })).count();
        let leaf_sizes = || {
            self.nodes.iter().filter_map(|node| match node {
                Node::Leaf { count: count @ 1.., .. } => Some(*count as usize),
                _ => None,
            })
        };
        let leaves = leaf_sizes().count();
        Statistics {
            branches,
            leaves,
            depth: self.depth,
            references: self.references.len(),
            largest_leaf: leaf_sizes().max().unwrap_or(0),
            cost: self.cost(),
            bytes: size_of_val(&self.nodes[..]) + size_of_val(&self.references[..]),
        }
    }
}

/// Looks for the nearest hit, and counts.
struct Counter<'a> {
    octree: &'a Octree,
    ray: &'a Ray,
    within: Interval,
    nearest: Option<Hit>,
    visits: Visits,
}

impl Visitor for Counter<'_> {
    fn branch(&mut self) {
        self.visits.nodes += 1;
    }

    fn leaf(&mut self, references: &[u32]) -> f32 {
        self.visits.primitives += references.len() as u64;
        self.nearest =
            closest_of(&self.octree.primitives, references.iter().copied(), self.ray, self.within, self.nearest);
        self.nearest.map_or(self.within.max, |hit| hit.t)
    }
}
