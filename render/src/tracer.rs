use std::cell::Cell;

use geometry::{Hit, Ray, Surface};
use glam::{DVec2, Vec2, Vec3};
use shading::{Bounces, Color, Incident, PointLight, ShadingPoint, World};

use crate::{LightPlan, Purpose, RayCounts, Sample, Scene, Settings, lit::LitPoint};

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

    /// Adds rays of a pixel as they leave the camera: this sample's and the next ones', as many as there is room for places in the pixel.
    pub(crate) fn camera_rays(&self, first: Sample, in_pixel: &mut [DVec2], rays: &mut Vec<Ray>) {
        let Scene { camera, raster, sampler, .. } = self.scene;
        let corner = DVec2::new(f64::from(first.pixel[0]), f64::from(first.pixel[1]));
        if first.count == 1 {
            // A single ray has nothing to be averaged with.
            in_pixel.fill(DVec2::splat(0.5));
        } else {
            sampler(Sample { purpose: Purpose::Pixel, ..first }, in_pixel);
        }
        for (&in_pixel, index) in in_pixel.iter().zip(first.index..) {
            let on_lens = || Sample { purpose: Purpose::Lens, index, ..first }.point(*sampler);
            rays.push(camera.ray(raster.film(corner + in_pixel, self.settings.size), &on_lens));
        }
    }

    /// What each of some camera rays meets.
    pub(crate) fn camera_hits(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        self.count(|counts| counts.camera += rays.len() as u64);
        self.scene.closest_many(rays, hits);
    }

    /// What a ray sees where it meets something.
    pub(crate) fn seen(&self, ray: &Ray, hit: &Hit) -> Seen {
        let length = ray.direction.length();
        let surface = self.scene.surface(ray, hit);
        Seen { hit: *hit, surface, direction: ray.direction / length, distance: hit.t * length }
    }

    /// The light that comes into the camera along a ray that sees this; `lit` is what the lights bring there, where that is known.
    pub(crate) fn camera_color(
        &self,
        sample: &Sample,
        ray: &Ray,
        seen: Option<&Seen>,
        lit: Option<LitPoint<'_>>,
    ) -> Color {
        let Some(seen) = seen else { return self.scene.background };
        let known = lit.map(|lit| (seen, lit));
        RayTree { tracer: self, sample, known }.color(ray, seen, self.scene.bounces)
    }

    /// How many lights are asked at a point.
    pub(crate) fn lights_asked(&self) -> usize {
        self.lights.asked()
    }

    /// Whether what is seen asks lights.
    pub(crate) fn asks_lights(&self, seen: &Seen) -> bool {
        self.scene.shader(seen.hit.primitive).asks_lights()
    }

    /// What the numbered light brings to what a camera ray sees, where nothing is in its way: see [`ShadingPoint::arriving`].
    pub(crate) fn arriving(&self, number: u32, sample: &Sample, seen: &Seen) -> Option<(Incident, Ray)> {
        let tree = RayTree { tracer: self, sample, known: None };
        let bounces = self.scene.bounces;
        let light = tree.light(number, bounces.path)?;
        tree.point(seen, bounces, &|| Vec2::ZERO).arriving(&light)
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

/// What a ray sees where it meets something.
pub(crate) struct Seen {
    hit: Hit,
    surface: Surface,
    /// As in [`ShadingPoint`].
    direction: Vec3,
    distance: f32,
}

/// All that is seen by one camera ray: the rays that come of it.
struct RayTree<'a> {
    tracer: &'a Tracer<'a>,
    sample: &'a Sample,
    /// What the camera ray sees, and what the lights bring there.
    known: Option<(&'a Seen, LitPoint<'a>)>,
}

impl RayTree<'_> {
    /// The light that comes back along a ray from what it sees.
    fn color(&self, ray: &Ray, seen: &Seen, bounces: Bounces) -> Color {
        let scene = self.tracer.scene;
        scene.shader(seen.hit.primitive).radiance(&self.point(seen, bounces, &|| scene.uv(ray, &seen.hit)))
    }

    fn point<'t>(&'t self, seen: &'t Seen, bounces: Bounces, uv: &'t dyn Fn() -> Vec2) -> ShadingPoint<'t> {
        let &Seen { ref surface, direction, distance, .. } = seen;
        ShadingPoint {
            world: self,
            direction,
            distance,
            surface,
            ray_origin: self.tracer.scene.ray_origin,
            uv,
            bounces,
        }
    }
}

impl World for RayTree<'_> {
    fn light(&self, number: u32, path: u32) -> Option<PointLight> {
        self.tracer.lights.light(number, path, self.tracer.scene.sampler, *self.sample)
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
        scene
            .closest(ray)
            .map_or(scene.secondary_background, |hit| self.color(ray, &self.tracer.seen(ray, &hit), bounces))
    }

    fn lit(&self, at: &ShadingPoint<'_>) -> Option<&[Incident]> {
        let (seen, lit) = self.known?;
        let scene = self.tracer.scene;
        let is_seen = std::ptr::eq(at.surface, &raw const seen.surface)
            && at.direction == seen.direction
            && at.bounces.path == scene.bounces.path
            && std::ptr::fn_addr_eq(at.ray_origin, scene.ray_origin);
        if !is_seen {
            return None;
        }
        self.tracer.count(|counts| counts.shadow += lit.segments as u64);
        Some(lit.incidents)
    }
}
