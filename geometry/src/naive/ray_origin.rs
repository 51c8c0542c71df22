use glam::{DVec3, Vec3};

use crate::{Ray, Surface};

/// How far new rays are moved, in the scene's units: the constant of countless tutorials.
pub const OFFSET: f32 = 1e-4;

/// A new ray starts a constant way off the surface, along its normal.
///
/// Right for scenes about as large as 1. The rounding of a point grows with its coordinates: from 1000 on it is as large as the
/// offset, and rays meet the surface that they leave ("acne"). In a scene of size 1/1000 the offset jumps over what it
/// should have met: light shines through walls.
pub fn offset_along_normal(surface: &Surface, direction: DVec3) -> Vec3 {
    let normal = surface.geometric_normal;
    let outward = if direction.as_vec3().dot(normal) < 0.0 { -normal } else { normal };
    surface.position + outward * OFFSET
}

/// A new ray starts a constant way along itself: what a `t_min` of [`OFFSET`] for unit directions comes to.
///
/// As [`offset_along_normal`], but worse for flat directions, which leave the surface by only a part of the offset.
pub fn offset_along_ray(surface: &Surface, direction: DVec3) -> Vec3 {
    surface.position + direction.as_vec3().normalize_or_zero() * OFFSET
}

/// The point `o + t d` in `f32`, which most programs take for the hit point.
///
/// It is off the surface by the rounding of `t`, which grows with the distance from the ray's origin and not only with the
/// point's own coordinates: where girasol takes a point of the primitive itself ([`crate::Primitive::surface`]), this one is off by
/// as much as 250,000 times more on slivers.
pub fn hit_point(ray: &Ray, t: f32) -> Vec3 {
    ray.origin + t * ray.direction
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_offset_is_too_small_for_a_large_scene_and_nothing_is_moved() {
        let surface = Surface::rounded(Vec3::new(0.0, 0.0, 4096.0), 4096.0, Vec3::Z);
        // The next f32 after 4096 is 4096.0005.
        assert_eq!(offset_along_normal(&surface, DVec3::Z), surface.position);
        assert_eq!(offset_along_ray(&surface, DVec3::Z), surface.position);
        assert!(surface.origin_towards(DVec3::Z).z > 4096.0);
    }

    #[test]
    fn a_new_ray_starts_on_the_side_that_it_goes_to() {
        let surface = Surface::rounded(Vec3::ZERO, 1.0, Vec3::Z);
        assert_eq!(offset_along_normal(&surface, -DVec3::Z), -OFFSET * Vec3::Z);
        assert_eq!(offset_along_ray(&surface, -2.0 * DVec3::Z), -OFFSET * Vec3::Z);
    }
}
