use std::ops::Range;

use geometry::{Hit, Ray};
use glam::DVec2;
use shading::Color;

use crate::{
    LostRays, RayCounts, Sample, Scene, Settings,
    lit::Lit,
    tracer::{Seen, Tracer},
};

/// So many rays are traced together: several times sixteen, so that those without a hit or light leave few gaps.
const TOGETHER: usize = 128;

/// In scenes with many lights fewer rays, so that what is known of their light at a time does not grow with the scene.
const INCIDENTS_TOGETHER: usize = 4096;
const FEWEST_TOGETHER: usize = 16;

/// Camera rays on their way: gathered, traced together, and then followed one by one, in the order in which they were asked for.
///
/// Together, because neighbours meet the same things: an accelerator answers sixteen of them in the time of a few
/// ([`accel::Accelerator::closest_many`]). Which rays those are has no influence on what each sees.
pub(crate) struct CameraRays<'a> {
    tracer: Tracer<'a>,
    lost: LostRays,
    together: usize,
    in_pixel: [DVec2; TOGETHER],
    rays: Vec<Ray>,
    /// The number of each ray's pixel.
    pixels: Vec<usize>,
    /// Which sample each ray is, and, when it is traced, what it sees.
    points: Vec<(Sample, Option<Seen>)>,
    hits: [Option<Hit>; TOGETHER],
    lit: Lit,
}

impl<'a> CameraRays<'a> {
    pub(crate) fn new(scene: &'a Scene, settings: &'a Settings) -> Self {
        let tracer = Tracer::new(scene, settings);
        let together = (INCIDENTS_TOGETHER / tracer.lights_asked().max(1)).clamp(FEWEST_TOGETHER, TOGETHER);
        Self {
            tracer,
            lost: LostRays::default(),
            together,
            in_pixel: [DVec2::ZERO; TOGETHER],
            rays: Vec::with_capacity(together),
            pixels: Vec::with_capacity(together),
            points: Vec::with_capacity(together),
            hits: [None; TOGETHER],
            lit: Lit::default(),
        }
    }

    /// Asks for rays of a pixel, which the caller has a number for. `told` is given the number and the light of each ray, black where that is
    /// lost: sooner or later, but in order.
    pub(crate) fn ask(
        &mut self,
        pixel: usize,
        first: Sample,
        indices: Range<u32>,
        told: &mut impl FnMut(usize, Color),
    ) {
        let mut index = indices.start;
        while index < indices.end {
            let count = (indices.end - index).min((self.together - self.rays.len()) as u32);
            let in_pixel = &mut self.in_pixel[..count as usize];
            self.tracer.camera_rays(Sample { index, ..first }, in_pixel, &mut self.rays);
            let samples = (index..index + count).map(|index| Sample { index, ..first });
            self.points.extend(samples.map(|sample| (sample, None)));
            self.pixels.extend((0..count).map(|_| pixel));
            index += count;
            if self.rays.len() == self.together {
                self.tell(told);
            }
        }
    }

    /// Tells of all rays that have been asked for and not yet told.
    pub(crate) fn tell(&mut self, told: &mut impl FnMut(usize, Color)) {
        let Self { tracer, rays, pixels, points, lit, .. } = self;
        let hits = &mut self.hits[..rays.len()];
        tracer.camera_hits(rays, hits);
        for ((ray, hit), (_, seen)) in rays.iter().zip(&*hits).zip(&mut *points) {
            *seen = hit.as_ref().map(|hit| tracer.seen(ray, hit));
        }
        lit.ask(tracer, points);
        for (number, ((ray, &pixel), (sample, seen))) in rays.iter().zip(&*pixels).zip(&*points).enumerate() {
            let color = tracer.camera_color(sample, ray, seen.as_ref(), lit.at(number));
            told(pixel, self.lost.checked(color, sample.pixel));
        }
        rays.clear();
        pixels.clear();
        points.clear();
    }

    /// The rays of all kinds traced since this was last asked, and the camera rays lost.
    pub(crate) fn take_counts(&mut self) -> (RayCounts, LostRays) {
        (self.tracer.take_counts(), std::mem::take(&mut self.lost))
    }
}
