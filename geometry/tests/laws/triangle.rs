use geometry::{
    Intersection, Interval, Primitive, Primitives, Ray, Triangle, TriangleLanes, TriangleProbe,
    conformance::{Aimed, closed_meshes, flat_triangles, times, triangles},
    intersect_lanes,
};
use glam::{DVec3, Vec3, dvec3};
use proptest::prelude::*;

use crate::exact::{DOUBLE, Exact, SINGLE, ULPS, Vector, approximate, exact, is_within, truths};
use crate::plane::exact_t;

/// The volumes between the ray's direction and two corners seen from the origin: the weights of the corners, times some factor.
fn volumes(triangle: &Triangle, ray: &Ray) -> [Exact; 3] {
    let direction = Vector::from(ray.direction);
    let [a, b, c] = triangle.corners.map(|corner| Vector::from(corner).minus(&ray.origin.into()));
    [(&b, &c), (&c, &a), (&a, &b)].map(|(from, to)| direction.dot(&from.cross(to)))
}

/// How far each volume may be off in `f64`: a rounding of the corners' distance from the origin, times the width seen.
fn volume_errors(triangle: &Triangle, ray: &Ray) -> [f64; 3] {
    let direction = ray.direction.as_dvec3();
    let corners = triangle.corners.map(|corner| corner.as_dvec3() - ray.origin.as_dvec3());
    let beside = corners.map(|corner| corner.cross(direction).length());
    let far = corners.map(DVec3::length).into_iter().fold(0.0, f64::max);
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| 4.0 * DOUBLE * far * (beside[i] + beside[j]))
}

/// Whether the exact ray meets the triangle, if that is not closer than `f64` sees.
fn is_met(triangle: &Triangle, ray: &Ray) -> Option<bool> {
    let volumes = volumes(triangle, ray).map(|volume| approximate(&volume));
    let errors = volume_errors(triangle, ray);
    let clear = |sign: f64| (0..3).all(|i| sign * volumes[i] > errors[i]);
    let is_positive = (0..3).any(|i| volumes[i] > errors[i]);
    let is_negative = (0..3).any(|i| volumes[i] < -errors[i]);
    let through = clear(1.0) || clear(-1.0);
    let beside = is_positive && is_negative;
    (through || beside).then_some(through)
}

pub(crate) fn point_and_normal(triangle: &Triangle) -> (Vector, Vector) {
    let [a, b, c] = triangle.corners.map(Vector::from);
    let normal = b.minus(&a).cross(&c.minus(&a));
    (a, normal)
}

/// Where the ray meets the triangle's plane, and how far off `f64` may be, as for any plane; `None` if edge-on.
fn exact_t_and_error(triangle: &Triangle, ray: &Ray) -> Option<(Exact, f64)> {
    let (point, normal) = point_and_normal(triangle);
    exact_t(&point, &normal, ray).map(|(t, scale)| (t, 4.0 * DOUBLE * scale))
}

