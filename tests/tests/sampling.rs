//! What better samples are worth: errors against a picture of many rays, and rays counted. All pictures are the same on every run.

use std::num::NonZeroU32;
use std::ops::ControlFlow;

use cli::scenes::{self, EmbeddedFiles};
use render::{
    Allotment, Assembled, Crop, Film, LightSamples, Lighting, Modules, Sampler, Settings, random, render, sobol,
};
use shading::SoftShadows;
use tests::Rendering;

/// Seeds over which errors are taken together.
const SEEDS: u32 = 2;

fn scene(name: &str, sampler: Sampler) -> Assembled {
    let scene = scenes::find(name).expect("the scene is embedded");
    let rendering = Rendering {
        text: scene.source().into_owned(),
        files: EmbeddedFiles,
        modules: Modules { sampler, ..Modules::default() },
        lighting: Lighting { soft_shadows: scene.soft_shadows.then(SoftShadows::default), ..Lighting::default() },
    };
    rendering.assemble()
}

fn film(assembled: &Assembled, settings: &Settings) -> Film {
    render(&assembled.scene, settings, &|_| ControlFlow::Continue(())).expect("nothing breaks it off")
}

/// 96 x 72 pixels of a scene in its own size.
fn part(assembled: &Assembled, [x, y]: [u32; 2], aa: u32, samples: u32) -> Settings {
    let crop = Some(Crop { x, y, width: 96, height: 72 });
    Settings { crop, aa, samples, ..assembled.settings.clone() }
}

/// The mean of all channels' squared errors, and the rays of all kinds, both over all seeds.
fn error_and_rays(assembled: &Assembled, settings: &Settings, reference: &Film) -> (f64, u64) {
    let (mut squares, mut rays) = (0.0, 0);
    for seed in 0..SEEDS {
        let film = film(assembled, &Settings { seed, ..settings.clone() });
        rays += film.rays.total();
        for (pixel, right) in film.pixels.iter().zip(&reference.pixels) {
            let errors = pixel.to_array().into_iter().zip(right.to_array()).map(|(a, b)| f64::from(a - b));
            squares += errors.map(|error| error * error).sum::<f64>();
        }
    }
    (squares / (3.0 * f64::from(SEEDS) * reference.pixels.len() as f64), rays)
}

/// 1024 rays a pixel, by other random numbers than those of the pictures.
fn reference(assembled: &Assembled, settings: &Settings) -> Film {
    let settings = Settings { aa: 4, samples: 4, seed: 99, allotment: Allotment::Even, ..settings.clone() };
    film(assembled, &settings)
}

/// Half the rays, or fewer, must give no larger error.
#[track_caller]
fn assert_half_the_rays(name: &str, (error, rays): (f64, u64), (usual_error, usual_rays): (f64, u64)) {
    // Not every ray meets something: the same settings take a few more or fewer. 1 % is allowed.
    assert!(rays as f64 <= 0.505 * usual_rays as f64, "{name}: {rays} rays instead of {usual_rays}");
    assert!(error <= usual_error, "{name}: an error of {} instead of {}", error.sqrt(), usual_error.sqrt());
}

#[test]
fn soft_shadows_need_less_than_half_the_rays_of_random_samples() {
    // Random samples are the report's, 16 rays a pixel: every ray asks all of a cluster's lights. 48 that share them out are fewer in all.
    let (usual, better) = (scene("shadows-soft", random), scene("shadows-soft", sobol));
    let settings = |aa, samples, light_samples| Settings { light_samples, ..part(&usual, [200, 300], aa, samples) };
    let reference = reference(&better, &settings(4, 4, LightSamples::Shared));
    let usual = error_and_rays(&usual, &settings(2, 1, LightSamples::All), &reference);
    let better = error_and_rays(&better, &settings(2, 3, LightSamples::Shared), &reference);
    assert_half_the_rays("shadows-soft", better, usual);
}

#[test]
fn depth_of_field_needs_less_than_half_the_rays_of_random_samples() {
    let (usual, better) = (scene("depth-of-field", random), scene("depth-of-field", sobol));
    let settings = |aa, samples| part(&usual, [150, 0], aa, samples);
    let reference = reference(&better, &settings(4, 4));
    // 32 rays a pixel, and 16.
    let usual = error_and_rays(&usual, &settings(2, 2), &reference);
    let better = error_and_rays(&better, &settings(2, 1), &reference);
    assert_half_the_rays("depth-of-field", better, usual);
}

/// Adaptive rays, 4 to 64 a pixel, against 16 and 32 for every pixel: the errors of both, as powers of the number of rays, say how many of
/// the latter would give the error of the former.
#[track_caller]
fn assert_adaptive_saves_half(name: &str, place: [u32; 2]) {
    let assembled = scene(name, sobol);
    let even = |samples| part(&assembled, place, 2, samples);
    let adaptive = Settings { allotment: Allotment::Adaptive, least_aa: 1, aa: 3, ..even(1) };
    let reference = reference(&assembled, &even(1));
    let [few, many] = [1, 2].map(|samples| error_and_rays(&assembled, &even(samples), &reference));
    let (error, rays) = error_and_rays(&assembled, &adaptive, &reference);
    let power = (few.0 / many.0).ln() / (many.1 as f64 / few.1 as f64).ln();
    let needed = few.1 as f64 * (few.0 / error).powf(1.0 / power);
    assert!(rays as f64 <= 0.5 * needed, "{name}: {rays} rays do what {needed} do evenly");
}

