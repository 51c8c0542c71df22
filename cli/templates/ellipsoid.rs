//! Where does a ray meet an ellipsoid?

use geometry::{Intersection, Interval, Ray, Ellipsoid};

/// The first intersection strictly within the interval, from outside or inside.
///
/// A stub: it meets nothing.
pub fn intersect(_ellipsoid: &Ellipsoid, _ray: &Ray, _within: Interval) -> Option<Intersection> {
    None
}
