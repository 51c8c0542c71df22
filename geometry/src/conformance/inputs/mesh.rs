use glam::{DMat3, DVec3, Vec3};
use proptest::prelude::*;

use super::{frame, magnitude, unit_vector};
use crate::{Mesh, Ray};

/// A closed mesh and rays that start inside it.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosed {
    /// Star-shaped around the rays' origin.
    pub mesh: Mesh,
    /// Rays to every point, to the middle of every edge, and to the middle of every triangle, as exactly as `f32` allows.
    pub rays: Vec<Ray>,
}

/// Octahedra split up to three times and crumpled (radii 1 : 10), stretched (1 : 1e3), of size 1e-3 to 1e6, up to 1e3 sizes from
/// the origin of space.
pub fn closed_meshes() -> impl Strategy<Value = Enclosed> {
    let stretch = [magnitude(1e-3, 1.0), magnitude(1e-3, 1.0), magnitude(1e-3, 1.0)];
    let place = (magnitude(1e-3, 1e6), prop_oneof![Just(0.0), magnitude(1.0, 1e3)], unit_vector());
    (0..4_usize, prop::collection::vec(magnitude(0.1, 1.0), 32), stretch, frame(), place).prop_map(
        |(splits, radii, stretch, turn, (size, far, side))| {
            let (directions, triangles) = split_octahedron(splits);
            let inside = (side * far * size).as_vec3();
            let linear = turn * DMat3::from_diagonal(DVec3::from(stretch)) * size;
            let place = |(direction, radius): (&DVec3, &f64)| {
                (inside.as_dvec3() + linear * (direction.normalize() * *radius)).as_vec3()
            };
            let positions: Vec<Vec3> = directions.iter().zip(radii.iter().cycle()).map(place).collect();
            let middles = triangles.iter().flat_map(|corners| {
                let [a, b, c] = corners.map(|corner| positions[corner as usize]);
                [0.5 * a + 0.5 * b, 0.5 * b + 0.5 * c, 0.5 * c + 0.5 * a, (a + b + c) / 3.0]
            });
            let rays =
                positions.iter().copied().chain(middles).map(|target| Ray::new(inside, target - inside)).collect();
            Enclosed { mesh: Mesh { positions, triangles, ..Mesh::default() }, rays }
        },
    )
}

/// An octahedron whose triangles were split in four a number of times: points (not on a sphere), and corners
/// counter-clockwise from outside.
pub fn split_octahedron(splits: usize) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let mut points = vec![DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
    let mut triangles: Vec<[u32; 3]> =
        vec![[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
    for _ in 0..splits {
        let mut middle = |a: u32, b: u32| {
            let point = (points[a as usize] + points[b as usize]) * 0.5;
            let known = points.iter().position(|&other| other == point);
            known.unwrap_or_else(|| {
                points.push(point);
                points.len() - 1
            }) as u32
        };
        let split = |[a, b, c]: [u32; 3]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        triangles = triangles.into_iter().flat_map(split).collect();
    }
    (points, triangles)
}
