use std::f64::consts::{PI, TAU};

use geometry::conformance::{plane_uv, sphere_uv, triangle_uv};
use geometry::{Kernels, Plane};
use glam::{DVec2, DVec3, Vec2};

use crate::Kit;

/// The reference's.
fn sphere(outward: DVec3) -> Vec2 {
    Kernels::default().uv_of_sphere(outward)
}

#[test]
fn every_mistake_about_a_spheres_texture_is_named() {
    Kit { page: "geometry/src/conformance/sphere_uv.rs", laws: sphere_uv::LAWS }.catches([
        ("nothing is returned", (|_| Vec2::ZERO) as sphere_uv::Part, "u_runs_around_from_x_over_y"),
        ("u mirrored", |d| sphere(DVec3::new(d.x, -d.y, d.z)), "u_runs_around_from_x_over_y"),
        ("u begins on the other side", |d| sphere(DVec3::new(-d.x, -d.y, d.z)), "u_runs_around_from_x_over_y"),
        ("y is up", |d| sphere(DVec3::new(d.z, d.x, d.y)), "u_runs_around_from_x_over_y"),
        (
            "negative angles are left negative",
            |d| Vec2::new((d.y.atan2(d.x) / TAU) as f32, sphere(d).y),
            "u_runs_around_from_x_over_y",
        ),
        ("v flipped", |d| sphere(DVec3::new(d.x, d.y, -d.z)), "v_runs_from_the_pole_above_to_the_one_below"),
        (
            "v is the height",
            |d| Vec2::new(sphere(d).x, (0.5 - 0.5 * d.normalize().z) as f32),
            "v_runs_from_the_pole_above_to_the_one_below",
        ),
        (
            "the direction is taken for a unit vector",
            |d| Vec2::new(sphere(d).x, (d.z.clamp(-1.0, 1.0).acos() / PI) as f32),
            "the_directions_length_does_not_matter",
        ),
        (
            "u of the seam is 1",
            |d| {
                let around = d.y.atan2(d.x) / TAU;
                Vec2::new(if around < 0.0 { around + 1.0 } else { around } as f32, sphere(d).y)
            },
            "coordinates_lie_in_the_texture",
        ),
        (
            "acos for v",
            |d| Vec2::new(sphere(d).x, (d.normalize().z.acos() / PI) as f32),
            "v_keeps_its_digits_near_the_poles",
        ),
        (
            "an angle in f32",
            |d| {
                let d = d.normalize().as_vec3();
                let around = d.y.atan2(d.x) / std::f32::consts::TAU;
                let around = if around < 0.0 { around + 1.0 } else { around };
                let v = d.x.hypot(d.y).atan2(d.z) / std::f32::consts::PI;
                Vec2::new(if around < 1.0 { around } else { 0.0 }, v.min(1.0))
            },
            "coordinates_are_the_exact_ones_to_a_rounding",
        ),
    ]);
}

/// How many copies lie between the plane's point and the place.
fn copies(plane: &Plane, offset: DVec3) -> DVec2 {
    let [u, v] = plane.gradients().map(|gradient| gradient.dot(offset));
    DVec2::new(u, v)
}

/// Less the whole part, never 1.
fn repeated(copies: DVec2) -> Vec2 {
    let fraction = (copies - copies.floor()).as_vec2();
    Vec2::select(fraction.cmplt(Vec2::ONE), fraction, Vec2::ZERO)
}

#[test]
fn every_mistake_about_a_planes_texture_is_named() {
    Kit { page: "geometry/src/conformance/plane_uv.rs", laws: plane_uv::LAWS }.catches([
        ("nothing is returned", (|_, _| Vec2::ZERO) as plane_uv::Part, "the_first_copy_begins_at_the_planes_point"),
        (
            "u and v swapped",
            |plane, offset| repeated(DVec2::new(copies(plane, offset).y, copies(plane, offset).x)),
            "the_first_copy_begins_at_the_planes_point",
        ),
        (
            "v flipped",
            |plane, offset| repeated(copies(plane, offset) * DVec2::new(1.0, -1.0)),
            "the_first_copy_begins_at_the_planes_point",
        ),
        ("the texture is not repeated", |plane, offset| copies(plane, offset).as_vec2(), "the_texture_repeats"),
        (
            "the texture ends at its edge",
            |plane, offset| copies(plane, offset).clamp(DVec2::ZERO, DVec2::ONE).as_vec2(),
            "the_texture_repeats",
        ),
        (
            "mirrored behind the point",
            |plane, offset| repeated(copies(plane, offset).abs()),
            "the_texture_repeats_backwards_too",
        ),
        (
            "a fraction that keeps its sign",
            |plane, offset| {
                let copies = copies(plane, offset);
                (copies - copies.trunc()).as_vec2()
            },
            "the_texture_repeats_backwards_too",
        ),
        (
            "a tiny negative fraction is 1",
            |plane, offset| {
                let copies = copies(plane, offset);
                (copies - copies.floor()).as_vec2()
            },
            "coordinates_lie_in_the_texture",
        ),
        (
            "narrowed before the whole part is taken off",
            |plane, offset| repeated(copies(plane, offset).as_vec2().as_dvec2()),
            "far_out_the_digits_are_kept",
        ),
    ]);
}

/// The reference's.
fn mean(corners: [Vec2; 3], u: f32, v: f32) -> Vec2 {
    Kernels::default().uv_of_triangle(corners, u, v)
}

#[test]
fn every_mistake_about_a_triangles_texture_is_named() {
    Kit { page: "geometry/src/conformance/triangle_uv.rs", laws: triangle_uv::LAWS }.catches([
        ("nothing is returned", (|_, _, _| Vec2::ZERO) as triangle_uv::Part, "at_a_corner_it_is_the_corners"),
        ("the corners one place on", |[a, b, c], u, v| mean([b, c, a], u, v), "at_a_corner_it_is_the_corners"),
        ("u and v swapped", |corners, u, v| mean(corners, v, u), "at_a_corner_it_is_the_corners"),
        ("the weights themselves", |_, u, v| Vec2::new(u, v), "at_a_corner_it_is_the_corners"),
        (
            "v flipped",
            |corners, u, v| {
                let uv = mean(corners, u, v);
                Vec2::new(uv.x, 1.0 - uv.y)
            },
            "at_a_corner_it_is_the_corners",
        ),
        (
            "the nearest corner's",
            |[a, b, c], u, v| {
                if u >= 0.5 {
                    b
                } else if v >= 0.5 {
                    c
                } else {
                    a
                }
            },
            "between_the_corners_it_is_their_weighted_mean",
        ),
        (
            "wrapped before the mean",
            |corners, u, v| mean(corners.map(|uv| uv - uv.floor()), u, v),
            "coordinates_beyond_the_texture_are_kept",
        ),
        (
            "cut to the texture",
            |corners, u, v| mean(corners, u, v).clamp(Vec2::ZERO, Vec2::ONE),
            "coordinates_beyond_the_texture_are_kept",
        ),
        (
            "all in f32",
            |[a, b, c], u, v| a * (1.0 - u - v) + b * u + c * v,
            "coordinates_are_the_exact_mean_to_a_rounding",
        ),
    ]);
}
