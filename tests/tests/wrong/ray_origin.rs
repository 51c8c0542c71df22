use geometry::conformance::ray_origin::{LAWS, Part};
use geometry::{Surface, naive};
use glam::Vec3;

use crate::Kit;

#[test]
fn every_mistake_about_the_origin_of_a_new_ray_is_named() {
    Kit { page: "geometry/src/conformance/ray_origin.rs", laws: LAWS }.catches([
        ("the origin of space", (|_, _| Vec3::ZERO) as Part, "a_ray_starts_at_its_surface"),
        ("the point itself", |surface, _| surface.position, "a_ray_starts_on_the_side_that_it_goes_to"),
        (
            "always outwards",
            |surface, _| surface.origin_towards(surface.geometric_normal.as_dvec3()),
            "a_ray_starts_on_the_side_that_it_goes_to",
        ),
        (
            "along the direction, not made a unit vector",
            |surface, direction| surface.position + 1e-4 * direction.as_vec3(),
            "the_directions_length_does_not_matter",
        ),
        (
            "the shading normal",
            |surface, direction| {
                Surface { geometric_normal: surface.shading_normal, ..*surface }.origin_towards(direction)
            },
            "the_shading_normal_does_not_matter",
        ),
        ("a constant along the normal", naive::offset_along_normal, "a_large_scene_is_left"),
        (
            "never less than a constant",
            |surface, direction| {
                let [own, constant] =
                    [surface.origin_towards(direction), naive::offset_along_normal(surface, direction)];
                let off = |origin: Vec3| (origin - surface.position).length();
                if off(own) < off(constant) { constant } else { own }
            },
            "a_small_scene_is_not_jumped_over",
        ),
        (
            "a share of the point's own coordinates",
            |surface, direction| {
                let normal = surface.geometric_normal;
                let outward = if direction.dot(normal.as_dvec3()) < 0.0 { -normal } else { normal };
                surface.position + outward * (1.6e-7 * surface.position.length())
            },
            "a_triangle_is_not_met_again",
        ),
    ]);
}
