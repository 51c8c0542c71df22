//! Sections 2.3.2 and 2.3.5: triangles and meshes of them.

use std::fmt::Write;

use tests::Rendering;

use super::{Triple, WHITE, assert_close, constant, flat, lit, look, seen, texel, textured};

/// A point of the plane z = 0 seen from above, a little aslant.
fn above([x, y]: [f64; 2]) -> (Triple, Triple) {
    ([x, y - 1.0, 5.0], [x, y, 0.0])
}

#[test]
fn a_triangle_is_seen_from_both_sides_and_only_inside_its_edges() {
    let scene = WHITE.to_owned()
        + "object { shader white type generic-mesh points 3  0 0 0  4 0 0  0 4 0  triangles 1  0 1 2  normals none uvs none }";
    for ([x, y], color) in
        [([1.0, 1.0], 1.0), ([1.9, 1.9], 1.0), ([2.1, 2.1], 0.0), ([-0.1, 1.0], 0.0), ([1.0, -0.1], 0.0)]
    {
        let (eye, target) = above([x, y]);
        assert_close(flat(eye, target, &scene), [color; 3], 0.0);
        assert_close(flat([eye[0], eye[1], -5.0], target, &scene), [color; 3], 0.0);
    }
}

/// A triangle with these normals at its corners (0, 0), (3, 0) and (0, 3), at a point, lit from 5 above it: (1 - 5 / 20) n.l.
fn with_normals(normals: &str, at: [f64; 2]) -> shading::Color {
    let (eye, target) = above(at);
    let [x, y] = at;
    let scene = constant("white", "1 1 1")
        + &format!("light {{ type point color 1 1 1 power 20 p {x} {y} 5 }}")
        + &format!(
            "object {{ shader white type generic-mesh points 3  0 0 0  3 0 0  0 3 0  triangles 1  0 1 2
             normals {normals} uvs none }}"
        );
    lit(eye, target, &scene)
}

#[test]
fn without_normals_a_triangle_is_flat() {
    assert_close(with_normals("none", [0.5, 1.0]), [0.75; 3], 1e-6);
}

#[test]
fn normals_are_interpolated_and_made_unit_again() {
    let normals = "0.6 0 0.8  -0.6 0 0.8  0 0 1";
    for form in ["vertex", "facevarying"] {
        // In the middle they add up to (0, 0, 2.6).
        assert_close(with_normals(&format!("{form} {normals}"), [1.0, 1.0]), [0.75; 3], 1e-6);
        // Halfway between the first and the third: (0.3, 0, 0.9), whose cosine is 0.9 / sqrt(0.09 + 0.81) = 0.948683.
        let found = with_normals(&format!("{form} {normals}"), [1e-6, 1.5]);
        assert_close(found, [0.75 * 0.948_683; 3], 1e-5);
    }
}

/// The colour of a triangle with corners (0, 0), (4, 0) and (0, 4) under a texture of 4 x 4 texels.
fn texture_at(at: [f64; 2], uvs: &str) -> shading::Color {
    let (eye, target) = above(at);
    let triangle = "object { shader textured type generic-mesh points 3  0 0 0  4 0 0  0 4 0  triangles 1  0 1 2";
    seen(&textured(4, 4, &format!("{} {triangle} normals none uvs {uvs} }}", look(eye, target))))
}

#[test]
fn without_uvs_the_edges_from_the_first_corner_are_the_basis() {
    // (u, v) = (x, y) / 4; texels' middles at 1/8, 3/8, 5/8 and 7/8.
    assert_close(texture_at([0.5, 0.5], "none"), texel(0, 0), 1e-4);
    assert_close(texture_at([2.5, 0.5], "none"), texel(2, 0), 1e-4);
    assert_close(texture_at([0.5, 2.5], "none"), texel(0, 2), 1e-4);
    assert_close(texture_at([1.5, 1.5], "none"), texel(1, 1), 1e-4);
}

#[test]
fn uvs_at_the_corners_are_interpolated() {
    // u from 1/8 at the left to 5/8 = 1/8 + 4/8 at the right; v = 1 - 1/8 below and 3/8 = 7/8 - 4/8 above. Halfway along the
    // edges the texel is one further.
    for form in ["vertex", "facevarying"] {
        let uvs = format!("{form}  0.125 0.875  0.625 0.875  0.125 0.375");
        assert_close(texture_at([0.001, 0.001], &uvs), texel(0, 3), 2e-3);
        assert_close(texture_at([2.0, 0.001], &uvs), texel(1, 3), 2e-3);
        assert_close(texture_at([0.001, 2.0], &uvs), texel(0, 2), 2e-3);
        assert_close(texture_at([1.999, 1.999], &uvs), texel(1, 2), 2e-3);
    }
}

#[test]
fn a_mesh_of_80000_triangles_looks_like_the_two_that_it_is_cut_from() {
    let scene = |cells: usize| {
        let mut mesh = format!("points {}\n", (cells + 1) * (cells + 1));
        for (i, j) in (0..=cells).flat_map(|i| (0..=cells).map(move |j| (i, j))) {
            // Steps of 1/64 have no rounding.
            let edge = 200 / cells;
            let _ = writeln!(mesh, "{} {} 0", (i * edge) as f32 / 64.0, (j * edge) as f32 / 64.0);
        }
        let _ = writeln!(mesh, "triangles {}", 2 * cells * cells);
        for corner in (0..cells).flat_map(|i| (0..cells).map(move |j| i * (cells + 1) + j)) {
            let (right, up) = (corner + cells + 1, corner + 1);
            let _ = writeln!(mesh, "{corner} {right} {} {corner} {} {up}", right + 1, right + 1);
        }
        format!(
            "{WHITE} image {{ resolution 40 30 aa 1 1 }}
             camera {{ type pinhole eye 1.5 -4 4 target 1.5 1.5 0 up 0 0 1 fov 60 aspect 1.3333 }}
             object {{ shader white type generic-mesh {mesh} normals none uvs none }}
             light {{ type point color 1 1 1 power 20 p 1 1 4 }}"
        )
    };
    let (whole, cut) = (Rendering::of(scene(1)), Rendering::of(scene(200)));
    assert_eq!(cut.assemble().scene.inventory(&cut.assemble().settings).bounded.total(), 80_000);
    for (whole, cut) in whole.film().pixels.into_iter().zip(cut.film().pixels) {
        assert_close(cut, whole.to_array().map(f64::from), 1e-5);
    }
}
