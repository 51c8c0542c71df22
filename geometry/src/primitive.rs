use glam::Vec2;

use crate::{Aabb, Intersection, Interval, Ray, Surface};

/// A shape that a ray can meet.
pub trait Primitive {
    /// A box around it; never too small. Infinite shapes have an infinite box.
    fn bounds(&self) -> Aabb;

    /// The nearest intersection strictly within the interval, whichever side it is met from.
    ///
    /// `t` is the exact one rounded to `f32`, to within 0.51 ulp, wherever half an ulp of the inputs could not make a miss of it;
    /// elsewhere as exact as `f64` sees; and so is whether it is met at all. (The kits in `conformance` hold every primitive to it.)
    fn intersect(&self, ray: &Ray, within: Interval) -> Option<Intersection>;

    /// The surface at an intersection that [`Self::intersect`] has found for the same ray.
    fn surface(&self, ray: &Ray, at: &Intersection) -> Surface;

    /// The texture coordinates there. Called only where a texture wants them.
    fn uv(&self, ray: &Ray, at: &Intersection) -> Vec2;
}
