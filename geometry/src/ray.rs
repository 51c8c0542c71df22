use glam::{DVec3, Vec3};

/// A half-line: the points `origin + t * direction` for `t > 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes: of any length but zero. The length is the unit of `t`.
    pub direction: Vec3,
}

impl Ray {
    /// A ray from a point along a direction.
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction }
    }

    /// The point at `t`, computed in `f64`.
    ///
    /// Good enough to look at. A surface computes its own point instead (see [`crate::Surface`]): far along a ray the
    /// rounding of `t` alone moves this one off the surface.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin.as_dvec3() + self.direction.as_dvec3() * t
    }
}
