//! Pictures of a scene with every sampling setting, against a reference.

use std::ops::ControlFlow;
use std::time::Instant;

use render::{Allotment, Buckets, Film, Modules, Settings};

use super::curve::Point;
use super::samplings::Sampling;
use crate::input::{ReadyScene, SceneSource};
use crate::metrics::{PIXELS_PER_DEGREE, flip, rmse};
use crate::options::RenderOptions;
use crate::report::{Failure, Show};
use crate::scenes::EmbeddedScene;

/// The reference is the mean of two pictures of 512 rays a pixel: 2^4 x 2^4 zones with two rays each.
const REFERENCE_AA: u32 = 4;
const REFERENCE_SAMPLES: u32 = 2;
/// What is added to the seed for their numbers, so that no picture that is judged has the same: the reference must not know its noise.
const REFERENCE_SEEDS: [u32; 2] = [1_000_001, 1_000_002];

/// Small buckets, so that all threads have work to the end of a small picture.
const BUCKETS: u32 = 8;

/// What was measured of a scene.
pub(crate) struct Study {
    /// Its name.
    pub(crate) scene: &'static str,
    /// Of the pictures.
    pub(crate) size: [u32; 2],
    /// Camera rays a pixel of the reference.
    pub(crate) reference_rays: u32,
    /// How far the reference itself is from the truth, as RMSE: half the distance of its two halves.
    pub(crate) reference_error: f64,
    /// For each sampling, its points by rising cost.
    pub(crate) curves: Vec<Vec<Point>>,
}

/// How often [`study`] tells that it is further.
pub(crate) const STEPS: usize = 2;

/// Measures a scene at a width in pixels. The errors depend on the seed alone. `advance` is called [`STEPS`] times.
pub(crate) fn study(
    scene: &'static EmbeddedScene,
    width: u32,
    seed: u32,
    modules: Modules,
    samplings: &[Sampling],
    advance: &dyn Fn(),
) -> Result<Study, Failure> {
    let source = SceneSource::embedded(scene);
    let parsed = source.parse(&modules);
    let ready = |sampler| -> Result<ReadyScene, Failure> {
        let modules = Modules { sampler, ..modules };
        let ready = source.assemble(&parsed, &RenderOptions::default(), modules, Show::Errors)?;
        let settings = small(&ready.settings, width, seed);
        Ok(ReadyScene { settings, ..ready })
    };
    let best = ready(render::sobol)?;
    let size = best.settings.size;
    let reference = Reference::render(&best)?;
    advance();
    let scenes = samplings.iter().map(|sampling| ready(sampling.sampler)).collect::<Result<Vec<_>, _>>()?;
    let mut sums: Vec<Vec<Sums>> =
        samplings.iter().map(|sampling| vec![Sums::default(); sampling.steps.len()]).collect();
    // One picture of each in turn, so that whatever else the machine does meets all alike.
    for number in 0..samplings.iter().flat_map(|sampling| &sampling.steps).map(|step| step.pictures).max().unwrap_or(0)
    {
        for ((sampling, ready), sums) in samplings.iter().zip(&scenes).zip(&mut sums) {
            for (step, sums) in sampling.steps.iter().zip(sums).filter(|(step, _)| number < step.pictures) {
                let settings = step.settings(&ready.settings);
                let seed = settings.seed.wrapping_add(number);
                sums.add(ready, &Settings { seed, light_samples: sampling.light_samples, ..settings }, &reference)?;
            }
        }
    }
    advance();
    let pixels = f64::from(size[0]) * f64::from(size[1]);
    let curve = |sums: Vec<Sums>| sums.into_iter().map(|sums| sums.point(pixels)).collect();
    let curves = sums.into_iter().map(curve).collect();
    let reference_rays = 2 * (1 << (2 * REFERENCE_AA)) * REFERENCE_SAMPLES;
    Ok(Study { scene: scene.name, size, reference_rays, reference_error: reference.error, curves })
}

fn small(settings: &Settings, width: u32, seed: u32) -> Settings {
    let [w, h] = settings.size;
    let height = (width * h + w / 2) / w;
    let buckets = Buckets { size: BUCKETS, ..settings.buckets };
    Settings { size: [width, height.max(1)], buckets, seed, allotment: Allotment::Even, ..settings.clone() }
}

/// What a picture is held against.
struct Reference {
    film: Film,
    error: f64,
}

