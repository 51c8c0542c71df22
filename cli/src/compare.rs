//! A scene rendered twice: with a program's own parts, and with some of them set back to the reference's.

mod page;
mod parts;
mod slider;
mod summary;

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use render::{Film, Modules};

use crate::args::CompareArguments;
use crate::input::{ReadyScene, SceneSource};
use crate::metrics::{ErrorMap, PIXELS_PER_DEGREE, flip, rmse};
use crate::parts::Part;
use crate::progress::Progress;
use crate::report::{Failure, Show};

pub(crate) use page::page;
pub(crate) use parts::{Parts, parse_parts};
pub(crate) use summary::summary;

/// Both pictures of a scene, and what they took.
pub(crate) struct Contest {
    /// The scene's name.
    pub(crate) scene: String,
    /// The parts that differ.
    pub(crate) parts: Vec<Part>,
    /// With the program's own parts.
    pub(crate) own: Side,
    /// With the reference's.
    pub(crate) reference: Side,
    /// What is seen of the difference.
    pub(crate) flip: ErrorMap,
    /// The root of the mean square difference in linear light.
    pub(crate) rmse: f64,
}

/// One of the two.
pub(crate) struct Side {
    pub(crate) film: Film,
    /// Putting the scene together: building the accelerator, reading textures.
    pub(crate) assembling: Duration,
    /// The median of the renderings.
    pub(crate) rendering: Duration,
}

impl Side {
    /// All kinds of rays, in a second of rendering.
    pub(crate) fn rays_per_second(&self) -> f64 {
        self.film.rays.total() as f64 / self.rendering.as_secs_f64()
    }
}

impl Contest {
    /// Renders with both, in turn, so that what else the machine does slows neither more than the other.
    pub(crate) fn hold(
        source: &SceneSource,
        arguments: &CompareArguments,
        modules: Modules,
        parts: &[Part],
    ) -> Result<Self, Failure> {
        let options = &arguments.options;
        let chosen = options.modules(modules);
        let reference = parts.iter().fold(chosen, |modules, part| part.set_back(modules));
        let reference_options = options.without_parts();
        let own_text = source.parse(&chosen);
        let reference_text = source.parse(&reference);
        let own = timed(|| source.assemble(&own_text, options, modules, Show::Errors));
        let reference = timed(|| source.assemble(&reference_text, &reference_options, reference, Show::Errors));
        let own = (own.0.map_err(|failure| failure.help("that was with this program's own parts"))?, own.1);
        let reference = (reference.0?, reference.1);
        let progress = Progress::counting("renderings", &source.name, arguments.quiet);
        let rounds = arguments.repeat.get() as usize;
        let mut times = [Vec::new(), Vec::new()];
        let mut films = [None, None];
        for round in 0..rounds {
            for (number, ready) in [&own.0, &reference.0].into_iter().enumerate() {
                progress.advance(2 * round + number, 2 * rounds);
                let (film, time) = timed(|| rendered(ready));
                films[number] = film;
                times[number].push(time);
            }
        }
        progress.finish();
        let [Some(own_film), Some(reference_film)] = films else {
            return Err(Failure::new("a rendering was broken off"));
        };
        let [own_time, reference_time] = times.map(median);
        let not_comparable = |error| {
            Failure::of("the pictures cannot be compared", error)
                .help("this program's own parts made another size of it than the reference's")
        };
        Ok(Self {
            scene: source.name.clone(),
            parts: parts.to_vec(),
            flip: flip(&own_film, &reference_film, PIXELS_PER_DEGREE).map_err(not_comparable)?,
            rmse: rmse(&own_film, &reference_film).map_err(not_comparable)?,
            own: Side { film: own_film, assembling: own.1, rendering: own_time },
            reference: Side { film: reference_film, assembling: reference.1, rendering: reference_time },
        })
    }

    /// The pixels, `[x, y]` in the picture, that have not the same bits, row by row.
    pub(crate) fn different(&self) -> impl Iterator<Item = [u32; 2]> {
        let bits = |film: &Film| film.pixels.iter().map(|pixel| pixel.to_array().map(f32::to_bits)).collect::<Vec<_>>();
        let width = self.own.film.width;
        let pairs = bits(&self.own.film).into_iter().zip(bits(&self.reference.film));
        let numbered = (0_u32..).zip(pairs).filter(|(_, (own, reference))| own != reference);
        numbered.map(move |(number, _)| [number % width, number / width])
    }
}

fn rendered(ready: &ReadyScene) -> Option<Film> {
    ready.assembled.scene.render(&ready.settings, &|_| ControlFlow::Continue(()))
}

fn timed<T>(work: impl FnOnce() -> T) -> (T, Duration) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed())
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort();
    times.get(times.len() / 2).copied().unwrap_or_default()
}
