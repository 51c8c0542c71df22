use std::f32::consts::PI;

use glam::{DVec3, Vec2};

/// A sphere's texture coordinates as usually written: `v` from `acos`, all in `f32`.
///
/// `acos(z)` near the poles, where `z` is near 1, knows the angle only to `sqrt(2 u)`, 0.00035: 0.3 of a texel of a texture 4096 high. And
/// `u` just before the seam rounds up to 1, beyond the picture's last column.
pub fn sphere_uv(direction: DVec3) -> Vec2 {
    let direction = direction.as_vec3();
    let around = libm::atan2f(direction.y, direction.x) / (2.0 * PI);
    let u = if around < 0.0 { around + 1.0 } else { around };
    Vec2::new(u, libm::acosf(direction.z.clamp(-1.0, 1.0)) / PI)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_seam_rounds_up_to_1_and_the_pole_swallows_what_is_near_it() {
        assert_eq!(sphere_uv(DVec3::Y).x, 0.25);
        assert_eq!(sphere_uv(DVec3::new(1.0, -1e-9, 0.0)).x, 1.0);
        assert_eq!(sphere_uv(DVec3::new(1e-4, 0.0, 1.0).normalize()).y, 0.0);
    }
}
