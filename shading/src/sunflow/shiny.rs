use std::f32::consts::PI;
use std::sync::Arc;

use super::mirror::reflectance;
use super::shaded::Shaded;
use crate::{Color, LightFormula, Shader, ShadingPoint, Texture};

/// A matt surface, of one colour or textured, under a mirror of the same colour.
#[derive(Clone)]
pub struct Shiny {
    /// The matt part: the share of light that it reflects to all sides together.
    pub diffuse: Arc<dyn Texture>,
    /// The share of the matt part's colour in the mirror's.
    pub reflection: f32,
}

impl Shader for Shiny {
    /// `1 / pi x diffuse(u, v) x sum E_l (n.l) + reflectance(v.n) x trace(reflected)`, the mirror's colour being `diffuse(u, v) x reflection`.
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        let shaded = Shaded::new(at);
        let diffuse = self.diffuse.color(at.uv);
        let arriving: Color = shaded.lit().map(|light| light.color * light.cosine).sum();
        let mirror = reflectance(diffuse * self.reflection, shaded.cosine);
        diffuse * arriving * (1.0 / PI) + mirror * shaded.reflected()
    }

    fn asks_lights(&self) -> Option<LightFormula> {
        Some(LightFormula::Sunflow)
    }
}
