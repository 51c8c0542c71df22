use geometry::Ray;

use crate::{Bounces, Color, PointLight};

/// What a shader may ask of the scene around a point.
pub trait World {
    /// The lights; none means that the ambient light alone shows something.
    fn lights(&self) -> &[PointLight];

    /// The share of a surface's colour that is seen in a scene without lights.
    fn ambient(&self) -> f32;

    /// Whether something opaque lies strictly between the segment's ends, `origin` and `origin + direction`.
    fn blocked(&self, segment: &Ray) -> bool;

    /// The light that comes back along a ray.
    fn trace(&self, ray: &Ray, bounces: Bounces) -> Color;
}
