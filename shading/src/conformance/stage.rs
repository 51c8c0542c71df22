use std::cell::RefCell;

use geometry::conformance::{Counterexample, Figure, Ink, Verdict};
use geometry::{Interval, Primitive, Ray, Sphere, Surface};
use glam::{DVec3, Vec2, Vec3};

use crate::{Bounces, Color, LazySurface, PointLight, Shader, ShadingPoint, World};

/// A point to be shaded and the little world around it: a case of a shader's laws.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// The unit direction in which the ray came.
    pub direction: Vec3,
    /// How far it came.
    pub distance: f32,
    /// The surface that it met.
    pub surface: Surface,
    /// The texture coordinates there.
    pub uv: Vec2,
    /// How often the ray may still bounce.
    pub bounces: Bounces,
    /// The lights.
    pub lamps: [Option<Lamp>; 2],
    /// Something opaque.
    pub blocker: Option<Sphere>,
    /// The share of a surface's colour that shows where there is no light.
    pub ambient: f32,
}

/// A light of a stage. Its light falls off by [`Lamp::arriving`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// Where it stands.
    pub position: Vec3,
    /// Its colour.
    pub color: Color,
    /// Its power, greater than 0.
    pub power: f32,
}

impl Lamp {
    /// What arrives at a distance: a falloff that no renderer has, `P / (P + d)`, so that a shader must ask the light for its own.
    pub fn arriving(&self, distance: f32) -> Color {
        self.light().at_distance(distance)
    }

    fn light(&self) -> PointLight {
        let Self { position, color, power } = *self;
        PointLight { position, color, power, falloff: |distance, power| power / (power + distance) }
    }
}

/// What a shader made of a stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// The light that it returned.
    pub color: Color,
    /// The rays that it followed, and how often each might still bounce.
    pub rays: Vec<(Ray, Bounces)>,
    /// The segments that it asked about.
    pub segments: Vec<Ray>,
}

/// What a ray in a direction comes back with: another colour for each direction, and no channel of them black.
pub fn sky(direction: Vec3) -> Color {
    let Vec3 { x, y, z } = direction;
    Color::new(0.6 + 0.3 * x, 0.6 + 0.3 * y, 0.6 + 0.3 * z)
}

struct Asked<'a> {
    stage: &'a Stage,
    sky: fn(Vec3) -> Color,
    rays: RefCell<Vec<(Ray, Bounces)>>,
    segments: RefCell<Vec<Ray>>,
}

impl World for Asked<'_> {
    fn light(&self, number: u32, _path: u32) -> Option<PointLight> {
        self.stage.lamps.iter().flatten().nth(number as usize).map(Lamp::light)
    }

    fn ambient(&self) -> Option<f32> {
        self.stage.lamps.iter().all(Option::is_none).then_some(self.stage.ambient)
    }

    fn blocked(&self, segment: &Ray) -> bool {
        self.segments.borrow_mut().push(*segment);
        self.stage.blocker.is_some_and(|blocker| blocker.intersect(segment, Interval::SEGMENT).is_some())
    }

    fn trace(&self, ray: &Ray, bounces: Bounces) -> Color {
        self.rays.borrow_mut().push((*ray, bounces));
        (self.sky)(ray.direction)
    }
}

impl Stage {
    /// What a shader makes of it, where every ray that it follows sees [`sky`].
    pub fn shown(&self, shader: &dyn Shader) -> Shown {
        self.shown_under(sky, shader)
    }

    /// What a shader makes of it under another sky.
    pub fn shown_under(&self, sky: fn(Vec3) -> Color, shader: &dyn Shader) -> Shown {
        let world = Asked { stage: self, sky, rays: RefCell::default(), segments: RefCell::default() };
        let color = shader.radiance(&ShadingPoint {
            world: &world,
            direction: self.direction,
            distance: self.distance,
            surface: LazySurface::Known(&self.surface),
            ray_origin: Surface::origin_towards,
            uv: &|| self.uv,
            bounces: self.bounces,
        });
        Shown { color, rays: world.rays.into_inner(), segments: world.segments.into_inner() }
    }

    /// The surface's true normal on the viewer's side.
    pub fn outward(&self) -> DVec3 {
        towards_viewer(self.surface.geometric_normal, self.direction)
    }

    /// The normal to shade with, on the viewer's side: no stage's leans away from the viewer.
    pub fn normal(&self) -> DVec3 {
        towards_viewer(self.surface.shading_normal, self.direction)
    }

    /// The direction in which a mirror sends the ray on: `d - 2 (d.n) n`.
    pub fn mirrored(&self) -> DVec3 {
        let (d, n) = (self.direction.as_dvec3().normalize(), self.normal());
        d - 2.0 * d.dot(n) * n
    }

    /// From the point to its first light; straight up if it has none.
    pub fn to_lamp(&self) -> DVec3 {
        let lamp = self.lamps.iter().flatten().next();
        lamp.map_or(self.outward(), |lamp| lamp.position.as_dvec3() - self.surface.position.as_dvec3())
    }

