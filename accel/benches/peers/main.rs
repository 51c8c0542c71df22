//! The same rays through girasol and others, in turn. See README.md.
#![allow(clippy::print_stdout, missing_docs, unreachable_pub)]

mod embree;
mod meshes;
mod rays;

use std::hint::black_box;
use std::time::Instant;

use accel::Accelerator;
use embree::{Embree, Mode};
use geometry::{Interval, Primitives, Ray};

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(&**word));
    println!("| mesh | rays | Embree Mrays/s | robust | exact | watertight |");
    println!("|---|---|---|---|---|---|");
    for (name, make) in meshes::all() {
        if !["primary", "diffuse", "shadow"].iter().any(|kind| wanted(&format!("{name} {kind}"))) {
            continue;
        }
        let scene = make();
        let mut primitives = Primitives::default();
        primitives.add_mesh(scene.mesh.clone());
        let start = Instant::now();
        let exact = accel::wide(primitives.clone());
        let built = start.elapsed().as_secs_f64();
        let watertight = accel::wide_watertight(primitives.clone());
        let start = Instant::now();
        let default = Embree::build(&scene.mesh.positions, &scene.mesh.triangles, Mode::Default, 2);
        let embree_built = start.elapsed().as_secs_f64();
        let robust = Embree::build(&scene.mesh.positions, &scene.mesh.triangles, Mode::Robust, 1);
        let rays = rays::of(&scene, &primitives, |ray| exact.closest(ray, Interval::FORWARD));
        let statistics = exact.statistics();
        println!(
            "| {name} | {} triangles, {} rays hit; built in {built:.3} s (Embree {embree_built:.3}); {:.1} B/tri, depth {} |",
            primitives.len(),
            rays.shadow.len(),
            statistics.bytes as f64 / f64::from(primitives.len()),
            statistics.depth
        );
        for (kind, rays) in [("primary", &rays.primary), ("diffuse", &rays.diffuse)] {
            let different = rays.iter().filter(|ray| {
                exact.closest(ray, Interval::FORWARD).map(|hit| hit.primitive) != robust.closest(ray).map(|hit| hit.0)
            });
            let different = different.count();
            let closest = |ray: &Ray| exact.closest(ray, Interval::FORWARD).map_or(0.0, |hit| hit.t);
            let closest_w = |ray: &Ray| watertight.closest(ray, Interval::FORWARD).map_or(0.0, |hit| hit.t);
            let others =
                [&default, &robust].map(|embree| move |ray: &Ray| embree.closest(ray).map_or(0.0, |hit| hit.1));
            report(
                wanted(&format!("{name} {kind}")),
                name,
                kind,
                rays,
                &[&others[0], &others[1], &closest, &closest_w],
                different,
            );
        }
        let different =
            rays.shadow.iter().filter(|ray| exact.any(ray, rays::SHADOW) != robust.any(ray, rays::SHADOW)).count();
        let any = |ray: &Ray| f32::from(exact.any(ray, rays::SHADOW));
        let any_w = |ray: &Ray| f32::from(watertight.any(ray, rays::SHADOW));
        let others = [&default, &robust].map(|embree| move |ray: &Ray| f32::from(embree.any(ray, rays::SHADOW)));
        report(
            wanted(&format!("{name} shadow")),
            name,
            "shadow",
            &rays.shadow,
            &[&others[0], &others[1], &any, &any_w],
            different,
        );
    }
}

/// Rays that one contestant traces before the next has its turn: a few milliseconds.
const TURN: usize = 1 << 12;
const ROUNDS: usize = 15;

fn report(wanted: bool, name: &str, kind: &str, rays: &[Ray], contestants: &[&dyn Fn(&Ray) -> f32], different: usize) {
    if !wanted {
        return;
    }
    let times = times(rays, contestants);
    let ratio = |a: usize, b: usize| times[a] / times[b];
    let speed = rays.len() as f64 / times[0] / 1e6;
    println!(
        "| {name} | {kind} | {speed:.2} | {:.2} | {:.2} ({:.2}) | {:.2} ({:.2}) | {different} differ",
        ratio(0, 1),
        ratio(0, 2),
        ratio(1, 2),
        ratio(0, 3),
        ratio(1, 3)
    );
}

/// The time of each contestant: for every turn the median of some rounds.
fn times(rays: &[Ray], contestants: &[&dyn Fn(&Ray) -> f32]) -> Vec<f64> {
    let mut totals = vec![0.0; contestants.len()];
    for turn in rays.chunks(TURN) {
        let mut rounds = vec![[0.0; ROUNDS]; contestants.len()];
        for round in 0..ROUNDS {
            for (contestant, times) in contestants.iter().zip(&mut rounds) {
                let start = Instant::now();
                let mut sum = 0.0;
                for ray in turn {
                    sum += contestant(ray);
                }
                black_box(sum);
                times[round] = start.elapsed().as_secs_f64();
            }
        }
        for (total, mut times) in totals.iter_mut().zip(rounds) {
            times.sort_by(f64::total_cmp);
            *total += times[0];
        }
    }
    totals
}
