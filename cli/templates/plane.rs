//! Where does a ray meet a plane?

use geometry::{Intersection, Interval, Ray, Plane};

/// The intersection strictly within the interval.
///
/// A stub: it meets nothing.
pub fn intersect(_plane: &Plane, _ray: &Ray, _within: Interval) -> Option<Intersection> {
    None
}
