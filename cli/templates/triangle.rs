//! Where does a ray meet a triangle?

use geometry::{Intersection, Interval, Ray, Triangle};

/// The intersection strictly within the interval, from either side, with the weights of the second and third corner.
///
/// A stub: it meets nothing.
pub fn intersect(_triangle: &Triangle, _ray: &Ray, _within: Interval) -> Option<Intersection> {
    None
}
