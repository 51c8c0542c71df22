use super::shaded::Shaded;
use crate::{Absorption, Color, Shader, ShadingPoint};

/// A clear body that casts a full shadow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glass {
    /// The index of refraction inside over that outside, greater than 0.
    pub eta: f32,
    /// Multiplies the light at each passage of the surface, by channel.
    pub color: Color,
    /// What the light loses on its way inside.
    pub absorption: Option<Absorption>,
}

impl Shader for Glass {
    /// From outside `color x (kr x trace(reflected) + kt x trace(refracted))`, from inside `color x kt x trace(refracted)`: there the
    /// reflection is dropped, unless it is total. `kr` by Fresnel, `kt = 1 - kr`; a way inside loses what absorption takes.
    ///
    /// The formulas are those of [`crate::optics::border`], but that they take the cosine as 0 where the shading normal leans away from the
    /// viewer, and the normal's length as it is.
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        let shaded = Shaded::new(at);
        let inside = at.is_inside();
        let absorbed = match &self.absorption {
            Some(absorption) if inside => absorption.transmittance(at.distance),
            _ => Color::WHITE,
        };
        if absorbed == Color::BLACK {
            return Color::BLACK;
        }
        let (direction, normal) = shaded.direction_and_normal();
        let (direction, normal) = (direction.as_dvec3(), normal.as_dvec3());
        let (eta, cosine) = (f64::from(self.eta), f64::from(shaded.cosine));
        let ratio = if inside { eta } else { 1.0 / eta };
        let cos_out_squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
        if cos_out_squared < 0.0 {
            return self.color * absorbed * shaded.reflected();
        }
        let refracted = direction * ratio + normal * (ratio * cosine - cos_out_squared.sqrt());
        let (cos_in, cos_out) = (normal.dot(shaded.mirrored().as_dvec3()), -normal.dot(refracted));
        let parallel = (cos_in - eta * cos_out) / (cos_in + eta * cos_out);
        let perpendicular = (eta * cos_in - cos_out) / (eta * cos_in + cos_out);
        let reflectance = (0.5 * (parallel * parallel + perpendicular * perpendicular)) as f32;
        let mut seen = shaded.refracted(refracted.as_vec3()) * (1.0 - reflectance);
        if !inside {
            seen += shaded.reflected() * reflectance;
        }
        self.color * absorbed * seen
    }
}
