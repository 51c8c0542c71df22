use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};

use render::{Film, Modules, Settings};

use crate::args::BenchArguments;
use crate::input::{ReadyScene, SceneSource};
use crate::options::{AcceleratorName, RenderOptions};
use crate::output::{check_place, print, write_file};
use crate::progress::Progress;
use crate::report::{self, Failure, Show};
use crate::scenes;
use crate::table::{Align, markdown};

/// The edge of buckets of scenes with many primitives without the accelerator: small, so that one bucket does not overrun the limit.
const SMALL_BUCKETS: u32 = 4;
const MANY_PRIMITIVES: usize = 500;

/// The report's own table (section 5): scene, with and without the octree.
const REPORT: [(&str, &str, &str); 4] = [
    ("bunny", "11 s", "> 20 min"),
    ("chainlink", "> 20 min", "> 20 min"),
    ("hand", "7 min", "> 20 min"),
    ("marbles", "23 s", "> 20 min"),
];

pub(crate) fn run(arguments: &BenchArguments, modules: Modules) -> Result<(), Failure> {
    arguments.output.as_deref().map_or(Ok(()), check_place)?;
    let sources = sources(&arguments.scenes)?;
    let mut rows = Vec::new();
    let mut left_out = Vec::new();
    for source in &sources {
        match measure(source, arguments, modules) {
            Ok(row) => rows.push(row),
            Err(failure) => {
                report::failure(&failure);
                left_out.push(source.label().to_owned());
            }
        }
    }
    let table = table(&rows);
    print(&table)?;
    if let Some(path) = &arguments.output {
        write_file(path, table.as_bytes())?;
    }
    if left_out.is_empty() { Ok(()) } else { Err(Failure::new(format!("left out: {}", left_out.join(", ")))) }
}

/// The scenes to measure: built-in ones, files, and the files of folders.
fn sources(wanted: &[String]) -> Result<Vec<SceneSource>, Failure> {
    if wanted.is_empty() {
        return Ok(scenes::all().iter().map(SceneSource::embedded).collect());
    }
    let mut sources = Vec::new();
    for scene in wanted {
        let path = Path::new(scene);
        if path.is_dir() {
            sources.extend(SceneSource::folder(path)?);
        } else {
            sources.push(SceneSource::find(scene)?);
        }
    }
    Ok(sources)
}

/// What was measured of a scene.
struct Row {
    name: String,
    size: [u32; 2],
    primitives: usize,
    one_thread: Duration,
    threads: usize,
    all_threads: Duration,
    /// `None`: over the limit.
    without: Option<Duration>,
    limit: f64,
    rays: u64,
}

fn measure(source: &SceneSource, arguments: &BenchArguments, modules: Modules) -> Result<Row, Failure> {
    let options = &arguments.options;
    let parsed = source.parse(&modules);
    let assemble = |options: &RenderOptions, show| source.assemble(&parsed, options, modules, show);
    let with = assemble(options, Show::Errors)?;
    let threads = with.settings.threads.map_or_else(available_threads, usize::from);

    let named = |what: &str| Progress::start(&format!("{}, {what}", source.name), arguments.quiet);
    let alone = Settings { threads: NonZeroUsize::new(1), ..with.settings.clone() };
    let (mut all_threads, mut one_thread, mut film) = (Vec::new(), Vec::new(), None);
    for _ in 0..arguments.repeat.get() {
        let (rendered, time) = unlimited(&with, &with.settings, &named("all threads"))?;
        all_threads.push(time);
        one_thread.push(unlimited(&with, &alone, &named("one thread"))?.1);
        film = Some(rendered);
    }
    let film = film.ok_or_else(broken_off)?;
    let without = assemble(&options.with_accelerator(AcceleratorName::None), Show::Errors)?;
    let primitives = with.assembled.scene.inventory(&with.settings).bounded.total();
    let mut small = without.settings.clone();
    if primitives > MANY_PRIMITIVES {
        small.buckets.size = small.buckets.size.min(SMALL_BUCKETS);
    }
    let limit = Some(Duration::from_secs_f64(arguments.limit));
    let unaided = timed(&without, &small, &named("without accelerator"), limit);
    if unaided.as_ref().is_some_and(|(other, _)| other.pixels != film.pixels) {
        return Err(Failure::new(format!("`{}` looks different with and without the accelerator", source.label())));
    }
    Ok(Row {
        name: source.name.clone(),
        size: [film.width, film.height],
        primitives,
        one_thread: median(one_thread),
        threads,
        all_threads: median(all_threads),
        without: unaided.map(|(_, time)| time),
        limit: arguments.limit,
        rays: film.rays.total(),
    })
}

fn available_threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort();
    times[times.len() / 2]
}

/// Renders within a limit; `None` if it was reached.
fn timed(
    ready: &ReadyScene,
    settings: &Settings,
    progress: &Progress,
    limit: Option<Duration>,
) -> Option<(Film, Duration)> {
    let start = Instant::now();
    let film = ready.assembled.scene.render(settings, &|bucket| {
        progress.advance(bucket.finished, bucket.total);
        if limit.is_some_and(|limit| start.elapsed() > limit) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    progress.finish();
    film.map(|film| (film, start.elapsed()))
}

fn unlimited(ready: &ReadyScene, settings: &Settings, progress: &Progress) -> Result<(Film, Duration), Failure> {
    timed(ready, settings, progress, None).ok_or_else(broken_off)
}

fn broken_off() -> Failure {
    Failure::new("the rendering was broken off")
}

fn table(rows: &[Row]) -> String {
    let threads = rows.first().map_or(1, |row| row.threads);
    let all = format!("{threads} threads");
    let without = format!("without, {threads} thr.");
    let headings = [
        ("scene", Align::Left),
        ("pixels", Align::Right),
        ("primitives", Align::Right),
        ("1 thread", Align::Right),
        (&all, Align::Right),
        ("ratio", Align::Right),
        (&without, Align::Right),
        ("gain", Align::Right),
        ("Mrays/s", Align::Right),
        ("report", Align::Right),
        ("without", Align::Right),
    ];
    let cells: Vec<Vec<String>> = rows.iter().map(cells).collect();
    markdown(&headings, &cells)
}

fn cells(row: &Row) -> Vec<String> {
    let all_threads = row.all_threads.as_secs_f64();
    let (without, gain) = match row.without {
        Some(time) => (seconds(time), format!("{:.1}", time.as_secs_f64() / all_threads)),
        None => (format!("> {} s", row.limit), format!("> {:.0}", row.limit / all_threads)),
    };
    let (report_with, report_without) =
        REPORT.iter().find(|(name, ..)| *name == row.name).map_or(("", ""), |&(_, with, without)| (with, without));
    vec![
        row.name.clone(),
        format!("{} x {}", row.size[0], row.size[1]),
        row.primitives.to_string(),
        seconds(row.one_thread),
        seconds(row.all_threads),
        format!("{:.2}", row.one_thread.as_secs_f64() / all_threads),
        without,
        gain,
        format!("{:.2}", row.rays as f64 / all_threads / 1e6),
        report_with.to_owned(),
        report_without.to_owned(),
    ]
}

fn seconds(time: Duration) -> String {
    format!("{:.2} s", time.as_secs_f64())
}
