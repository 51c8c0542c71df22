use crate::{Color, Shader, ShadingPoint};

use super::shaded::Shaded;

/// A mirror that reflects the more, the flatter it is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// The share of light that it reflects to where it came from, by channel.
    pub reflection: Color,
}

impl Shader for Mirror {
    /// `reflectance(v.n) x trace(reflected)`
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        let shaded = Shaded::new(at);
        reflectance(self.reflection, shaded.cosine) * shaded.reflected()
    }
}

/// What a mirror of a colour c reflects at an angle to its normal: `c + (1 - c) (1 - cos)^5`. (Schlick: An Inexpensive BRDF Model for
/// Physically-based Rendering, 1994.)
pub(super) fn reflectance(color: Color, cosine: f32) -> Color {
    let off = 1.0 - cosine;
    let grazing = off * off * off * off * off;
    color.map(|channel| channel + (1.0 - channel) * grazing)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mirror_reflects_its_colour_from_above_and_everything_along_it() {
        let color = Color::new(0.5, 0.25, 0.0);
        assert_eq!(reflectance(color, 1.0), color);
        assert_eq!(reflectance(color, 0.0), Color::WHITE);
        // (1 - 0.5)^5 = 1/32
        assert_eq!(reflectance(color, 0.5), Color::new(0.515_625, 0.273_437_5, 0.031_25));
    }
}
