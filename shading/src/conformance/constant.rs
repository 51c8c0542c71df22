//! The kit of the shader `constant`: one colour over the whole surface.
//!
//! **The idea.** Light that comes flat is spread over more surface, so a matt surface is lit by the cosine (Lambert 1760):
//!
//! ```text
//!          n   l
//!          |  /        light = colour x sum over the lights that are seen of E (n.l)
//!          | / )       E: the light's colour times its falloff at the distance
//!   -------|/-------   without lights in the scene: colour x ambient
//! ```
//!
//! **The contract.** A [`Constant`] makes a [`Shader`] of the colour. [`ShadingPoint::lit`] gives the lights that the point sees, with cosines
//! and falloff; who writes that, too, asks [`World::light`] by number and [`World::blocked`] about the segment to each.
//!
//! **Hard cases.** The back of a surface. Something beyond the light, or behind the point. A mesh's own normal that leans away from the
//! true one, so that a light is before the one and behind the other. A shadow ray that starts in the surface.
//!
//! **Literature.** Appel: Some Techniques for Shading Machine Renderings of Solids, 1968 (shadow rays). Whitted 1980. Hanika: Hacking the
//! Shadow Terminator, Ray Tracing Gems II, 2021 (leaning normals).
//!
//! **Exercises.** Pass the kit with `at.lit()`. Write `lit` yourself. Ask the lights in an order that finds shadows sooner, and count the
//! shadow rays. Soften the terminator of coarse meshes.
//!
//! | mistake | law that names it |
//! |---|---|
//! | nothing is returned | [`a_constant_surface_shows_the_scene_s_ambient_light`] |
//! | divided by pi | [`a_light_straight_above_gives_all_its_light`] |
//! | the light's colour forgotten | [`a_light_straight_above_gives_all_its_light`] |
//! | the cosine forgotten | [`light_falls_with_the_cosine`] |
//! | falloff forgotten | [`light_falls_with_the_distance_as_the_light_says`] |
//! | the cosine's absolute value | [`a_light_behind_the_surface_gives_nothing`] |
//! | only the first light counts | [`lights_add_up`] |
//! | ambient although there are lights | [`no_ambient_light_where_there_are_lights`] |
//! | no shadows | [`something_between_casts_a_shadow`] |
//! | shadow ray without end: shadow beyond the light | [`what_lies_beyond_the_light_casts_no_shadow`] |
//! | the shadow ray goes both ways | [`what_lies_behind_the_point_casts_no_shadow`] |
//! | the normal not on the viewer's side | [`the_back_is_lit_like_the_front`] |
//! | the true normal where a mesh has its own | [`light_goes_by_the_normal_that_a_mesh_gives`] |
//! | light through the surface | [`light_does_not_come_through_the_surface`] |
//! | the shadow ray starts in the surface | [`a_shadow_ray_starts_beside_the_surface`] |
//! | lets light through | [`a_constant_surface_casts_a_shadow`] |

use geometry::conformance::{Trial, Verdict};

use super::lit;
use crate::{Color, Shader};
#[cfg(doc)]
use crate::{ShadingPoint, World};

/// A surface of one colour.
pub type Constant = fn(Color) -> Box<dyn Shader>;

/// Without lights: the colour times the ambient share.
pub fn a_constant_surface_shows_the_scene_s_ambient_light(constant: &Constant, trial: &Trial) -> Verdict {
    lit::ambient(&|color| constant(color), trial)
}

/// Ambient light is for scenes without any light, and does not lighten shadows.
pub fn no_ambient_light_where_there_are_lights(constant: &Constant, trial: &Trial) -> Verdict {
    lit::no_ambient(&|color| constant(color), trial)
}

/// The colour times the light's, channel by channel.
pub fn a_light_straight_above_gives_all_its_light(constant: &Constant, trial: &Trial) -> Verdict {
    lit::straight_above(&|color| constant(color), trial)
}

/// Lambert: the flatter light comes, the more surface it is spread over.
pub fn light_falls_with_the_cosine(constant: &Constant, trial: &Trial) -> Verdict {
    lit::by_the_cosine(&|color| constant(color), trial)
}

