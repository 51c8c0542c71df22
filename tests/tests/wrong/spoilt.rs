//! What wrong shaders are made of.

use geometry::Ray;
use glam::Vec3;
use shading::{Bounces, Color, Shader, ShadingPoint, optics::reflect};

struct Spoilt<F> {
    radiance: F,
    casts_shadow: bool,
}

impl<F: Fn(&ShadingPoint<'_>) -> Color + Send + Sync> Shader for Spoilt<F> {
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        (self.radiance)(at)
    }

    fn casts_shadow(&self) -> bool {
        self.casts_shadow
    }
}

/// A shader that is a function.
pub(crate) fn opaque(radiance: impl Fn(&ShadingPoint<'_>) -> Color + Send + Sync + 'static) -> Box<dyn Shader> {
    Box::new(Spoilt { radiance, casts_shadow: true })
}

/// One that casts no shadow.
pub(crate) fn clear(radiance: impl Fn(&ShadingPoint<'_>) -> Color + Send + Sync + 'static) -> Box<dyn Shader> {
    Box::new(Spoilt { radiance, casts_shadow: false })
}

/// Follows a ray, if it may still bounce.
pub(crate) fn follow(at: &ShadingPoint<'_>, ray: &Ray, bounces: Option<Bounces>) -> Color {
    bounces.map_or(Color::BLACK, |bounces| at.world.trace(ray, bounces))
}

/// The mirrored direction, by the shading normal alone.
pub(crate) fn mirrored(at: &ShadingPoint<'_>) -> Vec3 {
    reflect(at.direction, at.surface.shading_normal)
}
