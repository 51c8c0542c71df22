use std::cell::{Cell, OnceCell};

use geometry::{Hit, Ray, Surface};
use glam::{DVec2, Vec3};
use shading::{Bounces, Color, Facing, Incident, LazySurface, LightFormula, PointLight, Shader, ShadingPoint, World};

use crate::{LightPlan, Purpose, RayCounts, Sample, Scene, Settings, camera_rays::Samples, lit::LitPoint};

/// Follows rays through a scene and counts them. Each thread has its own, so that counting costs the others nothing.
pub(crate) struct Tracer<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    lights: LightPlan<'a>,
    rays: Cell<RayCounts>,
}

impl<'a> Tracer<'a> {
    pub(crate) fn new(scene: &'a Scene, settings: &'a Settings) -> Self {
        let lights = LightPlan::new(scene, settings.light_samples, settings.rays_per_pixel());
        Self { scene, settings, lights, rays: Cell::default() }
    }

    /// The rays traced since this was last asked.
    pub(crate) fn take_counts(&self) -> RayCounts {
        self.rays.take()
    }

    /// Where in the picture rays of a pixel leave the camera, in pixels, and where on the lens, if it has one: this sample's and the next ones', as
    /// many as there is room for.
    pub(crate) fn places(&self, first: Sample, in_picture: &mut [DVec2], on_lens: &mut [DVec2]) {
        let Scene { camera, sampler, .. } = self.scene;
        if first.count == 1 {
            // A single ray has nothing to be averaged with.
            in_picture.fill(DVec2::splat(0.5));
        } else {
            sampler(Sample { purpose: Purpose::Pixel, ..first }, in_picture);
        }
        let corner = DVec2::new(f64::from(first.pixel[0]), f64::from(first.pixel[1]));
        in_picture.iter_mut().for_each(|place| *place += corner);
        if camera.has_lens() {
            sampler(Sample { purpose: Purpose::Lens, ..first }, on_lens);
        }
    }

    /// The rays that leave the camera at some places, given in pixels.
    pub(crate) fn camera_rays(
        &self,
        samples: &Samples,
        in_picture: &mut [DVec2],
        on_lens: &[DVec2],
        rays: &mut Vec<Ray>,
    ) {
        let Scene { camera, raster, sampler, .. } = self.scene;
        let size = self.settings.size;
        in_picture.iter_mut().for_each(|place| *place = raster.film(*place, size));
        if camera.has_lens() {
            camera.rays(in_picture, &|number| on_lens[number], rays);
        } else {
            // A camera may ask all the same.
            let lens = |number| Sample { purpose: Purpose::Lens, ..samples.of(number) }.point(*sampler);
            camera.rays(in_picture, &lens, rays);
        }
        // Whatever a camera makes: no more than asked for.
        rays.truncate(in_picture.len());
    }

    /// What each of some camera rays meets.
    pub(crate) fn camera_hits(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        self.count(|counts| counts.camera += rays.len() as u64);
        self.scene.closest_many(rays, hits);
    }

    /// What a ray sees where it meets something.
    #[inline(always)]
    pub(crate) fn seen<'r, S: Sight>(&self, ray: &'r Ray, hit: &'r Hit) -> Seen<'r, S>
    where
        'a: 'r,
    {
        let length = ray.direction.length();
        Seen {
            ray,
            hit,
            surface: S::of(self.scene, ray, hit),
            direction: ray.direction / length,
            distance: hit.t * length,
            shader: self.scene.shader(hit.primitive),
        }
    }

    /// Whether the scene has lights.
    pub(crate) fn has_lights(&self) -> bool {
        !self.scene.lights.is_empty()
    }

    /// What camera rays see that meet nothing.
    pub(crate) fn background(&self) -> Color {
        self.scene.background
    }

    /// The light that comes into the camera along a ray; `lit` is what the lights bring to what it sees, where that is known.
    pub(crate) fn camera_color<S: Sight>(
        &self,
        samples: &Samples,
        point: &Point<'_, S>,
        lit: Option<LitPoint<'_>>,
    ) -> Color {
        RayTree { tracer: self, samples, point, known: lit }.color(&point.seen, self.scene.bounces)
    }

    /// How many lights are asked at a point.
    pub(crate) fn lights_asked(&self) -> usize {
        self.lights.asked()
    }

    /// The light that is asked in the given turn at whatever a camera ray sees, if it is the same for all.
    pub(crate) fn light_of_all(&self, number: u32) -> Option<PointLight> {
        self.lights.of_all(number)
    }

    /// The light that is asked in the given turn at what a camera ray sees.
    pub(crate) fn light_of<S>(&self, number: u32, samples: &Samples, point: &Point<'_, S>) -> Option<PointLight> {
        self.lights.light(number, self.scene.bounces.path, self.scene.sampler, || samples.of(point.ray))
    }

    /// Adds what a camera ray sees, made ready for a formula. Not where the surface is not known, which it is in scenes with lights.
    #[inline]
    pub(crate) fn facing<S: Sight>(&self, formula: LightFormula, seen: &Seen<'_, S>, add: impl FnOnce(Facing)) {
        if let Some(surface) = seen.surface.known() {
            add(formula.facing(surface, seen.direction, self.scene.ray_origin));
        }
    }

