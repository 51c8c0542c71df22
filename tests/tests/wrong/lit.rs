//! A way to ask the lights that a student writes, with one mistake at a time.

use geometry::Ray;
use glam::Vec3;
use shading::{Color, PointLight, ShadingPoint};

/// What can be wrong in it.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Mistake {
    None,
    LightColorForgotten,
    CosineForgotten,
    FalloffForgotten,
    AbsoluteCosine,
    OnlyTheFirst,
    NoShadows,
    ShadowRayWithoutEnd,
    ShadowRayBothWays,
    NormalOfTheFront,
    TrueNormal,
    ThroughTheSurface,
    ShadowRayInTheSurface,
    DividedByPi,
}

/// A light as it arrives.
pub(crate) struct Arriving {
    pub(crate) direction: Vec3,
    pub(crate) color: Color,
    pub(crate) cosine: f32,
}

/// The lights that a point sees.
pub(crate) fn lights(at: &ShadingPoint<'_>, mistake: Mistake) -> Vec<Arriving> {
    let many = if mistake == Mistake::OnlyTheFirst { 1 } else { u32::MAX };
    let lights = (0..many).map_while(|number| at.world.light(number, at.bounces.path));
    lights.filter_map(|light| arriving(at, &light, mistake)).collect()
}

fn arriving(at: &ShadingPoint<'_>, light: &PointLight, mistake: Mistake) -> Option<Arriving> {
    let to_light = light.position - at.surface.position;
    let direction = to_light.normalize();
    let geometric = at.surface.geometric_normal;
    let outward = if at.is_inside() { -geometric } else { geometric };
    let normal = match mistake {
        Mistake::NormalOfTheFront => at.surface.shading_normal,
        Mistake::TrueNormal => outward,
        _ => at.normal(),
    };
    let cosine = normal.dot(direction);
    let cosine = if mistake == Mistake::AbsoluteCosine { cosine.abs() } else { cosine };
    // On which side the true surface has the light.
    let before = match mistake {
        Mistake::ThroughTheSurface | Mistake::AbsoluteCosine => true,
        Mistake::NormalOfTheFront => geometric.dot(direction) > 0.0,
        _ => outward.dot(direction) > 0.0,
    };
    if cosine <= 0.0 || !before {
        return None;
    }
    let segment = match mistake {
        Mistake::ShadowRayWithoutEnd => at.ray_along(direction * 1e6),
        Mistake::ShadowRayBothWays => Ray::new(at.surface.position - 6.0 * to_light, 7.0 * to_light),
        Mistake::ShadowRayInTheSurface => Ray::new(at.surface.position, to_light),
        _ => at.ray_towards(light.position),
    };
    if mistake != Mistake::NoShadows && at.world.blocked(&segment) {
        return None;
    }
    let color = match mistake {
        Mistake::FalloffForgotten => light.color,
        Mistake::LightColorForgotten => Color::WHITE,
        _ => light.at_distance(to_light.length()),
    };
    Some(Arriving { direction, color, cosine: if mistake == Mistake::CosineForgotten { 1.0 } else { cosine } })
}

/// A matt surface of a colour.
pub(crate) fn matt(at: &ShadingPoint<'_>, color: Color, mistake: Mistake) -> Color {
    if let Some(ambient) = at.ambient() {
        return color * ambient;
    }
    let mut light: Color = lights(at, mistake).iter().map(|light| light.color * light.cosine).sum();
    if mistake == Mistake::DividedByPi {
        light = light / std::f32::consts::PI;
    }
    color * light
}
