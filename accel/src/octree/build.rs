use geometry::{Aabb, Primitives};
use glam::Vec3;

use super::{Cell, Node, Octree, overlap::triangle_touches};

/// Cells are not divided below this depth: an edge of 2^-16 of the root's.
const MAX_DEPTH: usize = 16;

/// What visiting a divided cell costs, in tests of a primitive.
pub(super) const COST_OF_A_BRANCH: f32 = 4.0;

/// So many divisions in a row may seem not to pay: a tower that stands on the root's centre falls into four eighths whole before
/// the next divisions cut it up.
const PATIENCE: usize = 3;

pub(super) fn build(primitives: Primitives) -> Octree {
    let boxes: Vec<Aabb> = (0..primitives.len()).map(|number| primitives.bounds(number)).collect();
    let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
    let root = Cell::around(bounds);
    let grower = Grower { primitives: &primitives, boxes, slack: 8.0 * f32::EPSILON * bounds.magnitude() };
    let Grown { tree, .. } = grower.grow(root, (0..primitives.len()).collect(), 0, PATIENCE);
    let mut flat = Flat { nodes: vec![Node::Leaf { first: 0, count: 0 }], references: Vec::new(), depth: 0 };
    flat.lay_out(0, tree, 0);
    let Flat { nodes, references, depth } = flat;
    Octree { primitives, bounds, root, nodes, references, depth }
}

/// A cell with all below it.
enum Tree {
    Leaf(Vec<u32>),
    Branch(Box<[Tree; 8]>),
}

impl Tree {
    fn is_empty(&self) -> bool {
        matches!(self, Self::Leaf(inside) if inside.is_empty())
    }
}

/// A tree, and what a ray that passes its cell costs in tests of a primitive.
struct Grown {
    tree: Tree,
    cost: f32,
}

struct Grower<'a> {
    primitives: &'a Primitives,
    boxes: Vec<Aabb>,
    /// A primitive this near to a cell counts as touching it: much more than a cell's rounding.
    slack: f32,
}

impl Grower<'_> {
    /// The cheapest tree for the primitives inside a cell: divided as far as it pays.
    ///
    /// A ray that passes a cube passes each of its eighths with a probability of 1/4, the ratio of their surfaces (Cauchy 1841;
    /// MacDonald and Booth 1990). So a leaf of n costs n tests, and a division costs a visit and a quarter of what all its
    /// eighths cost. Whether it pays is known only after the eighths themselves have been divided.
    fn grow(&self, cell: Cell, inside: Vec<u32>, depth: usize, patience: usize) -> Grown {
        let cost_as_leaf = inside.len() as f32;
        if cost_as_leaf <= COST_OF_A_BRANCH || depth == MAX_DEPTH {
            return Grown { tree: Tree::Leaf(inside), cost: cost_as_leaf };
        }
        let eighths = self.divide(cell, &inside);
        let total: usize = eighths.iter().map(Vec::len).sum();
        let seems_to_pay = COST_OF_A_BRANCH + 0.25 * (total as f32) < cost_as_leaf;
        // What stands whole in two eighths is not told apart by cutting off the others: equal things would be divided along all their
        // edges, down to the last level.
        let separates = eighths.iter().filter(|eighth| eighth.len() == inside.len()).count() < 2;
        let patience = if seems_to_pay && separates { PATIENCE } else { patience - 1 };
        if patience == 0 {
            return Grown { tree: Tree::Leaf(inside), cost: cost_as_leaf };
        }
        let mut cost = COST_OF_A_BRANCH;
        let mut place = 0;
        let below = eighths.map(|inside| {
            let grown = self.grow(cell.eighth(place), inside, depth + 1, patience);
            place += 1;
            cost += 0.25 * grown.cost;
            grown.tree
        });
        if cost < cost_as_leaf {
            Grown { tree: Tree::Branch(Box::new(below)), cost }
        } else {
            Grown { tree: Tree::Leaf(inside), cost: cost_as_leaf }
        }
    }

    /// The primitives of each eighth of a cell.
    fn divide(&self, cell: Cell, inside: &[u32]) -> [Vec<u32>; 8] {
        let mut eighths: [Vec<u32>; 8] = Default::default();
        for &number in inside {
            let touched = touched_eighths(self.boxes[number as usize], cell.center);
            for (place, eighth) in eighths.iter_mut().enumerate() {
                if touched >> place & 1 == 1 && self.touches(number, cell.eighth(place)) {
                    eighth.push(number);
                }
            }
        }
        eighths
    }

    /// Whether a primitive whose box touches a cell may touch the cell itself.
    fn touches(&self, number: u32, cell: Cell) -> bool {
        self.primitives.triangle(number).is_none_or(|triangle| triangle_touches(triangle, cell, self.slack))
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

/// The tree as it is traversed: all nodes in a row, all references in a row.
struct Flat {
    nodes: Vec<Node>,
    references: Vec<u32>,
    depth: usize,
}

impl Flat {
    /// Puts a tree at a node that is there already.
    fn lay_out(&mut self, index: usize, tree: Tree, depth: usize) {
        self.depth = self.depth.max(depth);
        match tree {
            Tree::Leaf(inside) => {
                self.nodes[index] = Node::Leaf { first: self.references.len() as u32, count: inside.len() as u32 };
                self.references.extend(inside);
            }
            Tree::Branch(below) => {
                let first_child = self.nodes.len();
                let occupied = below.iter().rev().fold(0, |bits, tree| bits << 1 | u8::from(!tree.is_empty()));
                self.nodes[index] = Node::Branch { first_child: first_child as u32, occupied };
                self.nodes.extend((0..8).map(|_| Node::Leaf { first: 0, count: 0 }));
                for (place, tree) in below.into_iter().enumerate() {
                    self.lay_out(first_child + place, tree, depth + 1);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::Sphere;

    /// Found by the kit: thirty spheres in one place were divided along the twelve edges of their box down to the last level.
    #[test]
    fn equal_things_are_not_divided_along_their_edges() {
        let mut primitives = Primitives::default();
        for _ in 0..30 {
            primitives.add_sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
        }
        primitives.add_sphere(Sphere { center: Vec3::new(7.0, 5.0, 3.0), radius: 0.5 });
        let nodes = build(primitives).nodes.len();
        assert!(nodes < 1000, "{nodes}");
    }

    #[test]
    fn a_box_on_a_dividing_plane_touches_both_sides() {
        let flat = Aabb { min: Vec3::new(-2.0, -2.0, 0.0), max: Vec3::new(-1.0, -1.0, 0.0) };
        assert_eq!(touched_eighths(flat, Vec3::ZERO), 0b0001_0001);
        let everywhere = Aabb { min: Vec3::splat(-1.0), max: Vec3::ONE };
        assert_eq!(touched_eighths(everywhere, Vec3::ZERO), 0xFF);
    }
}
