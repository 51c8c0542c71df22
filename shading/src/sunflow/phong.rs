use std::f32::consts::PI;
use std::sync::Arc;

use glam::Vec3;

use super::shaded::Shaded;
use crate::{Color, LightFormula, Shader, ShadingPoint, Texture, matt::power};

/// A matt surface, of one colour or textured, with a highlight; black where no light reaches.
#[derive(Clone)]
pub struct Phong {
    /// The matt part: the share of light that it reflects to all sides together.
    pub diffuse: Arc<dyn Texture>,
    /// The share of light in the highlight.
    pub specular: Color,
    /// How narrow the highlight is: the higher, the narrower; 0 or greater.
    pub exponent: f32,
}

impl Shader for Phong {
    /// `1 / pi x diffuse(u, v) x sum E_l (n.l) + specular x (exponent + 2) / (2 pi) x sum E_l (n.l) max(0, r.l)^exponent`, r being v mirrored
    /// at n. Its factors keep either part from reflecting more than arrives. (Lafortune and Willems: Using the Modified Phong
    /// Reflectance Model for Physically Based Rendering, 1994.)
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        let shaded = Shaded::new(at);
        let shines = self.specular != Color::BLACK;
        let mirrored = if shines { shaded.mirrored() } else { Vec3::ZERO };
        let mut matt = Color::BLACK;
        let mut highlight = Color::BLACK;
        for light in shaded.lit() {
            let arriving = light.color * light.cosine;
            matt += arriving;
            if shines {
                highlight += arriving * power(mirrored.dot(light.direction).max(0.0), self.exponent);
            }
        }
        // No texture is looked up in the dark.
        let matt = if matt == Color::BLACK { matt } else { self.diffuse.color(at.uv) * matt };
        matt * (1.0 / PI) + self.specular * highlight * ((self.exponent + 2.0) / (2.0 * PI))
    }

    fn asks_lights(&self) -> Option<LightFormula> {
        Some(LightFormula::Sunflow)
    }
}
