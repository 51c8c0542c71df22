//! The kit of the shader `phong`: a matt surface with a highlight.
//!
//! **The idea.** A rough mirror shows a light as a spot around where a smooth one would show it: the nearer the viewer is to the mirrored
//! light, the brighter.
//!
//! ```text
//!     l    n    r        r: the light's direction mirrored at n; v: to the viewer
//!      \   |   /  . v    light = diffuse(u, v) x sum E (n.l) + specular x sum E max(0, r.v)^exponent
//!       \  |  / .
//!   -----\-|-/.------    without lights in the scene: diffuse(u, v) x ambient
//! ```
//!
//! **The contract.** A [`Phong`] makes a [`Shader`] of the matt part, the highlight's colour and its exponent. Of the lights all is true that
//! [`super::constant`] says.
//!
//! **Hard cases.** Light and viewer on one side of the normal, where `r.v` is below 0 and an even exponent makes it light again. A light
//! behind the surface whose mirror image is before it. Exponents that are no whole numbers.
//!
//! **Literature.** Phong: Illumination for Computer Generated Pictures, CACM 1975. Blinn: Models of Light Reflection for Computer Synthesized
//! Pictures, SIGGRAPH 1977 (the other half vector). Lafortune and Willems: Using the Modified Phong Reflectance Model, 1994.
//!
//! **Exercises.** Pass the kit. Which law names Blinn's highlight, and with which exponent does it come nearest? Make it reflect no more than
//! arrives, and say which laws change. Beat [`crate::Phong`] at a thousand lights.
//!
//! | mistake | law that names it |
//! |---|---|
//! | nothing is returned | [`a_phong_surface_shows_the_scene_s_ambient_light`] |
//! | ambient although there are lights | [`no_ambient_light_where_there_are_lights`] |
//! | shadow ray without end: shadow beyond the light | [`what_lies_beyond_the_light_casts_no_shadow`] |
//! | the normal not on the viewer's side | [`the_back_is_lit_like_the_front`] |
//! | the texture asked at another place | [`the_texture_is_asked_at_the_point`] |
//! | no highlight | [`a_highlight_stands_where_the_light_is_mirrored`] |
//! | the highlight dimmed by the light's cosine | [`a_highlight_is_as_bright_at_any_slant`] |
//! | the exponent forgotten | [`a_highlight_falls_by_the_power_of_the_cosine`] |
//! | the wrong half: Blinn's highlight | [`a_highlight_falls_by_the_power_of_the_cosine`] |
//! | r.v below 0 to an even power | [`there_is_no_highlight_on_the_far_side_of_the_mirror`] |
//! | the highlight in the matt part's colour | [`a_highlight_has_its_own_colour`] |
//! | highlight behind the surface | [`a_light_behind_the_surface_has_no_highlight`] |
//! | highlight in the shadow | [`there_is_no_highlight_in_the_shadow`] |
//! | the highlight's normal not on the viewer's side | [`the_back_has_its_highlights`] |

use std::sync::Arc;

use geometry::conformance::{Trial, Verdict};
use glam::Vec2;
use proptest::prelude::*;

use super::stage::times;
use super::{Lamp, Stage, blocked_at, colors, from_inside, from_outside, lamps, leaning, lit, lit_from_behind, stages};
use super::{straight, undimmed};
use crate::{Color, Shader, Texture};

/// A surface from its matt part, its highlight's colour and its exponent.
pub type Phong = fn(Arc<dyn Texture>, Color, f32) -> Box<dyn Shader>;

fn matt(phong: &Phong, color: Color) -> Box<dyn Shader> {
    phong(Arc::new(color), Color::BLACK, 10.0)
}

/// Without lights: the colour times the ambient share.
pub fn a_phong_surface_shows_the_scene_s_ambient_light(phong: &Phong, trial: &Trial) -> Verdict {
    lit::ambient(&|color| matt(phong, color), trial)
}

/// Ambient light is for scenes without any light, and does not lighten shadows.
pub fn no_ambient_light_where_there_are_lights(phong: &Phong, trial: &Trial) -> Verdict {
    lit::no_ambient(&|color| matt(phong, color), trial)
}

/// The colour times the light's, channel by channel.
pub fn a_light_straight_above_gives_all_its_light(phong: &Phong, trial: &Trial) -> Verdict {
    lit::straight_above(&|color| matt(phong, color), trial)
}

/// Lambert: the flatter light comes, the more surface it is spread over.
pub fn light_falls_with_the_cosine(phong: &Phong, trial: &Trial) -> Verdict {
    lit::by_the_cosine(&|color| matt(phong, color), trial)
}

/// Each light knows its falloff.
pub fn light_falls_with_the_distance_as_the_light_says(phong: &Phong, trial: &Trial) -> Verdict {
    lit::by_the_distance(&|color| matt(phong, color), trial)
}

/// There the cosine is below 0.
pub fn a_light_behind_the_surface_gives_nothing(phong: &Phong, trial: &Trial) -> Verdict {
    lit::behind(&|color| matt(phong, color), trial)
}

