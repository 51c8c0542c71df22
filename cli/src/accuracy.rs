//! Speed against error: the measurements of `girasol accuracy`, and the page that shows them.
//!
//! Errors are the same on every run with the same seed; times are this machine's.

mod aimed;
pub(crate) mod chart;
mod exact;
mod families;
pub(crate) mod figure;
mod images;
mod instructions;
mod kernels;
mod machine;
mod measure;
mod new_rays;
mod page;
mod pictures;
mod random;
mod speed;
pub(crate) mod steps;
mod sweeps;
mod text;
mod truth;

use render::Modules;
use serde_json::{Map, Value, json};

use crate::progress::Progress;
use crate::report::Failure;
use crate::scenes::EmbeddedScene;
use figure::Figure;
use steps::Steps;

/// How much is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Effort {
    /// Begins the random cases.
    pub(crate) seed: u64,
    /// Random cases for each kernel and family.
    pub(crate) cases: usize,
    /// How often each kernel is timed on each family; the least time counts.
    pub(crate) rounds: usize,
    /// The size of the pictures of figure 5.
    pub(crate) picture: [u32; 2],
    /// Their anti-aliasing.
    pub(crate) picture_aa: u32,
    /// The width of the pictures of figure 4.
    pub(crate) image_width: u32,
}

impl Effort {
    /// For a page that is shown.
    pub(crate) fn full(seed: u64) -> Self {
        Self { seed, cases: 20_000, rounds: 40, picture: [1050, 315], picture_aa: 1, image_width: 64 }
    }

    /// For a first look.
    pub(crate) fn quick(seed: u64) -> Self {
        Self { seed, cases: 2_000, rounds: 5, picture: [200, 60], picture_aa: 0, image_width: 16 }
    }
}

/// The page and the JSON.
pub(crate) struct Report {
    /// One HTML file.
    pub(crate) html: String,
    /// The numbers of all its figures.
    pub(crate) json: Value,
}

/// Measures everything, image errors with the given scenes. Kernels and the sampler of `modules` that are not ours appear beside ours.
pub(crate) fn report(
    modules: &Modules,
    effort: &Effort,
    scenes: &[&'static EmbeddedScene],
    progress: Progress,
) -> Result<Report, Failure> {
    let steps = Steps::start(
        speed::steps() + sweeps::steps() + new_rays::STEPS + images::steps(scenes) + pictures::STEPS,
        progress,
    );
    let figures = [
        speed::figure(modules, &instructions::Counts::default(), effort, &steps)?,
        sweeps::figure(modules, effort, &steps)?,
        new_rays::figure(modules, effort, &steps)?,
        images::figure(modules, scenes, effort, &steps)?,
        pictures::figure(effort, &steps)?,
    ];
    steps.finish();
    Ok(assembled(effort, &figures))
}

fn assembled(effort: &Effort, figures: &[Figure]) -> Report {
    let machine = machine::machine();
    let settings = settings(effort);
    let about = [&machine[..], &settings[..]].concat();
    let object = |facts: &[(String, String)]| -> Map<String, Value> {
        facts.iter().map(|(name, fact)| (name.clone(), Value::from(fact.clone()))).collect()
    };
    let data: Map<String, Value> = figures.iter().map(|figure| (figure.id.to_owned(), figure.data.clone())).collect();
    Report {
        html: page::page(&about, figures),
        json: json!({ "machine": object(&machine), "settings": object(&settings), "figures": data }),
    }
}

fn settings(effort: &Effort) -> Vec<(String, String)> {
    [
        ("Seed", effort.seed.to_string()),
        ("Cases", format!("{} for each kernel and family", effort.cases)),
        ("Timing", format!("the least of {} rounds, one thread, data in the first cache", effort.rounds)),
        ("Truth", "double-double arithmetic, 106 bits".to_owned()),
    ]
    .map(|(name, fact)| (name.to_owned(), fact))
    .into()
}
