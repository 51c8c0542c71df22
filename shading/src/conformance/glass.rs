//! The kit of the shader `glass`.
//!
//! **The idea.** At a border between two media light divides: a part is mirrored, the rest goes on, bent towards the normal where it enters
//! the denser medium and away from it where it leaves. From inside, flat light cannot leave at all.
//!
//! ```text
//!     d \  | n   / r     eta: the index on the ray's side over that on the other: 1 / eta from outside, eta from inside
//!        \ |    /        sin(theta_t) = eta sin(theta_i)                                  (Snell 1621)
//!   -------+--------     kr = ( ((a - b) / (a + b))^2 + ((c - d) / (c + d))^2 ) / 2       (Fresnel 1823, unpolarised)
//!          |\                 with a = eta cos(theta_i), b = cos(theta_t), c = eta cos(theta_t), d = cos(theta_i)
//!          | \ t         light = colour x (kr x what r sees + (1 - kr) x what t sees), and after a way inside
//!                                x exp(-way / distance (1 - absorption colour))           (Beer 1852)
//! ```
//!
//! **The contract.** A [`Glass`] makes a [`Shader`] of the index inside over that outside, the colour, and what is absorbed.
//! [`ShadingPoint::reflected`] and [`ShadingPoint::refracted`] follow rays; [`crate::optics::border`] is the reference's own. It casts no shadow.
//!
//! **Hard cases.** The critical angle. An index of 1, where nothing happens, and below 1, a bubble. A ray that has reflections left and no
//! refraction, or the other way round. White under a white sky: no light is lost or made.
//!
//! **Literature.** Whitted: An Improved Illumination Model for Shaded Display, CACM 1980. Pharr, Jakob, Humphreys: Physically Based
//! Rendering, 4th ed. 2023, section 9.5. de Greve: Reflections and Refractions in Ray Tracing, 2006.
//!
//! **Exercises.** Pass the kit with `border`. Write `border` yourself in `f32` and say how near to the critical angle it is right. Put Schlick's
//! approximation in its place: which law fails, and at what angle most? Follow one of the two rays by chance and compare the noise.
//!
//! | mistake | law that names it |
//! |---|---|
//! | nothing is returned | [`glass_of_index_1_shows_what_is_behind_it`] |
//! | the colour forgotten | [`glass_of_index_1_shows_what_is_behind_it`] |
//! | Fresnel forgotten: all goes through | [`glass_seen_straight_reflects_as_fresnel_says`] |
//! | refracted away from the normal: eta inverted | [`a_ray_into_glass_bends_as_snell_says`] |
//! | refraction with eta inverted inside | [`a_ray_out_of_glass_bends_as_snell_says`] |
//! | Schlick's approximation for Fresnel | [`glass_reflects_as_fresnel_says_at_any_angle`] |
//! | no total internal reflection | [`beyond_the_critical_angle_glass_reflects_all`] |
//! | energy gained: the reflection added, and nothing taken away | [`glass_seen_straight_reflects_as_fresnel_says`] |
//! | absorption outside as well | [`light_from_outside_is_not_absorbed`] |
//! | no absorption inside | [`light_through_the_inside_is_absorbed_by_its_way`] |
//! | absorption whatever the way's length | [`light_through_the_inside_is_absorbed_by_its_way`] |
//! | depth off by one: a refraction is not counted | [`each_ray_of_glass_has_one_bounce_of_its_kind_less`] |
//! | reflections and refractions counted as one | [`each_ray_of_glass_has_one_bounce_of_its_kind_less`] |
//! | black where one kind of bounce has run out | [`where_one_kind_of_bounce_has_run_out_the_other_goes_on`] |
//! | a refracted ray starts on the wrong side | [`rays_from_glass_start_beside_the_surface`] |
//! | lit like a matt surface as well | [`glass_does_not_depend_on_lights`] |
//! | glass that shadows | [`glass_casts_no_shadow`] |

use geometry::conformance::{Trial, Verdict, same};
use glam::DVec3;
use proptest::prelude::*;

