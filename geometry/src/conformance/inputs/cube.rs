use super::super::exact::SINGLE;
use crate::{Hit, Interval, Mesh, Primitives, Ray, Surface, Transform, unit_cube};

/// The twelve triangles of a cube somewhere.
pub(crate) struct Cube {
    triangles: Primitives,
    place: Transform,
}

impl Cube {
    pub(crate) fn new(place: &Transform) -> Self {
        let Mesh { positions, triangles, .. } = unit_cube();
        let positions = positions.into_iter().map(|position| place.point_f32(position)).collect();
        let mut primitives = Primitives::default();
        primitives.add_mesh(Mesh { positions, triangles, ..Mesh::default() });
        Self { triangles: primitives, place: *place }
    }

    pub(crate) fn nearest(&self, ray: &Ray) -> Option<(Hit, Surface)> {
        let hits = (0..12).filter_map(|number| self.triangles.intersect(number, ray, Interval::FORWARD));
        let hit = hits.reduce(|nearest, hit| if hit.is_before(nearest) { hit } else { nearest })?;
        Some((hit, self.triangles.surface(ray, &hit)))
    }

    pub(crate) fn blocks(&self, segment: &Ray) -> bool {
        (0..12).any(|number| self.triangles.intersect(number, segment, Interval::SEGMENT).is_some())
    }

    /// Corners are rounded, so that the two triangles of a turned face are not quite in one plane: how steep one may rise from
    /// the other. An ulp or two of a corner's coordinates, over the side.
    pub(crate) fn flatness(&self) -> f64 {
        let side = self.place.linear.x_axis.length();
        16.0 * SINGLE * (self.place.translation.length() + side) / side
    }

    /// How far a point of one face is from the planes of the four around it.
    pub(crate) fn distance_from_other_faces(&self, surface: &Surface, hit: Hit) -> f64 {
        let local = self.place.inverse().expect("of full rank").point(surface.position.as_dvec3());
        // Faces come in pairs along x, y, z; two triangles each.
        let own_axis = hit.primitive as usize / 4;
        let margin = |axis: usize| (0.5 - local[axis].abs()) * self.place.linear.x_axis.length();
        (0..3).filter(|&axis| axis != own_axis).map(margin).fold(f64::INFINITY, f64::min)
    }
}
