//! What it takes to build the wide octree, from ten thousand triangles to ten million: time, and memory at the end and at the peak.
//!
//! ```console
//! $ cargo bench -p accel --bench build                 # two minutes
//! $ cargo bench -p accel --bench build -- 1000000      # up to so many triangles
//! ```
//!
//! The mesh is the bumpy knot of the bench against peers, finer and finer; and its fence, whose thin triangles stand in pieces. Times are the
//! least of some rounds, so that they hold on a busy machine; `ns per n log n` is the time on one thread over the triangles and their
//! logarithm: it does not grow. Bytes are what the accelerator takes beside the primitives themselves, counted by the allocator. The bench
//! against peers has Embree's time to build.
#![allow(clippy::print_stdout, missing_docs, unreachable_pub)]

#[allow(dead_code)]
#[path = "peers/meshes.rs"]
mod meshes;

use std::time::Instant;

use accel::wide;
use geometry::{Mesh, Primitives};
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

fn main() {
    let most = std::env::args().skip(1).filter_map(|word| word.parse().ok()).next().unwrap_or(10_000_000);
    println!(
        "| mesh | triangles | 1 thread, ms | 2 threads, ms | ns per n log n | bytes a triangle | peak, of these |"
    );
    println!("|---|--:|--:|--:|--:|--:|--:|");
    for triangles in [10_000, 100_000, 1_000_000, 10_000_000].into_iter().filter(|&triangles| triangles <= most) {
        print_row("knot", knot(triangles));
    }
    for (name, make) in meshes::all().into_iter().filter(|(name, _)| *name == "fence") {
        print_row(name, make().mesh);
    }
}

fn print_row(name: &str, mesh: Mesh) {
    let rounds = if mesh.triangles.len() > 1_000_000 { 2 } else { 7 };
    let mut primitives = Primitives::default();
    primitives.add_mesh(mesh);
    let count = primitives.len() as usize;
    let mut times = [f64::INFINITY; 2];
    let mut memory = Memory { built: 0, peak: 0 };
    for _ in 0..rounds {
        for threads in [1, 2] {
            let (time, of_this) = build(&primitives, threads);
            times[threads - 1] = times[threads - 1].min(time);
            memory = Memory { built: of_this.built, peak: memory.peak.max(of_this.peak) };
        }
    }
    println!(
        "| {name} | {count} | {:.1} | {:.1} | {:.2} | {:.1} | {:.2} |",
        1e3 * times[0],
        1e3 * times[1],
        1e9 * times[0] / (count as f64 * (count as f64).log2()),
        memory.built as f64 / count as f64,
        memory.peak as f64 / memory.built as f64,
    );
}

/// Bytes beside the primitives.
struct Memory {
    built: usize,
    peak: usize,
}

fn build(primitives: &Primitives, threads: usize) -> (f64, Memory) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let primitives = primitives.clone();
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let start = Instant::now();
    let accelerator = pool.install(|| wide(primitives));
    let time = start.elapsed().as_secs_f64();
    let memory = Memory { built: MEMORY.current_usage() - before, peak: MEMORY.peak_usage() - before };
    drop(accelerator);
    (time, memory)
}

/// The knot, of about so many triangles.
fn knot(triangles: u32) -> Mesh {
    let around = (f64::from(triangles) / 80.0).sqrt() as u32;
    meshes::knot(triangles / (2 * around), around).mesh
}