use super::Shown;
use super::stage::{sky_at, times};
use super::{Stage, absorbed, colors, from_inside, from_outside, lamps, stages, straight};
#[cfg(doc)]
use crate::ShadingPoint;
use crate::{Absorption, Bounces, Color, Shader};

/// A clear body from its index of refraction, its colour and what it absorbs.
pub type Glass = fn(f32, Color, Option<Absorption>) -> Box<dyn Shader>;

/// Indices inside over outside: water to diamond, and a bubble's.
pub fn indices() -> impl Strategy<Value = f32> {
    prop_oneof![3 => 1.05_f32..2.5, 1 => 0.4_f32..0.95]
}

/// What happens at a border, by the formulas above.
struct Border {
    /// The share that is reflected.
    reflectance: f64,
    /// Where the rest goes, if there is a rest.
    refracted: Option<DVec3>,
    /// The square of the cosine on the far side: below 0 beyond the critical angle.
    cos_out_squared: f64,
}

impl Border {
    fn of(stage: &Stage, index: f32) -> Self {
        let inside = stage.direction.as_dvec3().dot(stage.surface.geometric_normal.as_dvec3()) > 0.0;
        let eta = if inside { f64::from(index) } else { 1.0 / f64::from(index) };
        let (d, n) = (stage.direction.as_dvec3().normalize(), stage.normal());
        let cos_in = -d.dot(n);
        let cos_out_squared = 1.0 - eta * eta * (1.0 - cos_in * cos_in);
        if cos_out_squared <= 0.0 {
            return Self { reflectance: 1.0, refracted: None, cos_out_squared };
        }
        let cos_out = cos_out_squared.sqrt();
        let share = |a: f64, b: f64| (a - b) / (a + b) * (a - b) / (a + b);
        let reflectance = 0.5 * (share(eta * cos_in, cos_out) + share(eta * cos_out, cos_in));
        Self { reflectance, refracted: Some(d * eta + n * (eta * cos_in - cos_out)), cos_out_squared }
    }

    /// What is seen by its two rays under the kit's sky.
    fn seen(&self, stage: &Stage) -> [f64; 3] {
        let reflected = sky_at(stage.mirrored());
        let refracted = self.refracted.map_or([0.0; 3], sky_at);
        [0, 1, 2].map(|channel| reflected[channel] * self.reflectance + refracted[channel] * (1.0 - self.reflectance))
    }
}

/// A body, and a ray that comes to it, not within a hundredth of the critical angle's cosine: there single precision sees little.
fn borders(stages: impl Strategy<Value = Stage>) -> impl Strategy<Value = (Stage, f32)> {
    (stages, indices())
        .prop_filter("nearly critical", |(stage, index)| Border::of(stage, *index).cos_out_squared.abs() > 0.01)
}

fn shows(glass: &Glass, stage: &Stage, index: f32, color: Color) -> Verdict {
    let shown = stage.shown(&*glass(index, color, None));
    stage.shows(&shown, times(color, Border::of(stage, index).seen(stage)))
}

/// The verdict on where the ray goes that passes the border, whatever share of light it brings.
fn bends(glass: &Glass, stage: &Stage, index: f32) -> Verdict {
    let shown = stage.shown(&*glass(index, Color::WHITE, None));
    let Some(refracted) = Border::of(stage, index).refracted else { return Ok(()) };
    let through = |(ray, _): &&(geometry::Ray, Bounces)| ray.direction.as_dvec3().dot(stage.outward()) < 0.0;
    let Some((ray, _)) = shown.rays.iter().find(through) else {
        return stage.unlike(&shown, format!("a ray along {refracted:?}"), "no ray through the surface");
    };
    let found = ray.direction.as_dvec3().normalize();
    if (found - refracted).length() <= 1e-5 {
        return Ok(());
    }
    stage.unlike(&shown, format!("a ray along {refracted:?}"), format!("{found:?}"))
}

/// No border, so nothing is bent or reflected: the colour times what lies straight on.
pub fn glass_of_index_1_shows_what_is_behind_it(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search((straight(), colors()), |(stage, color)| {
        let shown = stage.shown(&*glass(1.0, *color, None));
        stage.shows(&shown, times(*color, sky_at(stage.direction.as_dvec3())))
    })
}

