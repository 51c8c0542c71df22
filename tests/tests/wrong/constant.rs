use shading::{Color, Constant, Shader, conformance::constant};

use crate::Kit;
use crate::lit::{Mistake, matt};
use crate::spoilt::{clear, opaque};

macro_rules! with {
    ($mistake:ident) => {
        |color| opaque(move |at| matt(at, color, Mistake::$mistake))
    };
}

#[test]
fn every_mistake_in_a_constant_surface_is_named() {
    Kit { page: "shading/src/conformance/constant.rs", laws: constant::LAWS }.catches([
        (
            "nothing is returned",
            (|_| opaque(|_| Color::BLACK)) as constant::Constant,
            "a_constant_surface_shows_the_scene_s_ambient_light",
        ),
        ("divided by pi", with!(DividedByPi), "a_light_straight_above_gives_all_its_light"),
        ("the light's colour forgotten", with!(LightColorForgotten), "a_light_straight_above_gives_all_its_light"),
        ("the cosine forgotten", with!(CosineForgotten), "light_falls_with_the_cosine"),
        ("falloff forgotten", with!(FalloffForgotten), "light_falls_with_the_distance_as_the_light_says"),
        ("the cosine's absolute value", with!(AbsoluteCosine), "a_light_behind_the_surface_gives_nothing"),
        ("only the first light counts", with!(OnlyTheFirst), "lights_add_up"),
        (
            "ambient although there are lights",
            |color| {
                opaque(move |at| {
                    // The share is told in a scene without lights alone; a student's is a constant of his own.
                    matt(at, color, Mistake::None) + at.ambient().map_or(color * 0.05, |_| Color::BLACK)
                })
            },
            "no_ambient_light_where_there_are_lights",
        ),
        ("no shadows", with!(NoShadows), "something_between_casts_a_shadow"),
        (
            "shadow ray without end: shadow beyond the light",
            with!(ShadowRayWithoutEnd),
            "what_lies_beyond_the_light_casts_no_shadow",
        ),
        ("the shadow ray goes both ways", with!(ShadowRayBothWays), "what_lies_behind_the_point_casts_no_shadow"),
        ("the normal not on the viewer's side", with!(NormalOfTheFront), "the_back_is_lit_like_the_front"),
        ("the true normal where a mesh has its own", with!(TrueNormal), "light_goes_by_the_normal_that_a_mesh_gives"),
        ("light through the surface", with!(ThroughTheSurface), "light_does_not_come_through_the_surface"),
        (
            "the shadow ray starts in the surface",
            with!(ShadowRayInTheSurface),
            "a_shadow_ray_starts_beside_the_surface",
        ),
        (
            "lets light through",
            |color| clear(move |at| Constant { color }.radiance(at)),
            "a_constant_surface_casts_a_shadow",
        ),
    ]);
}
