use geometry::{Aabb, Clip, Interval, Ray};
use glam::Vec3;

use super::{Cell, Node, Octree, traverse::Visitor};

impl Octree {
    /// The same traversal with somebody's own box test, which is asked for the box of each cell on the way: twice the work of
    /// [`Octree::traverse`], and only as right as that test.
    #[cold]
    pub(super) fn traverse_asking(&self, clip: Clip, ray: &Ray, within: Interval, visitor: &mut dyn Visitor) {
        let Some(way) = clip(&self.bounds, ray, within) else { return };
        let lower = |axis: usize| usize::from(ray.direction[axis].is_sign_negative()) << axis;
        let octant = lower(0) | lower(1) | lower(2);
        let mut walk = Asking { octree: self, clip, ray, within, octant, limit: within.max, visitor };
        walk.pass(0, self.root, way);
    }
}

/// A ray on its way.
struct Asking<'a> {
    octree: &'a Octree,
    clip: Clip,
    ray: &'a Ray,
    within: Interval,
    /// The eighth that the ray would enter first if it passed all.
    octant: usize,
    limit: f32,
    visitor: &'a mut dyn Visitor,
}

impl Asking<'_> {
    fn pass(&mut self, index: u32, cell: Cell, way: Interval) {
        // A hit at just this distance may still have a lower number, hence not >=.
        if way.min > self.limit {
            return;
        }
        match self.octree.nodes[index as usize] {
            Node::Leaf { first, count } => {
                let references = &self.octree.references[first as usize..(first + count) as usize];
                self.limit = self.visitor.leaf(references);
            }
            Node::Branch { first_child, occupied } => {
                self.visitor.branch();
                for crossed in [0b000, 0b001, 0b010, 0b100, 0b011, 0b101, 0b110, 0b111] {
                    let place = crossed ^ self.octant;
                    let eighth = cell.eighth(place);
                    if occupied >> place & 1 == 1
                        && let Some(way) = (self.clip)(&eighth.bounds(), self.ray, self.within)
                    {
                        self.pass(first_child + place as u32, eighth, way);
                    }
                }
            }
        }
    }
}

impl Cell {
    /// Its cube.
    pub(super) fn bounds(self) -> Aabb {
        let half = Vec3::splat(self.half);
        Aabb { min: self.center - half, max: self.center + half }
    }
}
