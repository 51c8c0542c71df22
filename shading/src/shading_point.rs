use geometry::{Ray, RayOrigin, Surface};
use glam::{Vec2, Vec3};

use crate::{Bounces, Color, Facing, Incident, LazySurface, LightFormula, World, optics};

/// A point that is to be coloured, and what can be asked there.
pub struct ShadingPoint<'a> {
    /// The scene around it.
    pub world: &'a dyn World,
    /// The unit direction in which the ray came.
    pub direction: Vec3,
    /// How far it came, in the scene's units.
    pub distance: f32,
    /// The surface as it is, whichever side is seen: computed when it is looked at.
    pub surface: LazySurface<'a>,
    /// Where rays that leave it start.
    pub ray_origin: RayOrigin,
    /// The texture coordinates: computed when asked for.
    pub uv: &'a dyn Fn() -> Vec2,
    /// How often the ray may still bounce.
    pub bounces: Bounces,
}

impl ShadingPoint<'_> {
    /// Whether the ray came from inside the body: it meets the back of the surface.
    #[inline]
    pub fn is_inside(&self) -> bool {
        is_inside(&self.surface, self.direction)
    }

    /// The unit shading normal on the viewer's side.
    ///
    /// Where a mesh's own normal leans away from its triangle's, that is on the triangle's viewer's side.
    #[inline]
    pub fn normal(&self) -> Vec3 {
        normal(&self.surface, self.direction)
    }

    /// The geometric normal on the viewer's side.
    #[inline]
    pub fn outward(&self) -> Vec3 {
        outward(&self.surface, self.direction)
    }

    /// The lights that the point sees, with what arrives from each. Lights behind the surface are not seen, nor lights
    /// behind something opaque.
    pub fn lit(&self) -> impl Iterator<Item = Incident> {
        self.lit_by(LightFormula::Report)
    }

    /// As [`Self::lit`], by another formula.
    #[inline]
    pub fn lit_by(&self, formula: LightFormula) -> impl Iterator<Item = Incident> {
        let mut known = self.world.lit(self, formula).map(<[Incident]>::iter);
        let facing = known.is_none().then(|| self.facing(formula));
        let mut number = 0;
        std::iter::from_fn(move || match (&mut known, &facing) {
            (Some(known), _) => known.next().copied(),
            (None, facing) => {
                // Taken apart, for else what is known is written to memory as well, and read from there again.
                let Incident { direction, cosine, color } = self.next_lit(formula, facing.as_ref()?, &mut number)?;
                Some(Incident { direction, cosine, color })
            }
        })
    }

    fn facing(&self, formula: LightFormula) -> Facing {
        formula.facing(&self.surface, self.direction, self.ray_origin)
    }

    /// What arrives from the next light that the point sees, from a number on.
    fn next_lit(&self, formula: LightFormula, facing: &Facing, number: &mut u32) -> Option<Incident> {
        loop {
            let light = self.world.light(*number, self.bounces.path)?;
            *number += 1;
            if let Some((incident, segment)) = formula.arriving(facing, &light)
                && !self.world.blocked(&segment)
            {
                return Some(incident);
            }
        }
    }

    /// The share of the surface's own colour that shows in a scene without lights; `None` where there are some.
    pub fn ambient(&self) -> Option<f32> {
        self.world.ambient()
    }

    /// The light that a mirror here shows; black when the ray has been reflected often enough.
    pub fn reflected(&self) -> Color {
        let Some(bounces) = self.bounces.reflected() else { return Color::BLACK };
        self.world.trace(&self.mirrored_ray(), bounces)
    }

    /// The light that comes from `direction` on the far side; black when the ray has been refracted often enough.
    pub fn refracted(&self, direction: Vec3) -> Color {
        let Some(bounces) = self.bounces.refracted() else { return Color::BLACK };
        self.world.trace(&self.ray_along(direction), bounces)
    }

    /// A ray that leaves the surface in a direction.
    #[inline]
    pub fn ray_along(&self, direction: Vec3) -> Ray {
        Ray::new((self.ray_origin)(&self.surface, direction.as_dvec3()), direction)
    }

    /// A ray that leaves the surface and reaches `target` at `t = 1`.
    #[inline]
    pub fn ray_towards(&self, target: Vec3) -> Ray {
        let origin = (self.ray_origin)(&self.surface, target.as_dvec3() - self.surface.position.as_dvec3());
        Ray::new(origin, target - origin)
    }

    /// The mirrored ray, on the viewer's side: where the shading normal would send it through the surface, the geometric one
    /// decides.
    fn mirrored_ray(&self) -> Ray {
        let geometric = self.surface.geometric_normal;
        let mirrored = optics::reflect(self.direction, self.surface.shading_normal);
        let stays = mirrored.dot(geometric) * self.direction.dot(geometric) < 0.0;
        self.ray_along(if stays { mirrored } else { optics::reflect(self.direction, geometric) })
    }
}

/// See [`ShadingPoint::is_inside`].
#[inline]
fn is_inside(surface: &Surface, direction: Vec3) -> bool {
    direction.dot(surface.geometric_normal) > 0.0
}

/// See [`ShadingPoint::normal`].
#[inline]
pub(crate) fn normal(surface: &Surface, direction: Vec3) -> Vec3 {
    let &Surface { geometric_normal, shading_normal, .. } = surface;
    let seen_from_front = !is_inside(surface, direction);
    let on_the_front = shading_normal.dot(geometric_normal) >= 0.0;
    shading_normal * if seen_from_front == on_the_front { 1.0 } else { -1.0 }
}

/// See [`ShadingPoint::outward`].
#[inline]
pub(crate) fn outward(surface: &Surface, direction: Vec3) -> Vec3 {
    surface.geometric_normal * if is_inside(surface, direction) { -1.0 } else { 1.0 }
}
