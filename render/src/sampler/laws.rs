//! What every sampler must keep.

use glam::DVec2;

use super::{Purpose, Sample, Sampler, centred, random, sobol};

const SAMPLERS: [(&str, Sampler); 3] = [("random", random), ("centred", centred), ("sobol", sobol)];

fn sample(purpose: Purpose) -> Sample {
    Sample { seed: 1, pixel: [5, 7], zones: 4, count: 48, index: 0, purpose }
}

const PURPOSES: [Purpose; 4] =
    [Purpose::Pixel, Purpose::Lens, Purpose::Light { cluster: 0, path: 1 }, Purpose::Light { cluster: 1, path: 1 }];

#[test]
fn points_lie_in_the_unit_square() {
    let square = 0.0..1.0;
    for (name, sampler) in SAMPLERS {
        for (purpose, index) in PURPOSES.into_iter().flat_map(|purpose| (0..5000).map(move |index| (purpose, index))) {
            let point = Sample { count: 5000, index, ..sample(purpose) }.point(sampler);
            assert!(square.contains(&point.x) && square.contains(&point.y), "{name} {purpose:?} {index}: {point}");
        }
    }
}

#[test]
fn points_are_the_same_alone_and_together() {
    for (name, sampler) in SAMPLERS {
        for (purpose, index) in
            PURPOSES.into_iter().flat_map(|purpose| [0, 7, u32::MAX - 2].map(|index| (purpose, index)))
        {
            let first = Sample { index, ..sample(purpose) };
            let mut together = [DVec2::ZERO; 9];
            sampler(first, &mut together);
            let mut alone = [DVec2::ZERO; 9];
            first.each(&mut alone, |sample| sample.point(sampler));
            assert_eq!(together, alone, "{name} {purpose:?} {index}");
        }
    }
}

/// The report's law: `samples` rays in each of 2^aa x 2^aa zones.
#[test]
fn every_zone_of_a_pixel_has_its_rays() {
    for (name, sampler) in SAMPLERS {
        for (zones, samples, seed) in [(1, 5, 0), (2, 3, 1), (4, 1, 2), (4, 3, 3), (8, 7, 4), (16, 1, 5)] {
            let count = zones * zones * samples;
            let mut rays = vec![0; (zones * zones) as usize];
            for index in 0..count {
                let sample = Sample { seed, zones, count, index, ..sample(Purpose::Pixel) };
                let place = sample.point(sampler) * f64::from(zones);
                rays[place.y as usize * zones as usize + place.x as usize] += 1;
            }
            assert!(rays.iter().all(|&rays| rays == samples), "{name}, {zones} x {zones} zones: {rays:?}");
        }
    }
}

/// Chi-square over 64 x 64 squares of neighbouring pixels' and different purposes' points. 4095 degrees of freedom have a
/// mean of 4095 and a standard deviation of 90.5: five of them are allowed.
#[test]
fn pixels_and_purposes_are_independent_and_uniform() {
    for (name, sampler) in SAMPLERS {
        let at = |number: u32, purpose| {
            Sample { pixel: [number % 512, number / 512], index: 3, ..sample(purpose) }.point(sampler)
        };
        if name != "centred" {
            assert_uniform(name, "x and y in the pixel", |n| fraction(4.0 * at(n, Purpose::Pixel)));
            assert_uniform(name, "neighbours", |n| {
                DVec2::new(at(2 * n, Purpose::Lens).x, at(2 * n + 1, Purpose::Lens).x)
            });
            assert_uniform(name, "pixel and lens", |n| {
                DVec2::new(fraction(4.0 * at(n, Purpose::Pixel)).x, at(n, Purpose::Lens).x)
            });
        }
        assert_uniform(name, "x and y on the lens", |n| at(n, Purpose::Lens));
        assert_uniform(name, "lens and light", |n| DVec2::new(at(n, PURPOSES[1]).x, at(n, PURPOSES[2]).x));
        assert_uniform(name, "two lights", |n| DVec2::new(at(n, PURPOSES[2]).x, at(n, PURPOSES[3]).x));
    }
}

fn fraction(point: DVec2) -> DVec2 {
    point - point.floor()
}

#[track_caller]
fn assert_uniform(name: &str, what: &str, point: impl Fn(u32) -> DVec2) {
    let count = 1 << 17;
    let mut cells = vec![0_u32; 4096];
    for point in (0..count).map(point) {
        cells[(point.x * 64.0) as usize * 64 + (point.y * 64.0) as usize] += 1;
    }
    let expected = f64::from(count) / 4096.0;
    let chi_square: f64 = cells.iter().map(|&n| (f64::from(n) - expected).powi(2) / expected).sum();
    assert!((chi_square - 4095.0).abs() < 5.0 * 90.5, "{name}, {what}: {chi_square}");
}
