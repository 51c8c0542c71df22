//! Where does a ray meet a sphere?

use geometry::{Intersection, Interval, Ray, Sphere};

/// The first intersection strictly within the interval, from outside or inside.
///
/// A stub: it meets nothing.
pub fn intersect(_sphere: &Sphere, _ray: &Ray, _within: Interval) -> Option<Intersection> {
    None
}
