//! The tree: which primitive does a ray meet first?

use accel::Accelerator;
use geometry::{Hit, Interval, Primitives, Ray};

/// Builds the tree of some primitives.
pub fn build(primitives: Primitives) -> Box<dyn Accelerator> {
    Box::new(Octree { primitives })
}

/// A stub: it has all primitives, and asks none.
struct Octree {
    primitives: Primitives,
}

impl Accelerator for Octree {
    /// The nearest hit strictly within the interval; of hits at one distance the lowest primitive's.
    fn closest(&self, _ray: &Ray, _within: Interval) -> Option<Hit> {
        let _ = &self.primitives;
        None
    }

    /// Whether there is any hit strictly within the interval.
    fn any(&self, ray: &Ray, within: Interval) -> bool {
        self.closest(ray, within).is_some()
    }
}
