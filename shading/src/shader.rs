use crate::{Color, ShadingPoint};

/// What a surface looks like.
pub trait Shader: Send + Sync {
    /// The light that leaves the point towards the viewer: linear, not clamped.
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color;

    /// Whether the surface stops the light on its way to others. Only glass does not.
    fn casts_shadow(&self) -> bool {
        true
    }
}
