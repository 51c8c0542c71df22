//! Whoever finds triangles, one ray at a time.

use accel::Accelerator;
use geometry::{Interval, Ray};

pub trait Tracer {
    /// The nearest triangle and its `t`.
    fn closest(&self, ray: &Ray) -> Option<(u32, f32)>;

    /// Whether there is any triangle within the interval.
    fn any(&self, ray: &Ray, within: Interval) -> bool;
}

impl Tracer for &dyn Accelerator {
    fn closest(&self, ray: &Ray) -> Option<(u32, f32)> {
        Accelerator::closest(*self, ray, Interval::FORWARD).map(|hit| (hit.primitive, hit.t))
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        Accelerator::any(*self, ray, within)
    }
}
