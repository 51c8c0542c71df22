use shading::{Color, Glass, Shader, ShadingPoint, conformance::glass, optics::border};

use crate::Kit;
use crate::spoilt::{clear, follow, opaque};

/// The index of the ray's side over that of the other.
fn ratio(at: &ShadingPoint<'_>, index: f32) -> f32 {
    if at.is_inside() { index } else { 1.0 / index }
}

/// Glass with an index ratio and a reflectance of one's own.
fn by(at: &ShadingPoint<'_>, ratio: f32, reflectance: impl Fn(f32) -> f32) -> Color {
    let border = border(at.direction, at.normal(), ratio);
    let refracted = border.refracted.map_or(Color::BLACK, |direction| at.refracted(direction));
    let share = if border.refracted.is_some() { reflectance(border.reflectance) } else { 1.0 };
    at.reflected() * share + refracted * (1.0 - share)
}

#[test]
fn every_mistake_in_glass_is_named() {
    Kit { page: "shading/src/conformance/glass.rs", laws: glass::LAWS }.catches([
        (
            "nothing is returned",
            (|_, _, _| clear(|_| Color::BLACK)) as glass::Glass,
            "glass_of_index_1_shows_what_is_behind_it",
        ),
        (
            "the colour forgotten",
            |eta, _, absorption| Box::new(Glass { eta, color: Color::WHITE, absorption }),
            "glass_of_index_1_shows_what_is_behind_it",
        ),
        (
            "Fresnel forgotten: all goes through",
            |eta, color, _| clear(move |at| color * by(at, ratio(at, eta), |_| 0.0)),
            "glass_seen_straight_reflects_as_fresnel_says",
        ),
        (
            "refracted away from the normal: eta inverted",
            |eta, color, _| clear(move |at| color * by(at, 1.0 / ratio(at, eta), |share| share)),
            "a_ray_into_glass_bends_as_snell_says",
        ),
        (
            "refraction with eta inverted inside",
            |eta, color, _| clear(move |at| color * by(at, 1.0 / eta, |share| share)),
            "a_ray_out_of_glass_bends_as_snell_says",
        ),
        (
            "Schlick's approximation for Fresnel",
            |eta, color, _| {
                clear(move |at| {
                    let straight = ((eta - 1.0) / (eta + 1.0)).powi(2);
                    let cosine = -at.direction.dot(at.normal());
                    color * by(at, ratio(at, eta), |_| straight + (1.0 - straight) * (1.0 - cosine).powi(5))
                })
            },
            "glass_reflects_as_fresnel_says_at_any_angle",
        ),
        (
            "no total internal reflection",
            |eta, color, _| {
                clear(move |at| {
                    let passes = border(at.direction, at.normal(), ratio(at, eta)).refracted.is_some();
                    if passes { color * by(at, ratio(at, eta), |share| share) } else { Color::BLACK }
                })
            },
            "beyond_the_critical_angle_glass_reflects_all",
        ),
        (
            "energy gained: the reflection added, and nothing taken away",
            |eta, color, _| {
                clear(move |at| {
                    let border = border(at.direction, at.normal(), ratio(at, eta));
                    let refracted = border.refracted.map_or(Color::BLACK, |direction| at.refracted(direction));
                    color * (at.reflected() * border.reflectance + refracted)
                })
            },
            "glass_seen_straight_reflects_as_fresnel_says",
        ),
        (
            "absorption outside as well",
            |eta, color, absorption| {
                clear(move |at| {
                    let left = absorption.map_or(Color::WHITE, |absorption| absorption.transmittance(at.distance));
                    color * left * by(at, ratio(at, eta), |share| share)
                })
            },
            "light_from_outside_is_not_absorbed",
        ),
        (
            "no absorption inside",
            |eta, color, _| Box::new(Glass { eta, color, absorption: None }),
            "light_through_the_inside_is_absorbed_by_its_way",
        ),
        (
            "absorption whatever the way's length",
            |eta, color, absorption| {
                clear(move |at| {
                    let absorbed = absorption.filter(|_| at.is_inside());
                    let left = absorbed.map_or(Color::WHITE, |absorption| absorption.color);
                    color * left * by(at, ratio(at, eta), |share| share)
                })
            },
            "light_through_the_inside_is_absorbed_by_its_way",
        ),
        (
            "depth off by one: a refraction is not counted",
            |eta, color, absorption| {
                let right = Glass { eta, color, absorption };
                clear(move |at| {
                    let border = border(at.direction, at.normal(), ratio(at, eta));
                    let Some(direction) = border.refracted else { return right.radiance(at) };
                    let left = absorption.filter(|_| at.is_inside());
                    let left = left.map_or(Color::WHITE, |absorption| absorption.transmittance(at.distance));
                    let refracted = at.world.trace(&at.ray_along(direction), at.bounces);
                    color * left * (at.reflected() * border.reflectance + refracted * (1.0 - border.reflectance))
                })
            },
            "each_ray_of_glass_has_one_bounce_of_its_kind_less",
        ),
        (
            "reflections and refractions counted as one",
            |eta, color, absorption| {
                let right = Glass { eta, color, absorption };
                clear(move |at| {
                    let border = border(at.direction, at.normal(), ratio(at, eta));
                    let Some(direction) = border.refracted else { return right.radiance(at) };
                    let left = absorption.filter(|_| at.is_inside());
                    let left = left.map_or(Color::WHITE, |absorption| absorption.transmittance(at.distance));
                    let refracted = follow(at, &at.ray_along(direction), at.bounces.reflected());
                    color * left * (at.reflected() * border.reflectance + refracted * (1.0 - border.reflectance))
                })
            },
            "each_ray_of_glass_has_one_bounce_of_its_kind_less",
        ),
        (
            "black where one kind of bounce has run out",
            |eta, color, absorption| {
                let right = Glass { eta, color, absorption };
                clear(move |at| {
                    let runs_out = at.bounces.reflections == 0 || at.bounces.refractions == 0;
                    if runs_out { Color::BLACK } else { right.radiance(at) }
                })
            },
            "where_one_kind_of_bounce_has_run_out_the_other_goes_on",
        ),
        (
            "a refracted ray starts on the wrong side",
            |eta, color, absorption| {
                let right = Glass { eta, color, absorption };
                clear(move |at| {
                    let border = border(at.direction, at.normal(), ratio(at, eta));
                    let Some(direction) = border.refracted else { return right.radiance(at) };
                    let left = absorption.filter(|_| at.is_inside());
                    let left = left.map_or(Color::WHITE, |absorption| absorption.transmittance(at.distance));
                    let origin = at.ray_along(-direction).origin;
                    let refracted = follow(at, &geometry::Ray::new(origin, direction), at.bounces.refracted());
                    color * left * (at.reflected() * border.reflectance + refracted * (1.0 - border.reflectance))
                })
            },
            "rays_from_glass_start_beside_the_surface",
        ),
        (
            "lit like a matt surface as well",
            |eta, color, absorption| {
                let right = Glass { eta, color, absorption };
                clear(move |at| {
                    let matt: Color = at.lit().map(|light| light.color * light.cosine).sum();
                    right.radiance(at) + matt * 0.1
                })
            },
            "glass_does_not_depend_on_lights",
        ),
        (
            "glass that shadows",
            |eta, color, absorption| {
                let right = Glass { eta, color, absorption };
                opaque(move |at| right.radiance(at))
            },
            "glass_casts_no_shadow",
        ),
    ]);
}
