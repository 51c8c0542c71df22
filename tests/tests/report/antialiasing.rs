//! Section 3.1: zones in a pixel, and rays at random places of each zone.

use render::{Modules, Sampler, Settings, random, sobol};
use tests::Rendering;

use super::WHITE;

#[test]
fn the_larger_aa_number_gives_the_zones_and_samples_the_rays_in_each() {
    // width x height x (2^aa)^2 x samples
    for (image, rays) in [
        ("", 7 * 5),
        ("aa 0 0", 35),
        ("aa 0 1", 35 * 4),
        ("aa 2 0", 35 * 16),
        ("aa -2 1", 35 * 4),
        ("aa -2 -1", 35),
        ("samples 3", 35 * 3),
        ("aa 0 2 samples 3", 35 * 16 * 3),
    ] {
        let text = format!(
            "image {{ resolution 7 5 {image} }} camera {{ type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov 60 aspect 1.4 }}"
        );
        assert_eq!(Rendering::of(text).film().rays.camera, rays, "{image}");
    }
}

/// One pixel that sees all x and z from -10 to 10 at distance 10, where a white quad begins at (`x`, `z`) and goes on beyond its edge.
fn covered(image: &str, x: f64, z: f64, seed: u32) -> f32 {
    covered_by(sobol, image, x, z, seed)
}

fn covered_by(sampler: Sampler, image: &str, x: f64, z: f64, seed: u32) -> f32 {
    let text = format!(
        "{WHITE} image {{ resolution 1 1 {image} }} camera {{ type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov 90 aspect 1 }}
         object {{ shader white type generic-mesh points 4  {x} 10 {z}  50 10 {z}  50 10 50  {x} 10 50
         triangles 2 0 1 2 0 2 3 normals none uvs none }}"
    );
    let rendering = Rendering::flat(text);
    let modules = Modules { sampler, ..rendering.modules };
    Rendering { modules, ..rendering }.film_with(|settings| Settings { seed, ..settings }).pixels[0].r
}

#[test]
fn every_zone_has_its_rays_inside_it() {
    // With 4 x 4 zones, of 5 units each, an edge between zones parts them into those that see nothing else and those that see
    // nothing: the share is exact, wherever in their zones the rays fall.
    for (sampler, seed) in
        [random as Sampler, sobol].into_iter().flat_map(|sampler| (0..10).map(move |seed| (sampler, seed)))
    {
        for (step, share) in [(-5.0, 0.75), (0.0, 0.5), (5.0, 0.25)] {
            let covered = |x, z| covered_by(sampler, "aa 2 2 samples 5", x, z, seed);
            assert_eq!(covered(step, -50.0), share, "x = {step}, seed {seed}");
            assert_eq!(covered(-50.0, step), share, "z = {step}, seed {seed}");
        }
    }
}

#[test]
fn rays_fall_at_random_places_of_their_zones() {
    // The edge goes through the second zones of all four rows: 4 x 64 rays see it with probability 2/3, the standard deviation of their
    // share of the pixel is sqrt(256 x 2/9) / 1024 = 0.0074, and less where they keep apart. Ten seeds that agree would be no random
    // numbers. (Where an edge halves a zone, Sobol's points are halved, too, whatever the seed.)
    for sampler in [random as Sampler, sobol] {
        let share = |seed| covered_by(sampler, "aa 2 2 samples 64", -10.0 / 3.0, -50.0, seed);
        let shares: Vec<f32> = (0..10).map(share).collect();
        assert!(shares.iter().all(|share| (share - 2.0 / 3.0).abs() < 5.0 * 0.0074), "{shares:?}");
        assert!(shares.iter().any(|&share| share != shares[0]), "{shares:?}");
    }
}

#[test]
fn a_single_ray_goes_through_the_centre() {
    for seed in 0..10 {
        assert_eq!([covered("", -1e-3, -50.0, seed), covered("", 1e-3, -50.0, seed)], [1.0, 0.0]);
        assert_eq!([covered("", -50.0, -1e-3, seed), covered("", -50.0, 1e-3, seed)], [1.0, 0.0]);
    }
}
