use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::path::Path;

use glam::DVec2;
use image::{ImageFormat, RgbImage};
use render::{Crop, Film, Modules, Purpose, Sample, Scene, Settings, centred};
use scene_format::FileError;

use crate::args::ParityArguments;
use crate::comparison::{Comparison, lies_among};
use crate::input::{SceneSource, read};
use crate::options::RenderOptions;
use crate::output::{print, write_file};
use crate::progress::Progress;
use crate::report::{self, Failure, Show};
use crate::table::{Align, markdown};

/// By how much a channel may differ, of 255.
const CLOSE: u8 = 2;

/// The smallest share of pixels that must be close.
const LEAST_CLOSE: f64 = 0.995;

/// How far a picture with a lens may be off, as the root of its mean square: either picture has noise of its own.
const MOST_NOISE: f64 = 0.01;

/// Pixels that are off are looked into, up to so many of a scene. There are few, or something is wrong with all of them.
const LOOKED_INTO: usize = 1000;

/// So many pixels of a scene are listed that no edge explains.
const LISTED: usize = 10;

/// What a picture must come to.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Target {
    /// Almost every pixel must be close, and no other one off but at an edge.
    Close,
    /// Only the mean must be.
    Noise,
}

/// A scene's picture and its reference, compared.
struct Compared {
    name: String,
    ours: RgbImage,
    reference: RgbImage,
    found: Comparison,
    target: Target,
    /// The pixels that are not close and that no edge explains.
    unexplained: Vec<[u32; 2]>,
}

impl Compared {
    fn meets_its_target(&self) -> bool {
        match self.target {
            Target::Close => self.found.share_within(CLOSE) >= LEAST_CLOSE && self.unexplained.is_empty(),
            Target::Noise => self.found.rmse <= MOST_NOISE,
        }
    }
}

pub(crate) fn run(arguments: &ParityArguments, modules: Modules) -> Result<(), Failure> {
    if let Some(folder) = arguments.difference.as_deref().filter(|folder| !folder.is_dir()) {
        return Err(
            Failure::new(format!("there is no folder `{}` to write to", folder.display())).help("make it first")
        );
    }
    let mut compared = Vec::new();
    let mut failed = Vec::new();
    for source in SceneSource::folder(&arguments.scenes)? {
        match compare(&source, arguments, modules) {
            Ok(scene) => compared.push(scene),
            Err(failure) => {
                report::failure(&failure);
                failed.push(source.name);
            }
        }
    }
    print(&table(&compared))?;
    if let Some(list) = unexplained(&compared) {
        print(&list)?;
    }
    failed.extend(compared.into_iter().filter(|scene| !scene.meets_its_target()).map(|scene| scene.name));
    if failed.is_empty() { Ok(()) } else { Err(Failure::new(format!("missed: {}", failed.join(", ")))) }
}

fn compare(source: &SceneSource, arguments: &ParityArguments, modules: Modules) -> Result<Compared, Failure> {
    let reference = reference(&arguments.references, &source.name)?;
    let modules = Modules { sampler: beside_the_centre, ..modules.lit_as_by_sunflow() };
    let parsed = source.parse(&modules);
    let ready = source.assemble(&parsed, &RenderOptions::default(), modules, Show::BeforeRendering)?;
    let scene = &ready.assembled.scene;
    let progress = Progress::start(&source.name, arguments.quiet);
    let film = scene.render(&ready.settings, &|bucket| {
        progress.advance(bucket.finished, bucket.total);
        ControlFlow::Continue(())
    });
    progress.finish();
    let ours = film.as_ref().and_then(picture).ok_or_else(|| Failure::new("the rendering was broken off"))?;
    let found = Comparison::of(&ours, &reference).ok_or_else(|| {
        let size = |picture: &RgbImage| format!("{} x {}", picture.width(), picture.height());
        let message = format!("the reference of `{}` is of {} pixels", source.name, size(&reference));
        Failure::new(message).help(format!("the scene asks for {}: both must be rendered alike", size(&ours)))
    })?;
    let (target, unexplained) = if scene.camera().has_lens() {
        (Target::Noise, Vec::new())
    } else {
        let explained = |(index, at): (usize, [u32; 2])| {
            let [x, y] = at;
            index < LOOKED_INTO && edge_explains(scene, &ready.settings, at, reference.get_pixel(x, y).0)
        };
        let off = found.off_by_more_than(CLOSE).enumerate();
        (Target::Close, off.filter(|&pixel| !explained(pixel)).map(|(_, at)| at).collect())
    };
    if let Some(folder) = &arguments.difference {
        let mut bytes = std::io::Cursor::new(Vec::new());
        let written = found.picture(&unexplained).write_to(&mut bytes, ImageFormat::Png);
        written.map_err(|error| Failure::of("the picture cannot be encoded", error))?;
        write_file(&folder.join(format!("{}.png", source.name)), bytes.get_ref())?;
    }
    Ok(Compared { name: source.name.clone(), ours, reference, found, target, unexplained })
}

/// Rays beside a pixel's own, which goes through its centre: so many places along each edge of a square, this far apart in pixels.
const ALONG: u32 = 9;
const APART: f64 = 0.005;

