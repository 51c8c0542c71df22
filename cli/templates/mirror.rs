//! A mirror.

use shading::{Color, Shader, ShadingPoint};

/// Makes the shader of the share of light that is reflected.
pub fn shader(reflection: Color) -> Box<dyn Shader> {
    Box::new(Mirror { reflection })
}

/// A stub: black, whatever stands before it.
struct Mirror {
    reflection: Color,
}

impl Shader for Mirror {
    /// The light that leaves the point towards the viewer.
    fn radiance(&self, _at: &ShadingPoint<'_>) -> Color {
        let _ = self.reflection;
        Color::BLACK
    }
}
