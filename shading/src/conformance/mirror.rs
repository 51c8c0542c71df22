//! The kit of a mirror.
//!
//! **The idea.** A mirror shows what lies in one other direction: the ray goes on as far from the normal as it came.
//!
//! ```text
//!    d \   | n   / r       r = d - 2 (d.n) n
//!       \  |  /            light = reflection x what r sees, channel by channel
//!   -----\-|-/------
//! ```
//!
//! **The contract.** A [`Mirror`] makes a [`Shader`] of the share of light that is reflected. [`ShadingPoint::reflected`] follows the ray; who
//! writes that, too, asks [`World::trace`] with [`Bounces::reflected`].
//!
//! **Hard cases.** Seen from behind. A mesh's own normal that leans away from the true one: the ray goes by the leaning normal, unless
//! that sends it through the surface. The last reflection, after which there is black and no ray.
//!
//! **Literature.** Whitted: An Improved Illumination Model for Shaded Display, CACM 1980. Pharr, Jakob, Humphreys: Physically Based
//! Rendering, 4th ed. 2023, sections 9.3 and 6.8.6 (where a ray starts).
//!
//! **Exercises.** Pass the kit with `at.reflected()`. Write `reflected` yourself. Let the reflection rise towards grazing angles (Schlick:
//! An Inexpensive BRDF Model for Physically-based Rendering, 1994) and say which laws must then change. Blur it with several rays, and
//! compare the noise at equal time.
//!
//! | mistake | law that names it |
//! |---|---|
//! | nothing is returned | [`a_mirror_shows_what_is_before_it`] |
//! | mirrored the wrong way: the ray's direction is turned around | [`a_mirror_sends_the_ray_as_far_from_the_normal_as_it_came`] |
//! | the colour forgotten | [`a_mirror_filters_each_channel`] |
//! | the normal not on the viewer's side | [`a_mirror_reflects_on_its_back_too`] |
//! | mirrored at the true normal where a mesh has its own | [`a_mirror_goes_by_the_normal_that_a_mesh_gives`] |
//! | depth off by one: a reflection is not counted | [`a_mirrored_ray_has_one_reflection_less`] |
//! | depth off by one: one ray too many | [`a_mirror_is_black_after_the_last_reflection`] |
//! | the ray starts in the surface | [`a_mirrored_ray_starts_beside_the_surface`] |
//! | the ray goes through the surface | [`a_mirrored_ray_stays_before_the_surface`] |
//! | lit like a matt surface as well | [`a_mirror_does_not_depend_on_lights`] |
//! | lets light through | [`a_mirror_casts_a_shadow`] |

use super::stage::{sky_at, times};
use super::{Stage, colors, from_inside, from_outside, lamps, leaning, mirrored_through, stages, straight};
use crate::{Bounces, Color, Shader};
#[cfg(doc)]
use crate::{ShadingPoint, World};
use geometry::conformance::{Trial, Verdict, same};

/// A mirror from the share of light that it reflects.
pub type Mirror = fn(Color) -> Box<dyn Shader>;

/// The verdict on what a mirror of a colour shows.
fn shows(mirror: &Mirror, color: Color, stage: &Stage) -> Verdict {
    let shown = stage.shown(&*mirror(color));
    stage.shows(&shown, times(color, sky_at(stage.mirrored())))
}

/// Looked at straight, it shows where the ray came from.
pub fn a_mirror_shows_what_is_before_it(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search(straight(), |stage| shows(mirror, Color::WHITE, stage))
}

/// `r = d - 2 (d.n) n`.
pub fn a_mirror_sends_the_ray_as_far_from_the_normal_as_it_came(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search(from_outside(), |stage| shows(mirror, Color::WHITE, stage))
}

/// What comes back is multiplied by the colour.
pub fn a_mirror_filters_each_channel(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search((from_outside(), colors()), |(stage, color)| shows(mirror, *color, stage))
}

