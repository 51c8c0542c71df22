use glam::Vec3;
use scene_format::scene_file::Light;
use shading::{Color, Falloff, PointLight};

use super::color::linear;

/// A light of a scene file, if it is of a kind that is rendered.
pub(super) fn point_light(light: &Light, falloff: Falloff) -> Option<PointLight> {
    let Light::Point { color, power, position } = light else { return None };
    let color = linear(color);
    let (color, power) = match power {
        Some(power) => (color, power.value),
        None => split_flux(color),
    };
    Some(PointLight { position: Vec3::from(position.value), color, power, falloff })
}

/// The old form gives colour times power in one: the power is the strongest channel's.
fn split_flux(flux: Color) -> (Color, f32) {
    let power = flux.r.max(flux.g).max(flux.b);
    if power > 0.0 { (flux / power, power) } else { (Color::BLACK, 0.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_old_form_is_split_into_colour_and_power() {
        assert_eq!(split_flux(Color::new(5.0, 10.0, 0.0)), (Color::new(0.5, 1.0, 0.0), 10.0));
        assert_eq!(split_flux(Color::BLACK), (Color::BLACK, 0.0));
    }
}