/// The sum over all lights.
pub fn lights_add_up(phong: &Phong, trial: &Trial) -> Verdict {
    lit::add_up(&|color| matt(phong, color), trial)
}

/// A point is dark if something opaque lies between it and the light.
pub fn something_between_casts_a_shadow(phong: &Phong, trial: &Trial) -> Verdict {
    lit::in_shadow(&|color| matt(phong, color), trial)
}

/// The shadow ray ends at the light.
pub fn what_lies_beyond_the_light_casts_no_shadow(phong: &Phong, trial: &Trial) -> Verdict {
    lit::beyond_the_light(&|color| matt(phong, color), trial)
}

/// The shadow ray begins at the point.
pub fn what_lies_behind_the_point_casts_no_shadow(phong: &Phong, trial: &Trial) -> Verdict {
    lit::behind_the_point(&|color| matt(phong, color), trial)
}

/// The side that is seen is lit from its own side.
pub fn the_back_is_lit_like_the_front(phong: &Phong, trial: &Trial) -> Verdict {
    lit::the_back(&|color| matt(phong, color), trial)
}

/// The shading normal makes flat triangles look round.
pub fn light_goes_by_the_normal_that_a_mesh_gives(phong: &Phong, trial: &Trial) -> Verdict {
    lit::the_mesh_s_normal(&|color| matt(phong, color), trial)
}

/// A light behind the true surface gives nothing, even before a mesh's leaning normal.
pub fn light_does_not_come_through_the_surface(phong: &Phong, trial: &Trial) -> Verdict {
    lit::through_the_surface(&|color| matt(phong, color), trial)
}

/// At the very point it would meet the surface itself.
pub fn a_shadow_ray_starts_beside_the_surface(phong: &Phong, trial: &Trial) -> Verdict {
    lit::shadow_rays_leave(&|color| matt(phong, color), trial)
}

/// Another colour at each place.
struct Everywhere;

impl Everywhere {
    fn at(uv: Vec2) -> Color {
        Color::new(0.5 + 0.1 * uv.x, 0.5 + 0.1 * uv.y, 0.5)
    }
}

impl Texture for Everywhere {
    fn color(&self, uv: &dyn Fn() -> Vec2) -> Color {
        Self::at(uv())
    }
}

/// Lit or not, the matt part is the texture's colour at the point's own coordinates.
pub fn the_texture_is_asked_at_the_point(phong: &Phong, trial: &Trial) -> Verdict {
    trial.search((lit(stages()), any::<bool>()), |(stage, is_lit)| {
        let textured = phong(Arc::new(Everywhere), Color::BLACK, 10.0);
        let (stage, light) = match is_lit {
            true => (stage.clone(), stage.matt_light()),
            false => (Stage { lamps: [None; 2], ambient: 0.5, ..stage.clone() }, [0.5; 3]),
        };
        stage.shows(&stage.shown(&*textured), times(Everywhere::at(stage.uv), light))
    })
}

/// A surface and the lights that it is seen by.
#[derive(Clone, Debug)]
struct Shining {
    stage: Stage,
    specular: Color,
    exponent: f32,
}

/// Exponents from a wide highlight to a narrow one, whole and not.
fn shining(stages: impl Strategy<Value = Stage>) -> impl Strategy<Value = Shining> {
    let exponent = prop_oneof![(1..60_u32).prop_map(|whole| whole as f32), 0.5_f32..60.0];
    (stages, colors(), exponent).prop_map(|(stage, specular, exponent)| Shining { stage, specular, exponent })
}

impl Shining {
    /// The verdict on a highlight without a matt part.
    fn shows(&self, phong: &Phong) -> Verdict {
        self.shows_with(phong, Color::BLACK)
    }

    /// The verdict on both together, where nothing shades them.
    fn shows_with(&self, phong: &Phong, diffuse: Color) -> Verdict {
        let Self { stage, specular, exponent } = self;
        let shown = stage.shown(&*phong(Arc::new(diffuse), *specular, *exponent));
        let mut expected = times(diffuse, stage.matt_light());
        for (direction, _, light) in stage.arriving() {
            // r.v, with v mirrored instead of l.
            let near = stage.mirrored().dot(direction).max(0.0);
            let highlight = times(*specular, light.map(|channel| channel * libm::pow(near, f64::from(*exponent))));
            expected = [0, 1, 2].map(|channel| expected[channel] + highlight[channel]);
        }
        // A power multiplies the rounding of its base.
        stage.shows_to(&shown, expected, 1e-6 * f64::from(10.0 + exponent))
    }

    /// The verdict that there is no highlight.
    fn is_dark(&self, phong: &Phong) -> Verdict {
        let Self { stage, specular, exponent } = self;
        stage.shows(&stage.shown(&*phong(Arc::new(Color::BLACK), *specular, *exponent)), [0.0; 3])
    }
}

/// With its light just where a mirror would show it, at a colour of white.
fn mirrored(stages: impl Strategy<Value = Stage>) -> impl Strategy<Value = Stage> {
    undimmed(lit(stages)).prop_map(|stage| {
        let to_light = stage.mirrored() * stage.to_lamp().length();
        let position = (stage.surface.position.as_dvec3() + to_light).as_vec3();
        Stage { lamps: stage.lamps.map(|lamp| lamp.map(|lamp| Lamp { position, ..lamp })), ..stage }
    })
}

