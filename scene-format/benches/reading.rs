//! How fast a scene is read, and how much memory that takes: `cargo bench -p scene-format -- FILE.sc ...`, or without files a mesh
//! that is made up here.
//!
//! A plain program: nothing here needs statistics beyond the fastest of several runs, and it counts bytes, too.
#![expect(clippy::print_stdout, reason = "a table for whoever runs it")]

use std::fmt::Write;
use std::hint::black_box;
use std::mem::size_of_val;
use std::time::Instant;

use peak_alloc::PeakAlloc;
use scene_format::scene_file::{Mesh, PerVertex, Shape, Statement};
use scene_format::{NoFiles, SceneFile, parse};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

const RUNS: usize = 20;

fn main() {
    println!(
        "{:<40} {:>8} {:>8} {:>10} {:>10} {:>10} {:>6}",
        "file", "MB", "ms", "MB/s", "peak MB", "meshes MB", "ratio"
    );
    // Cargo passes an option of its own.
    let files: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    for file in &files {
        let bytes = std::fs::read(file).unwrap_or_else(|error| panic!("{file}: {error}"));
        measure(file, &scene_format::decode(&bytes).unwrap_or_else(|error| panic!("{file}: {error}")));
    }
    if files.is_empty() {
        for side in [100, 200, 400] {
            measure(&format!("a field of {side} x {side} squares"), &field(side));
        }
    }
}

fn measure(name: &str, text: &str) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let scene = parse(name, text, &NoFiles).scene;
    let peak = (MEMORY.peak_usage() - before) as f64;
    let meshes = mesh_bytes(&scene) as f64;
    let fastest = (0..RUNS)
        .map(|_| {
            let start = Instant::now();
            black_box(parse(name, black_box(text), &NoFiles));
            start.elapsed().as_secs_f64()
        })
        .fold(f64::INFINITY, f64::min);
    let size = text.len() as f64;
    let name = name.rsplit('/').next().unwrap_or(name);
    println!(
        "{name:<40} {:8.2} {:8.2} {:10.0} {:10.2} {:10.2} {:6.2}",
        size / 1e6,
        fastest * 1e3,
        size / 1e6 / fastest,
        peak / 1e6,
        meshes / 1e6,
        peak / meshes
    );
}

fn mesh_bytes(scene: &SceneFile) -> usize {
    let shapes = scene.statements.iter().filter_map(|statement| match &statement.value {
        Statement::Object(object) => Some(&object.shape.value),
        _ => None,
    });
    let meshes = shapes.filter_map(|shape| match shape {
        Shape::Mesh(Mesh { points, triangles, normals, uvs, .. }) => {
            Some(size_of_val(&points[..]) + size_of_val(&triangles[..]) + values(normals) + values(uvs))
        }
        _ => None,
    });
    meshes.sum()
}

fn values<const N: usize>(values: &PerVertex<N>) -> usize {
    match values {
        PerVertex::None => 0,
        PerVertex::Vertex(rows) => size_of_val(&rows[..]),
        PerVertex::FaceVarying(rows) => size_of_val(&rows[..]),
    }
}

/// A bumpy field of squares, each of two triangles, with normals and texture coordinates.
fn field(side: usize) -> String {
    let mut text = format!("object {{\n  shader none\n  type generic-mesh\n  points {}\n", (side + 1) * (side + 1));
    let places = || (0..=side).flat_map(|y| (0..=side).map(move |x| (x as f64 / side as f64, y as f64 / side as f64)));
    for (x, y) in places() {
        let _ = writeln!(text, "    {:.6} {:.6} {:.6}", 10.0 * x, 10.0 * y, (9.0 * x * y).sin());
    }
    let _ = writeln!(text, "  triangles {}", 2 * side * side);
    for corner in (0..side).flat_map(|y| (0..side).map(move |x| y * (side + 1) + x)) {
        let above = corner + side + 1;
        let _ = writeln!(text, "    {corner} {} {above}\n    {} {} {above}", corner + 1, corner + 1, above + 1);
    }
    let _ = writeln!(text, "  normals vertex");
    for (x, y) in places() {
        let _ = writeln!(text, "    {:.5} {:.5} {:.5}", -y, -x, 1.0 - x * y);
    }
    let _ = writeln!(text, "  uvs vertex");
    for (x, y) in places() {
        let _ = writeln!(text, "    {x:.4} {y:.4}");
    }
    text + "}\n"
}
