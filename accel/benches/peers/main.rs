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
    println!(
        "| mesh | rays | Embree, Mrays/s | robust | packets | exact (to robust) | exact many (to packets) | watertight (to robust) | watertight many (to packets) | differ |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
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
        let within = |kind: &str| if kind == "shadow" { rays::SHADOW } else { Interval::FORWARD };
        for (kind, rays) in [("primary", &rays.primary), ("shadow", &rays.shadow), ("diffuse", &rays.diffuse)] {
            let within = within(kind);
            let is_any = kind == "shadow";
            // As many as fill their packets.
            let rays = &rays[..rays.len() / 16 * 16];
            let single = |accelerator: &dyn Accelerator, rays: &[Ray]| {
                let mut sum = 0.0;
                for ray in rays {
                    sum += if is_any {
                        f32::from(accelerator.any(ray, within))
                    } else {
                        accelerator.closest(ray, within).map_or(0.0, |hit| hit.t)
                    };
                }
                sum
            };
            let many = |accelerator: &dyn Accelerator, rays: &[Ray]| {
                let mut sum = 0.0;
                let (mut hits, mut found) = ([None; 256], [false; 256]);
                for rays in rays.chunks(256) {
                    if is_any {
                        accelerator.any_many(rays, within, &mut found[..rays.len()]);
                        sum += found[..rays.len()].iter().map(|&found| f32::from(found)).sum::<f32>();
                    } else {
                        accelerator.closest_many(rays, &mut hits[..rays.len()]);
                        sum += hits[..rays.len()].iter().flatten().map(|hit| hit.t).sum::<f32>();
                    }
                }
                sum
            };
            let embree = |embree: &Embree, rays: &[Ray]| {
                let mut sum = 0.0;
                for ray in rays {
                    sum += if is_any {
                        f32::from(embree.any(ray, within))
                    } else {
                        embree.closest(ray).map_or(0.0, |hit| hit.1)
                    };
                }
                sum
            };
            let embree_many = |embree: &Embree, rays: &[Ray]| {
                let mut sum = 0.0;
                let (mut hits, mut found) = ([None; 16], [false; 16]);
                for rays in rays.chunks(16) {
                    if is_any {
                        embree.any_16(rays, within, &mut found);
                        sum += found.iter().map(|&found| f32::from(found)).sum::<f32>();
                    } else {
                        embree.closest_16(rays, &mut hits);
                        sum += hits.iter().flatten().map(|hit| hit.1).sum::<f32>();
                    }
                }
                sum
            };
            let (exact, watertight) = (&*exact, &*watertight);
            let contestants: [&Contestant; 7] = [
                &|rays| embree(&default, rays),
                &|rays| embree(&robust, rays),
                &|rays| embree_many(&default, rays),
                &|rays| single(exact, rays),
                &|rays| many(exact, rays),
                &|rays| single(watertight, rays),
                &|rays| many(watertight, rays),
            ];
            if !wanted(&format!("{name} {kind}")) {
                continue;
            }
            let different = rays.iter().filter(|ray| {
                if is_any {
                    exact.any(ray, within) != robust.any(ray, within)
                } else {
                    exact.closest(ray, within).map(|hit| hit.primitive) != robust.closest(ray).map(|hit| hit.0)
                }
            });
            let different = different.count();
            let times = times(rays, &contestants);
            let over = |a: usize, b: usize| times[a] / times[b];
            println!(
                "| {name} | {kind} | {:.1} | {:.2} | {:.2} | {:.2} ({:.2}) | {:.2} ({:.2}) | {:.2} ({:.2}) | {:.2} ({:.2}) | {different} |",
                rays.len() as f64 / times[0] / 1e6,
                over(0, 1),
                over(0, 2),
                over(0, 3),
                over(1, 3),
                over(0, 4),
                over(2, 4),
                over(0, 5),
                over(1, 5),
                over(0, 6),
                over(2, 6),
            );
        }
    }
}

/// Traces rays; what it returns depends on all of them.
type Contestant<'a> = dyn Fn(&[Ray]) -> f32 + 'a;

/// Rays that one contestant traces before the next has its turn: a millisecond.
const TURN: usize = 1 << 12;
const ROUNDS: usize = 7;

/// The time of each contestant: for every turn the least disturbed of some rounds.
fn times(rays: &[Ray], contestants: &[&Contestant]) -> Vec<f64> {
    let mut totals = vec![0.0; contestants.len()];
    for turn in rays.chunks(TURN) {
        let mut least = vec![f64::INFINITY; contestants.len()];
        for _ in 0..ROUNDS {
            for (contestant, least) in contestants.iter().zip(&mut least) {
                let start = Instant::now();
                black_box(contestant(turn));
                *least = least.min(start.elapsed().as_secs_f64());
            }
        }
        for (total, least) in totals.iter_mut().zip(least) {
            *total += least;
        }
    }
    totals
}
