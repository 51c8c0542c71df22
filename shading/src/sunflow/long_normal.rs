use std::cell::OnceCell;

use geometry::Surface;

use crate::{Color, LazySurface, Shader, ShadingPoint};

/// A shader for a surface whose normals have another length than 1: Sunflow takes a plane's normal as it is written and as transforms
/// leave it, so that one twice as long is lit twice as brightly, and a mirror turns rays too far.
pub struct LongNormal {
    /// What shades the surface.
    pub shader: Box<dyn Shader>,
    /// The length of its normals, greater than 0.
    pub length: f32,
}

impl Shader for LongNormal {
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        let known = OnceCell::new();
        let compute = || {
            let Surface { geometric_normal, shading_normal, .. } = *at.surface;
            Surface {
                geometric_normal: geometric_normal * self.length,
                shading_normal: shading_normal * self.length,
                ..*at.surface
            }
        };
        let surface = LazySurface::Asked { known: &known, compute: &compute };
        self.shader.radiance(&ShadingPoint { surface, ..*at })
    }

    fn casts_shadow(&self) -> bool {
        self.shader.casts_shadow()
    }
}
