use geometry::Triangle;
use glam::DVec3;

use super::Cell;

/// Whether a triangle comes within `slack` of a cell. Some that do not may pass; none that does is lost.
///
/// Two convex bodies are apart only if their shadows on some line are: on a normal of either, or on a cross product of an edge of
/// each. The cell's own normals are left out, since the caller has compared the boxes.
///
/// ```text
///      +----+   /|
///      |    |  / |       line of the triangle's normal, and of each triangle's edge x cell's edge
///      |    | /__|
///      +----+      ---+----+--+---+--->
/// ```
///
/// (Akenine-Möller: Fast 3D Triangle-Box Overlap Testing, 2001.)
pub(super) fn triangle_touches(triangle: &Triangle, cell: Cell, slack: f32) -> bool {
    let center = cell.center.as_dvec3();
    let half = f64::from(cell.half) + f64::from(slack);
    let corners = triangle.corners.map(|corner| corner.as_dvec3() - center);
    let [a, b, c] = corners;
    let edges = [b - a, c - b, a - c];
    let apart_along = |line: DVec3| {
        let reach = half * (line.x.abs() + line.y.abs() + line.z.abs());
        let [a, b, c] = corners.map(|corner| corner.dot(line));
        a.min(b).min(c) > reach || a.max(b).max(c) < -reach
    };
    let crossed = |edge: DVec3| {
        [DVec3::new(0.0, -edge.z, edge.y), DVec3::new(edge.z, 0.0, -edge.x), DVec3::new(-edge.y, edge.x, 0.0)]
    };
    !(apart_along(edges[0].cross(edges[1])) || edges.into_iter().flat_map(crossed).any(apart_along))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    const CELL: Cell = Cell { center: Vec3::ZERO, half: 1.0 };

    fn touches(corners: [[f32; 3]; 3]) -> bool {
        triangle_touches(&Triangle { corners: corners.map(Vec3::from) }, CELL, 1e-6)
    }

    #[test]
    fn a_triangle_that_cuts_a_corner_off_touches_and_one_just_past_the_corner_does_not() {
        let across = |distance: f32| [[distance, 0.0, 0.0], [0.0, distance, 0.0], [0.0, 0.0, distance]];
        assert!(touches(across(2.9)));
        assert!(!touches(across(3.1)), "the plane x + y + z = 3.1 passes the corner (1, 1, 1)");
    }

    #[test]
    fn a_needle_past_an_edge_does_not_touch() {
        assert!(!touches([[2.5, 0.0, 0.0], [0.0, 2.5, 0.0], [0.0, 2.5, 0.01]]));
        assert!(touches([[1.9, 0.0, 0.0], [0.0, 1.9, 0.0], [0.0, 1.9, 0.01]]));
    }

    #[test]
    fn touching_counts() {
        assert!(touches([[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0]]));
        assert!(touches([[-5.0, -5.0, 1.0], [5.0, -5.0, 1.0], [0.0, 5.0, 1.0]]));
    }
}
