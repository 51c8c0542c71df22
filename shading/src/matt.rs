use std::sync::Arc;

use glam::Vec3;

use crate::{Color, LightFormula, Shader, ShadingPoint, Texture, optics::reflect};

/// One colour over the whole surface, lit and shadowed, without a highlight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant {
    /// The colour.
    pub color: Color,
}

impl Shader for Constant {
    /// `color x sum E_l (n.l)`; without lights `color x ambient`.
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        let light = match at.ambient() {
            Some(ambient) => Color::grey(ambient),
            None => at.lit().map(|light| light.color * light.cosine).sum(),
        };
        self.color * light
    }

    fn asks_lights(&self) -> Option<LightFormula> {
        Some(LightFormula::Report)
    }
}

/// A matt surface, of one colour or textured, with a highlight.
#[derive(Clone)]
pub struct Phong {
    /// The matt part.
    pub diffuse: Arc<dyn Texture>,
    /// The colour of the highlight.
    pub specular: Color,
    /// How narrow the highlight is: the higher, the narrower; 0 or greater.
    pub exponent: f32,
}

impl Shader for Phong {
    /// `diffuse(u, v) x sum E_l (n.l) + specular x sum E_l max(0, r.v)^exponent`, r the light's direction mirrored at n; without
    /// lights `diffuse(u, v) x ambient`. (Phong: Illumination for Computer Generated Pictures, CACM 1975.)
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        if let Some(ambient) = at.ambient() {
            return self.diffuse.color(at.uv) * ambient;
        }
        let shines = self.specular != Color::BLACK;
        // r.v = (l mirrored at n).v = l.(v mirrored at n): one mirror for all lights.
        let mirrored: Vec3 = if shines { reflect(at.direction, at.normal()) } else { Vec3::ZERO };
        let mut matt = Color::BLACK;
        let mut highlight = Color::BLACK;
        at.lit().for_each(|light| {
            matt += light.color * light.cosine;
            if shines {
                highlight += light.color * power(mirrored.dot(light.direction).max(0.0), self.exponent);
            }
        });
        // No texture is looked up in the dark.
        let matt = if matt == Color::BLACK { matt } else { self.diffuse.color(at.uv) * matt };
        matt + self.specular * highlight
    }

    fn asks_lights(&self) -> Option<LightFormula> {
        Some(LightFormula::Report)
    }
}

/// `base^exponent` for a base in 0..=1 (or a rounding above) and an exponent of 0 or more. Right to 0.51 ulp.
///
/// Whole exponents, the usual ones, by squaring: in `f64`, where each of at most 32 steps doubles the error of the one before, 2^-36 of the
/// result at the end.
pub(crate) fn power(base: f32, exponent: f32) -> f32 {
    const LARGEST_BY_SQUARING: f32 = 65536.0;
    if !(0.0..=LARGEST_BY_SQUARING).contains(&exponent) || exponent != exponent.trunc() {
        return libm::pow(f64::from(base), f64::from(exponent)) as f32;
    }
    let (mut result, mut square, mut rest) = (1.0_f64, f64::from(base), exponent as u32);
    while rest > 0 {
        if rest & 1 == 1 {
            result *= square;
        }
        square *= square;
        rest >>= 1;
    }
    result as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_right_to_half_an_ulp() {
        for exponent in [0.0, 0.5, 1.0, 2.0, 7.0, 12.34, 50.0, 1000.0, 65535.0, 65536.0, 1e6] {
            for base in (0..=1000).map(|step| step as f32 / 1000.0).chain([0.999_99, 0.999_999_9, 1.0 + f32::EPSILON]) {
                // To 2^-52: f64's own function.
                let truth = libm::pow(f64::from(base), f64::from(exponent));
                let power = power(base, exponent);
                let ulp = f64::from(power.next_up()) - f64::from(power);
                assert!((f64::from(power) - truth).abs() <= 0.51 * ulp, "{base}^{exponent} = {truth}, not {power}");
            }
        }
    }

    #[test]
    fn broken_powers_work_too() {
        assert!((power(0.25, 0.5) - 0.5).abs() < 1e-7);
        assert!((power(0.5, 1.5) - 0.353_553_4).abs() < 1e-7);
    }
}
