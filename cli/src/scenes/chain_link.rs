use super::mesh::Mesh;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Wires side by side.
const WIRES: u32 = 16;
/// Full turns of each wire.
const TURNS: u32 = 6;
/// Points along half a turn: from the middle of one straight run around a bend to the middle of the next.
const STEPS: i32 = 20;
/// Vertices around a wire.
const SIDES: u32 = 10;
/// Half the width of a wire's zigzag.
const REACH: f64 = 1.0;
/// How far the runs lie in front of the fence's plane, and behind it.
const DEPTH: f64 = 0.12;
/// The height of a full turn: four times the reach makes the meshes square.
const PITCH: f64 = 4.0 * REACH;
/// How far a bend reaches through its neighbour's bend.
const OVERLAP: f64 = 0.24;
/// The wire's radius.
const RADIUS: f64 = 0.07;
/// From one wire to the next.
const SPACING: f64 = 2.0 * REACH - OVERLAP;

/// A fence as a machine weaves it: each wire is a flattened helix, hooked into the bends of the one before.
pub(super) fn scene() -> String {
    let mut wires = Mesh::default();
    for wire in 0..WIRES {
        wires.tube(&center_line(wire), RADIUS, SIDES);
    }
    [include_str!("../../scenes/chainlink.sc"), &wires.object("wires", "zinc"), &posts().object("posts", "paint")]
        .concat()
}

/// The middle of a wire, from bottom to top.
///
/// ```text
///   \     .      Around each bend the points lie close. A wire runs up to the right in front (y < 0) and up to the left
///    \   /       behind; its neighbour is half a pitch higher, so that their bends meet at one height, and each holds the
///     > <        other: below that height this wire is in front, above it the neighbour.
///    /   \
/// ```
fn center_line(wire: u32) -> Vec<DVec3> {
    let middle = SPACING * (f64::from(wire) - 0.5 * f64::from(WIRES - 1));
    let raised = if wire.is_multiple_of(2) { 0.0 } else { 0.5 * PITCH };
    let mut points = Vec::new();
    for bend in 0..2 * TURNS {
        let at_bend = PI * (f64::from(bend) + 0.5);
        for step in -STEPS / 2..STEPS / 2 {
            let away = f64::from(step) / f64::from(STEPS / 2);
            let turn = at_bend + 0.5 * PI * away * away.abs();
            let (sine, cosine) = (libm::sin(turn), libm::cos(turn));
            // A wave between a sine and a triangle, and a step with a soft flank.
            let across = REACH * libm::asin(0.985 * sine) / libm::asin(0.985);
            let ahead = DEPTH * cosine / (cosine * cosine + 0.03).sqrt();
            points.push(DVec3::new(middle + across, -ahead, raised + PITCH * turn / TAU));
        }
    }
    points
}

/// A post at each side, a rail above, and balls on the posts.
fn posts() -> Mesh {
    let mut mesh = Mesh::default();
    let side = SPACING * 0.5 * f64::from(WIRES - 1) + REACH;
    let top = PITCH * (f64::from(TURNS) + 0.5);
    for x in [-side, side] {
        mesh.rod(DVec3::new(x, 0.0, -3.0), DVec3::new(x, 0.0, top + 0.6), 0.42, 24);
        ball(&mut mesh, DVec3::new(x, 0.0, top + 0.9), 0.62);
    }
    mesh.rod(DVec3::new(-side, 0.0, top - 0.2), DVec3::new(side, 0.0, top - 0.2), 0.26, 24);
    mesh.rod(DVec3::new(-side, 0.0, 0.2), DVec3::new(side, 0.0, 0.2), 0.14, 24);
    mesh
}

fn ball(mesh: &mut Mesh, center: DVec3, radius: f64) {
    let first = mesh.points.len();
    let profile: Vec<_> = (0..=12)
        .map(|i| PI * f64::from(i) / 12.0)
        .map(|angle| (radius * libm::sin(angle), -radius * libm::cos(angle)))
        .collect();
    mesh.lathe(&profile, 24);
    for point in &mut mesh.points[first..] {
        *point += center;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbouring_wires_touch_nowhere() {
        let (left, right) = (center_line(0), center_line(1));
        let between = left.iter().flat_map(|a| right.iter().map(|b| a.distance(*b)));
        // Points are at most 0.25 apart along straight runs, but close around the bends, where the wires meet.
        let nearest = between.fold(f64::INFINITY, f64::min);
        assert!(nearest > 2.0 * RADIUS, "{nearest} is not more than a wire's thickness");
    }

    #[test]
    fn neighbouring_wires_hold_each_other() {
        // At the height of their common bend, the left wire reaches beyond the right one.
        let farthest = center_line(0).iter().map(|p| p.x).fold(f64::NEG_INFINITY, f64::max);
        let nearest = center_line(1).iter().map(|p| p.x).fold(f64::INFINITY, f64::min);
        assert!(farthest > nearest + 2.0 * RADIUS);
    }
}
