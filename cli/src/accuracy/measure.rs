//! The errors of kernels, and the time they take.

use std::hint::black_box;
use std::time::{Duration, Instant};

use geometry::{Intersection, Interval};
use serde_json::{Value, json};

use super::aimed::Aimed;
use super::families::Family;
use super::kernels::{Contender, FalseHits, Subject};
use super::random::Random;
use super::truth::Truth;

/// What was found of one kernel on some cases.
#[derive(Clone, Debug, Default)]
pub(crate) struct Errors {
    /// Cases that have a clear answer.
    pub(crate) clear: usize,
    /// Cases that have none.
    pub(crate) unclear: usize,
    /// Hits where there are none.
    pub(crate) false_hits: usize,
    /// Misses where there is a hit.
    pub(crate) false_misses: usize,
    /// Of the hits that it found and that are there: how far `t` is off, in units of its last place.
    ulps: Vec<f64>,
}

/// A row of numbers. Counts are shares of the clear cases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Summary {
    pub(crate) p50: f64,
    pub(crate) p999: f64,
    pub(crate) max: f64,
    pub(crate) misjudged: f64,
    pub(crate) false_hits: f64,
    pub(crate) false_misses: f64,
    /// Of all cases.
    pub(crate) unclear: f64,
}

impl Errors {
    fn note(&mut self, truth: Truth, found: Option<Intersection>) {
        match (truth, found) {
            (Truth::Unclear, _) => self.unclear += 1,
            (Truth::Miss, None) => self.clear += 1,
            (Truth::Miss, Some(_)) => {
                self.clear += 1;
                self.false_hits += 1;
            }
            (Truth::Hit(_), None) => {
                self.clear += 1;
                self.false_misses += 1;
            }
            (Truth::Hit(t), Some(found)) => {
                self.clear += 1;
                self.ulps.push(t.distance(found.t) / ulp(t.approximate()));
            }
        }
    }

    /// All cases of both.
    pub(crate) fn and(&mut self, other: &Self) {
        self.clear += other.clear;
        self.unclear += other.unclear;
        self.false_hits += other.false_hits;
        self.false_misses += other.false_misses;
        self.ulps.extend(&other.ulps);
    }

    pub(crate) fn summary(&self, false_hits: FalseHits) -> Summary {
        let mut sorted = self.ulps.clone();
        sorted.sort_by(f64::total_cmp);
        let of_clear = |count: usize| count as f64 / self.clear.max(1) as f64;
        let wrong = match false_hits {
            FalseHits::AreWrong => self.false_hits + self.false_misses,
            FalseHits::AreHarmless => self.false_misses,
        };
        Summary {
            p50: percentile(&sorted, 0.5),
            p999: percentile(&sorted, 0.999),
            max: percentile(&sorted, 1.0),
            misjudged: of_clear(wrong),
            false_hits: of_clear(self.false_hits),
            false_misses: of_clear(self.false_misses),
            unclear: self.unclear as f64 / (self.clear + self.unclear).max(1) as f64,
        }
    }
}

impl Summary {
    /// For programs. What is not defined, as the error of a kernel that never hits, is null.
    pub(crate) fn json(&self) -> Value {
        json!({
            "ulp": { "p50": self.p50, "p99.9": self.p999, "max": self.max },
            "misjudged": self.misjudged, "false hits": self.false_hits, "false misses": self.false_misses,
            "unclear": self.unclear,
        })
    }
}

/// The least number that a share of sorted numbers does not exceed; NaN if there are none.
fn percentile(sorted: &[f64], share: f64) -> f64 {
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.max(1) - 1).copied().unwrap_or(f64::NAN)
}

/// The unit in the last place of an `f32` of this size.
fn ulp(number: f64) -> f64 {
    let nearest = number.abs() as f32;
    f64::from(nearest.next_up()) - f64::from(nearest)
}

/// The errors of each kernel on the same cases.
pub(crate) fn errors<Shape>(subject: &Subject<Shape>, family: &Family<Shape>, seed: u64, cases: usize) -> Vec<Errors> {
    let mut random = Random::new(seed, &format!("{} {}", subject.name, family.name));
    let mut errors = vec![Errors::default(); subject.contenders.len()];
    for _ in 0..cases {
        let Aimed { shape, ray } = (family.make)(&mut random);
        let truth = (subject.truth)(&shape, &ray);
        for (errors, contender) in errors.iter_mut().zip(&subject.contenders) {
            errors.note(truth, (contender.run)(&shape, &ray, Interval::FORWARD));
        }
    }
    errors
}

/// So many cases are timed, again and again: they and their answers fit in the first cache.
pub(crate) const TIMED_CASES: usize = 128;

/// How often they are gone through between two looks at the clock.
const PASSES: usize = 8;

