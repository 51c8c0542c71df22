//! The same rays through girasol and others, in turn. See README.md.
#![allow(clippy::print_stdout, clippy::print_stderr, missing_docs, unreachable_pub)]

mod contest;
mod crates;
mod embree;
mod meshes;
mod rays;
mod table;
mod targets;
mod tracer;

use std::process::ExitCode;
use std::time::Instant;

use accel::Accelerator;
use contest::{Ask, Contestant, differences, many, packets, single, times};
use crates::{BvhCrate, Obvhs};
use embree::{Embree, Installed, Mode};
use geometry::{Interval, Primitives, Ray};
use meshes::Scene;
use obvhs::{bvh2::Bvh2, cwbvh::CwBvh};
use table::{Row, Who};

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let (quick, words): (Vec<_>, Vec<_>) = words.into_iter().partition(|word| word == "--quick");
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(&**word));
    let embree = match Installed::three() {
        Ok(embree) => embree,
        Err(error) => {
            eprintln!("Embree 3 is not installed; README.md says how to get it. ({error})");
            return ExitCode::FAILURE;
        }
    };
    let embree_4 = std::env::var_os("EMBREE4").map(|place| Installed::four(place.as_ref()));
    let embree_4 = match embree_4.transpose() {
        Ok(embree) => embree.filter(|_| quick.is_empty()),
        Err(error) => {
            eprintln!("EMBREE4 does not name an Embree 4. ({error})");
            return ExitCode::FAILURE;
        }
    };
    if embree_4.is_none() {
        eprintln!("Without Embree 4: see README.md.");
    }
    println!("{}", table::HEAD);
    let mut rows = Vec::new();
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
        let default = Embree::build(&embree, &scene, Mode::Default, rayon_threads());
        let embree_built = start.elapsed().as_secs_f64();
        let robust = Embree::build(&embree, &scene, Mode::Robust, 1);
        let others = quick.is_empty().then(|| Others::build(&scene, embree_4.as_ref()));
        let rays = rays::of(&scene, &primitives, |ray| exact.closest(ray, Interval::FORWARD));
        let statistics = exact.statistics();
        println!(
            "| {name} | {} triangles, {} rays hit; built in {built:.3} s (Embree {embree_built:.3}); {:.1} B/tri, depth {} |",
            primitives.len(),
            rays.shadow.len(),
            statistics.bytes as f64 / f64::from(primitives.len()),
            statistics.depth
        );
        let within = Ask::Any(rays::SHADOW);
        let kinds = [
            ("primary", &rays.primary, Ask::Closest),
            ("shadow", &rays.shadow, within),
            ("diffuse", &rays.diffuse, Ask::Closest),
        ];
        for (kind, rays, ask) in kinds.into_iter().filter(|(kind, ..)| wanted(&format!("{name} {kind}"))) {
            // As many as fill their packets.
            let rays = &rays[..rays.len() / 16 * 16];
            let (exact, watertight): (&dyn Accelerator, &dyn Accelerator) = (&*exact, &*watertight);
            let mut row = Row::new(name, kind, rays.len());
            let mut contestants: Vec<(Who, Contestant)> = vec![
                (Who::Embree, single(&default, ask)),
                (Who::Robust, single(&robust, ask)),
                (Who::Packets, packets(&default, ask)),
                (Who::Exact, single(&exact, ask)),
                (Who::ExactMany, many(exact, ask)),
                (Who::Watertight, single(&watertight, ask)),
                (Who::WatertightMany, many(watertight, ask)),
            ];
            row.differ(Who::Robust, differences(rays, ask, &exact, &robust));
            if let Some(others) = &others {
                others.join(&mut contestants, &mut row, rays, ask, &exact);
            }
            let (who, contestants): (Vec<_>, Vec<_>) = contestants.into_iter().unzip();
            for (who, time) in who.into_iter().zip(times(rays, &contestants)) {
                row.took(who, time);
            }
            println!("{}", row.line());
            rows.push(row);
        }
    }
    if quick.is_empty() {
        table::print_others(&rows);
    }
    targets::print(&rows);
    ExitCode::SUCCESS
}

/// As many as build girasol's trees.
fn rayon_threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Those beside Embree 3.
struct Others<'a> {
    embree: Option<[Embree<'a>; 2]>,
    obvhs_wide: Obvhs<CwBvh>,
    obvhs_binary: Obvhs<Bvh2>,
    bvh: BvhCrate,
}

impl<'a> Others<'a> {
    fn build(scene: &Scene, embree: Option<&'a Installed>) -> Self {
        Self {
            embree: embree
                .map(|embree| [Mode::Default, Mode::Robust].map(|mode| Embree::build(embree, scene, mode, 1))),
            obvhs_wide: Obvhs::wide(scene),
            obvhs_binary: Obvhs::binary(scene),
            bvh: BvhCrate::build(scene),
        }
    }

    fn join<'b>(
        &'b self,
        contestants: &mut Vec<(Who, Contestant<'b>)>,
        row: &mut Row,
        rays: &[Ray],
        ask: Ask,
        exact: &&dyn Accelerator,
    ) {
        let Self { embree, obvhs_wide, obvhs_binary, bvh } = self;
        if let Some([default, robust]) = embree {
            contestants.push((Who::Embree4, single(default, ask)));
            contestants.push((Who::Robust4, single(robust, ask)));
            contestants.push((Who::Packets4, packets(default, ask)));
            row.differ(Who::Robust4, differences(rays, ask, exact, robust));
        }
        contestants.push((Who::ObvhsWide, single(obvhs_wide, ask)));
        contestants.push((Who::ObvhsBinary, single(obvhs_binary, ask)));
        contestants.push((Who::Bvh, single(bvh, ask)));
        row.differ(Who::ObvhsWide, differences(rays, ask, exact, obvhs_wide));
        row.differ(Who::ObvhsBinary, differences(rays, ask, exact, obvhs_binary));
        row.differ(Who::Bvh, differences(rays, ask, exact, bvh));
    }
}
