//! The kit of a sampler.
//!
//! **The idea.** A picture is a mean: over a pixel's area, a lens, the lights of a cluster. A sampler says where in these the rays go. Points
//! that keep apart need fewer rays for the same noise; points that repeat, or that are for two purposes at once, draw patterns.
//!
//! ```text
//!   +---+---+    every zone of the pixel has as many rays;         pixel x  | . . .      the same numbers for lens
//!   |  .|.  |    all else is free                                           |. . . .     and pixel: no mean over both,
//!   +---+---+                                                               | . . .      but over a line in them
//!   |.  |  .|                                                               +-------
//!   +---+---+                                                                 lens x
//! ```
//!
//! **The contract.** A [`Sampler`] fills in points of the unit square, 1 excluded: the one that a [`Sample`] names and those with the next
//! indices. Each is a function of its sample alone, whatever was asked before and by which thread. Of the points for [`Purpose::Pixel`]
//! each zone gets as many. Points of other pixels, seeds and purposes do not depend on each other.
//!
//! **Hard cases.** Indices up to the last 32-bit number. Seeds, pixels and purposes that are mixed by adding: the pixel to the right is then
//! this one with the next seed. Generators that are seeded with neighbouring numbers and give neighbouring first numbers.
//!
//! **How it is tested.** Independence and evenness by a chi-square over 64 x 64 cells; a sampler that is right fails one run in 10^8.
//!
//! **Literature.** Cook: Stochastic Sampling in Computer Graphics, TOG 1986. Shirley: Discrepancy as a Quality Measure for Sample
//! Distributions, Eurographics 1991. Owen: Randomly Permuted (t,m,s)-Nets, 1995. Burley: Practical Hash-based Owen Scrambling, JCGT 2020.
//!
//! **Exercises.** Pass the kit with one hash of all the words. Compare `accuracy` of the images: random, in zones, yours. Blue noise between
//! neighbouring pixels (Heitz and others, 2019). Beat [`crate::sobol`] at 16 rays a pixel.
//!
//! | mistake | law that names it |
//! |---|---|
//! | nothing is filled in | [`points_lie_in_the_unit_square`] |
//! | 1 is reached | [`points_lie_in_the_unit_square`] |
//! | every index has the same point | [`each_index_has_its_own_point`] |
//! | depends on call order: a generator with a state | [`a_point_is_a_function_of_its_sample_alone`] |
//! | only the first of several points is filled in rightly | [`points_are_the_same_alone_and_together`] |
//! | the seed is not used | [`another_seed_is_another_picture`] |
//! | seeds shared between pixels | [`pixels_have_points_of_their_own`] |
//! | dimensions correlated: the lens is the pixel | [`purposes_have_points_of_their_own`] |
//! | zones missed: independent points all over the pixel | [`every_zone_of_a_pixel_has_its_rays`] |
//! | all points in one half of the square | [`points_fill_the_square_evenly`] |
//! | x is y | [`points_fill_the_square_evenly`] |
//! | pixel and seed added: neighbours follow each other | [`neighbouring_pixels_are_independent`] |
//! | the lens is the pixel mirrored | [`pixel_and_lens_are_independent`] |
//! | all lights of a ray share one choice | [`lights_are_independent_of_each_other_and_of_the_lens`] |

use geometry::conformance::{Counterexample, Figure, Ink, Trial, Verdict, same};
use glam::DVec2;
use proptest::prelude::*;

use crate::{Purpose, Sample, Sampler};

const PURPOSES: [Purpose; 4] =
    [Purpose::Pixel, Purpose::Lens, Purpose::Light { cluster: 0, path: 1 }, Purpose::Light { cluster: 1, path: 1 }];