/// `((eta - 1) / (eta + 1))^2`: 4 % for window glass.
pub fn glass_seen_straight_reflects_as_fresnel_says(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search((straight(), indices()), |(stage, index)| shows(glass, stage, *index, Color::WHITE))
}

/// From outside, towards the normal if the index is above 1.
pub fn a_ray_into_glass_bends_as_snell_says(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search(borders(from_outside()), |(stage, index)| bends(glass, stage, *index))
}

/// From inside, the other way round.
pub fn a_ray_out_of_glass_bends_as_snell_says(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search(borders(from_inside()), |(stage, index)| bends(glass, stage, *index))
}

/// The two shares of light, from either side, where there are two.
pub fn glass_reflects_as_fresnel_says_at_any_angle(glass: &Glass, trial: &Trial) -> Verdict {
    let both = borders(stages()).prop_filter("total", |(stage, index)| Border::of(stage, *index).refracted.is_some());
    trial.search(both, |(stage, index)| shows(glass, stage, *index, Color::WHITE))
}

/// All of the light, and one ray.
pub fn beyond_the_critical_angle_glass_reflects_all(glass: &Glass, trial: &Trial) -> Verdict {
    let total = (stages(), 1.5_f32..2.5, any::<bool>()).prop_map(|(stage, index, bubble)| {
        let inside = stage.direction.dot(stage.surface.geometric_normal) > 0.0;
        (stage, if inside || !bubble { index } else { 1.0 / index })
    });
    let total = total.prop_filter("not total", |(stage, index)| Border::of(stage, *index).cos_out_squared < -0.01);
    trial.search(total, |(stage, index)| shows(glass, stage, *index, Color::WHITE))
}

/// Under a white sky, white glass is white: the two shares make one.
pub fn glass_neither_takes_nor_makes_light(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search((stages(), indices(), colors()), |(stage, index, color)| {
        let shown = stage.shown_under(|_| Color::WHITE, &*glass(*index, *color, None));
        stage.shows(&shown, color.to_array().map(f64::from))
    })
}

/// What came through the air has lost nothing.
pub fn light_from_outside_is_not_absorbed(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search((borders(from_outside()), absorbed()), |((stage, index), (absorption, way))| {
        let stage = Stage { distance: *way, ..stage.clone() };
        let shown = stage.shown(&*glass(*index, Color::WHITE, Some(*absorption)));
        stage.shows(&shown, Border::of(&stage, *index).seen(&stage))
    })
}

/// `exp(-way / distance (1 - colour))`, by channel, of all that comes back.
pub fn light_through_the_inside_is_absorbed_by_its_way(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search((borders(from_inside()), absorbed()), |((stage, index), (absorption, way))| {
        let stage = Stage { distance: *way, ..stage.clone() };
        let shown = stage.shown(&*glass(*index, Color::WHITE, Some(*absorption)));
        let seen = Border::of(&stage, *index).seen(&stage);
        let ways = f64::from(*way) / f64::from(absorption.distance);
        let left = absorption.color.to_array().map(|channel| libm::exp(-ways * (1.0 - f64::from(channel))));
        stage.shows(&shown, [0, 1, 2].map(|channel| seen[channel] * left[channel]))
    })
}

/// [`Bounces::reflected`] for the one, [`Bounces::refracted`] for the other.
pub fn each_ray_of_glass_has_one_bounce_of_its_kind_less(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search(borders(stages()), |(stage, index)| {
        let shown = stage.shown(&*glass(*index, Color::WHITE, None));
        let (mut reflected, mut refracted) = by_kind(stage, &shown);
        reflected.dedup();
        refracted.dedup();
        let passes = Border::of(stage, *index).refracted.is_some();
        let expected = |bounces: Option<Bounces>, is_due: bool| bounces.filter(|_| is_due).into_iter().collect();
        let expected: [Vec<Bounces>; 2] =
            [expected(stage.bounces.reflected(), true), expected(stage.bounces.refracted(), passes)];
        same(&expected, &[reflected, refracted])
    })
}