    /// Whether something is in the way of each segment. They count when a shader asks.
    pub(crate) fn blocked_many(&self, segments: &[Ray], blocked: &mut [bool]) {
        self.scene.blocked_many(segments, blocked);
    }

    fn count(&self, add: impl FnOnce(&mut RayCounts)) {
        let mut rays = self.rays.get();
        add(&mut rays);
        self.rays.set(rays);
    }
}

/// What a camera ray sees.
pub(crate) struct Point<'a, S> {
    /// The ray's number among those that are traced together.
    pub(crate) ray: usize,
    pub(crate) seen: Seen<'a, S>,
}

/// What a ray sees where it meets something.
pub(crate) struct Seen<'a, S> {
    ray: &'a Ray,
    hit: &'a Hit,
    surface: S,
    /// As in [`ShadingPoint`].
    direction: Vec3,
    distance: f32,
    pub(crate) shader: &'a dyn Shader,
}

/// The surface that a ray sees: known, or to be computed when it is looked at.
///
/// In a scene with lights nearly every shader looks at it, so it is known from the start: a [`Surface`]. Without lights many show one colour
/// everywhere, so it is a [`OnceCell`].
pub(crate) trait Sight {
    /// At a hit.
    fn of(scene: &Scene, ray: &Ray, hit: &Hit) -> Self;

    /// The surface, if it has been computed.
    fn known(&self) -> Option<&Surface>;

    /// As a shader sees it.
    fn lazy<'t>(&'t self, compute: &'t dyn Fn() -> Surface) -> LazySurface<'t>;
}

impl Sight for Surface {
    #[inline]
    fn of(scene: &Scene, ray: &Ray, hit: &Hit) -> Self {
        scene.surface(ray, hit)
    }

    #[inline]
    fn known(&self) -> Option<&Surface> {
        Some(self)
    }

    #[inline]
    fn lazy<'t>(&'t self, _compute: &'t dyn Fn() -> Surface) -> LazySurface<'t> {
        LazySurface::Known(self)
    }
}

impl Sight for OnceCell<Surface> {
    #[inline]
    fn of(_scene: &Scene, _ray: &Ray, _hit: &Hit) -> Self {
        Self::new()
    }

    #[inline]
    fn known(&self) -> Option<&Surface> {
        self.get()
    }

    #[inline]
    fn lazy<'t>(&'t self, compute: &'t dyn Fn() -> Surface) -> LazySurface<'t> {
        LazySurface::Asked { known: self, compute }
    }
}

/// All that is seen by one camera ray: the rays that come of it.
struct RayTree<'a, S> {
    tracer: &'a Tracer<'a>,
    /// Which samples the camera rays are.
    samples: &'a Samples,
    /// What the camera ray sees, and what the lights bring there, where that is known.
    point: &'a Point<'a, S>,
    known: Option<LitPoint<'a>>,
}

impl<S: Sight> RayTree<'_, S> {
    /// The light that comes back along a ray from what it sees.
    fn color(&self, seen: &Seen<'_, S>, bounces: Bounces) -> Color {
        let scene = self.tracer.scene;
        let (ray, hit) = (seen.ray, seen.hit);
        seen.shader.radiance(&ShadingPoint {
            world: self,
            direction: seen.direction,
            distance: seen.distance,
            surface: seen.surface.lazy(&|| scene.surface(ray, hit)),
            ray_origin: scene.ray_origin,
            uv: &|| scene.uv(ray, hit),
            bounces,
        })
    }
}

impl<S: Sight> World for RayTree<'_, S> {
    fn light(&self, number: u32, path: u32) -> Option<PointLight> {
        self.tracer.lights.light(number, path, self.tracer.scene.sampler, || self.samples.of(self.point.ray))
    }

    fn ambient(&self) -> Option<f32> {
        let scene = self.tracer.scene;
        scene.lights.is_empty().then_some(scene.ambient)
    }

    fn blocked(&self, segment: &Ray) -> bool {
        self.tracer.count(|rays| rays.shadow += 1);
        self.tracer.scene.blocked(segment)
    }

    fn trace(&self, ray: &Ray, bounces: Bounces) -> Color {
        self.tracer.count(|rays| rays.secondary += 1);
        let scene = self.tracer.scene;
        let Some(hit) = scene.closest(ray) else { return scene.secondary_background };
        self.color(&self.tracer.seen(ray, &hit), bounces)
    }

    fn lit(&self, at: &ShadingPoint<'_>, formula: LightFormula) -> Option<&[Incident]> {
        let (seen, lit) = (&self.point.seen, self.known.as_ref()?);
        let scene = self.tracer.scene;
        let is_seen = seen.surface.known().is_some_and(|surface| at.surface.is(surface))
            && at.direction == seen.direction
            && at.bounces.path == scene.bounces.path
            && std::ptr::fn_addr_eq(at.ray_origin, scene.ray_origin)
            && formula == lit.formula;
        if !is_seen {
            return None;
        }
        self.tracer.count(|counts| counts.shadow += lit.segments as u64);
        Some(lit.incidents)
    }
}
