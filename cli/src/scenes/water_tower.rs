use super::mesh::{Mesh, on_circle};
use glam::DVec3;

/// Corners of the tower, each with a leg.
const LEGS: u32 = 6;
/// Heights of the rings that tie the legs together; the legs stand in the ground and end under the platform.
const LEVELS: [f64; 5] = [-0.2, 1.5, 3.1, 4.6, 6.0];
/// The platform's upper side.
const DECK: f64 = 6.1;
/// Sides of the tubes.
const SIDES: u32 = 8;
/// Parts of a full turn of what is round.
const TURN: u32 = 48;

/// A water tower: lattice legs, a platform with a railing, a tank and a roof, each a mesh.
pub(super) fn scene() -> String {
    let parts = [
        include_str!("../../scenes/watertower.sc").to_owned(),
        frame().object("frame", "steel"),
        deck().object("platform", "planks"),
        tank().object("tank", "enamel"),
        roof().object("roof", "tin"),
    ];
    parts.concat()
}

/// Legs, rings, crossed braces, the pipe in the middle, the railing and a ladder.
fn frame() -> Mesh {
    let mut mesh = Mesh::default();
    let leg = |corner: u32, level: f64| on_circle(corner % LEGS, LEGS) * (2.1 - 0.1 * level) + DVec3::Z * level;
    for corner in 0..LEGS {
        mesh.rod(leg(corner, LEVELS[0]), leg(corner, LEVELS[4]), 0.075, SIDES);
        for pair in LEVELS.windows(2) {
            let (low, high) = (pair[0], pair[1]);
            mesh.rod(leg(corner, high), leg(corner + 1, high), 0.045, SIDES);
            mesh.rod(leg(corner, low), leg(corner + 1, high), 0.025, SIDES);
            mesh.rod(leg(corner + 1, low), leg(corner, high), 0.025, SIDES);
            mesh.rod(leg(corner, high), DVec3::Z * high, 0.02, SIDES);
        }
    }
    mesh.rod(DVec3::Z * -0.2, DVec3::Z * DECK, 0.16, 2 * SIDES);
    railing(&mut mesh);
    ladder(&mut mesh);
    mesh
}

fn railing(mesh: &mut Mesh) {
    for height in [0.25, 0.5] {
        mesh.ring(DVec3::Z * (DECK + height), 2.3, 0.022, TURN, SIDES);
    }
    for post in 0..24 {
        let foot = on_circle(post, 24) * 2.3 + DVec3::Z * DECK;
        mesh.rod(foot, foot + DVec3::Z * 0.5, 0.02, SIDES);
    }
}

/// Up the side that looks along -y, through the platform and along the tank.
fn ladder(mesh: &mut Mesh) {
    let (bottom, top, away) = (-0.2, 9.0, -1.98);
    for side in [-0.17, 0.17] {
        mesh.rod(DVec3::new(side, away, bottom), DVec3::new(side, away, top), 0.022, SIDES);
    }
    for rung in 0..36 {
        let height = bottom + 0.25 * f64::from(rung + 1);
        mesh.rod(DVec3::new(-0.17, away, height), DVec3::new(0.17, away, height), 0.014, SIDES);
    }
}

/// The round floor that the tank stands on.
fn deck() -> Mesh {
    let mut mesh = Mesh::default();
    mesh.disc(DVec3::Z * (DECK - 0.1), DVec3::NEG_Z, 2.42, TURN);
    mesh.lathe(&[(2.42, DECK - 0.1), (2.42, DECK)], TURN);
    mesh.disc(DVec3::Z * DECK, DVec3::Z, 2.42, TURN);
    mesh
}

/// A cylinder with a bellied bottom, and hoops around it.
fn tank() -> Mesh {
    let mut mesh = Mesh::default();
    mesh.lathe(&[(1.8, DECK), (1.8, 9.1)], TURN);
    for hoop in 0..5 {
        mesh.ring(DVec3::Z * (DECK + 0.3 + 0.6 * f64::from(hoop)), 1.8, 0.035, TURN, SIDES);
    }
    // A quarter of an ellipse under the platform, through which the pipe leaves.
    let belly: Vec<_> = (0..=8).map(|i| on_circle(i, 32)).map(|p| (1.45 * p.y, DECK - 0.1 - 0.55 * p.x)).collect();
    mesh.lathe(&belly, TURN);
    mesh
}

/// A bent cone with eaves and a ball on its tip.
fn roof() -> Mesh {
    let mut mesh = Mesh::default();
    mesh.lathe(&[(1.7, 9.02), (2.0, 8.98)], TURN);
    mesh.lathe(&[(2.0, 8.98), (2.0, 9.05)], TURN);
    let slope: Vec<_> =
        (0..=8).map(|i| f64::from(i) / 8.0).map(|t| (2.0 - 1.94 * t, 9.05 + t * (0.75 + 0.55 * t))).collect();
    mesh.lathe(&slope, TURN);
    let ball: Vec<_> = (0..=12).map(|i| on_circle(i, 24)).map(|p| (0.16 * p.y, 10.45 - 0.16 * p.x)).collect();
    mesh.lathe(&ball, TURN / 2);
    mesh
}
