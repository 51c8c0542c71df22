//! Glass: reflects and refracts.

use shading::{Absorption, Color, Shader, ShadingPoint};

/// Makes the shader of the index of refraction, the colour, and what light loses on its way inside.
pub fn shader(eta: f32, color: Color, absorption: Option<Absorption>) -> Box<dyn Shader> {
    Box::new(Glass { eta, color, absorption })
}

/// A stub: black, whatever is behind it.
struct Glass {
    eta: f32,
    color: Color,
    absorption: Option<Absorption>,
}

impl Shader for Glass {
    /// The light that leaves the point towards the viewer.
    fn radiance(&self, _at: &ShadingPoint<'_>) -> Color {
        let _ = (self.eta, self.color, self.absorption);
        Color::BLACK
    }
}
