use geometry::{Aabb, Primitives};
use glam::Vec3;

use super::{Cell, Node, Octree};

/// Cells are not divided below this depth: an edge of 2^-16 of the root's.
const MAX_DEPTH: usize = 16;

/// What visiting a divided cell costs, in tests of a primitive.
const COST_OF_A_BRANCH: f32 = 2.0;

/// All leaves together hold at most this many references for each primitive, so that memory stays in proportion.
const MAX_REFERENCES_PER_PRIMITIVE: usize = 32;

pub(super) fn build(primitives: Primitives) -> Octree {
    let boxes: Vec<Aabb> = (0..primitives.len()).map(|number| primitives.bounds(number)).collect();
    let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
    let mut builder = Builder {
        budget: boxes.len() * MAX_REFERENCES_PER_PRIMITIVE,
        boxes,
        nodes: vec![Node::Leaf { first: 0, count: 0 }],
        references: Vec::new(),
        depth: 0,
    };
    let root = Cell::around(bounds);
    builder.fill(0, root, (0..primitives.len()).collect(), 0);
    let Builder { nodes, references, depth, .. } = builder;
    Octree { primitives, bounds, root, nodes, references, depth }
}

struct Builder {
    boxes: Vec<Aabb>,
    nodes: Vec<Node>,
    references: Vec<u32>,
    depth: usize,
    /// References that may still be added by dividing cells.
    budget: usize,
}

impl Builder {
    /// Makes node `index`, a cell at `depth` with these primitives, a leaf or a branch.
    fn fill(&mut self, index: usize, cell: Cell, inside: Vec<u32>, depth: usize) {
        self.depth = self.depth.max(depth);
        match self.divide(cell, &inside, depth) {
            None => {
                self.nodes[index] = Node::Leaf { first: self.references.len() as u32, count: inside.len() as u32 };
                self.references.extend(inside);
            }
            Some(eighths) => {
                drop(inside);
                let first_child = self.nodes.len();
                self.nodes[index] = Node::Branch { first_child: first_child as u32 };
                self.nodes.extend((0..8).map(|_| Node::Leaf { first: 0, count: 0 }));
                for (place, inside) in eighths.into_iter().enumerate() {
                    self.fill(first_child + place, cell.eighth(place), inside, depth + 1);
                }
            }
        }
    }

    /// The primitives of each eighth, if dividing pays.
    ///
    /// A ray that passes a cube passes each of its eighths with a probability of 1/4, the ratio of their surfaces (Cauchy
    /// 1841; MacDonald and Booth 1990). So a leaf of n costs n tests, and a division costs a visit and a quarter of all the
    /// eighths' tests.
    fn divide(&mut self, cell: Cell, inside: &[u32], depth: usize) -> Option<[Vec<u32>; 8]> {
        if depth == MAX_DEPTH || inside.len() as f32 <= COST_OF_A_BRANCH {
            return None;
        }
        let mut eighths: [Vec<u32>; 8] = Default::default();
        for &number in inside {
            let touched = touched_eighths(self.boxes[number as usize], cell.center);
            for (place, eighth) in eighths.iter_mut().enumerate() {
                if touched >> place & 1 == 1 {
                    eighth.push(number);
                }
            }
        }
        let total: usize = eighths.iter().map(Vec::len).sum();
        let added = total.saturating_sub(inside.len());
        let pays = COST_OF_A_BRANCH + 0.25 * (total as f32) < inside.len() as f32;
        if !pays || added > self.budget {
            return None;
        }
        self.budget -= added;
        Some(eighths)
    }
}

/// A bit for each eighth around a centre that a box touches. A box that ends on a dividing plane touches both sides.
fn touched_eighths(bounds: Aabb, center: Vec3) -> u8 {
    /// The eighths in the lower half of x, y, z.
    const LOWER: [u8; 3] = [0b0101_0101, 0b0011_0011, 0b0000_1111];
    (0..3).fold(0xFF, |touched, axis| {
        let lower = if bounds.min[axis] <= center[axis] { LOWER[axis] } else { 0 };
        let upper = if bounds.max[axis] >= center[axis] { !LOWER[axis] } else { 0 };
        touched & (lower | upper)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_on_a_dividing_plane_touches_both_sides() {
        let flat = Aabb { min: Vec3::new(-2.0, -2.0, 0.0), max: Vec3::new(-1.0, -1.0, 0.0) };
        assert_eq!(touched_eighths(flat, Vec3::ZERO), 0b0001_0001);
        let everywhere = Aabb { min: Vec3::splat(-1.0), max: Vec3::ONE };
        assert_eq!(touched_eighths(everywhere, Vec3::ZERO), 0xFF);
    }
}