/// A surface has two sides.
pub fn a_mirror_reflects_on_its_back_too(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search((from_inside(), colors()), |(stage, color)| shows(mirror, *color, stage))
}

/// The shading normal makes flat triangles look round.
pub fn a_mirror_goes_by_the_normal_that_a_mesh_gives(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search((leaning(), colors()), |(stage, color)| shows(mirror, *color, stage))
}

/// One ray goes on, with [`Bounces::reflected`].
pub fn a_mirrored_ray_has_one_reflection_less(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search(stages(), |stage| {
        let bounces: Vec<_> =
            stage.shown(&*mirror(Color::WHITE)).rays.into_iter().map(|(_, bounces)| Some(bounces)).collect();
        same(&vec![stage.bounces.reflected()], &bounces)
    })
}

/// Where no reflection is left: black, and no ray.
pub fn a_mirror_is_black_after_the_last_reflection(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search(stages(), |stage| {
        let last = Stage { bounces: Bounces { reflections: 0, ..stage.bounces }, ..stage.clone() };
        let shown = last.shown(&*mirror(Color::WHITE));
        same(&(Color::BLACK, 0), &(shown.color, shown.rays.len()))
    })
}

/// At the very point it would meet the surface that it leaves.
pub fn a_mirrored_ray_starts_beside_the_surface(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search(stages(), |stage| {
        let shown = stage.shown(&*mirror(Color::WHITE));
        shown.rays.iter().try_for_each(|(ray, _)| stage.leaves(&shown, ray))
    })
}

/// Where the mesh's normal would send it through the surface, it goes by the true one.
pub fn a_mirrored_ray_stays_before_the_surface(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search(mirrored_through(), |stage| {
        let shown = stage.shown(&*mirror(Color::WHITE));
        let stays = |ray: &geometry::Ray| ray.direction.as_dvec3().dot(stage.outward()) > 0.0;
        match shown.rays.iter().find(|(ray, _)| !stays(ray)) {
            None => Ok(()),
            Some((ray, _)) => stage.unlike(&shown, "a ray on the viewer's side", format!("{:?}", ray.direction)),
        }
    })
}

/// It has no light of its own and no matt part.
pub fn a_mirror_does_not_depend_on_lights(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search((lamps(stages()), colors()), |(stage, color)| shows(mirror, *color, stage))
}

/// Only glass lets light through.
pub fn a_mirror_casts_a_shadow(mirror: &Mirror, trial: &Trial) -> Verdict {
    trial.search(colors(), |&color| same(&true, &mirror(color).casts_shadow()))
}

geometry::kit! { $crate
    /// Names the laws of a mirror as tests: of a function from the share of light that it reflects to a [`crate::Shader`].
    mirror_conformance, Mirror, mirror;
    a_mirror_shows_what_is_before_it: "nothing is returned yet: begin with the colour times `at.reflected()`";
    a_mirror_sends_the_ray_as_far_from_the_normal_as_it_came: "the sign of the normal's part, or the ray's direction turned around first";
    a_mirror_filters_each_channel: "the colour is forgotten, or taken as one number";
    a_mirror_reflects_on_its_back_too: "the normal is not turned to the viewer";
    a_mirror_goes_by_the_normal_that_a_mesh_gives: "the geometric normal is taken for the shading normal";
    a_mirrored_ray_has_one_reflection_less: "the bounces are handed on as they came, or two rays are followed";
    a_mirror_is_black_after_the_last_reflection: "the depth is off by one: compared after the ray was followed, or by `<=`";
    a_mirrored_ray_starts_beside_the_surface: "the ray starts at the point itself, or is moved to the wrong side";
    a_mirrored_ray_stays_before_the_surface: "only the shading normal is asked which side the ray goes to";
    a_mirror_does_not_depend_on_lights: "a matt part is added";
    a_mirror_casts_a_shadow: "`casts_shadow` was copied from glass";
}
