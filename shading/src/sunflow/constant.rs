use crate::{Color, Shader, ShadingPoint};

/// One colour over the whole surface, whether light reaches it or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant {
    /// The colour.
    pub color: Color,
}

impl Shader for Constant {
    /// `color`
    fn radiance(&self, _at: &ShadingPoint<'_>) -> Color {
        self.color
    }
}
