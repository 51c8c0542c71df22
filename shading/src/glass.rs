use crate::{Color, Shader, ShadingPoint, optics};

/// A clear body: it reflects and refracts, and casts no shadow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glass {
    /// The index of refraction inside over that outside, greater than 0.
    pub eta: f32,
    /// Multiplies the light at each passage of the surface, by channel.
    pub color: Color,
    /// What the light loses on its way inside.
    pub absorption: Option<Absorption>,
}

/// What light loses inside a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Absorption {
    /// The length after which white light has become `exp(color - 1)`; greater than 0.
    pub distance: f32,
    /// 1 in a channel loses nothing there.
    pub color: Color,
}

impl Absorption {
    /// The share that is left after a length: `exp(-t / distance (1 - color))`, right to 0.51 ulp. (Beer 1852.)
    ///
    /// A channel of 1 loses nothing, whatever the length; NaN leaves nothing.
    pub fn transmittance(&self, length: f32) -> Color {
        let distances = f64::from(length) / f64::from(self.distance);
        self.color.map(|channel| match 1.0 - f64::from(channel) {
            0.0 => 1.0,
            loss => libm::exp(-distances * loss).max(0.0) as f32,
        })
    }
}

impl Shader for Glass {
    /// `color x (kr x trace(reflected) + (1 - kr) x trace(refracted))`, `kr` by Fresnel; when the ray came through the inside,
    /// times what absorption has left.
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        let absorbed = match &self.absorption {
            Some(absorption) if at.is_inside() => absorption.transmittance(at.distance),
            _ => Color::WHITE,
        };
        let filter = self.color * absorbed;
        if filter == Color::BLACK {
            return Color::BLACK;
        }
        let eta = if at.is_inside() { self.eta } else { 1.0 / self.eta };
        let border = optics::border(at.direction, at.normal(), eta);
        let refracted = border.refracted.map_or(Color::BLACK, |direction| at.refracted(direction));
        let reflected = if border.reflectance > 0.0 { at.reflected() } else { Color::BLACK };
        filter * (reflected * border.reflectance + refracted * (1.0 - border.reflectance))
    }

    fn casts_shadow(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn absorption_takes_by_channel_and_length() {
        let absorption = Absorption { distance: 2.0, color: Color::new(1.0, 0.5, 0.0) };
        let left = absorption.transmittance(2.0);
        assert_eq!(left.r, 1.0);
        assert!((left.g - 0.606_530_66).abs() < 1e-7, "exp(-1/2)");
        assert!((left.b - 0.367_879_44).abs() < 1e-7, "exp(-1)");
    }
}
