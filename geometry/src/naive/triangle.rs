use crate::{Intersection, Interval, Ray, Triangle};

/// The paper's own constant: a determinant below it in magnitude counts as a ray in the triangle's plane.
const EPSILON: f32 = 1e-6;

/// Möller's and Trumbore's test in `f32`, two-sided, with the epsilon of their paper.
///
/// ```text
///   [t u v] = [e2.q  s.p  d.q] / det      e1 = b - a, e2 = c - a, s = o - a
///   det = e1.p                              p = d x e2,  q = s x e1
/// ```
///
/// (Möller, Trumbore: Fast, Minimum Storage Ray/Triangle Intersection, Journal of Graphics Tools 1997.)
///
/// Three things go wrong. The determinant has the size of the triangle's area times the direction's length, so that the epsilon,
/// which has no unit, throws away small triangles: a whole scene scaled by 1/1000 disappears. Each triangle decides by its own
/// edges, rounded from its own first corner: rays slip through between two that share an edge. And `e2.q / det` cancels for
/// slivers and for triangles seen edge-on: `t` is then off by many thousand units in its last place.
pub fn moeller_trumbore(triangle: &Triangle, ray: &Ray, within: Interval) -> Option<Intersection> {
    let [a, b, c] = triangle.corners;
    let (edge1, edge2) = (b - a, c - a);
    let p = ray.direction.cross(edge2);
    let determinant = edge1.dot(p);
    if determinant > -EPSILON && determinant < EPSILON {
        return None;
    }
    let inverse = 1.0 / determinant;
    let from_corner = ray.origin - a;
    let u = from_corner.dot(p) * inverse;
    if !(0.0..=1.0).contains(&u) {
        return None;
    }
    let q = from_corner.cross(edge1);
    let v = ray.direction.dot(q) * inverse;
    if v < 0.0 || u + v > 1.0 {
        return None;
    }
    let t = edge2.dot(q) * inverse;
    within.contains(t).then_some(Intersection { t, u, v })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Primitive;
    use glam::Vec3;

    fn right_angled(size: f32) -> Triangle {
        Triangle { corners: [Vec3::ZERO, size * Vec3::X, size * Vec3::Y] }
    }

    fn above(size: f32) -> Ray {
        Ray::new(size * Vec3::new(0.25, 0.5, 2.0), -Vec3::Z)
    }

    #[test]
    fn an_easy_triangle_is_met_where_it_is() {
        let expected = Intersection { t: 2.0, u: 0.25, v: 0.5 };
        assert_eq!(moeller_trumbore(&right_angled(1.0), &above(1.0), Interval::FORWARD), Some(expected));
    }

    #[test]
    fn a_small_triangle_disappears() {
        // Its determinant is size^2 = 2.5e-7.
        let (triangle, ray) = (right_angled(5e-4), above(5e-4));
        assert!(triangle.intersect(&ray, Interval::FORWARD).is_some());
        assert_eq!(moeller_trumbore(&triangle, &ray, Interval::FORWARD), None);
    }
}
