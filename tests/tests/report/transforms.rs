//! Transforms: translate, rotate, scale and matrices, applied in the order written; normals by the inverse transpose.

use super::{Triple, WHITE, assert_close, flat, lit};

/// Whether the middle of a small sphere that was at `from` is at `to`.
fn moves(transform: &str, from: Triple, to: Triple) -> bool {
    let [x, y, z] = from;
    let scene = format!("{WHITE} object {{ shader white transform {transform} type sphere c {x} {y} {z} r 0.05 }}");
    // The sphere's own form with a transform is girasol's; a mesh says the same in Sunflow's words.
    let tetrahedron = format!(
        "{WHITE} object {{ shader white transform {transform} type generic-mesh points 4 {} {y} {z}  {x} {} {z}  {x} {y} {}
         {} {} {} triangles 4 0 1 2 0 1 3 0 2 3 1 2 3 normals none uvs none }}",
        x + 0.1, y + 0.1, z + 0.1, x - 0.1, y - 0.1, z - 0.1
    );
    [scene, tetrahedron].iter().all(|scene| {
        // From two directions, so that it is there and not only on the way.
        let seen = |eye: Triple| flat(std::array::from_fn(|axis| to[axis] + eye[axis]), to, scene).r == 1.0;
        seen([1.0, 2.0, 30.0]) && seen([20.0, -30.0, 3.0])
    })
}

#[test]
fn each_step_does_what_it_says() {
    let p = [1.0, 2.0, 3.0];
    for (step, to) in [
        ("translate 4 -5 6", [5.0, -3.0, 9.0]),
        ("scaleu 2", [2.0, 4.0, 6.0]),
        ("scale 3 -1 0.5", [3.0, -2.0, 1.5]),
        ("scalex 2", [2.0, 2.0, 3.0]),
        ("scaley 2", [1.0, 4.0, 3.0]),
        ("scalez 2", [1.0, 2.0, 6.0]),
        // Counter-clockwise seen from the tip of the axis: about x, y goes to z; about y, z to x; about z, x to y.
        ("rotatex 90", [1.0, -3.0, 2.0]),
        ("rotatey 90", [3.0, 2.0, -1.0]),
        ("rotatez 90", [-2.0, 1.0, 3.0]),
        // About the diagonal by a third of a turn: x to y to z to x.
        ("rotate 5 5 5 120", [3.0, 1.0, 2.0]),
    ] {
        assert!(moves(&format!("{{ {step} }}"), p, to), "{step}");
    }
}

#[test]
fn steps_are_taken_in_the_order_written() {
    assert!(moves("{ scaleu 0.5 translate 3 0 0 rotatez 90 }", [0.0; 3], [0.0, 3.0, 0.0]));
    assert!(moves("{ rotatez 90 translate 3 0 0 scaleu 0.5 }", [0.0; 3], [1.5, 0.0, 0.0]));
}

#[test]
fn matrices_are_written_by_rows_or_by_columns() {
    // (x, y, z) to (y + 10, 2 z + 20, x + 30)
    let to = [12.0, 26.0, 31.0];
    assert!(moves("row 0 1 0 10  0 0 2 20  1 0 0 30  0 0 0 1", [1.0, 2.0, 3.0], to));
    assert!(moves("col 0 0 1 0  1 0 0 0  0 2 0 0  10 20 30 1", [1.0, 2.0, 3.0], to));
}

#[test]
fn a_mesh_s_own_normals_go_through_the_inverse_transpose() {
    // The normal (1, 0, 1) under a scale by 2 along x is (1/2, 0, 1): its cosine with z is 2 / sqrt(5) = 0.894427. The scale itself
    // would make it (2, 0, 1): 0.447. The light is 5 above, of power 20.
    let scene = WHITE.to_owned()
        + "light { type point color 1 1 1 power 20 p 0 0 5 }
           object { shader white transform { scale 2 1 1 } type generic-mesh points 3  -3 -3 0  3 -3 0  0 3 0  triangles 1  0 1 2
           normals vertex 1 0 1  1 0 1  1 0 1  uvs none }";
    assert_close(lit([0.0, -1.0, 5.0], [0.0; 3], &scene), [0.75 * 0.894_427; 3], 1e-5);
}

#[test]
fn a_plane_s_normal_goes_through_the_inverse_transpose() {
    // The plane x + z = 0 under a scale by 2 along x is x / 2 + z = 0, with the same cosine.
    let scene = WHITE.to_owned()
        + "light { type point color 1 1 1 power 20 p 0 0 5 }
           object { shader white transform { scale 2 1 1 } type plane p 0 0 0 n 1 0 1 }";
    assert_close(lit([0.0, -1.0, 5.0], [0.0; 3], &scene), [0.75 * 0.894_427; 3], 1e-5);
}

#[test]
fn an_instance_shows_a_geometry_under_its_own_transform() {
    let scene = WHITE.to_owned()
        + "object { noinstance type generic-mesh name thing points 3 -1 -1 0 1 -1 0 0 1 0 triangles 1 0 1 2 normals none uvs none }
           instance { name once geometry thing transform { translate 5 0 0 } shader white }
           instance { name twice geometry thing transform { translate -5 0 0 } shader white }";
    for (x, color) in [(5.0, 1.0), (-5.0, 1.0), (0.0, 0.0)] {
        assert_close(flat([x, -1.0, 5.0], [x, 0.0, 0.0], &scene), [color; 3], 0.0);
    }
}
