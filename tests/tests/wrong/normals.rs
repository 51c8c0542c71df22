use geometry::conformance::{normal_matrix, smooth_normal};
use geometry::{Kernels, Transform};
use glam::{DMat3, Vec3};

use crate::Kit;

/// The reference's.
fn between(corners: [Vec3; 3], u: f32, v: f32) -> Option<Vec3> {
    Kernels::default().normal_between(corners, u, v)
}

fn mean([a, b, c]: [Vec3; 3], u: f32, v: f32) -> Vec3 {
    a * (1.0 - u - v) + b * u + c * v
}

#[test]
fn every_mistake_about_a_smooth_normal_is_named() {
    Kit { page: "geometry/src/conformance/smooth_normal.rs", laws: smooth_normal::LAWS }.catches([
        ("nothing is returned", (|_, _, _| None) as smooth_normal::Part, "at_a_corner_it_points_as_the_corners"),
        (
            "the corners one place on",
            |[a, b, c], u, v| between([b, c, a], u, v),
            "at_a_corner_it_points_as_the_corners",
        ),
        (
            "the nearest corner's",
            |[a, b, c], u, v| {
                Some(if u >= 0.5 {
                    b
                } else if v >= 0.5 {
                    c
                } else {
                    a
                })
            },
            "between_the_corners_it_points_as_their_weighted_mean",
        ),
        ("not renormalised", |corners, u, v| Some(mean(corners, u, v)), "it_is_a_unit_vector"),
        (
            "renormalised by a rough root",
            |corners, u, v| {
                let mean = mean(corners, u, v);
                // One step of Newton's from 1.
                Some(mean * (1.5 - 0.5 * mean.length_squared()))
            },
            "it_is_a_unit_vector",
        ),
        (
            "NaN where normals cancel",
            |corners, u, v| {
                let [a, b, c] = corners.map(|normal| normal.as_dvec3());
                let mean = a * (1.0 - f64::from(u) - f64::from(v)) + b * f64::from(u) + c * f64::from(v);
                Some((mean / mean.length()).as_vec3())
            },
            "where_normals_cancel_there_is_none",
        ),
        (
            "each corner normalised first",
            |corners, u, v| between(corners.map(|normal| normal.normalize_or_zero()), u, v),
            "a_longer_normal_counts_for_more",
        ),
    ]);
}

#[test]
fn every_mistake_about_the_matrix_of_normals_is_named() {
    Kit { page: "geometry/src/conformance/normal_matrix.rs", laws: normal_matrix::LAWS }.catches([
        ("nothing is returned", (|_| DMat3::ZERO) as normal_matrix::Part, "a_turn_turns_normals_as_points"),
        ("the transpose", |map| map.linear.transpose(), "a_turn_turns_normals_as_points"),
        ("the inverse instead of the inverse transpose", |map| map.linear.inverse(), "a_turn_turns_normals_as_points"),
        ("the map itself", |map| map.linear, "a_normal_stays_perpendicular_to_its_surface"),
        (
            "cofactors without their sign under a mirror",
            |map| if map.mirrors() { map.normals() * -1.0 } else { map.normals() },
            "a_mirror_keeps_normals_outward",
        ),
        (
            "an inverse that does not exist",
            |map: &Transform| map.linear.inverse().transpose(),
            "a_map_that_flattens_space_has_normals",
        ),
    ]);
}