/// Samples of any seed, pixel, number and purpose, in up to 2048 x 2048 zones.
pub fn samples() -> impl Strategy<Value = Sample> {
    let purpose = prop_oneof![
        Just(Purpose::Pixel),
        Just(Purpose::Lens),
        any::<(u32, u32)>().prop_map(|(cluster, path)| Purpose::Light { cluster, path }),
    ];
    let index = prop_oneof![3 => 0..1000_u32, 1 => any::<u32>()];
    let pixel = prop_oneof![3 => [0..4096_u32, 0..4096_u32], 1 => [0..u32::MAX, 0..u32::MAX]];
    (any::<u32>(), pixel, 0..12_u32, any::<u32>(), index, purpose).prop_map(
        |(seed, pixel, zones, count, index, purpose)| Sample { seed, pixel, zones: 1 << zones, count, index, purpose },
    )
}

/// Those for one purpose.
fn samples_for(purpose: Purpose) -> impl Strategy<Value = Sample> {
    samples().prop_map(move |sample| Sample { purpose, ..sample })
}

/// A sampler's point, where it has not left what stood there.
fn point(sampler: &Sampler, sample: Sample) -> DVec2 {
    let mut point = [DVec2::NAN];
    sampler(sample, &mut point);
    point[0]
}

fn drawn(points: impl IntoIterator<Item = DVec2>) -> Figure {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|corner| corner.extend(0.0));
    points
        .into_iter()
        .fold(Figure::flat().outline(&corners), |figure, point| figure.point(point.extend(0.0), Ink::Found, ""))
}

/// 0 is in it, 1 is not. What is not filled in is found here, too.
pub fn points_lie_in_the_unit_square(sampler: &Sampler, trial: &Trial) -> Verdict {
    trial.times(16).search(samples(), |&sample| {
        let mut points = [DVec2::NAN; 16];
        sampler(sample, &mut points);
        let square = |point: &DVec2| point.cmpge(DVec2::ZERO).all() && point.cmplt(DVec2::ONE).all();
        match points.iter().find(|point| !square(point)) {
            None => Ok(()),
            Some(point) if point.is_nan() => Err(Counterexample::new("every point filled in", "one that is not")),
            Some(point) => {
                Err(Counterexample::new("both from 0 to less than 1", format!("{point:?}")).drawn(drawn(points)))
            }
        }
    })
}

/// Otherwise all rays of a pixel are one.
pub fn each_index_has_its_own_point(sampler: &Sampler, trial: &Trial) -> Verdict {
    trial.search(samples_for(Purpose::Lens), |&sample| {
        differs(point(sampler, sample), point(sampler, Sample { index: sample.index ^ 1, ..sample }))
    })
}

/// Threads ask in any order, and no picture may depend on that.
pub fn a_point_is_a_function_of_its_sample_alone(sampler: &Sampler, trial: &Trial) -> Verdict {
    trial.search((samples(), samples()), |&(sample, other)| {
        let first = point(sampler, sample);
        point(sampler, other);
        same(&first, &point(sampler, sample))
    })
}

/// Several points asked for at once are those with the next indices.
pub fn points_are_the_same_alone_and_together(sampler: &Sampler, trial: &Trial) -> Verdict {
    trial.search(samples(), |&sample| {
        let mut together = [DVec2::NAN; 9];
        sampler(sample, &mut together);
        let mut alone = [DVec2::NAN; 9];
        sample.each(&mut alone, |sample| point(sampler, sample));
        same(&alone, &together)
    })
}

/// The user asks for another picture by another seed.
pub fn another_seed_is_another_picture(sampler: &Sampler, trial: &Trial) -> Verdict {
    trial.search(samples_for(Purpose::Lens), |&sample| {
        differs(point(sampler, sample), point(sampler, Sample { seed: sample.seed ^ 1, ..sample }))
    })
}

/// The same points in each pixel show as a pattern that repeats.
pub fn pixels_have_points_of_their_own(sampler: &Sampler, trial: &Trial) -> Verdict {
    trial.search((samples_for(Purpose::Lens), any::<bool>()), |&(sample, down)| {
        let [x, y] = sample.pixel;
        let neighbour = if down { [x, y + 1] } else { [x + 1, y] };
        differs(point(sampler, sample), point(sampler, Sample { pixel: neighbour, ..sample }))
    })
}

