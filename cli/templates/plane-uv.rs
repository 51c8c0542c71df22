//! Where on a plane's texture does a point lie?

use geometry::Plane;
use glam::{DVec3, Vec2};

/// The texture coordinates of a place: its offset from the plane's own point, however far.
///
/// A stub: one corner of the picture everywhere.
pub fn uv(_plane: &Plane, _offset: DVec3) -> Vec2 {
    Vec2::ZERO
}
