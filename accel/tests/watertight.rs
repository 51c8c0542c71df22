//! A million rays from inside of each of three closed meshes, aimed at vertices, at edges and at random: none gets out, asked of
//! every primitive and of the octree. Accelerators find the next surface behind a gap, too.

use accel::{Accelerator, none, octree, wide};
use geometry::{
    Interval, Mesh, Primitives, Ray, Transform,
    conformance::{CubeEdge, cube_edges, split_octahedron, times},
    unit_cube,
};
use glam::{DVec3, Vec3};
use proptest::prelude::*;

const RAYS: u64 = 1_000_000;

type Build = fn(Primitives) -> Box<dyn Accelerator>;

/// The first is what the others are held against.
const ACCELERATORS: [(&str, Build); 3] = [("every primitive", none), ("the octree", octree), ("the wide octree", wide)];

/// Random numbers as a function of a number. (Steele, Lea, Flood 2014: SplitMix64.)
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^ (bits >> 31)
    }

    fn number(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }

    /// A direction, not quite evenly spread.
    fn direction(&mut self) -> DVec3 {
        DVec3::new(self.number() - 0.5, self.number() - 0.5, self.number() - 0.5)
    }
}

/// The ray of a number: from inside at a vertex, at a point of an edge, or anywhere.
fn ray(mesh: &Mesh, inside: &impl Fn(&mut Random) -> DVec3, number: u64) -> Ray {
    let random = &mut Random(number);
    let origin = inside(random).as_vec3();
    let corners = mesh.triangles[random.below(mesh.triangles.len())].map(|corner| mesh.positions[corner as usize]);
    let direction = match number % 3 {
        0 => corners[0] - origin,
        1 => {
            let [a, b] = [corners[0], corners[1]].map(|corner| corner.as_dvec3());
            // In the middle, or anywhere on the edge as nearly as `f32` allows.
            let share = if random.bits().is_multiple_of(2) { 0.5 } else { random.number() };
            (a + (b - a) * share).as_vec3() - origin
        }
        _ => random.direction().as_vec3(),
    };
    Ray::new(origin, direction)
}

fn no_ray_gets_out(mesh: &Mesh, inside: impl Fn(&mut Random) -> DVec3) {
    let mut primitives = Primitives::default();
    primitives.add_mesh(mesh.clone());
    for (name, build) in ACCELERATORS {
        let accelerator = build(primitives.clone());
        let leaks: Vec<_> = (0..RAYS)
            .map(|number| ray(mesh, &inside, number))
            .filter(|ray| accelerator.closest(ray, Interval::FORWARD).is_none())
            .collect();
        assert!(
            leaks.is_empty(),
            "{} of {RAYS} rays get out, asked of {name}; the first is {:?}",
            leaks.len(),
            leaks[0]
        );
    }
}

/// 128 triangles of all shapes: radii 1 : 3, stretched 1 : 20. Every point between the centre and the surface is inside.
#[test]
fn no_ray_gets_out_of_a_crumpled_octahedron() {
    let (directions, triangles) = split_octahedron(2);
    let mut random = Random(1);
    let mut place =
        |direction: DVec3| direction.normalize() * (1.0 + 2.0 * random.number()) * DVec3::new(1.0, 0.3, 0.05);
    let positions: Vec<Vec3> = directions.into_iter().map(|direction| place(direction).as_vec3()).collect();
    let mesh = Mesh { positions, triangles, ..Mesh::default() };
    no_ray_gets_out(&mesh, |random| {
        let corners = mesh.triangles[random.below(mesh.triangles.len())];
        let [a, b, c] = corners.map(|corner| mesh.positions[corner as usize].as_dvec3());
        let (u, v) = (random.number(), random.number());
        (a * (1.0 - u) + (b * (1.0 - v) + c * v) * u) * (0.99 * random.number())
    });
}