/// A lens that follows the pixel turns blur into a shift.
pub fn purposes_have_points_of_their_own(sampler: &Sampler, trial: &Trial) -> Verdict {
    trial.search((samples(), 1..4_usize), |&(sample, step)| {
        let [one, other] = [0, step].map(|number| Sample { zones: 1, purpose: PURPOSES[number], ..sample });
        differs(point(sampler, one), point(sampler, other))
    })
}

fn differs(one: DVec2, other: DVec2) -> Verdict {
    if one != other {
        return Ok(());
    }
    Err(Counterexample::new("two different points", format!("twice {one:?}")).drawn(drawn([one])))
}

/// The report's law: `samples` rays in each of 2^aa x 2^aa zones, in any zones x zones that follow each other.
pub fn every_zone_of_a_pixel_has_its_rays(sampler: &Sampler, trial: &Trial) -> Verdict {
    trial.search((samples_for(Purpose::Pixel), 0..5_u32, 0..8_u32), |&(sample, halvings, turn)| {
        let zones = 1 << halvings;
        let first = turn * zones * zones;
        let mut points = vec![DVec2::NAN; (zones * zones) as usize];
        sampler(Sample { zones, count: 8 * zones * zones, index: first, ..sample }, &mut points);
        let mut rays = vec![0; points.len()];
        for point in &points {
            let place = *point * f64::from(zones);
            let zone = place.y as usize * zones as usize + place.x as usize;
            if let Some(rays) = rays.get_mut(zone) {
                *rays += 1;
            }
        }
        if rays.iter().all(|&rays| rays == 1) {
            return Ok(());
        }
        let expected =
            format!("one of the {0} points from index {first} on in each of {zones} x {zones} zones", rays.len());
        Err(Counterexample::new(expected, format!("row by row {rays:?}")).drawn(drawn(points)))
    })
}

/// Over many pixels, in x and y: each cell of the square as often as any other.
pub fn points_fill_the_square_evenly(sampler: &Sampler, trial: &Trial) -> Verdict {
    independent(trial, |seed, number| at(sampler, seed, number, Purpose::Lens))?;
    independent(trial, |seed, number| in_zone(at(sampler, seed, number, Purpose::Pixel)))?;
    independent(trial, |seed, number| at(sampler, seed, number, PURPOSES[2]))
}

/// One pixel's number says nothing about the next one's, across and down.
pub fn neighbouring_pixels_are_independent(sampler: &Sampler, trial: &Trial) -> Verdict {
    let lens =
        |seed, pixel| point(sampler, Sample { seed, pixel, zones: 4, count: 48, index: 3, purpose: Purpose::Lens });
    independent(trial, |seed, number| {
        let [x, y] = [number % 512, number / 512];
        DVec2::new(lens(seed, [2 * x, y]).x, lens(seed, [2 * x + 1, y]).x)
    })?;
    independent(trial, |seed, number| {
        let [x, y] = [number % 512, number / 512];
        DVec2::new(lens(seed, [x, 2 * y]).x, lens(seed, [x, 2 * y + 1]).x)
    })?;
    // With another seed, too: the next pixel is not this one with the next seed.
    independent(trial, |seed, number| {
        let [x, y] = [number % 512, number / 512];
        DVec2::new(lens(seed, [x + 1, y]).x, lens(seed.wrapping_add(1), [x, y]).x)
    })
}

/// The mean over both is right only if every part of the lens is seen from every part of the pixel.
pub fn pixel_and_lens_are_independent(sampler: &Sampler, trial: &Trial) -> Verdict {
    independent(trial, |seed, number| {
        let [pixel, lens] = [Purpose::Pixel, Purpose::Lens].map(|purpose| at(sampler, seed, number, purpose));
        DVec2::new(in_zone(pixel).x, lens.x)
    })?;
    independent(trial, |seed, number| {
        let [pixel, lens] = [Purpose::Pixel, Purpose::Lens].map(|purpose| at(sampler, seed, number, purpose));
        DVec2::new(in_zone(pixel).y, lens.y)
    })
}

