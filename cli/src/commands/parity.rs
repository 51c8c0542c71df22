use std::ops::ControlFlow;
use std::path::Path;

use image::{ImageFormat, RgbImage};
use render::{Film, Modules, render};
use scene_format::FileError;

use crate::args::ParityArguments;
use crate::comparison::{CLOSE, Comparison};
use crate::input::{SceneSource, read};
use crate::options::RenderOptions;
use crate::output::{print, write_file};
use crate::progress::Progress;
use crate::report::{self, Failure, Show};
use crate::table::{Align, markdown};

/// By how much a channel may differ where there are textures: a ray that starts a rounding aside sees another part of a texel.
const CLOSE_WITH_TEXTURES: u8 = 6;

/// The smallest share of pixels that must be close.
const LEAST_CLOSE: f64 = 0.995;

/// How far a picture with a lens may be off, as the root of its mean square: either picture has noise of its own.
const MOST_NOISE: f64 = 0.01;

/// So many pixels of a scene are listed that no edge explains.
const LISTED: usize = 10;

/// What a picture must come to.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Target {
    /// Almost every pixel must be as close as that, and no other one off but at an edge.
    Close(u8),
    /// Only the mean must be.
    Noise,
}

impl Target {
    fn is_met(self, found: &Comparison) -> bool {
        match self {
            Self::Close(most) => found.share_within(most) >= LEAST_CLOSE && found.unexplained.is_empty(),
            Self::Noise => found.rmse <= MOST_NOISE,
        }
    }
}

/// A scene's picture and its reference, compared.
struct Compared {
    name: String,
    ours: RgbImage,
    reference: RgbImage,
    found: Comparison,
    target: Target,
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
    failed.extend(compared.into_iter().filter(|scene| !scene.target.is_met(&scene.found)).map(|scene| scene.name));
    if failed.is_empty() { Ok(()) } else { Err(Failure::new(format!("missed: {}", failed.join(", ")))) }
}

fn compare(source: &SceneSource, arguments: &ParityArguments, modules: Modules) -> Result<Compared, Failure> {
    let reference = reference(&arguments.references, &source.name)?;
    let options = RenderOptions::lit_as_by_sunflow();
    let parsed = source.parse(&options.modules(modules));
    let ready = source.assemble(&parsed, &options, modules, Show::BeforeRendering)?;
    let target = match ready.assembled.shading.textures.len() {
        _ if ready.assembled.scene.camera().has_lens() => Target::Noise,
        0 => Target::Close(CLOSE),
        _ => Target::Close(CLOSE_WITH_TEXTURES),
    };
    let progress = Progress::start(&source.name, arguments.quiet);
    let film = render(&ready.assembled.scene, &ready.settings, &|bucket| {
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
    if let Some(folder) = &arguments.difference {
        let mut bytes = std::io::Cursor::new(Vec::new());
        found
            .picture()
            .write_to(&mut bytes, ImageFormat::Png)
            .map_err(|error| Failure::of("the picture cannot be encoded", error))?;
        write_file(&folder.join(format!("{}.png", source.name)), bytes.get_ref())?;
    }
    Ok(Compared { name: source.name.clone(), ours, reference, found, target })
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
    let row = |Compared { name, found, target, .. }: &Compared| {
        vec![
            name.clone(),
            percent(found.share_within(CLOSE)),
            percent(found.share_within(CLOSE_WITH_TEXTURES)),
            found.largest().to_string(),
            found.unexplained.len().to_string(),
            format!("{:.5}", found.rmse),
            match target {
                Target::Close(most) => format!("{} % within {most}", 100.0 * LEAST_CLOSE),
                Target::Noise => format!("RMSE {MOST_NOISE}"),
            },
            if target.is_met(found) { "met" } else { "missed" }.to_owned(),
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

/// The pixels that no edge explains, but where noise is expected; `None` if there are none.
fn unexplained(compared: &[Compared]) -> Option<String> {
    let mut rows = Vec::new();
    for Compared { name, ours, reference, found, .. } in compared.iter().filter(|scene| scene.target != Target::Noise) {
        let color = |picture: &RgbImage, [x, y]: [u32; 2]| {
            let [r, g, b] = picture.get_pixel(x, y).0;
            format!("{r} {g} {b}")
        };
        rows.extend(
            found
                .unexplained
                .iter()
                .take(LISTED)
                .map(|&at| vec![name.clone(), format!("{}, {}", at[0], at[1]), color(ours, at), color(reference, at)]),
        );
    }
    let headings =
        [("scene", Align::Left), ("pixel", Align::Right), ("ours", Align::Right), ("Sunflow's", Align::Right)];
    (!rows.is_empty())
        .then(|| format!("\nNo edge explains (the first {LISTED} of a scene):\n\n{}", markdown(&headings, &rows)))
}
