//! One colour over the whole surface, lit and shadowed.

use shading::{Color, Shader, ShadingPoint};

/// Makes the shader of a colour.
pub fn shader(color: Color) -> Box<dyn Shader> {
    Box::new(Constant { color })
}

/// A stub: black, whatever the colour.
struct Constant {
    color: Color,
}

impl Shader for Constant {
    /// The light that leaves the point towards the viewer.
    fn radiance(&self, _at: &ShadingPoint<'_>) -> Color {
        let _ = self.color;
        Color::BLACK
    }
}
