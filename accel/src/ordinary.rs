use geometry::Ray;

/// No coordinate that an accelerator computes with is greater: products of three of them, and of reciprocals, do not overflow.
pub(crate) const FARTHEST: f32 = (1_u64 << 36) as f32;

/// Whether the bounds that accelerators argue with hold for a ray: nothing in it is infinite or a NaN, it is not as far away or as long
/// or short that numbers overflow or vanish. Other rays are answered by asking every primitive.
#[inline(always)]
pub(crate) fn is_ordinary(ray: &Ray) -> bool {
    let (away, long) = (ray.origin.abs(), ray.direction.abs());
    // Sums, for `max_element` may pass over a NaN; they are below nothing if anything in them is a NaN.
    let is_near = away.x + away.y + away.z < FARTHEST;
    let is_short = long.x + long.y + long.z < FARTHEST;
    is_near & is_short & (long.max_element() > 1.0 / FARTHEST)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn rays_of_scenes_are_ordinary_and_others_are_not() {
        assert!(is_ordinary(&Ray::new(Vec3::splat(-1e9), Vec3::new(0.0, 1e-9, -0.0))));
        assert!(is_ordinary(&Ray::new(Vec3::ZERO, Vec3::new(1e9, 1e-44, 0.0))));
        // A small component does not make up for a large one.
        for large in [Vec3::new(1e20, 1e-15, 0.0), Vec3::new(0.0, 1e20, 1e-15), FARTHEST * Vec3::Y] {
            assert!(!is_ordinary(&Ray::new(large, Vec3::X)), "{large}");
            assert!(!is_ordinary(&Ray::new(Vec3::X, large)), "{large}");
        }
        assert!(!is_ordinary(&Ray::new(Vec3::X, Vec3::Z / FARTHEST)));
        for odd in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e20] {
            for axis in 0..3 {
                let mut v = Vec3::ONE;
                v[axis] = odd;
                assert!(!is_ordinary(&Ray::new(v, Vec3::X)), "{odd} {axis}");
                assert!(!is_ordinary(&Ray::new(Vec3::X, v)), "{odd} {axis}");
            }
        }
        assert!(!is_ordinary(&Ray::new(Vec3::X, Vec3::splat(1e-20))));
        assert!(!is_ordinary(&Ray::new(Vec3::X, Vec3::ZERO)));
    }
}
