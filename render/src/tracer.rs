use std::cell::{Cell, RefCell};

use geometry::Ray;
use glam::DVec2;
use shading::{Bounces, Color, PointLight, ShadingPoint, World};

use crate::{LightPlan, LostRays, Purpose, RayCounts, Sample, Scene, Settings};

/// Follows rays through a scene and counts them. Each bucket has its own, so that counting costs threads nothing.
pub(crate) struct Tracer<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    lights: LightPlan<'a>,
    rays: Cell<RayCounts>,
    lost: RefCell<LostRays>,
}

impl<'a> Tracer<'a> {
    pub(crate) fn new(scene: &'a Scene, settings: &'a Settings) -> Self {
        let lights = LightPlan::new(scene, settings.light_samples, settings.rays_per_pixel());
        Self { scene, settings, lights, rays: Cell::default(), lost: RefCell::default() }
    }

    /// The rays traced so far.
    pub(crate) fn rays(&self) -> RayCounts {
        self.rays.get()
    }

    /// The camera rays lost so far, and forgets them.
    pub(crate) fn lost(&self) -> LostRays {
        self.lost.take()
    }

    /// The light that comes into the camera along one of a pixel's rays; black where that is lost.
    pub(crate) fn camera_ray(&self, sample: Sample) -> Color {
        self.count(|rays| rays.camera += 1);
        let random = |purpose| (self.scene.sampler)(Sample { purpose, ..sample });
        // A single ray has nothing to be averaged with.
        let in_pixel = if sample.count == 1 { DVec2::splat(0.5) } else { random(Purpose::Pixel) };
        let corner = DVec2::new(f64::from(sample.pixel[0]), f64::from(sample.pixel[1]));
        let place = self.scene.raster.film(corner + in_pixel, self.settings.size);
        let ray = self.scene.camera.ray(place, &|| random(Purpose::Lens));
        let tree = RayTree { tracer: self, sample };
        let color = tree.follow(&ray, self.scene.bounces, self.scene.background);
        self.lost.borrow_mut().checked(color, sample.pixel)
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
    fn follow(&self, ray: &Ray, bounces: Bounces, background: Color) -> Color {
        let scene = self.tracer.scene;
        let Some(hit) = scene.closest(ray) else { return background };
        let length = ray.direction.length();
        let at = ShadingPoint {
            world: self,
            direction: ray.direction / length,
            distance: hit.t * length,
            surface: scene.surface(ray, &hit),
            ray_origin: scene.ray_origin,
            uv: &|| scene.uv(ray, &hit),
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
        self.follow(ray, bounces, self.tracer.scene.secondary_background)
    }
}
