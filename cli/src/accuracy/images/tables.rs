//! What is read off the curves.

use super::curve::{Measure, Point, cost_for, error_at, geometric_mean};
use super::samplings::{BASE, BASE_STEP, Sampling};
use super::study::Study;
use crate::accuracy::figure::Part;
use crate::table::Align;

/// What a sampling is worth against the base at 16 rays a pixel: below 1 it is better.
struct Reading {
    title: &'static str,
    read: fn(&[Point], base: &Point) -> Option<f64>,
}

const SECONDS: Measure = |point| point.seconds;
const RAYS: Measure = |point| point.rays;
const RMSE: Measure = |point| point.rmse;
const FLIP: Measure = |point| point.flip;

/// On straight lines between the measured points, on log-log axes.
const READINGS: [Reading; 6] = [
    Reading { title: "RMSE, equal time", read: |curve, base| error(curve, base, SECONDS, RMSE) },
    Reading { title: "FLIP, equal time", read: |curve, base| error(curve, base, SECONDS, FLIP) },
    Reading { title: "rays, equal RMSE", read: |curve, base| cost(curve, base, RMSE, RAYS) },
    Reading { title: "time, equal RMSE", read: |curve, base| cost(curve, base, RMSE, SECONDS) },
    Reading { title: "rays, equal FLIP", read: |curve, base| cost(curve, base, FLIP, RAYS) },
    Reading { title: "time, equal FLIP", read: |curve, base| cost(curve, base, FLIP, SECONDS) },
];

fn error(curve: &[Point], base: &Point, cost: Measure, error: Measure) -> Option<f64> {
    ratio(error_at(curve, cost, cost(base), error)?, error(base))
}

fn cost(curve: &[Point], base: &Point, error: Measure, cost: Measure) -> Option<f64> {
    ratio(cost_for(curve, error, error(base), cost)?, cost(base))
}

fn ratio(one: f64, other: f64) -> Option<f64> {
    Some(one / other).filter(|ratio| ratio.is_finite())
}

pub(super) const HOW_TO_READ: &str = "What each sampler is worth against the first one with 16 rays a pixel, read off between the points: its error \
     after the same time, and the rays (all of them, those to lights included) and the time that it needs for the same error. Below 1 is better; \
     a dash: not within the measured points.";

/// A row for each sampling but the base: means over the scenes, or over those of which there is something to be read.
pub(super) fn summary(studies: &[Study], samplings: &[Sampling]) -> Part {
    let rows = others(samplings).map(|(number, sampling)| {
        let mean = |reading: &Reading| {
            let read: Vec<f64> = studies.iter().filter_map(|study| read(reading, study, number)).collect();
            let mean = shown(geometric_mean(read.iter().copied()));
            if read.len() < studies.len() { format!("{mean} ({} scenes)", read.len()) } else { mean }
        };
        [sampling.name.clone()].into_iter().chain(READINGS.iter().map(mean)).collect()
    });
    Part::Table { headings: headings(&["mean over the scenes"]), rows: rows.collect() }
}

/// A row for each scene and sampling but the base.
pub(super) fn comparison(studies: &[Study], samplings: &[Sampling]) -> Part {
    let rows = studies.iter().flat_map(|study| {
        others(samplings).map(move |(number, sampling)| {
            let cells = READINGS.iter().map(|reading| shown(read(reading, study, number)));
            [study.scene.to_owned(), sampling.name.clone()].into_iter().chain(cells).collect()
        })
    });
    Part::Table { headings: headings(&["scene", "sampler"]), rows: rows.collect() }
}

/// A row for each measured point.
pub(super) fn measured(studies: &[Study], samplings: &[Sampling]) -> Part {
    let row = |study: &Study, sampling: &Sampling, point: &Point| {
        vec![
            study.scene.to_owned(),
            sampling.name.clone(),
            format!("{:.1}", point.rays_per_pixel),
            format!("{:.0}", point.rays),
            format!("{:.2} ms", 1e3 * point.seconds),
            format!("{:.5}", point.rmse),
            format!("{:.5}", point.flip),
            format!("{:.5}", study.reference_error),
        ]
    };
    let rows = studies.iter().flat_map(|study| {
        let curves = samplings.iter().zip(&study.curves);
        curves.flat_map(move |(sampling, points)| points.iter().map(move |point| row(study, sampling, point)))
    });
    let titles = ["rays a pixel", "all rays", "time", "RMSE", "FLIP", "RMSE of the reference"];
    let columns = ["scene", "sampler"].map(|title| (title.to_owned(), Align::Left));
    let headings = columns.into_iter().chain(titles.map(|title| (title.to_owned(), Align::Right))).collect();
    Part::Table { headings, rows: rows.collect() }
}

fn others(samplings: &[Sampling]) -> impl Iterator<Item = (usize, &Sampling)> {
    samplings.iter().enumerate().filter(|(number, _)| *number != BASE)
}

fn read(reading: &Reading, study: &Study, sampling: usize) -> Option<f64> {
    (reading.read)(&study.curves[sampling], &study.curves[BASE][BASE_STEP])
}

fn headings(first: &[&str]) -> Vec<(String, Align)> {
    let first = first.iter().map(|title| ((*title).to_owned(), Align::Left));
    first.chain(READINGS.iter().map(|reading| (reading.title.to_owned(), Align::Right))).collect()
}

fn shown(ratio: Option<f64>) -> String {
    ratio.map_or_else(|| "–".to_owned(), |ratio| format!("{ratio:.2}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An error of `factor` / sqrt(rays), and a ray takes `ray` seconds.
    fn curve(factor: f64, ray: f64) -> Vec<Point> {
        let point = |rays: f64| {
            let error = factor / rays.sqrt();
            Point { rays_per_pixel: rays, rays, seconds: ray * rays, rmse: error, flip: error }
        };
        [1.0, 4.0, 16.0, 64.0].map(point).to_vec()
    }

    #[test]
    fn tables_show_what_a_sampling_is_worth() {
        let sampling = |name: &str| Sampling {
            name: name.to_owned(),
            sampler: render::random,
            light_samples: render::LightSamples::All,
            steps: Vec::new(),
        };
        let samplings = [sampling("random"), sampling("good"), sampling("bad")];
        let curves = vec![curve(1.0, 0.1), curve(0.5, 0.2), curve(4.0, 0.1)];
        let study = Study { scene: "pyramid", size: [4, 3], reference_rays: 1024, reference_error: 0.0, curves };
        let Part::Table { rows, headings } = comparison(&[study], &samplings) else { panic!("a table") };
        assert_eq!(headings.len(), 8);
        // Half the error for the same rays, each of which takes twice the time: a quarter of the rays for the same error, half the time; the same time
        // is half the rays, where the error is 0.5 x sqrt(2). Four times the error: 16 times the rays, more than were measured.
        assert_eq!(rows[0], ["pyramid", "good", "0.71", "0.71", "0.25", "0.50", "0.25", "0.50"]);
        assert_eq!(rows[1], ["pyramid", "bad", "4.00", "4.00", "–", "–", "–", "–"]);
    }
}
