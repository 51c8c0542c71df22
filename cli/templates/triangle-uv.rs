//! Where on a mesh's texture does a point of a triangle lie?

use glam::Vec2;

/// The texture coordinates of those of the corners, by the weights of the second and third.
///
/// A stub: one corner of the picture everywhere.
pub fn uv(_corners: [Vec2; 3], _u: f32, _v: f32) -> Vec2 {
    Vec2::ZERO
}
