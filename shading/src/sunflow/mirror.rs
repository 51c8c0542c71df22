use crate::{Color, Shader, ShadingPoint};

/// A mirror that reflects the more, the flatter it is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// The share of light that it reflects to where it came from, by channel.
    pub reflection: Color,
}

impl Mirror {
    /// What it reflects at an angle to its normal: `c + (1 - c) (1 - cos)^5`. (Schlick: An Inexpensive BRDF Model for Physically-based
    /// Rendering, 1994.)
    fn reflectance(&self, cosine: f32) -> Color {
        let off = 1.0 - cosine;
        let grazing = off * off * off * off * off;
        self.reflection.map(|channel| channel + (1.0 - channel) * grazing)
    }
}

impl Shader for Mirror {
    /// `reflectance(v.n) x trace(reflected)`
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        let cosine = (-at.direction.dot(at.normal())).clamp(0.0, 1.0);
        self.reflectance(cosine) * at.reflected()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mirror_reflects_its_colour_from_above_and_everything_along_it() {
        let mirror = Mirror { reflection: Color::new(0.5, 0.25, 0.0) };
        assert_eq!(mirror.reflectance(1.0), mirror.reflection);
        assert_eq!(mirror.reflectance(0.0), Color::WHITE);
        // (1 - 0.5)^5 = 1/32
        assert_eq!(mirror.reflectance(0.5), Color::new(0.515_625, 0.273_437_5, 0.031_25));
    }
}
