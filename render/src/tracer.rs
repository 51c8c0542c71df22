use std::cell::Cell;

use geometry::{Hit, Ray};
use glam::DVec2;
use shading::{Bounces, Color, PointLight, ShadingPoint, World};

use crate::{LightPlan, Purpose, RayCounts, Sample, Scene, Settings};

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

    /// One of a pixel's rays, as it leaves the camera.
    pub(crate) fn camera_ray(&self, sample: Sample) -> Ray {
        let random = |purpose| (self.scene.sampler)(Sample { purpose, ..sample });
        // A single ray has nothing to be averaged with.
        let in_pixel = if sample.count == 1 { DVec2::splat(0.5) } else { random(Purpose::Pixel) };
        let corner = DVec2::new(f64::from(sample.pixel[0]), f64::from(sample.pixel[1]));
        let place = self.scene.raster.film(corner + in_pixel, self.settings.size);
        self.scene.camera.ray(place, &|| random(Purpose::Lens))
    }

    /// What each of some camera rays meets.
    pub(crate) fn camera_hits(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        self.count(|counts| counts.camera += rays.len() as u64);
        self.scene.closest_many(rays, hits);
    }

    /// The light that comes into the camera along a ray that has met this.
    pub(crate) fn camera_color(&self, sample: Sample, ray: &Ray, hit: Option<&Hit>) -> Color {
        let Some(hit) = hit else { return self.scene.background };
        RayTree { tracer: self, sample }.color(ray, hit, self.scene.bounces)
    }

    fn count(&self, add: impl FnOnce(&mut RayCounts)) {
        let mut rays = self.rays.get();
        add(&mut rays);
        self.rays.set(rays);
    }
}

/// All that is seen by one camera ray: the rays that come of it.
struct RayTree<'a> {
    tracer: &'a Tracer<'a>,
    sample: Sample,
}

impl RayTree<'_> {
    /// The light that comes back along a ray from what it has met.
    fn color(&self, ray: &Ray, hit: &Hit, bounces: Bounces) -> Color {
        let scene = self.tracer.scene;
        let length = ray.direction.length();
        let at = ShadingPoint {
            world: self,
            direction: ray.direction / length,
            distance: hit.t * length,
            surface: scene.surface(ray, hit),
            ray_origin: scene.ray_origin,
            uv: &|| scene.uv(ray, hit),
            bounces,
        };
        scene.shader(hit.primitive).radiance(&at)
    }
}

impl World for RayTree<'_> {
    fn light(&self, number: u32, path: u32) -> Option<PointLight> {
        self.tracer.lights.light(number, path, self.tracer.scene.sampler, self.sample)
    }

    fn ambient(&self) -> f32 {
        self.tracer.scene.ambient
    }

    fn blocked(&self, segment: &Ray) -> bool {
        self.tracer.count(|rays| rays.shadow += 1);
        self.tracer.scene.blocked(segment)
    }

    fn trace(&self, ray: &Ray, bounces: Bounces) -> Color {
        self.tracer.count(|rays| rays.secondary += 1);
        let scene = self.tracer.scene;
        scene.closest(ray).map_or(scene.secondary_background, |hit| self.color(ray, &hit, bounces))
    }
}
