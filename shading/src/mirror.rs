use crate::{Color, Shader, ShadingPoint};

/// A mirror.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// The share of light that it reflects, by channel.
    pub reflection: Color,
}

impl Shader for Mirror {
    /// `reflection x trace(reflected)`
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        // A black mirror needs no ray.
        if self.reflection == Color::BLACK { Color::BLACK } else { self.reflection * at.reflected() }
    }
}
