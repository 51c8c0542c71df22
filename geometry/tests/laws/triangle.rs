//! Triangles that were once got wrong, and many at once.

use geometry::{
    Intersection, Interval, Primitive, Ray, Triangle, TriangleLanes, TriangleProbe,
    conformance::{Aimed, times, triangles},
    intersect_lanes,
};
use glam::Vec3;
use proptest::prelude::*;

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
