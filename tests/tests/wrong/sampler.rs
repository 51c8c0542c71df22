use std::sync::atomic::{AtomicU32, Ordering};

use glam::DVec2;
use render::conformance::sampler;
use render::{Purpose, Sample, Sampler, random, sobol};

use crate::Kit;

/// Fills in points that are each a function of their sample.
fn each(first: Sample, points: &mut [DVec2], point: fn(Sample) -> DVec2) {
    first.each(points, point);
}

/// Chosen instead of the sample, but for the place in a zone, which goes by the index.
fn instead(sample: Sample, chosen: Sample) -> DVec2 {
    Sample { index: sample.index, zones: sample.zones, ..chosen }.point(random)
}

#[test]
fn every_mistake_in_a_sampler_is_named() {
    static CALLS: AtomicU32 = AtomicU32::new(0);
    Kit { page: "render/src/conformance/sampler.rs", laws: sampler::LAWS }.catches([
        ("nothing is filled in", (|_, _| {}) as Sampler, "points_lie_in_the_unit_square"),
        (
            "1 is reached",
            |first, points| each(first, points, |sample| (sample.point(random) * 256.0).round() / 256.0),
            "points_lie_in_the_unit_square",
        ),
        (
            "every index has the same point",
            |first, points| each(first, points, |sample| Sample { index: 0, ..sample }.point(random)),
            "each_index_has_its_own_point",
        ),
        (
            "depends on call order: a generator with a state",
            |first, points| {
                each(first, points, |sample| {
                    let seed = CALLS.fetch_add(1, Ordering::Relaxed);
                    Sample { seed, ..sample }.point(random)
                });
            },
            "a_point_is_a_function_of_its_sample_alone",
        ),
        (
            "only the first of several points is filled in rightly",
            |first, points| {
                sobol(first, points);
                points[1..].reverse();
            },
            "points_are_the_same_alone_and_together",
        ),
        (
            "the seed is not used",
            |first, points| each(first, points, |sample| Sample { seed: 0, ..sample }.point(random)),
            "another_seed_is_another_picture",
        ),
        (
            "seeds shared between pixels",
            |first, points| each(first, points, |sample| Sample { pixel: [0, 0], ..sample }.point(random)),
            "pixels_have_points_of_their_own",
        ),
        (
            "dimensions correlated: the lens is the pixel",
            |first, points| each(first, points, |sample| Sample { purpose: Purpose::Pixel, ..sample }.point(random)),
            "purposes_have_points_of_their_own",
        ),
        (
            "zones missed: independent points all over the pixel",
            |first, points| each(first, points, |sample| Sample { zones: 1, ..sample }.point(random)),
            "every_zone_of_a_pixel_has_its_rays",
        ),
        (
            "all points in one half of the square",
            |first, points| {
                each(first, points, |sample| {
                    let point = sample.point(random);
                    match sample.purpose {
                        Purpose::Pixel => point,
                        _ => DVec2::new(point.x, 0.5 * point.y),
                    }
                });
            },
            "points_fill_the_square_evenly",
        ),
        (
            "x is y",
            |first, points| {
                each(first, points, |sample| {
                    let point = sample.point(random);
                    match sample.purpose {
                        Purpose::Pixel => point,
                        _ => DVec2::splat(point.x),
                    }
                });
            },
            "points_fill_the_square_evenly",
        ),
        (
            "pixel and seed added: neighbours follow each other",
            |first, points| {
                each(first, points, |sample| {
                    let [x, y] = sample.pixel;
                    instead(sample, Sample { seed: sample.seed.wrapping_add(x), pixel: [0, y], ..sample })
                });
            },
            "neighbouring_pixels_are_independent",
        ),
        (
            "the lens is the pixel mirrored",
            |first, points| {
                each(first, points, |sample| match sample.purpose {
                    Purpose::Lens => {
                        let pixel = Sample { zones: 4, purpose: Purpose::Pixel, ..sample }.point(random) * 4.0;
                        DVec2::ONE.map(|one: f64| one - f64::EPSILON) - (pixel - pixel.floor())
                    }
                    _ => sample.point(random),
                });
            },
            "pixel_and_lens_are_independent",
        ),
        (
            "all lights of a ray share one choice",
            |first, points| {
                each(first, points, |sample| match sample.purpose {
                    // Not equal, but as good as.
                    Purpose::Light { cluster, .. } => {
                        let shared = Purpose::Light { cluster: 0, path: 1 };
                        let point = Sample { purpose: shared, ..sample }.point(random);
                        let moved = point + f64::from(cluster % 1000) * 1e-3;
                        moved - moved.floor()
                    }
                    _ => sample.point(random),
                });
            },
            "lights_are_independent_of_each_other_and_of_the_lens",
        ),
    ]);
}