/// Light, normal and viewer in one line: the highlight is the light times its colour.
pub fn a_highlight_stands_where_the_light_is_mirrored(phong: &Phong, trial: &Trial) -> Verdict {
    let white = shining(mirrored(straight())).prop_map(|case| Shining { specular: Color::WHITE, ..case });
    trial.search(white, |case| case.shows(phong))
}

/// Its height does not hang on the light's cosine.
pub fn a_highlight_is_as_bright_at_any_slant(phong: &Phong, trial: &Trial) -> Verdict {
    let white = shining(mirrored(from_outside())).prop_map(|case| Shining { specular: Color::WHITE, ..case });
    trial.search(white, |case| case.shows(phong))
}

/// `max(0, r.v)^exponent`, where that is above 0.
pub fn a_highlight_falls_by_the_power_of_the_cosine(phong: &Phong, trial: &Trial) -> Verdict {
    let near = lit(from_outside()).prop_filter("far side", |stage| stage.mirrored().dot(stage.to_lamp()) > 0.0);
    let white = shining(near).prop_map(|case| Shining { specular: Color::WHITE, ..case });
    trial.search(white, |case| case.shows(phong))
}

/// Where `r.v` is below 0 there is none, whatever the exponent.
pub fn there_is_no_highlight_on_the_far_side_of_the_mirror(phong: &Phong, trial: &Trial) -> Verdict {
    let far = lit(from_outside()).prop_filter("near side", |stage| stage.mirrored().dot(stage.to_lamp()) < 0.0);
    trial.search(shining(far), |case| case.is_dark(phong))
}

/// It is the specular colour's, channel by channel, beside the matt part.
pub fn a_highlight_has_its_own_colour(phong: &Phong, trial: &Trial) -> Verdict {
    trial.search((shining(lit(from_outside())), colors()), |(case, diffuse)| case.shows_with(phong, *diffuse))
}

/// Its mirror image may stand before the surface all the same.
pub fn a_light_behind_the_surface_has_no_highlight(phong: &Phong, trial: &Trial) -> Verdict {
    trial.search(shining(lit_from_behind(stages())), |case| case.is_dark(phong))
}

/// What casts a shadow on the matt part takes the highlight, too.
pub fn there_is_no_highlight_in_the_shadow(phong: &Phong, trial: &Trial) -> Verdict {
    trial.search(shining(blocked_at(lit(from_outside()), 0.4..0.7)), |case| case.is_dark(phong))
}

/// Seen from the back, lit from the back.
pub fn the_back_has_its_highlights(phong: &Phong, trial: &Trial) -> Verdict {
    trial.search((shining(lit(from_inside())), colors()), |(case, diffuse)| case.shows_with(phong, *diffuse))
}

/// Several lights, a leaning normal, either side: the sum of all that the formula says.
pub fn matt_parts_and_highlights_add_up(phong: &Phong, trial: &Trial) -> Verdict {
    let lit = prop_oneof![lamps(leaning()), lamps(stages())].prop_map(|stage| Stage { ambient: 0.5, ..stage });
    trial.search((shining(lit), colors()), |(case, diffuse)| case.shows_with(phong, *diffuse))
}

/// Only glass lets light through.
pub fn a_phong_surface_casts_a_shadow(phong: &Phong, trial: &Trial) -> Verdict {
    lit::casts_a_shadow(&|color| matt(phong, color), trial)
}

geometry::kit! { $crate
    /// Names the laws of the shader `phong` as tests: of a function from the matt part, the highlight's colour and its exponent to a
    /// [`crate::Shader`].
    phong_conformance, Phong, phong;
    a_phong_surface_shows_the_scene_s_ambient_light: "nothing is returned yet: begin with `at.ambient()`, which is `Some` in a scene without lights";
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
    the_texture_is_asked_at_the_point: "the texture is asked at a fixed place, or left out where there are no lights";
    a_highlight_stands_where_the_light_is_mirrored: "the highlight is missing, or counted twice";
    a_highlight_is_as_bright_at_any_slant: "the highlight is multiplied by the light's cosine, as other models do";
    a_highlight_falls_by_the_power_of_the_cosine: "the exponent is not used, or the angle between normal and half vector (Blinn) is taken instead of that between mirrored light and viewer";
    there_is_no_highlight_on_the_far_side_of_the_mirror: "`max(0, ...)` is missing before the power is taken";
    a_highlight_has_its_own_colour: "the matt colour is taken, or the two parts are multiplied";
    a_light_behind_the_surface_has_no_highlight: "only the matt part asks whether the light is before the surface";
    there_is_no_highlight_in_the_shadow: "the shadow is only asked for the matt part";
    the_back_has_its_highlights: "the light is mirrored at a normal that is not on the viewer's side";
    matt_parts_and_highlights_add_up: "one part overwrites the other, or only one light shines";
    a_phong_surface_casts_a_shadow: "`casts_shadow` was copied from glass";
}