impl Reference {
    fn render(ready: &ReadyScene) -> Result<Self, Failure> {
        let half = |number| {
            let seed = ready.settings.seed.wrapping_add(number);
            let settings = Settings { aa: REFERENCE_AA, samples: REFERENCE_SAMPLES, seed, ..ready.settings.clone() };
            picture(ready, &settings)
        };
        let [mut film, other] = [half(REFERENCE_SEEDS[0])?, half(REFERENCE_SEEDS[1])?];
        let error = rmse(&film, &other).map_err(not_compared)? / 2.0;
        for (pixel, other) in film.pixels.iter_mut().zip(other.pixels) {
            *pixel = (*pixel + other) / 2.0;
        }
        Ok(Self { film, error })
    }
}

/// What the pictures of a point have in all.
#[derive(Clone, Copy, Default)]
struct Sums {
    pictures: u32,
    seconds: Option<f64>,
    squares: f64,
    flips: f64,
    camera: u64,
    rays: u64,
}

impl Sums {
    /// Renders one more.
    fn add(&mut self, ready: &ReadyScene, settings: &Settings, reference: &Reference) -> Result<(), Failure> {
        let start = Instant::now();
        let film = picture(ready, settings)?;
        let seconds = start.elapsed().as_secs_f64();
        let error = rmse(&reference.film, &film).map_err(not_compared)?;
        let flip = flip(&reference.film, &film, PIXELS_PER_DEGREE).map_err(not_compared)?;
        self.pictures += 1;
        self.seconds = Some(self.seconds.map_or(seconds, |least| least.min(seconds)));
        self.squares += error * error;
        self.flips += flip.mean();
        self.camera += film.rays.camera;
        self.rays += film.rays.total();
        Ok(())
    }

    /// Of a picture of so many pixels.
    fn point(self, pixels: f64) -> Point {
        let pictures = f64::from(self.pictures);
        Point {
            rays_per_pixel: self.camera as f64 / pictures / pixels,
            rays: self.rays as f64 / pictures,
            seconds: self.seconds.unwrap_or(f64::NAN),
            rmse: (self.squares / pictures).sqrt(),
            flip: self.flips / pictures,
        }
    }
}

fn picture(ready: &ReadyScene, settings: &Settings) -> Result<Film, Failure> {
    ready
        .assembled
        .scene
        .render(settings, &|_| ControlFlow::Continue(()))
        .ok_or_else(|| Failure::new("the rendering was broken off"))
}

fn not_compared(error: impl std::fmt::Display) -> Failure {
    Failure::of("pictures were not compared", error)
}

#[cfg(test)]
mod tests {
    use super::super::samplings::all;
    use super::*;
    use crate::scenes;

    fn studied(seed: u32) -> Study {
        let scene = scenes::find("glass-mirror").unwrap();
        let modules = Modules::default();
        study(scene, 12, seed, modules, &all(&modules)[..1], &|| {}).unwrap()
    }

    #[test]
    fn errors_are_the_same_on_every_run_and_others_with_another_seed() {
        let without_times = |study: Study| -> Vec<Point> {
            study.curves.into_iter().flatten().map(|point| Point { seconds: 0.0, ..point }).collect()
        };
        assert_eq!(without_times(studied(1)), without_times(studied(1)));
        assert_ne!(without_times(studied(1)), without_times(studied(2)));
    }

    #[test]
    fn the_reference_is_nearer_to_the_truth_than_what_it_judges() {
        let Study { reference_error, reference_rays, curves, .. } = studied(1);
        assert_eq!(reference_rays, 1024);
        for point in &curves[0] {
            assert!(reference_error < point.rmse / 3.0, "{reference_error}, {point:?}");
        }
    }

    #[test]
    fn a_point_is_the_mean_of_its_pictures() {
        let sums = Sums { pictures: 2, seconds: Some(0.5), squares: 0.5, flips: 0.5, camera: 24, rays: 48 };
        let point = Point { rays_per_pixel: 1.0, rays: 24.0, seconds: 0.5, rmse: 0.5, flip: 0.25 };
        assert_eq!(sums.point(12.0), point);
    }

    #[test]
    fn points_have_the_rays_that_they_say_and_more_rays_come_nearer() {
        let points = &studied(1).curves[0];
        assert_eq!(points.iter().map(|point| point.rays_per_pixel).collect::<Vec<_>>(), [1.0, 4.0, 16.0, 64.0]);
        assert!(points.windows(2).all(|pair| pair[0].rmse > pair[1].rmse && pair[0].flip > pair[1].flip), "{points:?}");
    }
}
