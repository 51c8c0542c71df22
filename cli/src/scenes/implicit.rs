use super::mesh::Mesh;
use glam::{DVec3, UVec3};
use rayon::prelude::*;
use std::collections::HashMap;

/// The surface where `field` is 0, with the negative side as its inside, as a closed mesh: by marching tetrahedra (Doi and
/// Koide, "An Efficient Method of Triangulating Equi-Valued Surfaces", 1991) over cubes of edge `cell` from `low` to `high`.
///
/// Each cube is cut into the six tetrahedra around its diagonal, one for each order of the three axes, so that neighbours
/// share their faces' cuts and the mesh has no gaps. Points on an edge keep away from its ends: no triangle shrinks to a line.
///
/// All threads ask the field, which takes most of the time; what they find is put together in the same order for any number of them.
pub(super) fn mesh(field: &(dyn Fn(DVec3) -> f64 + Sync), low: DVec3, high: DVec3, cell: f64) -> Mesh {
    let cells = ((high - low) / cell).ceil().as_uvec3();
    let samples = cells + 1;
    let index = |at: UVec3| (at.z * samples.y + at.y) * samples.x + at.x;
    let place = |at: UVec3| low + at.as_dvec3() * cell;
    let places: Vec<_> = positions(samples).map(place).collect();
    let values: Vec<f64> = places.par_iter().map(|&at| field(at)).collect();

    let mut marching = Marching { mesh: Mesh::default(), on_edge: HashMap::new() };
    for at in positions(cells) {
        for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
            let mut corner = at;
            let corners = [None, Some(order[0]), Some(order[1]), Some(order[2])].map(|axis| {
                if let Some(axis) = axis {
                    corner[axis] += 1;
                }
                Corner { id: index(corner), place: place(corner), value: values[index(corner) as usize] }
            });
            marching.tetrahedron(corners);
        }
    }
    let mut mesh = marching.mesh;
    mesh.normals = mesh.points.par_iter().map(|&point| gradient(field, point, 0.1 * cell).normalize()).collect();
    mesh
}

/// A corner of a tetrahedron.
#[derive(Clone, Copy)]
struct Corner {
    id: u32,
    place: DVec3,
    value: f64,
}

struct Marching {
    mesh: Mesh,
    /// The vertex on the edge between two corners, the lower one first.
    on_edge: HashMap<(u32, u32), u32>,
}

impl Marching {
    /// Adds what of the surface is in a tetrahedron: nothing, a triangle or two.
    fn tetrahedron(&mut self, corners: [Corner; 4]) {
        let (inside, outside): (Vec<_>, Vec<_>) = corners.into_iter().partition(|corner| corner.value < 0.0);
        match (&inside[..], &outside[..]) {
            (&[a], &[p, q, r]) | (&[p, q, r], &[a]) => {
                let triangle = [self.cut(a, p), self.cut(a, q), self.cut(a, r)];
                self.triangle(triangle, inside[0], outside[0]);
            }
            (&[a, b], &[p, q]) => {
                let [ap, aq, bp, bq] = [self.cut(a, p), self.cut(a, q), self.cut(b, p), self.cut(b, q)];
                self.triangle([ap, aq, bq], a, q);
                self.triangle([ap, bq, bp], b, p);
            }
            _ => {}
        }
    }

    /// Adds a triangle that looks away from a corner inside, which with that corner outside is an edge that it crosses.
    fn triangle(&mut self, [a, b, c]: [u32; 3], inside: Corner, outside: Corner) {
        let at = |i: u32| self.mesh.points[i as usize];
        let looks_out = (at(b) - at(a)).cross(at(c) - at(a)).dot(outside.place - inside.place) > 0.0;
        self.mesh.triangles.push(if looks_out { [a, b, c] } else { [a, c, b] });
    }

    /// The vertex on an edge that the surface crosses.
    fn cut(&mut self, a: Corner, b: Corner) -> u32 {
        let (a, b) = if a.id < b.id { (a, b) } else { (b, a) };
        *self.on_edge.entry((a.id, b.id)).or_insert_with(|| {
            let share = (a.value / (a.value - b.value)).clamp(0.03, 0.97);
            self.mesh.vertex(a.place + (b.place - a.place) * share, DVec3::ZERO)
        })
    }
}

/// All positions of a grid, x fastest.
fn positions(size: UVec3) -> impl Iterator<Item = UVec3> {
    (0..size.z).flat_map(move |z| (0..size.y).flat_map(move |y| (0..size.x).map(move |x| UVec3::new(x, y, z))))
}

/// By central differences.
fn gradient(field: &dyn Fn(DVec3) -> f64, at: DVec3, step: f64) -> DVec3 {
    let along = |axis: DVec3| field(at + axis * step) - field(at - axis * step);
    DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z))
}