proptest! {
    #![proptest_config(times(16))]

    #[test]
    fn hit_and_miss_are_right_unless_the_ray_passes_an_edge_as_closely_as_f64_sees(aimed in triangles()) {
        let Aimed { shape, ray } = aimed;
        let Some(through) = is_met(&shape, &ray) else { return Ok(()) };
        let ahead = exact_t_and_error(&shape, &ray).map(|(t, error)| {
            let t = approximate(&t);
            (t > 0.0, t.abs() > error)
        });
        prop_assume!(!through || ahead.is_some_and(|(_, is_clear)| is_clear));
        let expected = through && ahead.is_some_and(|(is_ahead, _)| is_ahead);
        prop_assert_eq!(shape.intersect(&ray, Interval::FORWARD).is_some(), expected);
    }

    /// Where half an ulp of the inputs could not make hit and miss of each other.
    #[test]
    fn t_is_exact_to_half_an_ulp(aimed in triangles()) {
        let Aimed { shape, ray } = aimed;
        let errors = volume_errors(&shape, &ray).map(|error| error * SINGLE / DOUBLE);
        let volumes = volumes(&shape, &ray).map(|volume| approximate(&volume));
        prop_assume!((0..3).all(|i| volumes[i] > errors[i]) || (0..3).all(|i| volumes[i] < -errors[i]));
        let Some(hit) = shape.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        let (t, error) = exact_t_and_error(&shape, &ray).expect("not edge-on");
        // Nor make an origin in front of it one behind it.
        prop_assume!(error * SINGLE / DOUBLE < approximate(&t).abs());
        prop_assert!(is_within(&t, &truths(hit.t, ULPS, 0.0)), "t = {}", hit.t);
    }

    /// Slivers, edge-on, and origins very near a large triangle included.
    #[test]
    fn t_is_as_exact_as_f64_sees_on_every_triangle(aimed in triangles()) {
        let Aimed { shape, ray } = aimed;
        prop_assume!(is_met(&shape, &ray) == Some(true));
        let Some(hit) = shape.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        let (t, error) = exact_t_and_error(&shape, &ray).expect("not edge-on");
        prop_assert!(is_within(&t, &truths(hit.t, ULPS, error)), "t = {}", hit.t);
    }

    #[test]
    fn u_and_v_are_the_exact_weights(aimed in triangles()) {
        let Aimed { shape, ray } = aimed;
        prop_assume!(is_met(&shape, &ray) == Some(true));
        let Some(hit) = shape.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        prop_assert!(hit.u >= 0.0 && hit.v >= 0.0 && hit.u <= 1.0 && hit.v <= 1.0);
        let [a, b, c] = volumes(&shape, &ray);
        let sum = a + &b + &c;
        let error = 2.0 * volume_errors(&shape, &ray).into_iter().sum::<f64>() / approximate(&sum).abs();
        prop_assert!(is_within(&(b / &sum), &truths(hit.u, ULPS, error)), "u = {}", hit.u);
        prop_assert!(is_within(&(c / &sum), &truths(hit.v, ULPS, error)), "v = {}", hit.v);
    }

    #[test]
    fn a_hit_point_is_on_the_triangles_plane_to_a_rounding(aimed in triangles()) {
        let Aimed { shape, ray } = aimed;
        let Some(hit) = shape.intersect(&ray, Interval::FORWARD) else { return Ok(()) };
        let (point, normal) = point_and_normal(&shape);
        let off = normal.dot(&Vector::from(shape.surface(&ray, &hit).position).minus(&point));
        let bound = exact(7.0 * SINGLE * f64::from(shape.bounds().magnitude()));
        prop_assert!(&off * &off <= &bound * &bound * normal.dot(&normal));
    }

    /// Corners in a row, and rays straight at them: rounding must not make an area of it.
    #[test]
    fn a_triangle_without_area_is_never_met(aimed in flat_triangles()) {
        prop_assert_eq!(aimed.shape.intersect(&aimed.ray, Interval::FORWARD), None);
    }
}

proptest! {
    #![proptest_config(times(1))]

    #[test]
    fn no_ray_leaves_a_closed_mesh_through_its_edges_or_corners(enclosed in closed_meshes()) {
        let mut primitives = Primitives::default();
        primitives.add_mesh(enclosed.mesh);
        for ray in &enclosed.rays {
            let is_met = (0..primitives.len()).any(|face| primitives.intersect(face, ray, Interval::FORWARD).is_some());
            prop_assert!(is_met, "{:?}", ray);
        }
    }
}

