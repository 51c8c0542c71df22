use std::ops::{ControlFlow, Range};

use accel::Accelerator;
use geometry::{Hit, Interval, Plane, Primitive, Primitives, Ray, RayOrigin, Surface};
use glam::Vec2;
use shading::{Bounces, Color, PointLight, Shader};

use crate::{BucketOrdering, Camera, Film, FinishedBucket, Raster, Renderer, Sampler, Settings, Tile};

/// Everything a picture needs, ready to be asked. Made by [`crate::assemble`].
///
/// Primitives are numbered from 0, the bounded ones first and the planes after them.
pub struct Scene {
    pub(crate) camera: Box<dyn Camera>,
    pub(crate) bounded: Primitives,
    /// Finds the nearest bounded primitive.
    pub(crate) accelerator: Box<dyn Accelerator>,
    /// Finds what blocks a light, where that is not every primitive: built only for scenes with lights and glass.
    pub(crate) blockers: Option<Box<dyn Accelerator>>,
    pub(crate) planes: Vec<Plane>,
    pub(crate) shaders: Vec<Box<dyn Shader>>,
    /// Each primitive's shader, planes included.
    pub(crate) shader_of: Vec<u32>,
    pub(crate) lights: Vec<PointLight>,
    /// The lights that have taken the place of each of the file's.
    pub(crate) clusters: Vec<Range<usize>>,
    pub(crate) ambient: f32,
    /// What camera rays see where they hit nothing.
    pub(crate) background: Color,
    /// What reflected and refracted rays see there: Sunflow's are left in the dark.
    pub(crate) secondary_background: Color,
    /// Where pixels lie in what the camera sees.
    pub(crate) raster: Raster,
    pub(crate) bounces: Bounces,
    pub(crate) ray_origin: RayOrigin,
    pub(crate) sampler: Sampler,
    pub(crate) bucket_order: BucketOrdering,
    pub(crate) renderer: Renderer,
}

impl Scene {
    /// Renders it, with the renderer that [`crate::Modules`] named.
    pub fn render(
        &self,
        settings: &Settings,
        on_bucket: &(dyn Fn(&FinishedBucket<'_>) -> ControlFlow<()> + Sync),
    ) -> Option<Film> {
        (self.renderer)(self, settings, on_bucket)
    }

    /// The buckets of a picture, in the order in which they are to be taken.
    pub fn tiles(&self, settings: &Settings) -> Vec<Tile> {
        let (buckets, window) = (settings.buckets, settings.window());
        let count = |pixels: u32| pixels.div_ceil(buckets.size);
        let mut tiles = (self.bucket_order)(buckets.order, count(window.width), count(window.height));
        if buckets.reversed {
            tiles.reverse();
        }
        tiles
    }

    /// The camera.
    pub fn camera(&self) -> &dyn Camera {
        &*self.camera
    }

    /// The nearest hit in front of a ray, planes included.
    pub fn closest(&self, ray: &Ray) -> Option<Hit> {
        let mut nearest = self.accelerator.closest(ray, Interval::FORWARD);
        for (number, plane) in self.numbered_planes() {
            let within = Interval::FORWARD.up_to(nearest.map_or(f32::INFINITY, |hit| hit.t));
            nearest = self.bounded.kernels().meet_plane(plane, ray, within).map(|met| met.on(number)).or(nearest);
        }
        nearest
    }

    /// As [`Self::closest`], of many rays; `hits` is as long as `rays`.
    pub fn closest_many(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        self.accelerator.closest_many(rays, hits);
        for (number, plane) in self.numbered_planes() {
            for (ray, nearest) in rays.iter().zip(&mut *hits) {
                let within = Interval::FORWARD.up_to(nearest.map_or(f32::INFINITY, |hit| hit.t));
                if let Some(met) = self.bounded.kernels().meet_plane(plane, ray, within) {
                    *nearest = Some(met.on(number));
                }
            }
        }
    }

    /// Whether something that casts a shadow lies strictly between the ends of a segment.
    pub fn blocked(&self, segment: &Ray) -> bool {
        let by_plane = |(number, plane): (u32, &Plane)| {
            let meets = || self.bounded.kernels().meet_plane(plane, segment, Interval::SEGMENT).is_some();
            self.shader(number).casts_shadow() && meets()
        };
        self.numbered_planes().any(by_plane) || self.blockers().any(segment, Interval::SEGMENT)
    }

    /// As [`Self::blocked`], of many segments; `blocked` is as long as `segments`.
    pub fn blocked_many(&self, segments: &[Ray], blocked: &mut [bool]) {
        self.blockers().any_many(segments, Interval::SEGMENT, blocked);
        for (_, plane) in self.numbered_planes().filter(|&(number, _)| self.shader(number).casts_shadow()) {
            for (segment, blocked) in segments.iter().zip(&mut *blocked) {
                *blocked = *blocked || self.bounded.kernels().meet_plane(plane, segment, Interval::SEGMENT).is_some();
            }
        }
    }

    /// The surface at a hit of the same ray.
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        match self.plane(hit.primitive) {
            Some(plane) => plane.surface(ray, &hit.intersection()),
            None => self.bounded.surface(ray, hit),
        }
    }

    /// The texture coordinates at a hit of the same ray.
    pub fn uv(&self, ray: &Ray, hit: &Hit) -> Vec2 {
        match self.plane(hit.primitive) {
            Some(plane) => self.bounded.kernels().uv_of_plane(plane, ray),
            None => self.bounded.uv(ray, hit),
        }
    }

    /// A primitive's shader.
    pub fn shader(&self, primitive: u32) -> &dyn Shader {
        &*self.shaders[self.shader_of[primitive as usize] as usize]
    }

    fn blockers(&self) -> &dyn Accelerator {
        self.blockers.as_deref().unwrap_or(&*self.accelerator)
    }

    fn plane(&self, primitive: u32) -> Option<&Plane> {
        self.planes.get(primitive.checked_sub(self.bounded.len())? as usize)
    }

    fn numbered_planes(&self) -> impl Iterator<Item = (u32, &Plane)> {
        (self.bounded.len()..).zip(&self.planes)
    }
}