/// Which light of a cluster is asked is another choice than which of the next cluster, at the next bounce, and where on the lens.
pub fn lights_are_independent_of_each_other_and_of_the_lens(sampler: &Sampler, trial: &Trial) -> Verdict {
    let [_, lens, light, next_light] = PURPOSES;
    let next_bounce = Purpose::Light { cluster: 0, path: 2 };
    for [one, other] in [[lens, light], [light, next_light], [light, next_bounce]] {
        independent(trial, |seed, number| {
            DVec2::new(at(sampler, seed, number, one).x, at(sampler, seed, number, other).x)
        })?;
    }
    Ok(())
}

/// The numbered pixel's point for a purpose.
fn at(sampler: &Sampler, seed: u32, number: u32, purpose: Purpose) -> DVec2 {
    point(sampler, Sample { seed, pixel: [number % 512, number / 512], zones: 4, count: 48, index: 3, purpose })
}

/// The place in its zone of a point in a pixel of 4 x 4.
fn in_zone(point: DVec2) -> DVec2 {
    let place = 4.0 * point;
    place - place.floor()
}

/// Chi-square over 64 x 64 cells. 4095 degrees of freedom have a mean of 4095 and a standard deviation of 90.5; six of them are allowed.
fn independent(trial: &Trial, numbered: impl Fn(u32, u32) -> DVec2) -> Verdict {
    const CELLS: usize = 64;
    const POINTS: u32 = 1 << 17;
    // A statistic, not a search: a few seeds are enough, and the report names one.
    let trial = Trial { cases: trial.cases.div_ceil(128), ..*trial };
    trial.search(any::<u32>().no_shrink(), |&seed| {
        let mut cells = vec![0_u32; CELLS * CELLS];
        for point in (0..POINTS).map(|number| numbered(seed, number)) {
            let [x, y] = [point.x, point.y].map(|place| (place * CELLS as f64) as usize);
            if let Some(cell) = cells.get_mut(x.min(CELLS - 1) * CELLS + y.min(CELLS - 1)) {
                *cell += 1;
            }
        }
        let mean = f64::from(POINTS) / cells.len() as f64;
        let squared = |count: &u32| (f64::from(*count) - mean) * (f64::from(*count) - mean) / mean;
        let chi_square: f64 = cells.iter().map(squared).sum();
        if (chi_square - 4095.0).abs() < 6.0 * 90.5 {
            return Ok(());
        }
        let expected = format!("pairs spread over {CELLS} x {CELLS} cells by chance: chi-square 4095 to 543");
        let shown = drawn((0..500).map(|number| numbered(seed, number)));
        Err(Counterexample::new(expected, format!("chi-square {chi_square:.0}")).drawn(shown))
    })
}

geometry::kit! { $crate
    /// Names the laws of a sampler as tests: of a [`Sampler`](crate::Sampler).
    sampler_conformance, Sampler, sampler;
    points_lie_in_the_unit_square: "nothing is filled in yet; or 1 is reached, by dividing by the greatest number instead of one more";
    each_index_has_its_own_point: "the index is not used";
    a_point_is_a_function_of_its_sample_alone: "a generator is kept between calls: make the numbers of the sample's words by a hash instead";
    points_are_the_same_alone_and_together: "the next points are not those of the next indices: `Sample::each` makes them one by one";
    another_seed_is_another_picture: "the seed is not used";
    pixels_have_points_of_their_own: "the pixel, or one of its coordinates, is not used";
    purposes_have_points_of_their_own: "the purpose is not used, or the cluster's number or the path is not";
    every_zone_of_a_pixel_has_its_rays: "points fall anywhere in the pixel, or the zone is taken from something else than the index";
    points_fill_the_square_evenly: "x and y are made of the same number, or only some of a number's bits";
    neighbouring_pixels_are_independent: "words are added before they are mixed, or mixed too little";
    pixel_and_lens_are_independent: "one point serves two purposes, mirrored or moved";
    lights_are_independent_of_each_other_and_of_the_lens: "the cluster's number or the path is not mixed in well enough";
}
