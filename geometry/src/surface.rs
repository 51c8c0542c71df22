use glam::Vec3;

use crate::{Ray, rounding::UNIT_ROUNDOFF};

/// Where a ray that leaves a surface in a direction starts: on the side that it goes to, as near to the surface as the point is known.
/// The direction has any length but zero. The reference is [`Surface::origin_towards`].
pub type RayOrigin = fn(&Surface, Vec3) -> Vec3;

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

    /// A ray that leaves the surface in a direction.
    pub fn leave(&self, direction: Vec3) -> Ray {
        Ray { origin: self.origin_towards(direction), direction }
    }

    /// A ray that leaves the surface and reaches `target` at `t = 1`.
    pub fn leave_towards(&self, target: Vec3) -> Ray {
        let origin = self.origin_towards(target - self.position);
        Ray { origin, direction: target - origin }
    }

    /// The origin of a ray that leaves the surface in a direction: the one place where an origin is moved off a surface.
    ///
    /// The point is somewhere within its error box; the origin is moved along the normal until the whole box is on the side
    /// the ray goes to, and each coordinate is then rounded away from the surface. (Pharr, Jakob, Humphreys: Physically
    /// Based Rendering, 4th ed. 2023, section 6.8.6.)
    ///
    /// ```text
    ///           origin  o----> direction
    ///       +-----------|--+
    ///   ----|----- p ---|--|---- surface: somewhere in the box around p
    ///       +--------------+
    /// ```
    pub fn origin_towards(&self, direction: Vec3) -> Vec3 {
        let normal = self.geometric_normal;
        let outward = if direction.dot(normal) < 0.0 { -normal } else { normal };
        let offset = outward * normal.abs().dot(self.error);
        let away = |moved: f32, offset: f32| {
            if offset > 0.0 {
                moved.next_up()
            } else if offset < 0.0 {
                moved.next_down()
            } else {
                moved
            }
        };
        let moved = self.position + offset;
        Vec3::new(away(moved.x, offset.x), away(moved.y, offset.y), away(moved.z, offset.z))
    }
}
