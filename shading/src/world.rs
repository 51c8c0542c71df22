use geometry::Ray;

use crate::{Bounces, Color, PointLight};

/// What a shader may ask of the scene around a point.
pub trait World {
    /// The lights to ask at a point, one by one from number 0, to which a ray came by a path ([`Bounces::path`]); `None` after the last.
    /// Not even a first one means that the ambient light alone shows something.
    fn light(&self, number: u32, path: u32) -> Option<PointLight>;

    /// The share of a surface's colour that is seen in a scene without lights.
    fn ambient(&self) -> f32;

    /// Whether something opaque lies strictly between the segment's ends, `origin` and `origin + direction`.
    fn blocked(&self, segment: &Ray) -> bool;

    /// The light that comes back along a ray.
    fn trace(&self, ray: &Ray, bounces: Bounces) -> Color;
}
