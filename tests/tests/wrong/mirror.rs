use geometry::Ray;
use shading::{Color, Mirror, Shader, conformance::mirror, optics::reflect};

use crate::Kit;
use crate::spoilt::{clear, follow, mirrored, opaque};

#[test]
fn every_mistake_in_a_mirror_is_named() {
    Kit { page: "shading/src/conformance/mirror.rs", laws: mirror::LAWS }.catches([
        ("nothing is returned", (|_| opaque(|_| Color::BLACK)) as mirror::Mirror, "a_mirror_shows_what_is_before_it"),
        (
            "mirrored the wrong way: the ray's direction is turned around",
            |color| opaque(move |at| color * follow(at, &at.ray_along(-at.direction), at.bounces.reflected())),
            "a_mirror_sends_the_ray_as_far_from_the_normal_as_it_came",
        ),
        ("the colour forgotten", |_| opaque(|at| at.reflected()), "a_mirror_filters_each_channel"),
        (
            "the normal not on the viewer's side",
            |color| {
                opaque(move |at| {
                    let normal = at.surface.shading_normal;
                    let direction = at.direction + normal * (2.0 * at.direction.dot(normal).abs());
                    color * follow(at, &at.ray_along(direction), at.bounces.reflected())
                })
            },
            "a_mirror_reflects_on_its_back_too",
        ),
        (
            "mirrored at the true normal where a mesh has its own",
            |color| {
                opaque(move |at| {
                    let direction = reflect(at.direction, at.surface.geometric_normal);
                    color * follow(at, &at.ray_along(direction), at.bounces.reflected())
                })
            },
            "a_mirror_goes_by_the_normal_that_a_mesh_gives",
        ),
        (
            "depth off by one: a reflection is not counted",
            |color| opaque(move |at| color * at.world.trace(&at.ray_along(mirrored(at)), at.bounces)),
            "a_mirrored_ray_has_one_reflection_less",
        ),
        (
            "depth off by one: one ray too many",
            |color| {
                opaque(move |at| {
                    let counted = at.bounces.reflected().unwrap_or(at.bounces);
                    color * at.world.trace(&at.ray_along(mirrored(at)), counted)
                })
            },
            "a_mirror_is_black_after_the_last_reflection",
        ),
        (
            "the ray starts in the surface",
            |color| {
                opaque(move |at| {
                    color * follow(at, &Ray::new(at.surface.position, mirrored(at)), at.bounces.reflected())
                })
            },
            "a_mirrored_ray_starts_beside_the_surface",
        ),
        (
            "the ray goes through the surface",
            |color| opaque(move |at| color * follow(at, &at.ray_along(mirrored(at)), at.bounces.reflected())),
            "a_mirrored_ray_stays_before_the_surface",
        ),
        (
            "lit like a matt surface as well",
            |color| {
                opaque(move |at| {
                    let matt: Color = at.lit().map(|light| light.color * light.cosine).sum();
                    color * (at.reflected() + matt * 0.1)
                })
            },
            "a_mirror_does_not_depend_on_lights",
        ),
        (
            "lets light through",
            |reflection| clear(move |at| Mirror { reflection }.radiance(at)),
            "a_mirror_casts_a_shadow",
        ),
    ]);
}

#[test]
fn a_table_is_read_row_by_row() {
    let rows = crate::rows("shading/src/conformance/mirror.rs");
    assert_eq!(rows[0], "//! | nothing is returned | [`a_mirror_shows_what_is_before_it`] |");
    assert_eq!(rows.len(), 11);
}
