use crate::{Color, LightFormula, ShadingPoint};

/// What a surface looks like.
pub trait Shader: Send + Sync {
    /// The light that leaves the point towards the viewer: linear, not clamped.
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color;

    /// Whether the surface stops the light on its way to others. Only glass does not.
    fn casts_shadow(&self) -> bool {
        true
    }

    /// By which formula [`Self::radiance`] asks what the lights bring ([`ShadingPoint::lit_by`]), if nearly always it does; that of
    /// [`ShadingPoint::lit`] is [`LightFormula::Report`]. A hint, without influence on the picture: lights are then asked for many points
    /// together, which is faster, and in vain where the shader does not.
    fn asks_lights(&self) -> Option<LightFormula> {
        None
    }
}