/// Each light knows its falloff.
pub fn light_falls_with_the_distance_as_the_light_says(constant: &Constant, trial: &Trial) -> Verdict {
    lit::by_the_distance(&|color| constant(color), trial)
}

/// There the cosine is below 0.
pub fn a_light_behind_the_surface_gives_nothing(constant: &Constant, trial: &Trial) -> Verdict {
    lit::behind(&|color| constant(color), trial)
}

/// The sum over all lights.
pub fn lights_add_up(constant: &Constant, trial: &Trial) -> Verdict {
    lit::add_up(&|color| constant(color), trial)
}

/// A point is dark if something opaque lies between it and the light.
pub fn something_between_casts_a_shadow(constant: &Constant, trial: &Trial) -> Verdict {
    lit::in_shadow(&|color| constant(color), trial)
}

/// The shadow ray ends at the light.
pub fn what_lies_beyond_the_light_casts_no_shadow(constant: &Constant, trial: &Trial) -> Verdict {
    lit::beyond_the_light(&|color| constant(color), trial)
}

/// The shadow ray begins at the point.
pub fn what_lies_behind_the_point_casts_no_shadow(constant: &Constant, trial: &Trial) -> Verdict {
    lit::behind_the_point(&|color| constant(color), trial)
}

/// The side that is seen is lit from its own side.
pub fn the_back_is_lit_like_the_front(constant: &Constant, trial: &Trial) -> Verdict {
    lit::the_back(&|color| constant(color), trial)
}

/// The shading normal makes flat triangles look round.
pub fn light_goes_by_the_normal_that_a_mesh_gives(constant: &Constant, trial: &Trial) -> Verdict {
    lit::the_mesh_s_normal(&|color| constant(color), trial)
}

/// A light behind the true surface gives nothing, even before a mesh's leaning normal.
pub fn light_does_not_come_through_the_surface(constant: &Constant, trial: &Trial) -> Verdict {
    lit::through_the_surface(&|color| constant(color), trial)
}

/// At the very point it would meet the surface itself.
pub fn a_shadow_ray_starts_beside_the_surface(constant: &Constant, trial: &Trial) -> Verdict {
    lit::shadow_rays_leave(&|color| constant(color), trial)
}

/// Only glass lets light through.
pub fn a_constant_surface_casts_a_shadow(constant: &Constant, trial: &Trial) -> Verdict {
    lit::casts_a_shadow(&|color| constant(color), trial)
}

geometry::kit! { $crate
    /// Names the laws of the shader `constant` as tests: of a function from the colour to a [`crate::Shader`].
    constant_conformance, Constant, constant;
    a_constant_surface_shows_the_scene_s_ambient_light: "nothing is returned yet: begin with `at.ambient()`, which is `Some` in a scene without lights";
    no_ambient_light_where_there_are_lights: "the ambient share is added to the lights' light";
    a_light_straight_above_gives_all_its_light: "the light's colour is forgotten, or the sum over `at.lit()` is missing, or is divided by pi or by the number of lights";
    light_falls_with_the_cosine: "the cosine between normal and light is missing, or the viewer's is taken";
    light_falls_with_the_distance_as_the_light_says: "the light's colour is taken as it is, without its falloff at the distance; or both `at_distance` and a square of one's own";
    a_light_behind_the_surface_gives_nothing: "the cosine's absolute value is taken, or negative light is added";
    lights_add_up: "only the first or the last light counts, or their mean";
    something_between_casts_a_shadow: "no shadow ray is asked, or its answer is turned around";
    what_lies_beyond_the_light_casts_no_shadow: "the shadow ray goes on without end: `blocked` asks about the segment from `origin` to `origin + direction`, so the direction must not be normalised to be long";
    what_lies_behind_the_point_casts_no_shadow: "the shadow ray goes the wrong way, or from the light past the point";
    the_back_is_lit_like_the_front: "the normal is not on the viewer's side";
    light_goes_by_the_normal_that_a_mesh_gives: "the geometric normal is taken for the shading normal";
    light_does_not_come_through_the_surface: "only the shading normal is asked which side the light is on";
    a_shadow_ray_starts_beside_the_surface: "the shadow ray starts at the point: spots of shadow all over (acne)";
    a_constant_surface_casts_a_shadow: "`casts_shadow` was copied from glass";
}