/// The time of a test with each kernel, in nanoseconds, with the call through a pointer: the least of some rounds, in which the
/// kernels take turns.
pub(crate) fn nanoseconds<Shape>(
    subject: &Subject<Shape>,
    family: &Family<Shape>,
    seed: u64,
    rounds: usize,
) -> Vec<f64> {
    let cases = timed_cases(subject, family, seed);
    let mut least = vec![Duration::MAX; subject.contenders.len()];
    for _ in 0..rounds {
        for (least, contender) in least.iter_mut().zip(&subject.contenders) {
            let start = Instant::now();
            run(contender, &cases, PASSES);
            *least = start.elapsed().min(*least);
        }
    }
    least.iter().map(|time| time.as_secs_f64() * 1e9 / (PASSES * TIMED_CASES) as f64).collect()
}

pub(crate) fn timed_cases<Shape>(subject: &Subject<Shape>, family: &Family<Shape>, seed: u64) -> Vec<Aimed<Shape>> {
    let mut random = Random::new(seed, &format!("{} {} timed", subject.name, family.name));
    (0..TIMED_CASES).map(|_| (family.make)(&mut random)).collect()
}

/// Nothing but the kernel on some cases, so many times.
pub(crate) fn run<Shape>(contender: &Contender<Shape>, cases: &[Aimed<Shape>], passes: usize) {
    for _ in 0..passes {
        for Aimed { shape, ray } in cases {
            black_box((contender.run)(black_box(shape), black_box(ray), Interval::FORWARD));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::{families, kernels};
    use geometry::Kernels;

    #[test]
    fn percentiles_are_numbers_of_the_list() {
        let numbers: Vec<f64> = (1..=1000).map(f64::from).collect();
        assert_eq!([0.5, 0.999, 1.0].map(|share| percentile(&numbers, share)), [500.0, 999.0, 1000.0]);
        assert!(percentile(&[], 0.5).is_nan());
    }

    /// Half an ulp for our own kernels, in every family, and nothing misjudged.
    fn hold<Shape>(subject: &Subject<Shape>, families: &[Family<Shape>]) {
        for family in families {
            let errors = &errors(subject, family, 1, 4000)[1];
            let summary = errors.summary(subject.false_hits);
            let (name, family) = (subject.name, &family.name);
            assert!(summary.max <= 0.51, "{name}, {family}: {summary:?}");
            assert_eq!(summary.misjudged, 0.0, "{name}, {family}: {summary:?}");
            assert!(summary.unclear < 0.7 && errors.ulps.len() > 400, "{name}, {family}: {summary:?}");
        }
    }

    #[test]
    fn our_kernels_are_right_to_half_an_ulp_in_every_family() {
        let own = Kernels::default();
        hold(&kernels::sphere(&own), &families::spheres());
        hold(&kernels::ellipsoid(&own), &families::ellipsoids());
        hold(&kernels::triangle(&own), &families::triangles());
        hold(&kernels::plane(&own), &families::planes());
    }

    #[test]
    fn our_box_test_loses_nothing() {
        let subject = kernels::aabb(&Kernels::default());
        for family in families::boxes() {
            assert_eq!(errors(&subject, &family, 1, 4000)[1].false_misses, 0, "{}", family.name);
        }
    }

    /// What is found of a naive kernel in a family.
    fn naive<Shape>(subject: &Subject<Shape>, families: &[Family<Shape>], name: &str) -> Summary {
        let family = families.iter().find(|family| family.name == name).unwrap();
        errors(subject, family, 1, 4000)[0].summary(subject.false_hits)
    }

    #[test]
    fn naive_kernels_fail_where_they_are_known_to() {
        let own = Kernels::default();
        let sphere = |name| naive(&kernels::sphere(&own), &families::spheres(), name);
        assert!(sphere("everyday").misjudged < 0.001);
        assert!(sphere("D/r = 10⁴").misjudged > 0.1, "{:?}", sphere("D/r = 10⁴"));
        assert!(sphere("ray from just outside").p999 > 1e3, "{:?}", sphere("ray from just outside"));
        let triangle = |name| naive(&kernels::triangle(&own), &families::triangles(), name);
        assert!(triangle("everyday").misjudged < 0.001);
        assert!(triangle("size 10⁻⁶").false_misses > 0.3, "{:?}", triangle("size 10⁻⁶"));
        assert!(triangle("aspect 10⁶").p999 > 1e3, "{:?}", triangle("aspect 10⁶"));
        let plane = |name| naive(&kernels::plane(&own), &families::planes(), name);
        assert!(plane("everyday").misjudged < 0.001);
        assert!(plane("near-parallel, to 10⁻⁷").false_misses > 0.2, "{:?}", plane("near-parallel, to 10⁻⁷"));
        let aabb = |name| naive(&kernels::aabb(&own), &families::boxes(), name);
        assert!(aabb("flat").false_misses > 0.1, "{:?}", aabb("flat"));
        let ellipsoid = |name| naive(&kernels::ellipsoid(&own), &families::ellipsoids(), name);
        assert!(ellipsoid("10⁵ r from the origin").p999 > 1e3);
    }

    #[test]
    fn the_same_seed_finds_the_same_errors_and_another_others() {
        let subject = kernels::sphere(&Kernels::default());
        let family = &families::spheres()[0];
        let found = |seed| errors(&subject, family, seed, 500)[0].summary(FalseHits::AreWrong);
        assert_eq!(found(3), found(3));
        assert_ne!(found(3), found(4));
    }
}
