use geometry::Ray;

use crate::{Bounces, Color, Incident, LightFormula, PointLight, ShadingPoint};

/// What a shader may ask of the scene around a point.
pub trait World {
    /// The lights to ask at a point, one by one from number 0, to which a ray came by a path ([`Bounces::path`]); `None` after the last.
    fn light(&self, number: u32, path: u32) -> Option<PointLight>;

    /// The share of a surface's colour that is seen in a scene without lights; `None` in one with lights.
    fn ambient(&self) -> Option<f32>;

    /// Whether something opaque lies strictly between the segment's ends, `origin` and `origin + direction`.
    fn blocked(&self, segment: &Ray) -> bool;

    /// The light that comes back along a ray.
    fn trace(&self, ray: &Ray, bounces: Bounces) -> Color;

    /// What [`ShadingPoint::lit_by`] finds at a point, where that is known: whoever renders may have asked for many points together. For this very
    /// point and formula, not for a point whose surface, say, a shader has changed. A world that knows nothing beforehand says nothing.
    fn lit(&self, _at: &ShadingPoint<'_>, _formula: LightFormula) -> Option<&[Incident]> {
        None
    }
}
