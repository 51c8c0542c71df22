//! Figure 4: how far a picture is from the truth, against the time that it takes, for each way to choose samples.

mod charts;
mod curve;
mod samplings;
mod study;
mod tables;

use render::Modules;
use serde_json::{Value, json};

use super::figure::{BLUE, Figure, GREEN, GREY, Key, Mark, ORANGE, PINK, Part};
use super::{Effort, steps::Steps};
use crate::report::Failure;
use crate::scenes::EmbeddedScene;
use curve::{Measure, Point};
use samplings::{BASE, Sampling, all as samplings};
use study::Study;

/// Steps of [`figure`].
pub(crate) fn steps(scenes: &[&'static EmbeddedScene]) -> usize {
    scenes.len() * study::STEPS
}

pub(crate) fn figure(
    modules: &Modules,
    scenes: &[&'static EmbeddedScene],
    effort: &Effort,
    steps: &Steps,
) -> Result<Figure, Failure> {
    let samplings = samplings(modules);
    let measured = |scene: &'static EmbeddedScene| {
        study::study(scene, effort.image_width, effort.seed as u32, *modules, &samplings, &|| steps.advance())
    };
    let studies = scenes.iter().copied().map(measured).collect::<Result<Vec<_>, _>>()?;
    Ok(Figure {
        id: "images",
        title: "Image error against time",
        caption: caption(&studies),
        parts: parts(&studies, &samplings)?,
        data: data(&studies, &samplings),
    })
}

fn key(number: usize, sampling: &Sampling) -> Key {
    let colors = [GREY, BLUE, ORANGE, GREEN, PINK];
    let mark = match &*sampling.name {
        _ if number == BASE => Mark::Ring,
        "yours" => Mark::Square,
        _ => Mark::Disc,
    };
    Key { color: colors[number % colors.len()], mark, name: sampling.name.clone() }
}

/// The errors that are shown.
const ERRORS: [(&str, Measure); 2] = [("RMSE", |point| point.rmse), ("FLIP", |point| point.flip)];

fn caption(studies: &[Study]) -> String {
    let rays = studies.first().map_or(0, |study| study.reference_rays);
    format!(
        "Built-in scenes, rendered small with 1, 4, 16 and 64 rays a pixel by each sampler, and held against a reference of {rays} rays \
         with other random numbers. `random` is the report's way: a random place in each zone of a pixel, and every light of a soft shadow asked; \
         the others share those lights out among a pixel's rays. Adaptive rays go where neighbouring ones differ, between 2 and 256 of them a pixel. RMSE is the root of the mean square difference in linear light; FLIP is the mean of what an eye sees on \
         flipping between the two, 0 to 1. Lower and farther left is better. Independent random rays would fall as the root of their \
         number: a factor of two for each four times the time. Where all samplers meet at one ray a pixel they show the same picture: a \
         single ray goes through the pixel's centre."
    )
}

fn parts(studies: &[Study], samplings: &[Sampling]) -> Result<Vec<Part>, Failure> {
    let keys: Vec<Key> = samplings.iter().enumerate().map(|(number, sampling)| key(number, sampling)).collect();
    let mut parts = vec![
        Part::Legend(samplings.iter().enumerate().map(|(number, sampling)| key(number, sampling)).collect()),
        Part::Row(charts::overview(studies, &keys)?),
        tables::summary(studies, samplings),
        Part::Heading("Scene by scene".to_owned()),
    ];
    for (name, error) in ERRORS {
        parts.push(Part::Text(format!("{name} against seconds for a picture:")));
        parts.push(Part::Grid(charts::of_scenes(studies, &keys, name, error)?));
    }
    parts.push(Part::Text(tables::HOW_TO_READ.to_owned()));
    parts.push(tables::comparison(studies, samplings));
    parts.push(Part::Folded {
        title: "All that was measured".to_owned(),
        parts: vec![tables::measured(studies, samplings)],
    });
    Ok(parts)
}

fn data(studies: &[Study], samplings: &[Sampling]) -> Value {
    let point = |point: &Point| {
        json!({
            "rays_per_pixel": point.rays_per_pixel, "rays": point.rays, "seconds": point.seconds,
            "rmse": point.rmse, "flip": point.flip,
        })
    };
    let curve = |(sampling, points): (&Sampling, &Vec<Point>)| json!({ "sampling": sampling.name, "points": points.iter().map(point).collect::<Vec<_>>() });
    let scene = |study: &Study| {
        json!({
            "scene": study.scene,
            "size": study.size,
            "reference_rays_per_pixel": study.reference_rays,
            "reference_rmse": study.reference_error,
            "curves": samplings.iter().zip(&study.curves).map(curve).collect::<Vec<_>>(),
        })
    };
    Value::from(studies.iter().map(scene).collect::<Vec<_>>())
}
