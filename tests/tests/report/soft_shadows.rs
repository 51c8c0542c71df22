//! Section 3.2: each light becomes a 3 x 3 x 3 cluster, 0.1 apart, of 1/27 each.

use std::collections::BTreeSet;

use render::Lighting;
use shading::SoftShadows;
use tests::Rendering;

use super::{assert_close, constant, look, seen};

fn soft(text: String) -> Rendering {
    let soft_shadows = Some(SoftShadows::default());
    Rendering { lighting: Lighting { soft_shadows, ..Lighting::default() }, ..Rendering::of(text) }
}

#[test]
fn where_all_lights_of_the_cluster_shine_each_gives_its_share() {
    let scene = look([0.0, -1.0, 1.0], [0.0, 0.0, 0.0])
        + &constant("white", "1 1 1")
        + "object { shader white type plane p 0 0 0 n 0 0 1 } light { type point color 1 0.5 0 power 2 p 0.3 0 1 }";
    let steps = [-0.1, 0.0, 0.1];
    let mut expected = 0.0_f64;
    for (x, y, z) in steps.iter().flat_map(|&x| steps.iter().flat_map(move |&y| steps.map(|z| (0.3 + x, y, 1.0 + z)))) {
        let d = f64::sqrt(x * x + y * y + z * z);
        expected += (1.0 - d / 2.0) * z / d / 27.0;
    }
    assert_close(seen(&soft(scene)), [expected, 0.5 * expected, 0.0], 1e-6);
}

/// A strip of floor across the shadow of an edge at height 5, under a light at height 10:
///
/// ```text
///         z = 9.9 .. 10.1      * * *        n is perpendicular to the edge, and the middle of the cluster is at n.l = 0.5.
///                              * * *        The edge's shadow by a light at n.l and z falls on the floor at
///                                  \            n.p = -(n.l) 5 / (z - 5)
///         z = 5      black _________\           so a step of 0.1 in z moves it by 0.01, and steps along n = (0.954, 0.3, 0)
///                                    \          by 0.095 and 0.03: all 27 shadows end in different places, between
///         z = 0   ----------------------        -0.66 and -0.34.
/// ```
fn strip(edge: &str) -> Rendering {
    let (c, s) = (0.953_94, 0.3);
    let camera = format!(
        "camera {{ type pinhole eye {x} {y} 4 target {x} {y} 0 up {up_x} {c} 0 fov 5.7248 aspect 800 }}",
        x = -0.5 * c,
        y = -0.5 * s,
        up_x = -s
    );
    let quad: String = [[-20.0, 0.0], [20.0, 0.0], [20.0, 20.0], [-20.0, 20.0]]
        .map(|[along, across]| format!("{} {} 5 ", -s * along + c * across, c * along + s * across))
        .concat();
    let object = format!("object {{ shader white type generic-mesh points 4 {quad} triangles 2 0 1 2 0 2 3 }}");
    let light = format!("light {{ type point color 1 1 1 power 1000000 p {} {} 10 }}", 0.5 * c, 0.5 * s);
    let text = "image { resolution 800 1 }\n".to_owned()
        + &camera
        + &constant("white", "1 1 1")
        + "object { shader white type plane p 0 0 0 n 0 0 1 }\n"
        + &light
        + if edge.is_empty() { "" } else { &object };
    soft(text)
}

#[test]
fn a_penumbra_has_27_steps() {
    let open = strip("").film().pixels;
    let shaded = strip("edge").film().pixels;
    let mut levels = Vec::new();
    for (shaded, open) in shaded.iter().zip(&open) {
        // So far away all 27 lights give nearly the same.
        let lights = 27.0 * shaded.r / open.r;
        assert!((lights - lights.round()).abs() < 0.1, "{lights}");
        levels.push(lights.round() as u32);
    }
    assert!(levels.is_sorted() || levels.iter().rev().is_sorted(), "{levels:?}");
    assert_eq!(levels.into_iter().collect::<BTreeSet<_>>(), (0..=27).collect());
}

#[test]
fn soft_shadows_are_off_unless_asked_for() {
    let hard = Rendering { lighting: Lighting::default(), ..strip("edge") }.film();
    let dark = hard.pixels.iter().filter(|pixel| pixel.r == 0.0).count();
    let bright = hard.pixels.iter().filter(|pixel| pixel.r > 0.9).count();
    assert_eq!((dark + bright, dark > 0, bright > 0), (800, true, true));
}

#[test]
fn size_and_count_can_be_chosen() {
    // Two along each edge, 1 apart: lights at -0.5 and 0.5 of the point itself, all eight at the same distance of the pole.
    let text = look([0.0, -1.0, 1.0], [0.0, 0.0, 0.0])
        + &constant("white", "1 1 1")
        + "object { shader white type plane p 0 0 0 n 0 0 1 } light { type point color 1 1 1 power 4 p 0 0 1 }";
    let soft_shadows = Some(SoftShadows { along_edge: 2, spacing: 1.0 });
    let lighting = Lighting { soft_shadows, ..Lighting::default() };
    let found = seen(&Rendering { lighting, ..Rendering::of(text) });
    // d = sqrt(0.5 + z^2), cos = z / d for z = 0.5 and 1.5, four lights each: ((1 - d/4) z/d + ...) / 2
    let share = |z: f64| (1.0 - f64::sqrt(0.5 + z * z) / 4.0) * z / f64::sqrt(0.5 + z * z);
    assert_close(found, [0.5 * (share(0.5) + share(1.5)); 3], 1e-6);
}
