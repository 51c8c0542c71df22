use std::cell::Cell;

use geometry::Ray;
use shading::{Bounces, Color, PointLight, ShadingPoint, World};

use crate::{RayCounts, Scene};

/// Follows rays through a scene and counts them. Each bucket has its own, so that counting costs threads nothing.
pub(crate) struct Tracer<'a> {
    scene: &'a Scene,
    rays: Cell<RayCounts>,
}

impl<'a> Tracer<'a> {
    pub(crate) fn new(scene: &'a Scene) -> Self {
        Self { scene, rays: Cell::default() }
    }

    /// The rays traced so far.
    pub(crate) fn rays(&self) -> RayCounts {
        self.rays.get()
    }

    /// The light that comes into the camera along a ray.
    pub(crate) fn camera_ray(&self, ray: &Ray) -> Color {
        self.count(|rays| rays.camera += 1);
        self.follow(ray, self.scene.bounces, self.scene.background)
    }

    fn follow(&self, ray: &Ray, bounces: Bounces, background: Color) -> Color {
        let Some(hit) = self.scene.closest(ray) else { return background };
        let length = ray.direction.length();
        let at = ShadingPoint {
            world: self,
            direction: ray.direction / length,
            distance: hit.t * length,
            surface: self.scene.surface(ray, &hit),
            ray_origin: self.scene.ray_origin,
            uv: &|| self.scene.uv(ray, &hit),
            bounces,
        };
        self.scene.shader(hit.primitive).radiance(&at)
    }

    fn count(&self, add: impl FnOnce(&mut RayCounts)) {
        let mut rays = self.rays.get();
        add(&mut rays);
        self.rays.set(rays);
    }
}

impl World for Tracer<'_> {
    fn lights(&self) -> &[PointLight] {
        &self.scene.lights
    }

    fn ambient(&self) -> f32 {
        self.scene.ambient
    }

    fn blocked(&self, segment: &Ray) -> bool {
        self.count(|rays| rays.shadow += 1);
        self.scene.blocked(segment)
    }

    fn trace(&self, ray: &Ray, bounces: Bounces) -> Color {
        self.count(|rays| rays.secondary += 1);
        self.follow(ray, bounces, self.scene.secondary_background)
    }
}
