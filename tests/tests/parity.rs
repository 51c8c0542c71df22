//! Pictures lit as by Sunflow against its own, which are no part of this repository. Set `GIRASOL_SHARED` to a folder with
//!
//! ```text
//! scenes/parity/*.sc                   the scenes: one ray a pixel, but those with a lens
//! reference/sunflow/parity/NAME.png    Sunflow's picture of each
//! ```
//!
//! and run `cargo test --release -p tests --test parity -- --nocapture`.
#![expect(clippy::print_stdout, reason = "a table for whoever runs it")]

use std::fs;
use std::ops::ControlFlow;
use std::path::Path;

use image::RgbImage;
use render::{Assembled, Film, Lighting, Modules};
use tests::{Beside, scenes_of, shared_folder};

/// By how much a channel may differ, of 255.
const CLOSE: u8 = 2;

/// By how much where there are textures. Sunflow starts rays 0.001 off a surface, girasol a rounding error off: seen in a ball of
/// glass, a floor's texels are moved a little.
const CLOSE_WITH_TEXTURES: u8 = 6;

/// The smallest share of pixels that must be close.
const LEAST_CLOSE: f64 = 0.995;

/// How far a picture with a lens may be off, as the root of its mean square: either picture has noise of its own.
const MOST_NOISE: f64 = 0.01;

/// There is an edge where the colours around a pixel span more than this in a channel, of 255.
const EDGE: u8 = 6;

/// What a picture must come to.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Target {
    /// Almost every pixel must be as close as that, and no other one off but at an edge.
    Close(u8),
    /// Only the mean must be.
    Noise,
}

/// A scene's picture, and what it must come to.
fn picture(path: &Path) -> (RgbImage, Target) {
    let text = scene_format::decode(&fs::read(path).unwrap()).unwrap();
    let files = Beside(path.parent().unwrap().to_owned());
    let parsed = scene_format::parse(&path.to_string_lossy(), &text, &files);
    let modules = Modules::default().lit_as_by_sunflow();
    let assembled = render::assemble(&parsed.scene, &modules, &Lighting::default(), &files);
    let Assembled { scene, settings, warnings, shading } =
        assembled.unwrap_or_else(|errors| panic!("{}: {errors:#?}", path.display()));
    assert!(warnings.is_empty(), "{}: {warnings:#?}", path.display());
    let film: Film = render::render(&scene, &settings, &|_| ControlFlow::Continue(())).unwrap();
    let target = match shading.textures.len() {
        _ if scene.camera().has_lens() => Target::Noise,
        0 => Target::Close(CLOSE),
        _ => Target::Close(CLOSE_WITH_TEXTURES),
    };
    (RgbImage::from_raw(film.width, film.height, film.to_srgb_bytes()).unwrap(), target)
}

/// The largest difference of two pixels' channels.
fn difference(one: [u8; 3], other: [u8; 3]) -> u8 {
    (0..3).map(|channel| one[channel].abs_diff(other[channel])).max().unwrap_or(0)
}

/// How a picture differs from its reference.
struct Comparison {
    /// The largest difference in a channel of each pixel.
    differences: Vec<u8>,
    /// Pixels that differ by more than [`CLOSE`] and that no edge explains.
    unexplained: Vec<(u32, u32)>,
    /// The root of the mean square over all channels, 1 being white against black.
    rmse: f64,
}

impl Comparison {
    fn of(ours: &RgbImage, reference: &RgbImage) -> Self {
        assert_eq!(ours.dimensions(), reference.dimensions());
        let differences: Vec<u8> = ours.pixels().zip(reference.pixels()).map(|(a, b)| difference(a.0, b.0)).collect();
        let off = ours.enumerate_pixels().zip(&differences).filter(|&(_, &off)| off > CLOSE);
        let unexplained =
            off.map(|((x, y, _), _)| (x, y)).filter(|&(x, y)| !edge_explains(ours, reference, x, y)).collect();
        let squares = ours.iter().zip(reference.iter()).map(|(&a, &b)| (f64::from(a.abs_diff(b)) / 255.0).powi(2));
        let rmse = (squares.sum::<f64>() / ours.len() as f64).sqrt();
        Self { differences, unexplained, rmse }
    }

    fn share_within(&self, most: u8) -> f64 {
        self.differences.iter().filter(|&&off| off <= most).count() as f64 / self.differences.len() as f64
    }

    fn largest(&self) -> u8 {
        self.differences.iter().copied().max().unwrap_or(0)
    }
}

/// Whether a border of a body, a shadow or a texel may have moved across a pixel: there is one in either picture (a gap may be too
/// narrow for a pixel of the other), or the colour is that of a pixel beside it in the reference.
fn edge_explains(ours: &RgbImage, reference: &RgbImage, x: u32, y: u32) -> bool {
    let here = ours.get_pixel(x, y).0;
    let has_edge = |picture| {
        let channels = |channel: usize| around(picture, x, y).map(move |color| color[channel]);
        (0..3).any(|channel| channels(channel).max() > channels(channel).min().map(|least| least.saturating_add(EDGE)))
    };
    has_edge(reference) || has_edge(ours) || around(reference, x, y).any(|color| difference(here, color) <= CLOSE)
}

/// A pixel and those around it.
fn around(picture: &RgbImage, x: u32, y: u32) -> impl Iterator<Item = [u8; 3]> {
    let near = |at: u32, count: u32| at.saturating_sub(1)..=(at + 1).min(count - 1);
    let columns = near(x, picture.width());
    near(y, picture.height()).flat_map(move |y| columns.clone().map(move |x| picture.get_pixel(x, y).0))
}

#[test]
fn pictures_lit_as_by_sunflow_agree_with_sunflow_s() {
    let Some(shared) = shared_folder() else { return };
    println!("{:12} {:>8} {:>8} {:>4} {:>11} {:>8}", "scene", "<= 2", "<= 6", "max", "unexplained", "rmse");
    let mut failed = Vec::new();
    for path in scenes_of(&shared.join("scenes/parity")) {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let reference = shared.join("reference/sunflow/parity").join(format!("{name}.png"));
        let reference = image::load_from_memory(&fs::read(&reference).unwrap()).unwrap().into_rgb8();
        let (ours, target) = picture(&path);
        let found = Comparison::of(&ours, &reference);
        println!(
            "{name:12} {:>7.3}% {:>7.3}% {:>4} {:>11} {:>8.5}  {:?}",
            100.0 * found.share_within(CLOSE),
            100.0 * found.share_within(6),
            found.largest(),
            found.unexplained.len(),
            found.rmse,
            &found.unexplained[..found.unexplained.len().min(5)]
        );
        let agrees = match target {
            Target::Close(most) => found.share_within(most) >= LEAST_CLOSE && found.unexplained.is_empty(),
            Target::Noise => found.rmse <= MOST_NOISE,
        };
        if !agrees {
            failed.push(name);
        }
    }
    assert!(failed.is_empty(), "{failed:?} differ");
}
