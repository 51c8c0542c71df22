use crate::{Color, ShadingPoint};

/// What a surface looks like.
pub trait Shader: Send + Sync {
    /// The light that leaves the point towards the viewer: linear, not clamped.
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color;

    /// Whether the surface stops the light on its way to others. Only glass does not.
    fn casts_shadow(&self) -> bool {
        true
    }

    /// Whether [`Self::radiance`] asks for [`ShadingPoint::lit`], nearly always. A hint, without influence on the picture: lights are then
    /// asked for many points together, which is faster, and in vain where the shader does not.
    fn asks_lights(&self) -> bool {
        false
    }
}
