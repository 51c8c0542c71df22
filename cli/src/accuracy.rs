//! Speed against error: the measurements of `girasol accuracy`, and the page that shows them.
//!
//! Errors are the same on every run with the same seed; times are this machine's.

mod aimed;
pub(crate) mod chart;
mod exact;
mod families;
pub(crate) mod figure;
mod images;
pub(crate) mod instructions;
mod kernels;
mod machine;
mod measure;
mod new_rays;
pub(crate) mod page;
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
use instructions::Counts;
pub(crate) use machine::machine;
pub(crate) use pictures::png;
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
    /// Whether Valgrind counts instructions.
    pub(crate) count_instructions: bool,
    /// The size of the pictures of figure 5.
    pub(crate) picture: [u32; 2],
    /// Their anti-aliasing.
    pub(crate) picture_aa: u32,
    /// The width of the pictures of figure 4.
    pub(crate) image_width: u32,
}

impl Effort {
    /// For a page that is shown.
    pub(crate) const fn full(seed: u64) -> Self {
        Self {
            seed,
            cases: 20_000,
            rounds: 40,
            count_instructions: true,
            picture: [1050, 315],
            picture_aa: 1,
            image_width: 64,
        }
    }

    /// For a first look.
    pub(crate) const fn quick(seed: u64) -> Self {
        Self {
            seed,
            cases: 2_000,
            rounds: 5,
            count_instructions: false,
            picture: [200, 60],
            picture_aa: 0,
            image_width: 16,
        }
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
    let counted = if effort.count_instructions { instructions::steps(&modules.kernels) } else { 0 };
    let images = images::steps(scenes);
    let total = counted + speed::steps() + sweeps::steps() + new_rays::STEPS + images + pictures::STEPS;
    let steps = Steps::start(total, progress);
    let counts = if effort.count_instructions {
        Counts::of_all(&modules.kernels, effort.seed, &|| steps.advance())
    } else {
        Counts::none("a quick run leaves them out")
    };
    let figures = [
        speed::figure(modules, &counts, effort, &steps)?,
        sweeps::figure(modules, effort, &steps)?,
        new_rays::figure(modules, effort, &steps)?,
        images::figure(modules, scenes, effort, &steps)?,
        pictures::figure(effort, &steps)?,
    ];
    steps.finish();
    Ok(assembled(effort, &figures))
}

fn assembled(effort: &Effort, figures: &[Figure]) -> Report {
    let machine = machine();
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

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::{Intersection, Interval, Kernels, Primitive, Ray, Surface, Triangle};

    const SMALL: Effort = Effort { cases: 300, rounds: 1, picture: [40, 12], ..Effort::quick(5) };

    /// All but figure 4, which has its own tests and takes longer.
    fn made(modules: &Modules) -> Report {
        let steps = Steps::start(1, Progress::Silent);
        let figures = [
            speed::figure(modules, &Counts::none("of a test"), &SMALL, &steps),
            sweeps::figure(modules, &SMALL, &steps),
            new_rays::figure(modules, &SMALL, &steps),
            pictures::figure(&SMALL, &steps),
        ];
        assembled(&SMALL, &figures.map(Result::unwrap))
    }

    /// Everything but the times.
    fn errors(report: &Report) -> Value {
        let mut figures = report.json["figures"].clone();
        for kernel in figures["speed"].as_array_mut().unwrap() {
            kernel["ns"] = Value::Null;
            for family in kernel["families"].as_array_mut().unwrap() {
                family["ns"] = Value::Null;
            }
        }
        figures
    }

    #[test]
    fn two_runs_find_the_same_errors_and_the_page_needs_nothing_else() {
        let (one, other) = (made(&Modules::default()), made(&Modules::default()));
        assert!(errors(&one) == errors(&other), "the errors differ from run to run");
        assert_eq!(one.json["figures"].as_object().unwrap().len(), 4);
        for wanted in ["<script", "http:", "https:", "src=\"/", "@import", "url("] {
            let html = one.html.replace("http://www.w3.org/2000/svg", "");
            assert!(!html.contains(wanted), "{wanted}");
        }
        // Links lead to places of the page itself.
        for link in one.html.split("href=\"").skip(1) {
            let id = link.split('"').next().unwrap();
            assert!(one.html.contains(&format!("id=\"{}\"", id.trim_start_matches('#'))), "{id}");
        }
        let text = one.json.to_string();
        assert!(serde_json::from_str::<Value>(&text).unwrap()["figures"]["speed"].is_array());
        assert!(!text.contains("yours"));
    }

    /// A student's triangle that is found a thousandth too far, and new rays that start where the surface is.
    #[test]
    fn somebodys_own_kernels_stand_beside_ours_with_their_errors() {
        fn too_far(triangle: &Triangle, ray: &Ray, within: Interval) -> Option<Intersection> {
            triangle.intersect(ray, within).map(|met| Intersection { t: met.t * 1.001, ..met })
        }
        let modules = Modules {
            kernels: Kernels { triangle: Some(too_far), ..Kernels::default() },
            ray_origin: |surface: &Surface, _| surface.position,
            ..Modules::default()
        };
        let report = made(&modules);
        let figures = &report.json["figures"];
        let kernels = figures["speed"].as_array().unwrap();
        let yours: Vec<_> = kernels.iter().filter(|kernel| kernel["whose"] == "yours").collect();
        assert_eq!(yours.len(), 1);
        assert_eq!(yours[0]["primitive"], "triangle");
        // A thousandth is 2^23 / 1000 to 2^24 / 1000 units in the last place.
        let median = yours[0]["errors"]["ulp"]["p50"].as_f64().unwrap();
        assert!((8388.0..16778.0).contains(&median), "{median}");
        assert!(figures["sweeps"].to_string().contains("yours"));
        let ways = figures["new-rays"].as_array().unwrap();
        let acne: Vec<f64> = ways
            .iter()
            .filter(|way| way["way"] == "yours" && way["body"] == "sphere")
            .flat_map(|way| way["acne"].as_array().unwrap())
            .map(|share| share.as_f64().unwrap())
            .collect();
        assert!(!acne.is_empty() && acne.iter().all(|&share| share > 0.1), "{acne:?}");
        assert!(report.html.contains("yours"));
    }

    #[test]
    fn new_rays_of_girasol_neither_meet_what_they_leave_nor_jump_over_what_is_near() {
        let report = made(&Modules::default());
        let ways = report.json["figures"]["new-rays"].as_array().unwrap().clone();
        let worst = |whose: &str, what: &str| -> f64 {
            let shares = ways.iter().filter(|way| way["way"].as_str().unwrap().contains(whose));
            shares
                .flat_map(|way| way[what].as_array().unwrap())
                .map(|share| share.as_f64().unwrap())
                .fold(0.0, f64::max)
        };
        assert_eq!((worst("girasol", "acne"), worst("girasol", "leaks")), (0.0, 0.0));
        assert!(worst("along the normal", "acne") > 0.4 && worst("along the normal", "leaks") > 0.9);
        assert!(worst("t from", "acne") > 0.4 && worst("t from", "leaks") > 0.9);
    }
}
