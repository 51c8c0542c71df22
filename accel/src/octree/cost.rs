use geometry::Aabb;

use super::{Cell, Node, Octree, build::COST_OF_A_BRANCH};

impl Octree {
    /// What a ray that meets the box around all primitives costs, if it passes all of it, in tests of a primitive: each cell counts by the
    /// surface of what of it lies in that box (MacDonald and Booth 1990).
    pub(super) fn cost(&self) -> f32 {
        let surface = self.bounds.half_surface();
        if surface > 0.0 { self.cost_below(0, self.root) / surface } else { 0.0 }
    }

    fn cost_below(&self, index: u32, cell: Cell) -> f32 {
        let cube = cell.bounds();
        let inside = Aabb { min: cube.min.max(self.bounds.min), max: cube.max.min(self.bounds.max) };
        match self.nodes[index as usize] {
            Node::Leaf { count, .. } => inside.half_surface() * count as f32,
            Node::Branch { first_child, occupied } => (0..8)
                .filter(|place| occupied >> place & 1 == 1)
                .map(|place| self.cost_below(first_child + place, cell.eighth(place as usize)))
                .fold(inside.half_surface() * COST_OF_A_BRANCH, |sum, cost| sum + cost),
        }
    }
}

#[cfg(test)]
mod tests {
    use geometry::{Primitives, Sphere};
    use glam::Vec3;

    use super::super::build::build;

    #[test]
    fn the_cost_of_eight_heaps_in_the_corners_is_that_of_the_branch_and_of_a_quarter_of_each() {
        let mut primitives = Primitives::default();
        for number in 0..24_u8 {
            let side = |bit: u8| if number >> bit & 1 == 1 { 1.0 } else { -1.0 };
            primitives.add_sphere(Sphere { center: Vec3::new(side(0), side(1), side(2)), radius: 0.5 });
        }
        // 24 spheres in a cube of 3, whose eighths have 1/4 of its surface each: one visit, and 8 times 1/4 of three tests.
        assert!((build(primitives).cost() - (4.0 + 8.0 * 0.25 * 3.0)).abs() < 1e-4);
    }
}
