//! What each step gains, from asking every primitive to packets of rays.
//!
//! ```console
//! $ cargo bench -p accel --bench steps                        # four meshes of 50 to 490 thousand triangles; a few minutes
//! $ cargo bench -p accel --bench steps -- body fence          # those whose name holds one of the words
//! ```
//!
//! Meshes and rays are those of the bench against peers (its README.md describes them). The table has thousands of rays a second, on one thread,
//! for camera, shadow and diffuse rays; all take turns of eight thousand rays, whose ways are too many for the processor to foresee them from
//! the last round; and of some rounds of each turn the least disturbed counts. Time is that of the thread on the processor.
//! Some of the rays are asked of every exact step beforehand: all give the same hits.
#![allow(clippy::print_stdout, missing_docs, unreachable_pub)]

#[allow(dead_code)]
#[path = "peers/meshes.rs"]
mod meshes;
#[path = "peers/rays.rs"]
mod rays;

use std::hint::black_box;

use accel::{Accelerator, Step, none, octree, wide_up_to, wide_watertight};
use cpu_time::ThreadTime;
use geometry::{Interval, Primitives, Ray};

/// One at a time, or many in a call.
#[derive(Clone, Copy)]
enum Calls {
    Single,
    Many,
}

/// The step that is left out where no triangle is thin.
const IN_PIECES: &str = "thin triangles in pieces";

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    let wanted =
        |name: &str| name != "knot 1 M" && (words.is_empty() || words.iter().any(|word| name.contains(&**word)));
    println!(
        "| mesh | step | camera, k/s | shadow, k/s | diffuse, k/s | nodes a camera ray | primitives a camera ray |"
    );
    println!("|---|---|--:|--:|--:|--:|--:|");
    for (name, make) in meshes::all().into_iter().filter(|(name, _)| wanted(name)) {
        let scene = make();
        let mut primitives = Primitives::default();
        primitives.add_mesh(scene.mesh.clone());
        let built = |build: &dyn Fn(Primitives) -> Box<dyn Accelerator>| build(primitives.clone());
        let up_to = |step| built(&|primitives| wide_up_to(primitives, step));
        let trees = [
            built(&none),
            built(&octree),
            up_to(Step::OneLevel),
            up_to(Step::CheapestCuts),
            up_to(Step::ThinInPieces),
            built(&wide_watertight),
        ];
        let steps: [(&str, usize, Calls); 8] = [
            ("every primitive", 0, Calls::Single),
            ("the textbook octree", 1, Calls::Single),
            ("boxes side by side, one level a node", 2, Calls::Single),
            ("the cheapest cuts", 3, Calls::Single),
            (IN_PIECES, 4, Calls::Single),
            ("... in packets", 4, Calls::Many),
            ("watertight", 5, Calls::Single),
            ("... in packets", 5, Calls::Many),
        ];
        let rays = rays::of(&scene, &primitives, |ray| trees[4].closest(ray, Interval::FORWARD));
        let kinds = [(&rays.primary, None), (&rays.shadow, Some(rays::SHADOW)), (&rays.diffuse, None)];
        let speeds = kinds.map(|(rays, any)| speeds(rays, any, &trees, &steps));
        for ray in rays.primary.iter().chain(&rays.diffuse).step_by(997) {
            let expected = trees[1].closest(ray, Interval::FORWARD);
            assert!(trees[2..5].iter().all(|tree| tree.closest(ray, Interval::FORWARD) == expected), "{ray:?}");
        }
        let is_cut = trees[4].statistics() != trees[3].statistics();
        for (number, (step, tree, _)) in steps.iter().enumerate() {
            if *step == IN_PIECES && !is_cut {
                continue;
            }
            let visits: Vec<_> =
                rays.primary.iter().step_by(61).map(|ray| trees[*tree].visits(ray, Interval::FORWARD)).collect();
            let mean = |of: &dyn Fn(usize) -> u64| (0..visits.len()).map(of).sum::<u64>() as f64 / visits.len() as f64;
            let speed = speeds.each_ref().map(|speeds| speeds[number] / 1e3);
            println!(
                "| {name} | {step} | {} | {} | {} | {:.1} | {:.1} |",
                three_digits(speed[0]),
                three_digits(speed[1]),
                three_digits(speed[2]),
                mean(&|ray| visits[ray].nodes),
                mean(&|ray| visits[ray].primitives),
            );
        }
    }
}

fn three_digits(number: f64) -> String {
    if number >= 100.0 { format!("{number:.0}") } else { format!("{number:.2}") }
}

/// Rays that one step traces before the next has its turn.
const TURN: usize = 1 << 13;
/// So many turns, spread over the rays.
const TURNS: usize = 8;
const ROUNDS: usize = 5;
/// Rays enough to time asking every primitive.
const FEW: usize = 4;

/// Rays a second of each step. `any` is where to look for anything; without it, what is nearest is sought.
fn speeds(
    rays: &[Ray],
    any: Option<Interval>,
    trees: &[Box<dyn Accelerator>],
    steps: &[(&str, usize, Calls)],
) -> Vec<f64> {
    let apart = (rays.len() / TURNS).max(TURN);
    let turns: Vec<&[Ray]> = rays.chunks(apart).map(|part| &part[..TURN.min(part.len()) / 16 * 16]).collect();
    let mut totals = vec![(0.0, 0); steps.len()];
    for (number, turn) in turns.into_iter().enumerate() {
        let mut least = vec![f64::INFINITY; steps.len()];
        for round in 0..ROUNDS {
            for ((_, tree, calls), least) in steps.iter().zip(&mut least) {
                let is_slow = *tree == 0;
                if is_slow && (number > 0 || round > 0) {
                    continue;
                }
                let turn = if is_slow { &turn[..FEW.min(turn.len())] } else { turn };
                let start = ThreadTime::now();
                black_box(trace(&*trees[*tree], turn, any, *calls));
                *least = least.min(start.elapsed().as_secs_f64());
            }
        }
        for ((_, tree, _), (least, total)) in steps.iter().zip(least.into_iter().zip(&mut totals)) {
            if least.is_finite() {
                *total = (total.0 + least, total.1 + if *tree == 0 { FEW.min(turn.len()) } else { turn.len() });
            }
        }
    }
    totals.into_iter().map(|(time, rays)| rays as f64 / time).collect()
}

/// Something that depends on every answer.
fn trace(tree: &dyn Accelerator, rays: &[Ray], any: Option<Interval>, calls: Calls) -> f32 {
    match (calls, any) {
        (Calls::Single, None) => {
            rays.iter().filter_map(|ray| tree.closest(ray, Interval::FORWARD)).map(|hit| hit.t).sum()
        }
        (Calls::Single, Some(within)) => rays.iter().map(|ray| f32::from(tree.any(ray, within))).sum(),
        (Calls::Many, None) => {
            let mut hits = vec![None; rays.len()];
            tree.closest_many(rays, &mut hits);
            hits.into_iter().flatten().map(|hit| hit.t).sum()
        }
        (Calls::Many, Some(within)) => {
            let mut found = vec![false; rays.len()];
            tree.any_many(rays, within, &mut found);
            found.into_iter().map(f32::from).sum()
        }
    }
}
