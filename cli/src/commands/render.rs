use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use render::{Crop, Film, LostRays, Modules};
use shading::Color;

use crate::args::RenderArguments;
use crate::input::SceneSource;
use crate::interrupt::Interrupt;
use crate::output::{PictureFormat, check_place, write_file};
use crate::progress::Progress;
use crate::report::{self, Failure, Show};

pub(crate) fn run(arguments: &RenderArguments, modules: Modules) -> Result<(), Failure> {
    let interrupt = Interrupt::listen()?;
    let mut clock = Clock::start();
    let source = SceneSource::find(&arguments.scene.scene)?;
    let output = arguments.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}.png", source.name)));
    let format = PictureFormat::of(&output)?;
    check_place(&output)?;
    let parsed = source.parse(&arguments.options.modules(modules));
    clock.lap("reading");

    let show = if arguments.quiet { Show::Errors } else { Show::BeforeRendering };
    let ready = source.assemble(&parsed, &arguments.options, modules, show)?;
    if arguments.strict {
        report::refuse_warnings(source.label(), &parsed.diagnostics, &ready.assembled.warnings)?;
    }
    clock.lap("assembling");

    let progress = Progress::start(&source.name, arguments.quiet);
    let film = ready.assembled.scene.render(&ready.settings, &|bucket| {
        progress.advance(bucket.finished, bucket.total);
        ControlFlow::Continue(())
    });
    progress.finish();
    let film = film.ok_or_else(|| Failure::new("the rendering was broken off"))?;
    clock.lap("rendering");

    let shown = if arguments.show_nan { &marked(&film, ready.settings.window()) } else { &film };
    let bytes = format.encode(shown)?;
    interrupt.undivided(|| write_file(&output, &bytes))?;
    clock.lap("writing");

    if !arguments.quiet {
        if is_uniform(&film) && ready.assembled.scene.inventory(&ready.settings).lights > 0 {
            report::warning(
                "the whole picture has one colour",
                "perhaps no light reaches what the camera sees: with the linear falloff a light ends at a distance of its power, with \
                 `--falloff log` it does not",
            );
        }
        warn_of_lost_rays(&film.lost);
        let (width, height) = (film.width, film.height);
        report::line(format!("{}: {width} x {height} pixels in {}", output.display(), seconds(clock.total())));
    }
    if arguments.time {
        let rendering = clock.laps[2].1.as_secs_f64();
        for (step, time) in &clock.laps {
            report::line(format!("{step:>12} {}", seconds(*time)));
        }
        let rays = film.rays;
        report::line(format!(
            "{:>12} {} camera, {} secondary, {} shadow: {:.2} million a second",
            "rays",
            rays.camera,
            rays.secondary,
            rays.shadow,
            rays.total() as f64 / rendering / 1e6
        ));
    }
    Ok(())
}

/// Says where a picture lacks light.
fn warn_of_lost_rays(lost: &LostRays) {
    const NAMED: usize = 3;
    if lost.count == 0 {
        return;
    }
    let places: Vec<_> = lost.pixels.iter().take(NAMED).map(|[x, y]| format!("({x}, {y})")).collect();
    let more = if lost.pixels.len() > NAMED { " ..." } else { "" };
    report::warning(
        &format!("the light of {} rays is no number: pixels {}{more}", lost.count, places.join(", ")),
        "NaN, infinite or beyond 7.9e28, and counted as black; `--show-nan` shows all such pixels. Look for numbers in the scene that \
         overflow, or in a shader of your own for a division by 0 or the root of a negative number",
    );
}

/// The picture of a window dimmed to a quarter, and magenta where rays were lost.
fn marked(film: &Film, window: Crop) -> Film {
    let mut marked = film.clone();
    for pixel in &mut marked.pixels {
        *pixel = *pixel * 0.25;
    }
    for [x, y] in &film.lost.pixels {
        let index = (y - window.y) as usize * film.width as usize + (x - window.x) as usize;
        marked.pixels[index] = Color::new(1.0, 0.0, 1.0);
    }
    marked
}

fn is_uniform(film: &Film) -> bool {
    film.pixels.len() > 1 && film.pixels.windows(2).all(|pair| pair[0] == pair[1])
}

/// Which step took how long.
struct Clock {
    last: Instant,
    laps: Vec<(&'static str, Duration)>,
}

impl Clock {
    fn start() -> Self {
        Self { last: Instant::now(), laps: Vec::new() }
    }

    fn lap(&mut self, step: &'static str) {
        self.laps.push((step, self.last.elapsed()));
        self.last = Instant::now();
    }

    fn total(&self) -> Duration {
        self.laps.iter().map(|(_, time)| *time).sum()
    }
}

fn seconds(time: Duration) -> String {
    format!("{:.3} s", time.as_secs_f64())
}
