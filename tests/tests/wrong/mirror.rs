use geometry::Ray;
use glam::Vec3;
use shading::{Bounces, Color, Mirror, Shader, ShadingPoint, conformance::mirror, optics::reflect};

use crate::Kit;

/// A shader that is a function, and so is whether it casts a shadow.
struct Spoilt<F> {
    reflection: Color,
    radiance: F,
    casts_shadow: bool,
}

impl<F: Fn(Color, &ShadingPoint<'_>) -> Color + Send + Sync> Shader for Spoilt<F> {
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        (self.radiance)(self.reflection, at)
    }

    fn casts_shadow(&self) -> bool {
        self.casts_shadow
    }
}

fn spoilt(
    reflection: Color,
    radiance: impl Fn(Color, &ShadingPoint<'_>) -> Color + Send + Sync + 'static,
) -> Box<dyn Shader> {
    Box::new(Spoilt { reflection, radiance, casts_shadow: true })
}

/// Follows the ray in a direction, from a start, as `ShadingPoint::reflected` does.
fn follow(at: &ShadingPoint<'_>, ray: &Ray, bounces: Option<Bounces>) -> Color {
    bounces.map_or(Color::BLACK, |bounces| at.world.trace(ray, bounces))
}

fn mirrored(at: &ShadingPoint<'_>) -> Vec3 {
    reflect(at.direction, at.surface.shading_normal)
}

/// The normal on the front, whichever side is seen: what is forgotten on the back.
fn mirrored_by_front(at: &ShadingPoint<'_>) -> Vec3 {
    let normal = at.surface.shading_normal;
    at.direction + normal * (2.0 * at.direction.dot(normal).abs())
}

#[test]
fn every_mistake_in_a_mirror_is_named() {
    Kit { page: "shading/src/conformance/mirror.rs", laws: mirror::LAWS }.catches([
        (
            "nothing is returned",
            (|reflection| spoilt(reflection, |_, _| Color::BLACK)) as mirror::Mirror,
            "a_mirror_shows_what_is_before_it",
        ),
        (
            "mirrored the wrong way: the ray's direction is turned around",
            |reflection| {
                spoilt(reflection, |reflection, at| {
                    reflection * follow(at, &at.ray_along(-at.direction), at.bounces.reflected())
                })
            },
            "a_mirror_sends_the_ray_as_far_from_the_normal_as_it_came",
        ),
        (
            "the colour forgotten",
            |reflection| spoilt(reflection, |_, at| at.reflected()),
            "a_mirror_filters_each_channel",
        ),
        (
            "the normal not on the viewer's side",
            |reflection| {
                spoilt(reflection, |reflection, at| {
                    reflection * follow(at, &at.ray_along(mirrored_by_front(at)), at.bounces.reflected())
                })
            },
            "a_mirror_reflects_on_its_back_too",
        ),
        (
            "mirrored at the true normal where a mesh has its own",
            |reflection| {
                spoilt(reflection, |reflection, at| {
                    let direction = reflect(at.direction, at.surface.geometric_normal);
                    reflection * follow(at, &at.ray_along(direction), at.bounces.reflected())
                })
            },
            "a_mirror_goes_by_the_normal_that_a_mesh_gives",
        ),
        (
            "depth off by one: a reflection is not counted",
            |reflection| {
                spoilt(reflection, |reflection, at| {
                    reflection * at.world.trace(&at.ray_along(mirrored(at)), at.bounces)
                })
            },
            "a_mirrored_ray_has_one_reflection_less",
        ),
        (
            "depth off by one: one ray too many",
            |reflection| {
                spoilt(reflection, |reflection, at| {
                    let counted = at.bounces.reflected().unwrap_or(at.bounces);
                    reflection * at.world.trace(&at.ray_along(mirrored(at)), counted)
                })
            },
            "a_mirror_is_black_after_the_last_reflection",
        ),
        (
            "the ray starts in the surface",
            |reflection| {
                spoilt(reflection, |reflection, at| {
                    reflection * follow(at, &Ray::new(at.surface.position, mirrored(at)), at.bounces.reflected())
                })
            },
            "a_mirrored_ray_starts_beside_the_surface",
        ),
        (
            "the ray goes through the surface",
            |reflection| {
                spoilt(reflection, |reflection, at| {
                    reflection * follow(at, &at.ray_along(mirrored(at)), at.bounces.reflected())
                })
            },
            "a_mirrored_ray_stays_before_the_surface",
        ),
        (
            "lit like a matt surface as well",
            |reflection| {
                spoilt(reflection, |reflection, at| {
                    let matt: Color = at.lit().map(|light| light.color * light.cosine).sum();
                    reflection * (at.reflected() + matt * 0.1)
                })
            },
            "a_mirror_does_not_depend_on_lights",
        ),
        (
            "lets light through",
            |reflection| {
                Box::new(Spoilt {
                    reflection,
                    radiance: |reflection, at: &ShadingPoint<'_>| Mirror { reflection }.radiance(at),
                    casts_shadow: false,
                })
            },
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
