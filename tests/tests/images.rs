//! The image of every embedded scene, to the bit.
//!
//! When a scene or a shader is meant to look different, accept the new images with
//!
//! ```text
//! INSTA_UPDATE=always cargo test -p tests --test images
//! ```
//!
//! or look at each first, with `cargo insta review`.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use cli::scenes::{self, EmbeddedFiles, EmbeddedScene};
use image::ImageEncoder;
use render::{Film, Lighting, Modules, Settings};
use shading::SoftShadows;
use tests::Rendering;

/// Columns; the rows follow from the scene's own picture.
const WIDTH: u32 = 64;

/// Four rays a pixel, whatever the scene asks for.
fn small(settings: &Settings) -> Settings {
    let [width, height] = settings.size;
    Settings { size: [WIDTH, (WIDTH * height + width / 2) / width], aa: 1, samples: 1, ..settings.clone() }
}

fn film(scene: &EmbeddedScene) -> Film {
    let soft_shadows = scene.soft_shadows.then(SoftShadows::default);
    let rendering = Rendering {
        text: scene.source().into_owned(),
        files: EmbeddedFiles,
        modules: Modules::default(),
        lighting: Lighting { soft_shadows, ..Lighting::default() },
    };
    rendering.film_with(|settings| small(&settings))
}

fn png(film: &Film) -> Vec<u8> {
    let mut bytes = Vec::new();
    image::codecs::png::PngEncoder::new(&mut bytes)
        .write_image(&film.to_srgb_bytes(), film.width, film.height, image::ExtendedColorType::Rgb8)
        .expect("a small picture can be encoded");
    bytes
}

#[test]
fn every_embedded_scene_looks_as_it_did() {
    let changed: Vec<&str> = scenes::all()
        .iter()
        .filter(|scene| {
            let bytes = png(&film(scene));
            // So that one run shows all that have changed.
            let check = || insta::assert_binary_snapshot!(&format!("{}.png", scene.name), bytes.clone());
            catch_unwind(AssertUnwindSafe(check)).is_err()
        })
        .map(|scene| scene.name)
        .collect();
    assert!(changed.is_empty(), "look different: {}", changed.join(", "));
}

#[test]
fn there_is_no_image_of_a_scene_that_is_gone() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots");
    let names = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let gone: Vec<String> = names
        .filter_map(|name| Some(name.strip_prefix("images__")?.split_once('.')?.0.to_owned()))
        .filter(|name| scenes::find(name).is_none())
        .collect();
    assert!(gone.is_empty(), "delete the snapshots of {gone:?}");
}