    /// What each light brings where nothing is in its way: the unit direction to it, the cosine to the normal, and the light; none of
    /// those behind the surface or behind its normal.
    pub(super) fn arriving(&self) -> impl Iterator<Item = (DVec3, f64, [f64; 3])> {
        self.lamps.iter().flatten().filter_map(|lamp| {
            let to_light = lamp.position.as_dvec3() - self.surface.position.as_dvec3();
            let (distance, direction) = (to_light.length(), to_light.normalize());
            let cosine = direction.dot(self.normal());
            let power = f64::from(lamp.power);
            let arrives = times(lamp.color, [power / (power + distance); 3]);
            (cosine > 0.0 && direction.dot(self.outward()) > 0.0).then_some((direction, cosine, arrives))
        })
    }

    /// What all lights bring to a matt surface: the sum of light times cosine.
    pub(super) fn matt_light(&self) -> [f64; 3] {
        let lights = self.arriving().map(|(_, cosine, light)| light.map(|channel| channel * cosine));
        lights.fold([0.0; 3], |sum, light| [0, 1, 2].map(|channel| sum[channel] + light[channel]))
    }

    /// A drawing: the ray, the surface with its normal, what stands around, and the rays that the shader followed.
    pub fn figure(&self, shown: &Shown) -> Figure {
        let at = self.surface.position.as_dvec3();
        let ray = Ray::new(self.surface.position - self.direction * self.distance, self.direction);
        let (normal, length) = (self.normal(), f64::from(self.distance));
        let along = self.direction.as_dvec3().reject_from(self.outward());
        let along = along.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector()) * length;
        let mut figure = Figure::through(&ray, at + normal)
            .line(at - along, at + along, Ink::Shape)
            .line(at, at + normal * 0.5 * length, Ink::Shape)
            .point(at, Ink::Shape, "the point");
        if let Some(Sphere { center, radius }) = self.blocker {
            figure = figure.sphere(center.as_dvec3(), radius.into());
        }
        for lamp in self.lamps.iter().flatten() {
            figure = figure.point(lamp.position.as_dvec3(), Ink::Shape, "light");
        }
        for (ray, _) in &shown.rays {
            figure = figure.line(at, at + ray.direction.as_dvec3() * length, Ink::Found);
        }
        for segment in &shown.segments {
            figure = figure.line(segment.origin.as_dvec3(), segment.at(1.0), Ink::Found);
        }
        figure
    }

    /// The verdict where an amount of light was expected, to 1e-5: room for a few roundings in single precision.
    pub(super) fn shows(&self, shown: &Shown, expected: [f64; 3]) -> Verdict {
        self.shows_to(shown, expected, 1e-5)
    }

    /// The verdict where an amount of light was expected, to a share of the brightest channel, or of 1.
    pub(super) fn shows_to(&self, shown: &Shown, expected: [f64; 3], exact: f64) -> Verdict {
        let size = expected.iter().fold(1.0_f64, |size, channel| size.max(channel.abs()));
        let near = |(found, expected): (f32, f64)| (f64::from(found) - expected).abs() <= exact * size;
        if shown.color.to_array().into_iter().zip(expected).all(near) {
            return Ok(());
        }
        let expected = Color::from(expected.map(|channel| channel as f32));
        Err(Counterexample::new(format!("{expected:?}"), format!("{:?}", shown.color)).drawn(self.figure(shown)))
    }

    /// The verdict where something else was expected of what the shader did.
    pub(super) fn unlike(&self, shown: &Shown, expected: impl Into<String>, found: impl Into<String>) -> Verdict {
        Err(Counterexample::new(expected, found).drawn(self.figure(shown)))
    }

    /// The verdict on where a ray starts that leaves the surface: off it, on the side that it goes to.
    pub(super) fn leaves(&self, shown: &Shown, ray: &Ray) -> Verdict {
        let away = (ray.origin.as_dvec3() - self.surface.position.as_dvec3()).dot(self.outward());
        let goes = ray.direction.as_dvec3().dot(self.outward());
        if away * goes > 0.0 {
            return Ok(());
        }
        let expected = format!("a ray that starts beside {:?}, on the side that it goes to", self.surface.position);
        self.unlike(shown, expected, format!("{ray:?}"))
    }
}

fn towards_viewer(normal: Vec3, direction: Vec3) -> DVec3 {
    let normal = normal.as_dvec3().normalize();
    if direction.as_dvec3().dot(normal) > 0.0 { -normal } else { normal }
}

/// [`sky`] in `f64`.
pub(super) fn sky_at(direction: DVec3) -> [f64; 3] {
    direction.to_array().map(|coordinate| 0.6 + 0.3 * coordinate)
}

/// Channel by channel.
pub(super) fn times(color: Color, light: [f64; 3]) -> [f64; 3] {
    let color = color.to_array();
    [0, 1, 2].map(|channel| f64::from(color[channel]) * light[channel])
}
