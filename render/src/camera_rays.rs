use std::cell::OnceCell;
use std::ops::Range;

use geometry::{Hit, Ray, Surface};
use glam::DVec2;
use shading::Color;

use crate::{
    LostRays, RayCounts, Sample, Scene, Settings,
    lit::Lit,
    tracer::{Point, Sight, Tracer},
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
    samples: Samples,
    /// Where each ray leaves the camera; on the lens, if it has one.
    in_picture: [DVec2; TOGETHER],
    on_lens: [DVec2; TOGETHER],
    rays: Vec<Ray>,
    hits: [Option<Hit>; TOGETHER],
    lit: Lit,
    colors: [Color; TOGETHER],
}

/// Whose rays are on their way.
#[derive(Default)]
pub(crate) struct Samples {
    pixels: Vec<OfPixel>,
    /// For each ray, where in `pixels` its own stands.
    of_rays: Vec<u32>,
}

/// Rays of one pixel that follow each other.
struct OfPixel {
    /// The caller's number for it.
    number: usize,
    first_ray: usize,
    first_sample: Sample,
}

impl Samples {
    fn add(&mut self, count: usize, pixel: OfPixel) {
        self.of_rays.resize(pixel.first_ray + count, self.pixels.len() as u32);
        self.pixels.push(pixel);
    }

    fn clear(&mut self) {
        self.pixels.clear();
        self.of_rays.clear();
    }

    /// Which sample a ray is.
    pub(crate) fn of(&self, ray: usize) -> Sample {
        let &OfPixel { first_ray, first_sample, .. } = &self.pixels[self.of_rays[ray] as usize];
        Sample { index: first_sample.index + (ray - first_ray) as u32, ..first_sample }
    }
}

impl<'a> CameraRays<'a> {
    pub(crate) fn new(scene: &'a Scene, settings: &'a Settings) -> Self {
        let tracer = Tracer::new(scene, settings);
        let together = (INCIDENTS_TOGETHER / tracer.lights_asked().max(1)).clamp(FEWEST_TOGETHER, TOGETHER);
        let lit = Lit::new(&tracer);
        Self {
            tracer,
            lost: LostRays::default(),
            together,
            samples: Samples::default(),
            in_picture: [DVec2::ZERO; TOGETHER],
            on_lens: [DVec2::ZERO; TOGETHER],
            rays: Vec::with_capacity(together),
            hits: [None; TOGETHER],
            lit,
            colors: [Color::BLACK; TOGETHER],
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
            let asked = self.samples.of_rays.len();
            let count = ((indices.end - index) as usize).min(self.together - asked);
            let first = Sample { index, ..first };
            let next = asked..asked + count;
            self.tracer.places(first, &mut self.in_picture[next.clone()], &mut self.on_lens[next]);
            self.samples.add(count, OfPixel { number: pixel, first_ray: asked, first_sample: first });
            index += count as u32;
            if asked + count == self.together {
                self.tell(told);
            }
        }
    }

    /// Tells of all rays that have been asked for and not yet told.
    pub(crate) fn tell(&mut self, told: &mut impl FnMut(usize, Color)) {
        if self.tracer.has_lights() {
            self.tell_of::<Surface>(told);
        } else {
            self.tell_of::<OnceCell<Surface>>(told);
        }
    }

    fn tell_of<S: Sight>(&mut self, told: &mut impl FnMut(usize, Color)) {
        let Self { tracer, lost, samples, in_picture, on_lens, rays, lit, .. } = self;
        let asked = samples.of_rays.len();
        tracer.camera_rays(samples, &mut in_picture[..asked], &on_lens[..asked], rays);
        let hits = &mut self.hits[..rays.len()];
        tracer.camera_hits(rays, hits);
        // What those rays see that meet something.
        let mut points = Vec::with_capacity(rays.len());
        for (number, (ray, hit)) in rays.iter().zip(&*hits).enumerate() {
            if let Some(hit) = hit {
                points.push(Point::<S> { ray: number, seen: tracer.seen(ray, hit) });
            }
        }
        lit.ask(tracer, samples, &points);
        let colors = &mut self.colors[..rays.len()];
        colors.fill(tracer.background());
        for (number, point) in points.iter().enumerate() {
            colors[point.ray] = tracer.camera_color(samples, point, lit.at(number));
        }
        for (&color, &of_ray) in colors.iter().zip(&samples.of_rays) {
            let pixel = &samples.pixels[of_ray as usize];
            told(pixel.number, lost.checked(color, || pixel.first_sample.pixel));
        }
        samples.clear();
        rays.clear();
    }

    /// The rays of all kinds traced since this was last asked, and the camera rays lost.
    pub(crate) fn take_counts(&mut self) -> (RayCounts, LostRays) {
        (self.tracer.take_counts(), std::mem::take(&mut self.lost))
    }
}