/// A thin tube of 48 rings of four around a trefoil knot. Its inside holds every point between a ring's centre and its points.
#[test]
fn no_ray_gets_out_of_a_knotted_tube() {
    const RINGS: usize = 48;
    let center = |ring: usize| {
        let around = std::f64::consts::TAU * (ring % RINGS) as f64 / RINGS as f64;
        let out = 2.0 + (3.0 * around).cos();
        DVec3::new(out * (2.0 * around).cos(), out * (2.0 * around).sin(), (3.0 * around).sin())
    };
    let positions: Vec<Vec3> = (0..RINGS)
        .flat_map(|ring| {
            let along = (center(ring + 1) - center(ring + RINGS - 1)).normalize();
            let side = along.cross(center(ring)).normalize();
            let up = side.cross(along);
            [side, up, -side, -up].map(|off| (center(ring) + 0.03 * off).as_vec3())
        })
        .collect();
    let point = |ring: usize, place: usize| (ring % RINGS * 4 + place % 4) as u32;
    let triangles = (0..RINGS * 4)
        .flat_map(|quad| {
            let (ring, place) = (quad / 4, quad % 4);
            let (a, b) = (point(ring, place), point(ring, place + 1));
            let (c, d) = (point(ring + 1, place + 1), point(ring + 1, place));
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let mesh = Mesh { positions, triangles, ..Mesh::default() };
    no_ray_gets_out(&mesh, |random| {
        let ring = random.below(RINGS);
        let corners = [0, 1, 2, 3].map(|place| mesh.positions[point(ring, place) as usize].as_dvec3());
        let middle = corners.iter().sum::<DVec3>() / 4.0;
        middle + (corners[random.below(4)] - middle) * (0.9 * random.number())
    });
}

/// Twelve triangles of side 1 at a distance of 4e5, where the numbers are 1/32 apart: none of its faces is flat.
#[test]
fn no_ray_gets_out_of_a_cube_far_off() {
    let place = Transform::rotation(DVec3::new(1.0, 2.0, 3.0), 40.0)
        .then(&Transform::translation(DVec3::new(123_456.7, -234_567.8, 345_678.9)));
    let mut mesh = unit_cube();
    mesh.positions.iter_mut().for_each(|position| *position = place.point_f32(*position));
    no_ray_gets_out(&mesh, |random| place.point(random.direction() * 0.8));
}

proptest! {
    #![proptest_config(times(4))]

    /// From a face inwards, however near to its edge, unless an ulp decides on which side of the edge it starts.
    #[test]
    fn a_ray_that_leaves_a_face_finds_the_next_through_each_accelerator(case in cube_edges()) {
        let CubeEdge { place, ray, leaving } = case;
        let mut mesh = unit_cube();
        mesh.positions.iter_mut().for_each(|position| *position = place.point_f32(*position));
        let mut primitives = Primitives::default();
        primitives.add_mesh(mesh);
        let accelerators = ACCELERATORS.map(|(_, build)| build(primitives.clone()));
        let hits = accelerators.each_ref().map(|accelerator| accelerator.closest(&ray, Interval::FORWARD));
        prop_assert!(hits.iter().all(|hit| *hit == hits[0]), "{:?}", hits);
        let Some(hit) = hits[0] else { return Ok(()) };
        let surface = primitives.surface(&ray, &hit);
        let away = if leaving.dot(surface.geometric_normal) < 0.0 { -leaving } else { leaving };
        for direction in [away, -away] {
            let left = surface.leave(direction);
            let next = accelerators.each_ref().map(|accelerator| accelerator.closest(&left, Interval::FORWARD));
            prop_assert!(next.iter().all(|hit| *hit == next[0]), "{:?} for {:?}", next, left);
            let segment = surface.leave_towards(left.at(1.0).as_vec3());
            let blocked = accelerators.each_ref().map(|accelerator| accelerator.any(&segment, Interval::SEGMENT));
            prop_assert!(blocked.iter().all(|is| *is == blocked[0]), "{:?} for {:?}", blocked, segment);
        }
    }
}