#[test]
fn adaptive_rays_halve_the_cost_of_marbles() {
    assert_adaptive_saves_half("marbles", [320, 140]);
}

#[test]
fn adaptive_rays_halve_the_cost_of_glass() {
    assert_adaptive_saves_half("glass-mirror", [200, 200]);
}

#[test]
fn adaptive_rays_halve_the_cost_of_a_fence() {
    assert_adaptive_saves_half("chainlink", [270, 200]);
}

/// Three pixels across, three down. In the middle one stands a white square that covers a quarter of it; or it reaches into all.
fn square(half: f64, sampler: Sampler) -> Assembled {
    let text = format!(
        "image {{ resolution 3 3 aa 0 2 }} camera {{ type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov 90 aspect 1 }}
         shader {{ name white type constant color 1 1 1 }}
         object {{ shader white type generic-mesh points 4  -{half} 1.5 -{half}  {half} 1.5 -{half}  {half} 1.5 {half}  -{half} 1.5 {half}
         triangles 2 0 1 2 0 2 3 normals none uvs none }}"
    );
    let rendering = Rendering::flat(text);
    Rendering { modules: Modules { sampler, ..rendering.modules }, ..rendering }.assemble()
}

#[test]
fn adaptive_pixels_are_right_in_the_mean() {
    // The picture is 3 units wide at the square's distance, so a pixel is 1. Half an edge of 0.25: a quarter of the middle pixel, and nothing
    // of its neighbours. 0.75: the whole of it, a quarter of those beside it and a sixteenth of those at the corners, the numbers of rays
    // of which differ. A pixel's value is the mean of independent rays, so its variance is at most p (1 - p) / 2.
    const PICTURES: u32 = 2000;
    for (sampler_name, sampler) in [("random", random as Sampler), ("sobol", sobol)] {
        for (half, [corner, side, middle]) in [(0.25, [0.0, 0.0, 0.25]), (0.75, [0.0625, 0.25, 1.0])] {
            let assembled = square(half, sampler);
            let mut means = [0.0; 9];
            for seed in 0..PICTURES {
                let settings = Settings { seed, allotment: Allotment::Adaptive, ..assembled.settings.clone() };
                for (mean, pixel) in means.iter_mut().zip(film(&assembled, &settings).pixels) {
                    *mean += f64::from(pixel.r) / f64::from(PICTURES);
                }
            }
            let right: [f64; 9] = [corner, side, corner, side, middle, side, corner, side, corner];
            for (pixel, (mean, right)) in means.into_iter().zip(right).enumerate() {
                let sigma = (right * (1.0 - right) / 2.0 / f64::from(PICTURES)).sqrt();
                let off = (mean - right).abs();
                assert!(off <= 4.5 * sigma + 1e-6, "{sampler_name}, {half}, pixel {pixel}: {mean} instead of {right}");
            }
        }
    }
}

#[test]
fn adaptive_rays_are_between_the_fewest_and_the_most() {
    // A flat picture takes the fewest everywhere; a contrast that all exceed, the most, but where neighbours are all alike.
    let flat = square(50.0, sobol);
    let adaptive = |assembled: &Assembled, least_aa, contrast| {
        let settings = Settings { allotment: Allotment::Adaptive, least_aa, contrast, ..assembled.settings.clone() };
        film(assembled, &settings).rays.camera
    };
    assert_eq!([0, 1, 2].map(|least| adaptive(&flat, least, 0.1)), [9 * 2, 9 * 4, 9 * 16]);
    let busy = square(0.75, sobol);
    let rays = adaptive(&busy, 1, 1e-6);
    assert!((4 * 16 + 5 * 4..=9 * 16).contains(&rays), "{rays}");
}

#[test]
fn a_scene_s_aa_range_and_contrast_are_read_but_only_used_on_request() {
    let settings = |image: &str| {
        let text =
            format!("image {{ {image} }} camera {{ type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov 90 aspect 1 }}");
        Rendering::of(text).assemble().settings
    };
    let found = settings("aa 1 3 samples 2 contrast 0.3");
    assert_eq!((found.least_aa, found.aa, found.contrast, found.allotment), (1, 3, 0.3, Allotment::Even));
    assert_eq!((found.least_rays(), found.rays_per_pixel()), (8, 128));
    let found = settings("aa 2 -2");
    assert_eq!((found.least_aa, found.aa, found.contrast, found.least_rays()), (0, 2, 0.1, 2));
}

