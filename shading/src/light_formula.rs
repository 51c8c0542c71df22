use geometry::{Ray, RayOrigin, Surface};
use glam::Vec3;

use crate::{
    Color, PointLight,
    shading_point::{normal, outward},
};

/// The light that arrives from one light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incident {
    /// The unit direction to the light.
    pub direction: Vec3,
    /// The cosine between it and the normal, greater than 0.
    pub cosine: f32,
    /// How much arrives.
    pub color: Color,
}

/// A point turned to its viewer: what is the same for all lights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facing {
    /// Where the light is to arrive.
    pub position: Vec3,
    /// Where shadow rays start, whichever light they go to: as a ray along `outward` does.
    pub start: Vec3,
    /// The normal to shade with, on the viewer's side.
    pub normal: Vec3,
    /// The geometric normal on the viewer's side.
    pub outward: Vec3,
}

/// What arrives at a point from a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightFormula {
    /// The report's: at the point itself, from lights in front of both normals.
    Report,
    /// Sunflow's: at the point where rays start that leave it to the viewer's side.
    Sunflow,
}

/// How a light stands to a point.
#[derive(Clone, Copy)]
pub(crate) struct Aim {
    pub(crate) distance: f32,
    /// The unit direction to the light.
    pub(crate) direction: Vec3,
    /// Between it and the normal to shade with.
    pub(crate) cosine: f32,
    /// Of both normals.
    pub(crate) is_in_front: bool,
}

impl LightFormula {
    /// A point of a surface that is seen along a direction, made ready.
    #[inline]
    pub fn facing(self, surface: &Surface, direction: Vec3, ray_origin: RayOrigin) -> Facing {
        let (normal, outward) = (normal(surface, direction), outward(surface, direction));
        let start = ray_origin(surface, outward.as_dvec3());
        let position = match self {
            Self::Report => surface.position,
            Self::Sunflow => start,
        };
        Facing { position, start, normal, outward }
    }

    /// What arrives from a light where nothing is in its way, and the segment that must be free for that, which ends at the light. `None` if the
    /// light is behind the surface, or too far to count: then no shadow ray is needed.
    #[inline]
    pub fn arriving(self, at: &Facing, light: &PointLight) -> Option<(Incident, Ray)> {
        arriving(at.start, light, self.aim(at, light.position))
    }

    #[inline(always)]
    pub(crate) fn aim(self, at: &Facing, light: Vec3) -> Aim {
        let to_light = light - at.position;
        let distance = to_light.length();
        let direction = to_light / distance;
        let cosine = direction.dot(at.normal);
        // False where the light stands just at the point, too.
        let is_in_front = match self {
            Self::Report => (cosine > 0.0) & (direction.dot(at.outward) > 0.0),
            Self::Sunflow => (to_light.dot(at.normal) > 0.0) & (to_light.dot(at.outward) > 0.0),
        };
        Aim { distance, direction, cosine, is_in_front }
    }
}

/// What arrives from a light that stands so to a point, and the segment to it from where the point's shadow rays start. See
/// [`LightFormula::arriving`].
#[inline(always)]
pub(crate) fn arriving(start: Vec3, light: &PointLight, aim: Aim) -> Option<(Incident, Ray)> {
    let Aim { distance, direction, cosine, is_in_front } = aim;
    if !is_in_front {
        return None;
    }
    let color = light.at_distance(distance);
    if color == Color::BLACK {
        return None;
    }
    Some((Incident { direction, cosine, color }, Ray::new(start, light.position - start)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linear_falloff;

    /// What arrives at the origin from a place, where the normal to shade with is not the surface's own.
    fn arriving(formula: LightFormula, position: Vec3, normal: Vec3) -> Option<(Incident, Ray)> {
        let light = PointLight { position, color: Color::WHITE, power: 100.0, falloff: linear_falloff };
        let facing = Facing { position: Vec3::ZERO, start: Vec3::ZERO, normal, outward: Vec3::Z };
        formula.arriving(&facing, &light)
    }

    #[test]
    fn a_light_must_be_in_front_of_both_normals() {
        let slanted = Vec3::new(0.8, 0.0, 0.6);
        for formula in [LightFormula::Report, LightFormula::Sunflow] {
            let (incident, segment) = arriving(formula, Vec3::new(0.0, 0.0, 50.0), slanted).unwrap();
            assert_eq!((incident.direction, incident.cosine, incident.color), (Vec3::Z, 0.6, Color::grey(0.5)));
            assert!((segment.origin + segment.direction).distance(Vec3::new(0.0, 0.0, 50.0)) < 1e-5);
            // Behind the slanted one alone, behind the surface alone, in the plane of either.
            for behind in [Vec3::new(-3.0, 0.0, 1.0), Vec3::new(3.0, 0.0, -1.0), Vec3::X, Vec3::new(-0.6, 0.0, 0.8)] {
                assert_eq!(arriving(formula, 2.0 * behind, slanted), None, "{formula:?} {behind}");
            }
        }
    }
}