/// The bounces of the rays on the viewer's side, and of those through the surface.
fn by_kind(stage: &Stage, shown: &Shown) -> (Vec<Bounces>, Vec<Bounces>) {
    let of_side = |sign: f64| {
        let rays = shown.rays.iter().filter(move |(ray, _)| sign * ray.direction.as_dvec3().dot(stage.outward()) > 0.0);
        rays.map(|(_, bounces)| *bounces).collect()
    };
    (of_side(1.0), of_side(-1.0))
}

/// A ray without reflections left sees what is refracted, and the other way round; without either, black.
pub fn where_one_kind_of_bounce_has_run_out_the_other_goes_on(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search((borders(stages()), 0..2_u32, 0..2_u32), |((stage, index), reflections, refractions)| {
        let bounces = Bounces { reflections: *reflections, refractions: *refractions, ..stage.bounces };
        let stage = Stage { bounces, ..stage.clone() };
        let border = Border::of(&stage, *index);
        let share = |left: u32, share: f64| if left > 0 { share } else { 0.0 };
        let (mirrored, through) = (sky_at(stage.mirrored()), border.refracted.map_or([0.0; 3], sky_at));
        let reflected = share(*reflections, border.reflectance);
        let refracted = share(*refractions, 1.0 - border.reflectance);
        let expected = [0, 1, 2].map(|channel| mirrored[channel] * reflected + through[channel] * refracted);
        stage.shows(&stage.shown(&*glass(*index, Color::WHITE, None)), expected)
    })
}

/// Each on the side that it goes to.
pub fn rays_from_glass_start_beside_the_surface(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search(borders(stages()), |(stage, index)| {
        let shown = stage.shown(&*glass(*index, Color::WHITE, None));
        shown.rays.iter().try_for_each(|(ray, _)| stage.leaves(&shown, ray))
    })
}

/// It has no light of its own and no matt part.
pub fn glass_does_not_depend_on_lights(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search(borders(lamps(stages())), |(stage, index)| shows(glass, stage, *index, Color::WHITE))
}

/// Light goes through it to others.
pub fn glass_casts_no_shadow(glass: &Glass, trial: &Trial) -> Verdict {
    trial.search((indices(), colors()), |&(index, color)| same(&false, &glass(index, color, None).casts_shadow()))
}

geometry::kit! { $crate
    /// Names the laws of the shader `glass` as tests: of a function from the index of refraction, the colour and the absorption to a
    /// [`crate::Shader`].
    glass_conformance, Glass, glass;
    glass_of_index_1_shows_what_is_behind_it: "nothing is returned yet: begin with the colour times `at.refracted(at.direction)`";
    glass_seen_straight_reflects_as_fresnel_says: "the reflection is forgotten, or its share is not taken from the refracted light";
    a_ray_into_glass_bends_as_snell_says: "`eta` is the index inside over that outside, and the formula wants the other quotient here; or the sign of the normal's part is wrong";
    a_ray_out_of_glass_bends_as_snell_says: "`eta` is not turned over inside, or the normal is not on the ray's side";
    glass_reflects_as_fresnel_says_at_any_angle: "an approximation, or cosines of the two sides exchanged, or only one polarisation";
    beyond_the_critical_angle_glass_reflects_all: "a root of a negative number is taken as 0 or NaN, or black is returned";
    glass_neither_takes_nor_makes_light: "the two shares do not add up to 1, or one ray is left out when its share is small";
    light_from_outside_is_not_absorbed: "every way is absorbed, whichever side the ray came from";
    light_through_the_inside_is_absorbed_by_its_way: "absorption is left out, or does not use the length of the way, or only of the refracted part";
    each_ray_of_glass_has_one_bounce_of_its_kind_less: "the bounces are handed on as they came, or both kinds are counted together";
    where_one_kind_of_bounce_has_run_out_the_other_goes_on: "black is returned as soon as either kind has run out";
    rays_from_glass_start_beside_the_surface: "both rays start on the viewer's side, or at the point itself";
    glass_does_not_depend_on_lights: "a matt part is added";
    glass_casts_no_shadow: "`casts_shadow` is left as it is by default";
}
