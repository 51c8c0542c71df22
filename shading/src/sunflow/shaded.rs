use geometry::Ray;
use glam::Vec3;

use crate::{
    Color, Incident, LightFormula, ShadingPoint,
    shading_point::{normal, outward},
};

/// A point as Sunflow's shaders have it: turned to the viewer, and off the surface already, where the rays start.
///
/// Its normals need not be unit vectors (see [`super::LongNormal`]): the formulas take them as they are.
pub(super) struct Shaded<'a> {
    at: &'a ShadingPoint<'a>,
    /// The shading normal on the viewer's side.
    normal: Vec3,
    /// The geometric normal on the viewer's side.
    outward: Vec3,
    /// Of the angle between the viewer and the shading normal; 0 where that leans away.
    pub(super) cosine: f32,
}

impl<'a> Shaded<'a> {
    #[inline]
    pub(super) fn new(at: &'a ShadingPoint<'a>) -> Self {
        let surface = &*at.surface;
        let (normal, outward) = (normal(surface, at.direction), outward(surface, at.direction));
        Self { at, normal, outward, cosine: (-at.direction.dot(normal)).max(0.0) }
    }

    /// What shadow rays and mirrored rays start at.
    fn point(&self) -> Vec3 {
        (self.at.ray_origin)(&self.at.surface, self.outward.as_dvec3())
    }

    /// The direction in which a mirror sends the ray, `2 (v.n) n - v`: along the ray itself where the shading normal leans away from
    /// the viewer, and a unit vector only if the normal is one.
    pub(super) fn mirrored(&self) -> Vec3 {
        self.normal * (2.0 * self.cosine) + self.at.direction
    }

    /// The light that comes along the mirrored ray; black when the ray has been reflected often enough.
    pub(super) fn reflected(&self) -> Color {
        let Some(bounces) = self.at.bounces.reflected() else { return Color::BLACK };
        self.at.world.trace(&Ray::new(self.point(), self.mirrored().normalize()), bounces)
    }

    /// The light that comes from `direction` on the far side; black when the ray has been refracted often enough.
    pub(super) fn refracted(&self, direction: Vec3) -> Color {
        let Some(bounces) = self.at.bounces.refracted() else { return Color::BLACK };
        let point = (self.at.ray_origin)(&self.at.surface, -self.outward.as_dvec3());
        self.at.world.trace(&Ray::new(point, direction.normalize()), bounces)
    }

    /// The lights in front of both normals that the point sees, as they arrive there and not at the surface itself.
    pub(super) fn lit(&self) -> impl Iterator<Item = Incident> {
        self.at.lit_by(LightFormula::Sunflow)
    }

    /// The ray's unit direction, and the shading normal on the viewer's side.
    pub(super) fn direction_and_normal(&self) -> (Vec3, Vec3) {
        (self.at.direction, self.normal)
    }
}
