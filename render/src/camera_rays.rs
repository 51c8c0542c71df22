use std::ops::Range;

use geometry::{Hit, Ray};
use shading::Color;

use crate::{LostRays, RayCounts, Sample, Scene, Settings, tracer::Tracer};

/// So many rays are traced together.
const TOGETHER: usize = 128;

/// Camera rays on their way: gathered, traced together, and then followed one by one, in the order in which they were asked for.
///
/// Together, because neighbours meet the same things: an accelerator answers sixteen of them in the time of a few
/// ([`accel::Accelerator::closest_many`]). Which rays those are has no influence on what each sees.
pub(crate) struct CameraRays<'a> {
    tracer: Tracer<'a>,
    lost: LostRays,
    waiting: Vec<Waiting>,
    rays: Vec<Ray>,
    hits: [Option<Hit>; TOGETHER],
}

/// Whose light a ray brings.
struct Waiting {
    sample: Sample,
    pixel: usize,
}

impl<'a> CameraRays<'a> {
    pub(crate) fn new(scene: &'a Scene, settings: &'a Settings) -> Self {
        Self {
            tracer: Tracer::new(scene, settings),
            lost: LostRays::default(),
            waiting: Vec::with_capacity(TOGETHER),
            rays: Vec::with_capacity(TOGETHER),
            hits: [None; TOGETHER],
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
        for index in indices {
            let sample = Sample { index, ..first };
            self.rays.push(self.tracer.camera_ray(sample));
            self.waiting.push(Waiting { sample, pixel });
            if self.rays.len() == TOGETHER {
                self.tell(told);
            }
        }
    }

    /// Tells of all rays that have been asked for and not yet told.
    pub(crate) fn tell(&mut self, told: &mut impl FnMut(usize, Color)) {
        let hits = &mut self.hits[..self.rays.len()];
        self.tracer.camera_hits(&self.rays, hits);
        for ((Waiting { sample, pixel }, ray), hit) in self.waiting.drain(..).zip(&self.rays).zip(hits) {
            let color = self.tracer.camera_color(sample, ray, hit.as_ref());
            told(pixel, self.lost.checked(color, sample.pixel));
        }
        self.rays.clear();
    }

    /// The rays of all kinds traced since this was last asked, and the camera rays lost.
    pub(crate) fn take_counts(&mut self) -> (RayCounts, LostRays) {
        (self.tracer.take_counts(), std::mem::take(&mut self.lost))
    }
}
