use std::sync::Arc;

use glam::Vec2;
use shading::{Color, Shader, ShadingPoint, Texture, conformance::phong, optics::reflect};

use crate::Kit;
use crate::lit::{Arriving, Mistake, lights};
use crate::spoilt::opaque;

/// A surface in the student's way, with a highlight by a function of his.
fn with_highlight(
    diffuse: Arc<dyn Texture>,
    specular: Color,
    mistake: Mistake,
    highlight: impl Fn(&ShadingPoint<'_>, &Arriving) -> f32 + Send + Sync + 'static,
) -> Box<dyn Shader> {
    opaque(move |at| {
        let matt = diffuse.color(at.uv);
        if let Some(ambient) = at.ambient() {
            return matt * ambient;
        }
        let shaded = lights(at, mistake);
        shaded
            .iter()
            .map(|light| matt * light.color * light.cosine + specular * light.color * highlight(at, light))
            .sum()
    })
}

/// The right one.
fn near(at: &ShadingPoint<'_>, light: &Arriving) -> f32 {
    reflect(at.direction, at.normal()).dot(light.direction)
}

fn power(base: f32, exponent: f32) -> f32 {
    base.max(0.0).powf(exponent)
}

/// A right matt part, and what `more` adds to it.
fn matt_and(
    diffuse: Arc<dyn Texture>,
    more: impl Fn(&ShadingPoint<'_>) -> Color + Send + Sync + 'static,
) -> Box<dyn Shader> {
    let matt = shading::Phong { diffuse, specular: Color::BLACK, exponent: 1.0 };
    opaque(move |at| matt.radiance(at) + if at.ambient().is_none() { more(at) } else { Color::BLACK })
}

macro_rules! with {
    ($mistake:ident) => {
        |diffuse, specular, exponent| {
            with_highlight(diffuse, specular, Mistake::$mistake, move |at, light| power(near(at, light), exponent))
        }
    };
}

#[test]
fn every_mistake_in_a_phong_surface_is_named() {
    Kit { page: "shading/src/conformance/phong.rs", laws: phong::LAWS }.catches([
        (
            "nothing is returned",
            (|_, _, _| opaque(|_| Color::BLACK)) as phong::Phong,
            "a_phong_surface_shows_the_scene_s_ambient_light",
        ),
        (
            "ambient although there are lights",
            |diffuse, specular, exponent| {
                let right = shading::Phong { diffuse: diffuse.clone(), specular, exponent };
                opaque(move |at| {
                    let ambient = if at.ambient().is_none() { 0.05 } else { 0.0 };
                    right.radiance(at) + diffuse.color(at.uv) * ambient
                })
            },
            "no_ambient_light_where_there_are_lights",
        ),
        (
            "shadow ray without end: shadow beyond the light",
            with!(ShadowRayWithoutEnd),
            "what_lies_beyond_the_light_casts_no_shadow",
        ),
        ("the normal not on the viewer's side", with!(NormalOfTheFront), "the_back_is_lit_like_the_front"),
        (
            "the texture asked at another place",
            |diffuse, specular, exponent| {
                let texel: Color = diffuse.color(&|| Vec2::ZERO);
                Box::new(shading::Phong { diffuse: Arc::new(texel), specular, exponent })
            },
            "the_texture_is_asked_at_the_point",
        ),
        (
            "no highlight",
            |diffuse, specular, _| with_highlight(diffuse, specular, Mistake::None, |_, _| 0.0),
            "a_highlight_stands_where_the_light_is_mirrored",
        ),
        (
            "the highlight dimmed by the light's cosine",
            |diffuse, specular, exponent| {
                with_highlight(diffuse, specular, Mistake::None, move |at, light| {
                    light.cosine * power(near(at, light), exponent)
                })
            },
            "a_highlight_is_as_bright_at_any_slant",
        ),
        (
            "the exponent forgotten",
            |diffuse, specular, _| {
                with_highlight(diffuse, specular, Mistake::None, |at, light| near(at, light).max(0.0))
            },
            "a_highlight_falls_by_the_power_of_the_cosine",
        ),
        (
            "the wrong half: Blinn's highlight",
            |diffuse, specular, exponent| {
                with_highlight(diffuse, specular, Mistake::None, move |at, light| {
                    let half = (light.direction - at.direction).normalize();
                    power(at.normal().dot(half), exponent)
                })
            },
            "a_highlight_falls_by_the_power_of_the_cosine",
        ),
        (
            "r.v below 0 to an even power",
            |diffuse, specular, exponent| {
                with_highlight(diffuse, specular, Mistake::None, move |at, light| {
                    let near = near(at, light);
                    if exponent % 2.0 == 0.0 { near.abs().powf(exponent) } else { power(near, exponent) }
                })
            },
            "there_is_no_highlight_on_the_far_side_of_the_mirror",
        ),
        (
            "the highlight in the matt part's colour",
            |diffuse, specular, exponent| {
                opaque(move |at| {
                    let matt = diffuse.color(at.uv);
                    // Where the matt part is black, only the highlight's colour is left.
                    let tint = if matt == Color::BLACK { specular } else { matt };
                    shading::Phong {
                        diffuse: Arc::new(matt),
                        specular: if specular == Color::BLACK { specular } else { tint },
                        exponent,
                    }
                    .radiance(at)
                })
            },
            "a_highlight_has_its_own_colour",
        ),
        (
            "highlight behind the surface",
            |diffuse, specular, exponent| {
                matt_and(diffuse, move |at| {
                    let lights = (0..).map_while(|number| at.world.light(number, at.bounces.path));
                    let seen = lights.filter(|light| !at.world.blocked(&at.ray_towards(light.position)));
                    let mirrored = reflect(at.direction, at.normal());
                    let highlights = seen.map(|light| {
                        let to_light = light.position - at.surface.position;
                        let near = mirrored.dot(to_light.normalize());
                        specular * light.at_distance(to_light.length()) * power(near, exponent)
                    });
                    highlights.sum()
                })
            },
            "a_light_behind_the_surface_has_no_highlight",
        ),
        (
            "highlight in the shadow",
            |diffuse, specular, exponent| {
                matt_and(diffuse, move |at| {
                    let unshadowed = lights(at, Mistake::NoShadows);
                    unshadowed.iter().map(|light| specular * light.color * power(near(at, light), exponent)).sum()
                })
            },
            "there_is_no_highlight_in_the_shadow",
        ),
        (
            "the highlight's normal not on the viewer's side",
            |diffuse, specular, exponent| {
                matt_and(diffuse, move |at| {
                    let normal = at.surface.geometric_normal;
                    let flipped = at.direction + normal * (2.0 * at.direction.dot(normal).abs());
                    let shine =
                        |light: &Arriving| specular * light.color * power(flipped.dot(light.direction), exponent);
                    lights(at, Mistake::None).iter().map(shine).sum()
                })
            },
            "the_back_has_its_highlights",
        ),
    ]);
}
