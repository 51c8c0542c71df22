//! Our FLIP against its authors' own program. It compiles C++, so it is asked for:
//!
//! ```text
//! cargo test -p tests --features nv-flip --test nv_flip -- --nocapture
//! ```
//!
//! The literals in `metrics.rs` are what this prints.
#![expect(clippy::print_stdout, reason = "a table for whoever runs it")]

mod pairs;

use cli::metrics::{PIXELS_PER_DEGREE, flip};
use cli::scenes::{self, EmbeddedFiles};
use nv_flip::FlipImageRgb8;
use pairs::{Pair, Picture, Tolerance, generated};
use render::{Lighting, Modules, Settings};
use tests::Rendering;

/// Renders have flat parts. Measured: 1.2e-5 and 4.5e-8.
const RENDERED: Tolerance = Tolerance { pixel: 1.5e-4, mean: 5e-7 };

/// What the authors' program says of each pixel.
fn theirs(pair: &Pair, pixels_per_degree: f64) -> Vec<f64> {
    let image = |picture: &Picture| FlipImageRgb8::with_data(picture.width, picture.height, &picture.bytes);
    let map = nv_flip::flip(image(&pair.reference), image(&pair.test), pixels_per_degree as f32);
    map.to_vec().into_iter().map(f64::from).collect()
}

fn mean(errors: &[f64]) -> f64 {
    errors.iter().sum::<f64>() / errors.len() as f64
}

/// Whether both say the same of a pair.
fn agree(pair: &Pair, pixels_per_degree: f64) -> bool {
    let ours = flip(&pair.reference.film(), &pair.test.film(), pixels_per_degree).unwrap();
    let theirs = theirs(pair, pixels_per_degree);
    assert_eq!(ours.errors.len(), theirs.len());
    let off = ours.errors.iter().zip(&theirs).map(|(ours, theirs)| (ours - theirs).abs());
    let (largest, in_mean) = (off.fold(0.0, f64::max), (ours.mean() - mean(&theirs)).abs());
    println!(
        "{:28} {pixels_per_degree:>4} {:.9} {largest:.1e} {in_mean:.1e}   (\"{}\", {:.9}, {:.7}),",
        pair.name,
        ours.mean(),
        pair.name,
        mean(&theirs),
        theirs[theirs.len() / 2]
    );
    largest <= pair.tolerance.pixel && in_mean <= pair.tolerance.mean
}

fn assert_all_agree(pairs: &[Pair], pixels_per_degree: &[f64]) {
    println!("{:28}  ppd mean        largest off, in the mean   literal: name, their mean, middle pixel", "pair");
    let all = pixels_per_degree.iter().flat_map(|ppd| pairs.iter().map(move |pair| (pair, *ppd)));
    let differ: Vec<_> = all.filter(|(pair, ppd)| !agree(pair, *ppd)).map(|(pair, ppd)| (&pair.name, ppd)).collect();
    assert!(differ.is_empty(), "{differ:?} differ");
}

#[test]
fn flip_is_what_its_authors_say_on_generated_pictures_near_and_far() {
    assert_all_agree(&generated(), &[PIXELS_PER_DEGREE, 20.0, 150.0]);
}

#[test]
fn flip_is_what_its_authors_say_on_noisy_renderings() {
    let mut pairs = Vec::new();
    for name in ["marbles", "textures", "glass-mirror", "depth-of-field"] {
        let reference = rendered(name, 8, 1);
        pairs.extend([1, 4, 16].map(|samples| Pair {
            name: format!("{name}, {samples} rays"),
            reference: reference.clone(),
            test: rendered(name, samples, 2),
            tolerance: RENDERED,
        }));
    }
    assert_all_agree(&pairs, &[PIXELS_PER_DEGREE]);
}

/// An embedded scene, small and of odd size.
fn rendered(scene: &str, samples: u32, seed: u32) -> Picture {
    let rendering = Rendering {
        text: scenes::find(scene).unwrap().source().into_owned(),
        files: EmbeddedFiles,
        modules: Modules::default(),
        lighting: Lighting::default(),
    };
    let film = rendering.film_with(|settings| Settings { size: [61, 47], aa: 0, samples, seed, ..settings });
    Picture { width: film.width, height: film.height, bytes: film.to_srgb_bytes() }
}