#[test]
fn the_cube_does_not_leak_at_its_corners_and_edges() {
    let mut cube = Primitives::default();
    cube.add_mesh(geometry::unit_cube());
    let steps = [-0.5, 0.0, 0.5];
    for (x, y, z) in steps.into_iter().flat_map(|x| steps.map(|y| (x, y))).flat_map(|(x, y)| steps.map(|z| (x, y, z))) {
        let ray = Ray::new(Vec3::new(0.1, -0.2, 0.3), (dvec3(x, y, z) - dvec3(0.1, -0.2, 0.3)).as_vec3());
        let is_met = (0..12).any(|face| cube.intersect(face, &ray, Interval::FORWARD).is_some());
        assert!(is_met, "{ray:?}");
    }
}

/// Seen from 1e15 away, all corners are the same point in `f64`: the weights are 0, and so is their sum.
#[test]
fn a_triangle_too_far_to_be_told_from_a_point_is_not_met() {
    let shape = Triangle { corners: [Vec3::ZERO, 1e-3 * Vec3::X, 1e-3 * Vec3::Y] };
    let ray = Ray::new(Vec3::splat(1e15), Vec3::splat(-1.0));
    assert_eq!(shape.intersect(&ray, Interval::FORWARD), None);
}

/// The weights are of one sign, by rounding.
#[test]
fn corners_in_a_row_are_not_met() {
    let corner = |z: f32| Vec3::new(4720466.5, 0.0, z);
    let shape = Triangle { corners: [corner(0.0), corner(713.39575), corner(634.68713)] };
    let ray = Ray::new(Vec3::new(4682866.5, -27.936342, -93839.9), Vec3::new(37600.0, 27.936342, 94474.586));
    assert_eq!(shape.intersect(&ray, Interval::FORWARD), None);
}

/// Four rays with a triangle each, side by side; axes turned as `axes` of the first one's probe.
fn side_by_side(given: &[Aimed<Triangle>; 4]) -> TriangleLanes<4> {
    let mut lanes = TriangleLanes { origin: [[0.0; 4]; 3], direction: [[0.0; 4]; 3], corners: [[[0.0; 4]; 3]; 3] };
    for (lane, Aimed { shape, ray }) in given.iter().enumerate() {
        let probe = TriangleProbe::new(ray);
        for axis in 0..3 {
            lanes.origin[axis][lane] = probe.turned(ray.origin)[axis];
            lanes.direction[axis][lane] = probe.turned(ray.direction)[axis];
            for corner in 0..3 {
                lanes.corners[corner][axis][lane] = probe.turned(shape.corners[corner])[axis];
            }
        }
    }
    lanes
}

proptest! {
    #![proptest_config(times(16))]

    /// In each bit, where no doubt is told of; and there is doubt of whatever is missed.
    #[test]
    fn many_at_once_are_met_where_each_is_alone(given in prop::array::uniform4(triangles())) {
        let met = intersect_lanes(&side_by_side(&given));
        let everywhere = Interval { min: f32::NEG_INFINITY, max: f32::INFINITY };
        for (lane, Aimed { shape, ray }) in given.iter().enumerate() {
            let probe = TriangleProbe::new(ray);
            let alone = probe.intersect(shape.corners.map(|corner| probe.turned(corner)), everywhere);
            if met.is_in_doubt[lane] == 0 && met.t[lane].is_finite() {
                let together = Intersection { t: met.t[lane], u: met.u[lane], v: met.v[lane] };
                prop_assert_eq!(alone, Some(together), "lane {}", lane);
            }
        }
    }
}

#[test]
fn of_a_hit_inside_a_triangle_there_is_no_doubt() {
    let corners = [Vec3::new(-1.0, -1.0, 4.0), Vec3::new(1.0, -1.0, 5.0), Vec3::new(0.0, 1.0, 3.0)];
    let given = [0.0, 0.05, 0.1, 9.0]
        .map(|x| Aimed { shape: Triangle { corners }, ray: Ray::new(Vec3::ZERO, Vec3::new(x, 0.0, 1.0)) });
    assert_eq!(intersect_lanes(&side_by_side(&given)).is_in_doubt, [0, 0, 0, 1]);
}
