use glam::{DVec3, Vec3};

use crate::{Ray, rounding::UNIT_ROUNDOFF};

/// Where a ray that leaves a surface in a direction starts: on the side that it goes to, as near to the surface as the point is known.
/// The direction has any length but zero; it is in `f64`, since that to a target may lie in the surface but for its last bits. The
/// reference is [`Surface::origin_towards`].
pub type RayOrigin = fn(&Surface, DVec3) -> Vec3;

/// The surface at a hit, as a shader needs it. Computed for the nearest hit alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The point, on the primitive itself and not merely on the ray, rounded once to `f32`.
    pub position: Vec3,
    /// How far each coordinate of the point may be from the exact surface: at least 0.
    pub error: Vec3,
    /// The true normal: a unit vector, to the front (out of a closed body).
    pub geometric_normal: Vec3,
    /// The normal to shade with: a unit vector; it differs from the geometric one where a mesh gives its own.
    pub shading_normal: Vec3,
}

impl Surface {
    /// A surface whose point was computed in `f64` from coordinates no greater than `magnitude`, and then rounded.
    ///
    /// The error is the half ulp of that rounding, doubled to be safe, and 2^-48 of the magnitude for the `f64` steps before.
    pub fn rounded(position: Vec3, magnitude: f32, geometric_normal: Vec3) -> Self {
        const DOUBLE_STEPS: f32 = 1.0 / (1_u64 << 48) as f32;
        let error = 2.0 * UNIT_ROUNDOFF * position.abs() + Vec3::splat(DOUBLE_STEPS * magnitude);
        Self { position, error, geometric_normal, shading_normal: geometric_normal }
    }

    /// The same surface, known to lie at some distance from the point, along the normal.
    ///
    /// Rounding moves a point along a curved surface, too, and the surface bends away under it: where it is small and far off, by
    /// more than the error's share along the normal. Doubled, since a normal turns on the way.
    pub(crate) fn off_by(self, distance: f32) -> Self {
        Self { error: self.error + 2.0 * distance * self.geometric_normal.abs(), ..self }
    }

    /// A ray that leaves the surface in a direction.
    pub fn leave(&self, direction: Vec3) -> Ray {
        Ray { origin: self.origin_towards(direction.as_dvec3()), direction }
    }

    /// A ray that leaves the surface and reaches `target` at `t = 1`.
    pub fn leave_towards(&self, target: Vec3) -> Ray {
        let origin = self.origin_towards(target.as_dvec3() - self.position.as_dvec3());
        Ray { origin, direction: target - origin }
    }

    /// The origin of a ray that leaves the surface in a direction: the one place where an origin is moved off a surface.
    ///
    /// The point is somewhere within its error box; the origin is moved along the normal until the whole box is on the side
    /// the ray goes to. (Pharr, Jakob, Humphreys: Physically Based Rendering, 4th ed. 2023, section 6.8.6. They then round each
    /// coordinate away from the surface; far from the origin of space that moves the ray sideways, out of a small sphere.)
    ///
    /// ```text
    ///           origin  o----> direction
    ///       +-----------|--+
    ///   ----|----- p ---|--|---- surface: somewhere in the box around p
    ///       +--------------+
    /// ```
    pub fn origin_towards(&self, direction: DVec3) -> Vec3 {
        let normal = self.geometric_normal;
        // Whether their dot product is below 0, but for its last sum: with it the compiler would load the direction in pieces other than those
        // in which it has just been stored, and the processor would wait.
        let along = direction * normal.as_dvec3();
        let is_inward = along.x + along.y < -along.z;
        // Half of the error, which is doubled, is that of the point; the other half covers the rounding of what is returned, but for
        // its last bits, and for a point at the origin of space, which has no error.
        let height = normal.abs().dot(self.error) * (1.0 + 8.0 * UNIT_ROUNDOFF) + f32::MIN_POSITIVE;
        self.position + normal * if is_inward { -height } else { height }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_is_a_rounding_of_the_point_and_the_steps_before_it() {
        let surface = Surface::rounded(Vec3::new(0.0, -2.0, 4.0), 1024.0, Vec3::Z);
        let steps = f32::exp2(10.0 - 48.0);
        let ulp = f32::EPSILON;
        assert_eq!(surface.error, Vec3::new(steps, 2.0 * ulp + steps, 4.0 * ulp + steps));
        // A distance along the normal counts twice.
        assert_eq!(surface.off_by(0.25).error, surface.error + 0.5 * Vec3::Z);
    }

    #[test]
    fn a_ray_starts_where_the_whole_error_is_behind_it_and_no_farther() {
        let surface = Surface { error: Vec3::ONE, ..Surface::rounded(Vec3::ZERO, 0.0, Vec3::new(0.6, 0.0, 0.8)) };
        for (direction, side) in [(DVec3::Z, 1.0), (-DVec3::Z, -1.0)] {
            let origin = surface.origin_towards(direction);
            assert!(origin.distance(side * 1.4 * surface.geometric_normal) < 2e-6, "{origin}");
            assert!(origin.length() > 1.4, "a few last bits more");
        }
        // A point known just is left all the same.
        assert!(Surface { error: Vec3::ZERO, ..surface }.origin_towards(DVec3::Z).z > 0.0);
    }
}
