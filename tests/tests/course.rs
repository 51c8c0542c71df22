//! The course's own scenes, which are no part of this repository. Set `GIRASOL_SHARED` to a folder with
//!
//! ```text
//! scenes/course/*.sc  scenes/group/*.sc        the scenes
//! reference/sunflow/course/NAME.png            Sunflow's picture of each, alpha > 0 where it hit something
//! ```
//!
//! and run `cargo test -p tests --test course -- --nocapture`.
#![expect(clippy::print_stdout, reason = "a table for whoever runs it")]

use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};

use glam::DVec2;
use render::{Assembled, Film, Lighting, Modules, Scene};
use scene_format::Severity;
use shading::Falloff;
use tests::{Beside, scenes_of, shared_folder};

/// The longest that any scene may take: generous, against a rendering that never ends.
const LONGEST: Duration = Duration::from_secs(120);

/// Pixels by which an outline may be off.
const TOLERANCE: i64 = 1;

/// The most pixels of a picture that may differ at all: rays that graze an edge.
const MOST_DIFFERING: usize = 10;

fn assembled(path: &Path, falloff: Falloff) -> Assembled {
    let text = scene_format::decode(&fs::read(path).unwrap()).unwrap();
    let files = Beside(path.parent().unwrap().to_owned());
    let parsed = scene_format::parse(&path.to_string_lossy(), &text, &files);
    let errors: Vec<_> = parsed.diagnostics.iter().filter(|found| found.severity == Severity::Error).collect();
    assert!(errors.is_empty(), "{}: {errors:#?}", path.display());
    let modules = Modules { falloff, ..Modules::default() };
    let assembled = render::assemble(&parsed.scene, &modules, &Lighting::default(), &files);
    assembled.unwrap_or_else(|errors| panic!("{}: {errors:#?}", path.display()))
}

fn film(path: &Path, falloff: Falloff) -> Film {
    let start = Instant::now();
    let Assembled { scene, settings, .. } = assembled(path, falloff);
    let film = render::render(&scene, &settings, &|_| {
        if start.elapsed() > LONGEST { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let film = film.unwrap_or_else(|| panic!("{} takes longer than {LONGEST:?}", path.display()));
    println!("{}: {} x {}, {:.2} s", path.display(), film.width, film.height, start.elapsed().as_secs_f64());
    film
}

#[test]
fn every_scene_of_the_course_renders_at_its_own_settings() {
    let Some(shared) = shared_folder() else { return };
    for path in ["scenes/course", "scenes/group"].into_iter().flat_map(|folder| scenes_of(&shared.join(folder))) {
        let shows_something = |film: &Film| film.pixels.iter().any(|pixel| *pixel != film.pixels[0]);
        let mut film = film(&path, shading::linear_falloff);
        if !shows_something(&film) {
            // Lights of a power of 2 at a distance of 20: made for the report's first falloff, which has no end.
            film = self::film(&path, shading::logarithmic_falloff);
        }
        assert!(shows_something(&film), "{} is of one colour", path.display());
        assert!(film.pixels.iter().all(|pixel| pixel.to_array().into_iter().all(f32::is_finite)), "{}", path.display());
    }
}

/// Which pixels of a picture something covers, row by row from the top.
struct Silhouette {
    width: i64,
    height: i64,
    covered: Vec<bool>,
}

impl Silhouette {
    fn of_reference(path: &Path) -> Self {
        let picture = image::load_from_memory(&fs::read(path).unwrap()).unwrap().into_rgba8();
        let covered = picture.pixels().map(|pixel| pixel.0[3] > 0).collect();
        Self { width: picture.width().into(), height: picture.height().into(), covered }
    }

    /// One ray a pixel, along those of Sunflow: it numbers a pixel's centre x + 0.5 from the left and y + 0.5 from the bottom, and
    /// divides by W - 1 and H - 1.
    fn of_scene(scene: &Scene, [width, height]: [u32; 2]) -> Self {
        let centre = |at: u32, count: u32| (f64::from(at) + 0.5) / f64::from(count - 1);
        let covered = (0..height)
            .rev()
            .flat_map(|y| (0..width).map(move |x| DVec2::new(centre(x, width), centre(y, height))))
            .map(|place| scene.closest(&scene.camera().ray(place, &|| DVec2::splat(0.5))).is_some())
            .collect();
        Self { width: width.into(), height: height.into(), covered }
    }

    fn at(&self, x: i64, y: i64) -> Option<bool> {
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        inside.then(|| self.covered[(y * self.width + x) as usize])
    }

    /// Whether there is a pixel of a kind within the tolerance.
    fn has_near(&self, kind: bool, x: i64, y: i64) -> bool {
        let near = -TOLERANCE..=TOLERANCE;
        near.clone().any(|dy| near.clone().any(|dx| self.at(x + dx, y + dy) == Some(kind)))
    }
}

#[test]
fn silhouettes_agree_with_sunflow_s() {
    let Some(shared) = shared_folder() else { return };
    let mut beyond_tolerance = 0;
    let mut compared = 0;
    for path in scenes_of(&shared.join("scenes/course")) {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let reference = shared.join("reference/sunflow/course").join(format!("{name}.png"));
        if !reference.exists() {
            continue;
        }
        let reference = Silhouette::of_reference(&reference);
        let Assembled { scene, settings, .. } = assembled(&path, shading::linear_falloff);
        let ours = Silhouette::of_scene(&scene, settings.size);
        assert_eq!((ours.width, ours.height), (reference.width, reference.height), "{name}");
        let places = (0..ours.height).flat_map(|y| (0..ours.width).map(move |x| (x, y)));
        let differing: Vec<_> = places.filter(|&(x, y)| ours.at(x, y) != reference.at(x, y)).collect();
        let beyond: Vec<_> = differing
            .iter()
            .filter(|&&(x, y)| ours.at(x, y).is_some_and(|kind| !reference.has_near(kind, x, y)))
            .collect();
        println!(
            "{name}: {} of {} pixels covered, {} differ, {} beyond {TOLERANCE} pixel: {:?}",
            reference.covered.iter().filter(|&&covered| covered).count(),
            reference.covered.len(),
            differing.len(),
            beyond.len(),
            &beyond[..beyond.len().min(5)]
        );
        assert!(differing.len() <= MOST_DIFFERING, "{name}");
        beyond_tolerance += beyond.len();
        compared += 1;
    }
    assert!(compared > 0, "there is no reference");
    assert_eq!(beyond_tolerance, 0);
}
