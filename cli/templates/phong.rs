//! A matt surface with a highlight.

use std::sync::Arc;

use shading::{Color, Shader, ShadingPoint, Texture};

/// Makes the shader of a matt part, the colour of the highlight, and its exponent.
pub fn shader(diffuse: Arc<dyn Texture>, specular: Color, exponent: f32) -> Box<dyn Shader> {
    Box::new(Phong { diffuse, specular, exponent })
}

/// A stub: black, whatever it is made of.
struct Phong {
    diffuse: Arc<dyn Texture>,
    specular: Color,
    exponent: f32,
}

impl Shader for Phong {
    /// The light that leaves the point towards the viewer.
    fn radiance(&self, _at: &ShadingPoint<'_>) -> Color {
        let _ = (&self.diffuse, self.specular, self.exponent);
        Color::BLACK
    }
}