#[test]
fn two_passes_are_told_as_one_and_either_can_be_broken_off() {
    let assembled = square(0.75, sobol);
    let mut settings = Settings { allotment: Allotment::Adaptive, ..assembled.settings.clone() };
    settings.buckets.size = 1;
    let told = std::sync::Mutex::new(Vec::new());
    let broken_off_after = |last: usize| {
        told.lock().unwrap().clear();
        render(&assembled.scene, &settings, &|bucket| {
            assert_eq!((bucket.area.width, bucket.area.height, bucket.pixels.len()), (1, 1, 1));
            told.lock().unwrap().push((bucket.finished, bucket.total));
            if bucket.finished == last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })
    };
    assert!(broken_off_after(usize::MAX).is_some());
    assert_eq!(*told.lock().unwrap(), (1..=18).map(|finished| (finished, 18)).collect::<Vec<_>>());
    for last in [1, 9, 10, 17] {
        assert!(broken_off_after(last).is_none(), "broken off after {last}");
    }
}

/// A floor under the shadow of an edge, lit by two soft lights.
fn penumbra(sampler: Sampler) -> Assembled {
    let text = "image { resolution 8 2 aa 0 1 } camera { type pinhole eye 0 0 4 target 0 0 0 up 0 1 0 fov 20 aspect 4 }
        shader { name white type phong diff 1 1 1 spec 0.5 0.5 0.5 10 }
        object { shader white type plane p 0 0 0 n 0 0 1 }
        object { shader white type generic-mesh points 4  0 -20 5  20 -20 5  20 20 5  0 20 5  triangles 2 0 1 2 0 2 3 }
        light { type point color 1 0.5 0.25 power 20 p 0.2 0.3 10 }
        light { type point color 0.25 0.5 1 power 20 p -0.2 0 9 }";
    let lighting = Lighting { soft_shadows: Some(SoftShadows { along_edge: 3, spacing: 0.5 }), ..Lighting::default() };
    let rendering = Rendering { lighting, ..Rendering::of(text) };
    Rendering { modules: Modules { sampler, ..rendering.modules }, ..rendering }.assemble()
}

#[test]
fn drawn_lights_are_right_in_the_mean() {
    const PICTURES: u32 = 2000;
    for (name, sampler) in [("random", random as Sampler), ("sobol", sobol)] {
        let assembled = penumbra(sampler);
        // One ray a pixel, through its centre: nothing but the choice of lights is random.
        let with = |light_samples, seed| {
            let settings = Settings { light_samples, seed, aa: 0, ..assembled.settings.clone() };
            film(&assembled, &settings).pixels
        };
        let right = with(LightSamples::All, 0);
        for count in [1, 4, 26] {
            let light_samples = LightSamples::Each(NonZeroU32::new(count).unwrap());
            let mut sums = vec![[0.0, 0.0]; right.len()];
            for seed in 0..PICTURES {
                for ([sum, squares], pixel) in sums.iter_mut().zip(with(light_samples, seed)) {
                    *sum += f64::from(pixel.g);
                    *squares += f64::from(pixel.g).powi(2);
                }
            }
            for (pixel, ([sum, squares], right)) in sums.into_iter().zip(&right).enumerate() {
                let mean = sum / f64::from(PICTURES);
                let sigma = ((squares / f64::from(PICTURES) - mean * mean).max(0.0) / f64::from(PICTURES)).sqrt();
                let off = (mean - f64::from(right.g)).abs();
                assert!(
                    off <= 4.5 * sigma + 1e-5,
                    "{name}, {count} lights, pixel {pixel}: {mean} instead of {right:?}"
                );
            }
        }
    }
}

#[test]
fn as_many_lights_are_asked_as_were_wanted() {
    let assembled = penumbra(sobol);
    let asked = |light_samples, aa| {
        let settings = Settings { light_samples, aa, ..assembled.settings.clone() };
        let per_pixel = film(&assembled, &settings).rays.shadow / 16;
        (assembled.scene.inventory(&settings).lights_asked, per_pixel)
    };
    // Two clusters of 27; the floor lies in front of all of them. One ray a pixel, then four, then sixteen: 4 x 27 / 16 = 6.75.
    assert_eq!([0, 1].map(|aa| asked(LightSamples::All, aa)), [(54, 54), (54, 4 * 54)]);
    let shared = [0, 1, 2].map(|aa| asked(LightSamples::Shared, aa));
    assert_eq!(shared, [(54, 54), (54, 4 * 54), (2 * 7, 16 * 2 * 7)]);
    let five = LightSamples::Each(NonZeroU32::new(5).unwrap());
    assert_eq!([0, 1].map(|aa| asked(five, aa)), [(10, 10), (10, 4 * 10)]);
}

#[test]
fn more_lights_than_there_are_is_all_of_them() {
    let assembled = penumbra(sobol);
    let with = |light_samples| film(&assembled, &Settings { light_samples, aa: 1, ..assembled.settings.clone() });
    let many = LightSamples::Each(NonZeroU32::new(1000).unwrap());
    assert_eq!(with(many), with(LightSamples::All));
}
