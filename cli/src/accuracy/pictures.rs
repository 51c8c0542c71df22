//! Figure 5: one hard scene, naive and robust.

use std::ops::ControlFlow;

use geometry::naive;
use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
use render::{Film, Modules, Settings, assemble};
use serde_json::json;

use super::{
    Effort,
    figure::{Figure, Part},
    steps::Steps,
};
use crate::metrics::{PIXELS_PER_DEGREE, flip, rmse};
use crate::report::Failure;
use crate::scenes::{self, EmbeddedFiles};

/// Steps of [`figure`].
pub(crate) const STEPS: usize = 3;

/// The scene.
const SCENE: &str = "scales";

pub(crate) fn figure(effort: &Effort, steps: &Steps) -> Result<Figure, Failure> {
    let robust = rendered(Modules::default(), effort)?;
    steps.advance();
    let naive = Modules {
        kernels: naive::kernels(),
        ray_origin: naive::offset_along_normal,
        // The one that asks the naive box test.
        accelerator: accel::octree,
        ..Modules::default()
    };
    let naive = rendered(naive, effort)?;
    steps.advance();
    let map =
        flip(&robust, &naive, PIXELS_PER_DEGREE).map_err(|error| Failure::of("the pictures of figure 5", error))?;
    let (flip, rmse) =
        (map.mean(), rmse(&robust, &naive).map_err(|error| Failure::of("the pictures of figure 5", error))?);
    steps.advance();
    let png = |bytes: &[u8]| png(bytes, robust.width, robust.height);
    Ok(Figure {
        id: "pictures",
        title: "One hard scene, naive and robust",
        caption: format!(
            "The built-in scene `{SCENE}`: the same still life at four sizes, from a thousandth to a million, each as far from the eye \
             as it is large. The four should look alike. With girasol's kernels they do; with the naive ones and an offset \
             of 1e-4 the smallest loses its cube and table to an epsilon, and the large ones shadow themselves. (Mean FLIP {flip:.3}, \
             RMSE {rmse:.3} in linear light. `girasol render {SCENE} --naive all` makes the second picture; one kernel at a time shows \
             whose fault is what.)"
        ),
        parts: vec![
            Part::Png { bytes: png(&robust.to_srgb_bytes())?, alt: "girasol's kernels: sizes 0.001, 1, 1000 and 1,000,000".to_owned() },
            Part::Png { bytes: png(&naive.to_srgb_bytes())?, alt: "All naive kernels, and new rays 0.0001 off the surface".to_owned() },
            Part::Png {
                bytes: png(&map.to_srgb_bytes())?,
                alt: "FLIP: what an eye sees of the difference on flipping between the two, from black (nothing) to nearly white (all)".to_owned(),
            },
        ],
        data: json!({ "scene": SCENE, "size": [robust.width, robust.height], "flip": flip, "rmse": rmse }),
    })
}

fn rendered(modules: Modules, effort: &Effort) -> Result<Film, Failure> {
    let failed = || Failure::new(format!("the scene `{SCENE}` could not be rendered"));
    let scene = scenes::find(SCENE).ok_or_else(failed)?;
    let text = scene.source();
    let parsed = (modules.parse)(SCENE, &text, &EmbeddedFiles, &modules.limits);
    let assembled =
        assemble(&parsed.scene, &modules, &render::Lighting::default(), &EmbeddedFiles).map_err(|_| failed())?;
    let settings = Settings { size: effort.picture, aa: effort.picture_aa, ..assembled.settings };
    assembled.scene.render(&settings, &|_| ControlFlow::Continue(())).ok_or_else(failed)
}

/// An 8-bit sRGB picture as a PNG file.
pub(crate) fn png(bytes: &[u8], width: u32, height: u32) -> Result<Vec<u8>, Failure> {
    let mut file = Vec::new();
    PngEncoder::new(&mut file)
        .write_image(bytes, width, height, ExtendedColorType::Rgb8)
        .map_err(|error| Failure::of("a picture cannot be encoded", error))?;
    Ok(file)
}
