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
    println!("| mesh | rays | Embree Mrays/s | robust | exact |");
    println!("|---|---|---|---|---|");
    for (name, make) in meshes::all() {
        if !wanted(name) {
            continue;
        }
        let scene = make();
        let mut primitives = Primitives::default();
        primitives.add_mesh(scene.mesh.clone());
        let start = Instant::now();
        let exact = accel::wide(primitives.clone());
        let built = start.elapsed().as_secs_f64();
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
            let others =
                [&default, &robust].map(|embree| move |ray: &Ray| embree.closest(ray).map_or(0.0, |hit| hit.1));
            report(name, kind, rays, &[&others[0], &others[1], &closest], different);
        }
        let different =
            rays.shadow.iter().filter(|ray| exact.any(ray, rays::SHADOW) != robust.any(ray, rays::SHADOW)).count();
        let any = |ray: &Ray| f32::from(exact.any(ray, rays::SHADOW));
        let others = [&default, &robust].map(|embree| move |ray: &Ray| f32::from(embree.any(ray, rays::SHADOW)));
        report(name, "shadow", &rays.shadow, &[&others[0], &others[1], &any], different);
    }
}

fn report(name: &str, kind: &str, rays: &[Ray], contestants: &[&dyn Fn(&Ray) -> f32], different: usize) {
    const ROUNDS: usize = 9;
    let mut times = vec![Vec::new(); contestants.len()];
    for _ in 0..ROUNDS {
        for (contestant, times) in contestants.iter().zip(&mut times) {
            let start = Instant::now();
            let mut sum = 0.0;
            for ray in rays {
                sum += contestant(ray);
            }
            black_box(sum);
            times.push(start.elapsed().as_secs_f64());
        }
    }
    let median = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let ratio = |a: usize, b: usize| median((0..ROUNDS).map(|round| times[a][round] / times[b][round]).collect());
    let speed = rays.len() as f64 / median(times[0].clone()) / 1e6;
    println!(
        "| {name} | {kind} | {speed:.2} | {:.2} | {:.2} (robust {:.2}) | {different} differ",
        ratio(0, 1),
        ratio(0, 2),
        ratio(1, 2)
    );
}