/// Rays in the middle of each zone; with a seed all of a pixel's rays go through the place of that number beside its centre, counted from 1,
/// row by row.
fn beside_the_centre(first: Sample, points: &mut [DVec2]) {
    match first.purpose {
        Purpose::Pixel if first.seed > 0 => {
            let place = [(first.seed - 1) % ALONG, (first.seed - 1) / ALONG];
            let middle = f64::from(ALONG - 1) / 2.0;
            points.fill(DVec2::from(place.map(|number| 0.5 + (f64::from(number) - middle) * APART)));
        }
        _ => centred(first, points),
    }
}

/// Whether a border of a body, a shadow or a texel explains that a pixel has another colour than in the reference: it passes so near the
/// pixel's ray that rounding decides on its side, so rays beside it see colours around that one.
fn edge_explains(scene: &Scene, settings: &Settings, [x, y]: [u32; 2], expected: [u8; 3]) -> bool {
    let crop = Some(Crop { x, y, width: 1, height: 1 });
    let seen = |seed| {
        let settings = Settings { crop, aa: 0, samples: 2, seed, threads: NonZeroUsize::new(1), ..settings.clone() };
        let film = scene.render(&settings, &|_| ControlFlow::Continue(()))?;
        film.to_srgb_bytes().first_chunk().copied()
    };
    let colors: Vec<[u8; 3]> = (1..=ALONG * ALONG).filter_map(seen).collect();
    lies_among(expected, &colors, CLOSE)
}

fn picture(film: &Film) -> Option<RgbImage> {
    RgbImage::from_raw(film.width, film.height, film.to_srgb_bytes())
}

fn reference(folder: &Path, name: &str) -> Result<RgbImage, Failure> {
    let path = folder.join(format!("{name}.png"));
    let failed = |reason: String| {
        Failure::of(format!("the reference `{}` cannot be read", path.display()), reason)
            .help("each scene NAME.sc needs Sunflow's picture of it as NAME.png in the folder of references")
    };
    let bytes = read(&path).map_err(|error| match error {
        FileError::NotFound => failed("there is no such file".to_owned()),
        FileError::Unreadable(reason) => failed(reason),
    })?;
    let decoded = image::load_from_memory_with_format(&bytes, ImageFormat::Png);
    Ok(decoded.map_err(|error| failed(error.to_string()))?.into_rgb8())
}

fn table(compared: &[Compared]) -> String {
    let percent = |share: f64| format!("{:.3}", 100.0 * share);
    let row = |scene: &Compared| {
        vec![
            scene.name.clone(),
            percent(scene.found.share_within(CLOSE)),
            percent(scene.found.share_within(6)),
            scene.found.largest().to_string(),
            scene.unexplained.len().to_string(),
            format!("{:.5}", scene.found.rmse),
            match scene.target {
                Target::Close => format!("{} % within {CLOSE}, 0 unexplained", 100.0 * LEAST_CLOSE),
                Target::Noise => format!("RMSE {MOST_NOISE}"),
            },
            if scene.meets_its_target() { "met" } else { "missed" }.to_owned(),
        ]
    };
    let headings = [
        ("scene", Align::Left),
        ("% within 2", Align::Right),
        ("% within 6", Align::Right),
        ("largest", Align::Right),
        ("unexplained", Align::Right),
        ("RMSE", Align::Right),
        ("target", Align::Left),
        ("", Align::Left),
    ];
    markdown(&headings, &compared.iter().map(row).collect::<Vec<_>>())
}

/// The pixels that no edge explains; `None` if there are none.
fn unexplained(compared: &[Compared]) -> Option<String> {
    let mut rows = Vec::new();
    for Compared { name, ours, reference, unexplained, .. } in compared {
        let color = |picture: &RgbImage, [x, y]: [u32; 2]| {
            let [r, g, b] = picture.get_pixel(x, y).0;
            format!("{r} {g} {b}")
        };
        let listed = unexplained.iter().take(LISTED);
        rows.extend(
            listed
                .map(|&at| vec![name.clone(), format!("{}, {}", at[0], at[1]), color(ours, at), color(reference, at)]),
        );
    }
    let headings =
        [("scene", Align::Left), ("pixel", Align::Right), ("ours", Align::Right), ("Sunflow's", Align::Right)];
    (!rows.is_empty()).then(|| {
        format!(
            "\nOff by more than {CLOSE}, and no edge beside them (the first {LISTED} of a scene):\n\n{}",
            markdown(&headings, &rows)
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_choose_places_a_fiftieth_of_a_pixel_around_the_centre() {
        let place = |seed| {
            let sample = Sample { seed, pixel: [3, 4], zones: 1, count: 2, index: 1, purpose: Purpose::Pixel };
            let mut point = [DVec2::ZERO];
            beside_the_centre(sample, &mut point);
            point[0]
        };
        assert_eq!([place(0), place(41)], [DVec2::splat(0.5); 2]);
        let near = |found: DVec2, x: f64, y: f64| (found - DVec2::new(x, y)).length() < 1e-12;
        assert!(near(place(1), 0.48, 0.48) && near(place(2), 0.485, 0.48) && near(place(81), 0.52, 0.52));
    }
}
