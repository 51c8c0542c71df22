//! What moves normals as a map moves points?

use geometry::Transform;
use glam::DMat3;

/// The matrix that moves normals, up to a positive factor.
///
/// A stub: it leaves nothing of them.
pub fn normals(_map: &Transform) -> DMat3 {
    DMat3::ZERO
}
