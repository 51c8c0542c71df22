use crate::{Absorption, Color, Shader, ShadingPoint, optics};

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
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        let inside = at.is_inside();
        let eta = if inside { self.eta } else { 1.0 / self.eta };
        let border = optics::border(at.direction, at.normal(), eta);
        let seen = match border.refracted {
            None => at.reflected(),
            Some(direction) => {
                let refracted = at.refracted(direction) * (1.0 - border.reflectance);
                if inside { refracted } else { refracted + at.reflected() * border.reflectance }
            }
        };
        match &self.absorption {
            Some(absorption) if inside => self.color * absorption.transmittance(at.distance) * seen,
            _ => self.color * seen,
        }
    }
}
