//! Polygons in space as triangles.

use crate::scene_file::Triple;

/// Polygons of more corners are cut as if they were convex: to cut the others takes time by the square of their corners, and nobody
/// writes such.
const MOST_CORNERS: usize = 64;

/// Gives each triangle of a polygon, as places among its corners, in the polygon's own sense of rotation: a fan around the first
/// corner where the polygon is convex, else ears (Meisters: Polygons Have Ears, 1975). What has no ears left, as it crosses itself or
/// lies on a line, ends as a fan, too.
pub(super) fn triangles<E>(corners: &[Triple], mut each: impl FnMut([usize; 3]) -> Result<(), E>) -> Result<(), E> {
    let mut left: Vec<usize> = (0..corners.len()).collect();
    if (4..=MOST_CORNERS).contains(&corners.len()) {
        let flat = flattened(corners);
        if !is_convex(&flat) {
            while left.len() > 3 {
                let Some(ear) = (0..left.len()).find(|&at| is_ear(&flat, &left, at)) else { break };
                each(around(&left, ear))?;
                left.remove(ear);
            }
        }
    }
    let [first, rest @ ..] = left.as_slice() else { return Ok(()) };
    rest.windows(2).try_for_each(|pair| each([*first, pair[0], pair[1]]))
}

/// The corners in the plane that they are seen best in, turning against the clock: without the axis in which their normal (Newell's
/// sum over the edges) is longest.
fn flattened(corners: &[Triple]) -> Vec<[f64; 2]> {
    let corners: Vec<[f64; 3]> = corners.iter().map(|corner| corner.map(f64::from)).collect();
    let mut normal = [0.0; 3];
    for (at, [x, y, z]) in corners.iter().enumerate() {
        let [next_x, next_y, next_z] = corners[(at + 1) % corners.len()];
        normal[0] += (y - next_y) * (z + next_z);
        normal[1] += (z - next_z) * (x + next_x);
        normal[2] += (x - next_x) * (y + next_y);
    }
    let [x, y, z] = normal.map(f64::abs);
    let axis = if x > y && x > z { 0 } else { 1 + usize::from(z >= y) };
    let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
    let (first, second) = if normal[axis] < 0.0 { (second, first) } else { (first, second) };
    corners.iter().map(|corner| [corner[first], corner[second]]).collect()
}

/// Twice the area of a triangle; greater than 0 when it turns against the clock.
fn turn([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

fn is_convex(flat: &[[f64; 2]]) -> bool {
    let at = |place: usize| flat[place % flat.len()];
    (0..flat.len()).all(|place| turn([at(place), at(place + 1), at(place + 2)]) >= 0.0)
}

/// A corner and its two neighbours among those that are left.
fn around(left: &[usize], at: usize) -> [usize; 3] {
    [left[(at + left.len() - 1) % left.len()], left[at], left[(at + 1) % left.len()]]
}

/// Whether the triangle at a corner lies within the polygon: it turns the same way, and no other corner is in it.
fn is_ear(flat: &[[f64; 2]], left: &[usize], at: usize) -> bool {
    let ear = around(left, at).map(|corner| flat[corner]);
    let [a, b, c] = ear;
    let inside = |point: [f64; 2]| {
        !ear.contains(&point) && turn([a, b, point]) >= 0.0 && turn([b, c, point]) >= 0.0 && turn([c, a, point]) >= 0.0
    };
    turn(ear) > 0.0 && !left.iter().any(|&corner| inside(flat[corner]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(corners: &[Triple]) -> Vec<[usize; 3]> {
        let mut found = Vec::new();
        triangles::<()>(corners, |triangle| {
            found.push(triangle);
            Ok(())
        })
        .unwrap();
        found
    }

    /// A polygon in the plane x = 2, seen from where x is greater.
    fn upright(corners: &[[f32; 2]]) -> Vec<Triple> {
        corners.iter().map(|[y, z]| [2.0, *y, *z]).collect()
    }

    #[test]
    fn a_convex_polygon_is_a_fan() {
        assert_eq!(cut(&upright(&[[0., 0.], [2., 0.], [2., 1.], [0., 1.]])), [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(cut(&upright(&[[0., 0.], [2., 0.], [2., 1.]])), [[0, 1, 2]]);
        assert_eq!(cut(&upright(&[[0., 0.], [2., 0.]])), [[0; 3]; 0]);
    }

    #[test]
    fn a_polygon_with_a_dent_is_covered_once_whichever_corner_comes_first_and_whichever_way_it_turns() {
        // The letter L with a notch: a fan around most of its corners leaves it.
        let outline = [[0., 0.], [3., 0.], [3., 1.], [2., 1.], [1.5, 0.5], [1., 1.], [1., 3.], [0., 3.]];
        let area = 3.0 + 2.0 - 0.25;
        for turns in 0..outline.len() {
            for turned_round in [false, true] {
                let mut corners = outline;
                corners.rotate_left(turns);
                if turned_round {
                    corners.reverse();
                }
                let found = cut(&upright(&corners));
                let areas = found.iter().map(|places| turn(places.map(|place| corners[place].map(f64::from))) / 2.0);
                let sign = if turned_round { -1.0 } else { 1.0 };
                assert!(areas.clone().all(|area| area * sign > 0.0), "{found:?}");
                assert!((areas.sum::<f64>() * sign - area).abs() < 1e-12, "{found:?}");
                assert_eq!(found.len(), corners.len() - 2);
            }
        }
    }

    #[test]
    fn what_is_no_polygon_is_cut_all_the_same() {
        let line = upright(&[[0., 0.], [1., 0.], [2., 0.], [1., 0.], [0., 0.]]);
        assert_eq!(cut(&line).len(), 3);
        let bow = upright(&[[0., 0.], [1., 1.], [1., 0.], [0., 1.]]);
        assert_eq!(cut(&bow).len(), 2);
        let many: Vec<[f32; 2]> = (0..=MOST_CORNERS).map(|at| [at as f32, (at % 2) as f32]).collect();
        assert_eq!(cut(&upright(&many)).len(), MOST_CORNERS - 1);
    }
}
