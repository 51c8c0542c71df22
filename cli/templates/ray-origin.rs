//! Where does a ray start that leaves a surface?

use geometry::Surface;
use glam::{DVec3, Vec3};

/// A point on the side that the direction goes to, as near to the surface as can be.
///
/// A stub: the origin of space, wherever the surface is.
pub fn origin_towards(_surface: &Surface, _direction: DVec3) -> Vec3 {
    Vec3::ZERO
}
