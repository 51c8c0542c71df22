//! The figure's diagrams.

use super::ERRORS;
use super::curve::{Measure, Point, geometric_mean};
use super::samplings::{BASE, BASE_STEP};
use super::study::Study;
use crate::accuracy::chart::{Chart, Line, Series};
use crate::accuracy::figure::{Key, Part};
use crate::report::Failure;

/// Each error against the time, in the mean over all scenes: both as shares of what the base has with 16 rays a pixel.
pub(super) fn overview(studies: &[Study], keys: &[Key]) -> Result<Vec<Part>, Failure> {
    let chart = |(name, error): (&str, Measure)| {
        let relative = |sampling: usize, number: usize, measure: Measure| {
            let ratio =
                |study: &Study| measure(&study.curves[sampling][number]) / measure(&study.curves[BASE][BASE_STEP]);
            geometric_mean(studies.iter().map(ratio).filter(|ratio| ratio.is_normal()))
        };
        let curves: Vec<Vec<[f64; 2]>> = (0..keys.len())
            .map(|sampling| {
                let count = studies.first().map_or(0, |study| study.curves[sampling].len());
                let place = |number| {
                    Some([relative(sampling, number, |point| point.seconds)?, relative(sampling, number, error)?])
                };
                (0..count).filter_map(place).collect()
            })
            .collect();
        let base = &keys[BASE].name;
        let chart = Chart {
            title: format!("{name}, mean over the scenes"),
            x_label: format!("time, {base} with 16 rays a pixel = 1"),
            y_label: format!("{name}, {base} with 16 rays = 1"),
            ..chart_of(&curves, keys)
        };
        let alt = format!(
            "{name} against time in the mean over all scenes, a curve for each sampler; the table below has what is read off it"
        );
        Ok(Part::Svg { svg: chart.svg()?, alt })
    };
    ERRORS.into_iter().map(chart).collect()
}

/// A small diagram for each scene.
pub(super) fn of_scenes(studies: &[Study], keys: &[Key], name: &str, error: Measure) -> Result<Vec<Part>, Failure> {
    let chart = |study: &Study| {
        let place = |point: &Point| [point.seconds, error(point)];
        let curves: Vec<Vec<[f64; 2]>> = study.curves.iter().map(|points| points.iter().map(place).collect()).collect();
        let chart = Chart { title: study.scene.to_owned(), ..chart_of(&curves, keys) };
        let alt = format!("{name} against seconds, scene {}: the table below has the numbers", study.scene);
        Ok(Part::Svg { svg: chart.small_svg()?, alt })
    };
    studies.iter().map(chart).collect()
}

fn chart_of(curves: &[Vec<[f64; 2]>], keys: &[Key]) -> Chart {
    let series = curves.iter().zip(keys).map(|(points, key)| Series {
        color: key.color,
        mark: key.mark,
        line: Line::Full,
        points: points.clone(),
        label: None,
    });
    Chart {
        title: String::new(),
        x_label: String::new(),
        y_label: String::new(),
        x: decades(curves.iter().flatten().map(|point| point[0])),
        y: decades(curves.iter().flatten().map(|point| point[1])),
        y_floor: None,
        series: series.collect(),
    }
}

/// The powers of ten around some numbers; those that have no logarithm do not count.
fn decades(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let powers = values.map(f64::log10).filter(|power| power.is_finite());
    let (low, high) =
        powers.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), power| (power.min(low), power.max(high)));
    if low > high {
        return [0.1, 1.0];
    }
    let low = low.floor();
    [low, high.ceil().max(low + 1.0)].map(|power| 10_f64.powi(power as i32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_runs_from_power_of_ten_to_power_of_ten() {
        assert_eq!(decades([0.02, 0.5].into_iter()), [0.01, 1.0]);
        assert_eq!(decades([3.0, 4.0, 0.0].into_iter()), [1.0, 10.0]);
        assert_eq!(decades([1.0].into_iter()), [1.0, 10.0]);
        assert_eq!(decades([0.0].into_iter()), [0.1, 1.0]);
    }
}
