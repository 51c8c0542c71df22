use accel::Statistics;
use geometry::{PrimitiveCount, Primitives, Ray};
use glam::DVec2;

use crate::{LightPlan, Scene, Settings};

/// What a scene needs, and what it does not.
#[derive(Clone, Debug, PartialEq)]
pub struct Inventory {
    /// Spheres, ellipsoids and triangles.
    pub bounded: PrimitiveCount,
    /// Infinite planes.
    pub planes: usize,
    /// Memory of the bounded primitives, in bytes.
    pub primitive_bytes: usize,
    /// The accelerator of all bounded primitives.
    pub accelerator: Statistics,
    /// The one of the opaque primitives, where there must be one.
    pub blockers: Option<Statistics>,
    /// Shaders that some object uses.
    pub shaders: usize,
    /// Whether some of them let light through.
    pub glass: bool,
    /// Lights, after soft shadows have made many of each.
    pub lights: usize,
    /// How many of them are asked at each point.
    pub lights_asked: usize,
    /// Whether the camera has a lens.
    pub lens: bool,
    /// How many camera rays the settings ask for; the most, where they are not shared out evenly.
    pub camera_rays: u64,
}

impl Scene {
    /// The bounded primitives, for who wants to find what meets them in another way.
    pub fn bounded(&self) -> &Primitives {
        &self.bounded
    }

    /// Rays of the camera spread evenly over the picture, so many along each edge; those of a lens from its middle.
    pub fn camera_rays(&self, settings: &Settings, along_edge: u32) -> Vec<Ray> {
        let size = DVec2::new(f64::from(settings.size[0]), f64::from(settings.size[1]));
        let ray = |number: u32| {
            let [column, row] = [number % along_edge, number / along_edge].map(f64::from);
            let place = (DVec2::new(column, row) + 0.5) / f64::from(along_edge) * size;
            self.camera.ray(self.raster.film(place, settings.size), &|| DVec2::splat(0.5))
        };
        (0..along_edge * along_edge).map(ray).collect()
    }

    /// What the scene needs for a picture with these settings.
    pub fn inventory(&self, settings: &Settings) -> Inventory {
        let window = settings.window();
        Inventory {
            bounded: self.bounded.count(),
            planes: self.planes.len(),
            primitive_bytes: self.bounded.bytes(),
            accelerator: self.accelerator.statistics(),
            blockers: self.blockers.as_ref().map(|blockers| blockers.statistics()),
            shaders: self.shaders.len(),
            glass: !self.shaders.iter().all(|shader| shader.casts_shadow()),
            lights: self.lights.len(),
            lights_asked: LightPlan::new(self, settings.light_samples, settings.rays_per_pixel()).asked(),
            lens: self.camera.has_lens(),
            camera_rays: u64::from(window.width) * u64::from(window.height) * u64::from(settings.rays_per_pixel()),
        }
    }
}
