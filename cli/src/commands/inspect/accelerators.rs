use std::time::Instant;

use accel::{Accelerator, Visits};
use geometry::{Interval, Primitives};

use super::thousands;
use crate::input::ReadyScene;
use crate::table::{Align, markdown};

type Build = fn(Primitives) -> Box<dyn Accelerator>;

/// Those to be read one after the other.
const BUILDERS: [(&str, Build); 3] = [("none", accel::none), ("octree", accel::octree), ("wide", accel::wide)];

/// So many camera rays along each edge of the picture are followed through each accelerator.
const RAYS_ALONG_EDGE: u32 = 64;

/// What each accelerator is made of for a scene, and what it makes of the scene's camera rays; the chosen one, too, if it is another.
pub(super) fn table(ready: &ReadyScene, chosen: Build) -> String {
    let is_known = BUILDERS.iter().any(|&(_, build)| std::ptr::fn_addr_eq(build, chosen));
    let other = (!is_known).then_some(("chosen", chosen));
    let rows: Vec<_> = BUILDERS.into_iter().chain(other).map(|(name, build)| row(name, build, ready)).collect();
    let headings = [
        "accelerator",
        "nodes",
        "depth",
        "leaves",
        "in a leaf",
        "at most",
        "bytes a primitive",
        "cost",
        "built in",
        "nodes a ray",
        "primitives a ray",
    ];
    let mut align = Align::Left;
    let headings = headings.map(|heading| (heading, std::mem::replace(&mut align, Align::Right)));
    format!(
        "{}\ncost: what a ray is expected to cost that passes all it might meet, in tests of a primitive.\n\
         a ray: the mean of {} camera rays, each followed to what it meets first.\n",
        markdown(&headings, &rows),
        thousands(u64::from(RAYS_ALONG_EDGE * RAYS_ALONG_EDGE))
    )
}

fn row(name: &str, build: Build, ready: &ReadyScene) -> Vec<String> {
    let scene = &ready.assembled.scene;
    let primitives = scene.bounded().clone();
    let count = f64::from(primitives.len().max(1));
    let start = Instant::now();
    let accelerator = build(primitives);
    let built = start.elapsed();
    let statistics = accelerator.statistics();
    let rays = scene.camera_rays(&ready.settings, RAYS_ALONG_EDGE);
    let visits = rays.iter().map(|ray| accelerator.visits(ray, Interval::FORWARD));
    let visits = visits.fold(Visits::default(), |sum, visits| Visits {
        nodes: sum.nodes + visits.nodes,
        primitives: sum.primitives + visits.primitives,
    });
    let mean = |sum: u64| format!("{:.1}", sum as f64 / rays.len() as f64);
    vec![
        name.to_owned(),
        thousands(statistics.branches as u64),
        statistics.depth.to_string(),
        thousands(statistics.leaves as u64),
        format!("{:.1}", statistics.references as f64 / statistics.leaves.max(1) as f64),
        thousands(statistics.largest_leaf as u64),
        format!("{:.1}", statistics.bytes as f64 / count),
        format!("{:.1}", statistics.cost),
        format!("{:.1} ms", 1e3 * built.as_secs_f64()),
        mean(visits.nodes),
        mean(visits.primitives),
    ]
}
