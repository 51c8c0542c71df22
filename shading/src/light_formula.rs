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
    /// Where shadow rays start: off the surface, on the viewer's side.
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
struct Aim {
    distance: f32,
    /// The unit direction to the light.
    direction: Vec3,
    /// Between it and the normal to shade with.
    cosine: f32,
    /// Of both normals.
    is_in_front: bool,
}

/// Points turned to their viewers, for [`LightFormula::arriving_lanes`]: a row of numbers for each coordinate.
#[derive(Clone, Copy, Debug)]
pub struct FacingLanes<const N: usize> {
    position: [[f32; N]; 3],
    start: [[f32; N]; 3],
    normal: [[f32; N]; 3],
    outward: [[f32; N]; 3],
}

impl<const N: usize> FacingLanes<N> {
    /// No points yet.
    pub const NONE: Self =
        Self { position: [[0.0; N]; 3], start: [[0.0; N]; 3], normal: [[0.0; N]; 3], outward: [[0.0; N]; 3] };

    /// Puts a point into a lane.
    #[inline]
    pub fn put(&mut self, lane: usize, point: &Facing) {
        let rows = [&mut self.position, &mut self.start, &mut self.normal, &mut self.outward];
        for (rows, vector) in rows.into_iter().zip([point.position, point.start, point.normal, point.outward]) {
            for axis in 0..3 {
                rows[axis][lane] = vector[axis];
            }
        }
    }

    /// The point in a lane.
    #[inline(always)]
    fn lane(&self, lane: usize) -> Facing {
        let at = |rows: &[[f32; N]; 3]| Vec3::new(rows[0][lane], rows[1][lane], rows[2][lane]);
        Facing {
            position: at(&self.position),
            start: at(&self.start),
            normal: at(&self.normal),
            outward: at(&self.outward),
        }
    }
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

    /// The same at the first so many points, each from a light of its own: `arrives` is told the lane and what arrives there.
    #[inline]
    pub fn arriving_lanes<'a, const N: usize>(
        self,
        at: &FacingLanes<N>,
        count: usize,
        light: impl Fn(usize) -> &'a PointLight,
        mut arrives: impl FnMut(usize, Incident, Ray),
    ) {
        let (mut distances, mut cosines, mut directions) = ([0.0; N], [0.0; N], [[0.0; N]; 3]);
        let mut are_in_front = [0; N];
        // A loop that the compiler makes vectors of.
        for lane in 0..N {
            let aim = self.aim(&at.lane(lane), light(lane).position);
            (distances[lane], cosines[lane]) = (aim.distance, aim.cosine);
            for axis in 0..3 {
                directions[axis][lane] = aim.direction[axis];
            }
            are_in_front[lane] = u32::from(aim.is_in_front);
        }
        for lane in 0..count {
            let aim = Aim {
                distance: distances[lane],
                direction: Vec3::new(directions[0][lane], directions[1][lane], directions[2][lane]),
                cosine: cosines[lane],
                is_in_front: are_in_front[lane] != 0,
            };
            if let Some((incident, segment)) = arriving(at.lane(lane).start, light(lane), aim) {
                arrives(lane, incident, segment);
            }
        }
    }

    #[inline(always)]
    fn aim(self, at: &Facing, light: Vec3) -> Aim {
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

#[inline(always)]
fn arriving(start: Vec3, light: &PointLight, aim: Aim) -> Option<(Incident, Ray)> {
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

    const SURFACE: Surface =
        Surface { position: Vec3::ZERO, error: Vec3::ZERO, geometric_normal: Vec3::Z, shading_normal: Vec3::Z };

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
