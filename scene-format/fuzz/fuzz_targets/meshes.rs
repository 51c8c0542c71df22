//! Whatever the bytes: each format's reader refuses them, or gives a mesh whose corners are points of it.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scene_format::{Limits, read_mesh, smooth_normals};

fuzz_target!(|bytes: &[u8]| {
    let limits = Limits { elements: 1 << 12, ..Limits::default() };
    for name in ["a.obj", "a.stl", "a.ply", "a.ra3"] {
        if let Ok(mut mesh) = read_mesh(name, bytes, &limits) {
            assert!(mesh.points.len().max(mesh.triangles.len()) <= limits.elements);
            assert!(mesh.triangles.as_flattened().iter().all(|&corner| (corner as usize) < mesh.points.len()));
            smooth_normals(&mut mesh);
        }
    }
});
