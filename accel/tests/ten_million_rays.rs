//! Ten million rays of all kinds at the kinds of scene that trouble accelerators: the wide octree and the plain one return the same hits,
//! bit for bit, and a sample of them is asked of every primitive.

#[path = "../benches/peers/meshes.rs"]
#[expect(unreachable_pub, reason = "shared with the bench against peers")]
mod meshes;
#[path = "../benches/peers/rays.rs"]
#[expect(unreachable_pub, reason = "shared with the bench against peers")]
mod rays;

use accel::{none, octree, wide};
use geometry::{Ellipsoid, Hit, Interval, Primitives, Ray, Sphere, Transform};
use glam::{DVec3, Vec3};
use meshes::{Random, Scene};
use rayon::prelude::*;
use rays::{Rays, SHADOW};

/// How many rays each scene gets in the whole run. The plain octree takes long over the fence's thin triangles.
const COUNTS: [(&str, u64); 6] = [
    ("balls among triangles", 3_000_000),
    ("body", 2_500_000),
    ("knot 72 k", 2_000_000),
    ("knot 1 M", 1_500_000),
    ("stadium", 800_000),
    ("fence", 200_000),
];

/// Rays that are traced together.
const BATCH: u64 = 256;

/// Every so many batches, the first ray is asked of every primitive.
const SAMPLED: u64 = 16;

/// All of them: `cargo test --release -p accel --test ten_million_rays -- --ignored --nocapture`. Some minutes.
#[test]
#[ignore = "takes minutes"]
fn ten_million_rays_find_the_same_in_both_octrees() {
    assert_eq!(COUNTS.iter().map(|(_, rays)| rays).sum::<u64>(), 10_000_000);
    for (name, rays) in COUNTS {
        find_the_same(name, 0..rays / BATCH);
    }
}

#[test]
fn some_of_them_do_so_every_time() {
    // The others take seconds to build.
    for (name, rays) in &COUNTS[..3] {
        find_the_same(name, 0..rays / BATCH / 200);
    }
}

#[expect(clippy::print_stdout, reason = "the long run tells how far it is, with `--nocapture`")]
fn find_the_same(name: &str, batches: std::ops::Range<u64>) {
    let (scene, primitives) = scene(name);
    let (wide, octree) = (wide(primitives.clone()), octree(primitives.clone()));
    let every = none(primitives.clone());
    let seen = rays::of(&scene, &primitives, |ray| wide.closest(ray, Interval::FORWARD));
    let aims = Aims::of(&scene, seen);
    let differ = |batch: u64| -> Option<String> {
        let numbers = batch * BATCH..(batch + 1) * BATCH;
        let rays: Vec<Ray> = numbers.clone().map(|number| aims.ray(number)).collect();
        let mut together = vec![None; rays.len()];
        wide.closest_many(&rays, &mut together);
        let mut blocked = vec![false; rays.len()];
        wide.any_many(&rays, SHADOW, &mut blocked);
        for (((ray, number), together), blocked) in rays.iter().zip(numbers).zip(together).zip(blocked) {
            let expected = octree.closest(ray, Interval::FORWARD);
            let found = wide.closest(ray, Interval::FORWARD);
            let is_sampled = number % (BATCH * SAMPLED) == 0;
            let truth = if is_sampled { every.closest(ray, Interval::FORWARD) } else { expected };
            // Two ways to ask the same: what is hit, and whether something is hit up to t = 1.
            let near = octree.any(ray, SHADOW);
            let same = [found, together, truth].iter().all(|hit| bits(*hit) == bits(expected));
            if !same || blocked != near || wide.any(ray, SHADOW) != near {
                return Some(format!(
                    "{name}, ray {number}: {ray:?}: octree {expected:?}, {near}; wide {found:?}; in a batch {together:?}, {blocked}; \
                     every primitive {truth:?}"
                ));
            }
        }
        None
    };
    let count = batches.end - batches.start;
    let differences: Vec<_> = batches.into_par_iter().filter_map(differ).collect();
    assert!(differences.is_empty(), "{} of {count} batches differ; the first: {}", differences.len(), differences[0]);
    println!("{name}: {count} batches of {BATCH} rays");
}

fn bits(hit: Option<Hit>) -> Option<[u32; 4]> {
    hit.map(|Hit { t, u, v, primitive }| [t.to_bits(), u.to_bits(), v.to_bits(), primitive])
}

fn scene(name: &str) -> (Scene, Primitives) {
    let mut primitives = Primitives::default();
    let mesh = if name == "balls among triangles" { "body" } else { name };
    let (_, make) = meshes::all().into_iter().find(|(known, _)| *known == mesh).expect("a mesh of the bench");
    let scene = make();
    if mesh != name {
        add_balls(&mut primitives);
    }
    primitives.add_mesh(scene.mesh.clone());
    (scene, primitives)
}

/// Spheres and ellipsoids in and around the body, some of them twice.
fn add_balls(primitives: &mut Primitives) {
    let mut random = Random(3);
    for number in 0..400 {
        let center = 3.0 * Vec3::new(random.next(), random.next(), random.next()) - 1.5;
        let radius = 0.02 + 0.1 * random.next();
        if number % 2 == 0 {
            let twice = if number % 20 == 0 { 2 } else { 1 };
            (0..twice).for_each(|_| primitives.add_sphere(Sphere { center, radius }));
        } else {
            let axes = f64::from(radius) * DVec3::new(1.0, 0.5, 2.0);
            let turn = Transform::rotation(DVec3::new(1.0, 2.0, 3.0), f64::from(number));
            let place = Transform::scale(axes).then(&turn).then(&Transform::translation(center.as_dvec3()));
            primitives.add_ellipsoid(Ellipsoid::new(place).expect("positive axes"));
        }
    }
}

/// What rays are aimed at.
struct Aims<'a> {
    scene: &'a Scene,
    seen: Rays,
    /// The middle of the scene, and its size.
    middle: Vec3,
    size: f32,
}

impl<'a> Aims<'a> {
    fn of(scene: &'a Scene, seen: Rays) -> Self {
        let positions = &scene.mesh.positions;
        let min = positions.iter().copied().reduce(Vec3::min).expect("a mesh with points");
        let max = positions.iter().copied().reduce(Vec3::max).expect("a mesh with points");
        Self { scene, seen, middle: 0.5 * (min + max), size: (max - min).max_element() }
    }

    /// The ray of a number: ten kinds in turn.
    fn ray(&self, number: u64) -> Ray {
        let random = &mut Random(number);
        let from = |list: &[Ray]| list[(number / 10) as usize % list.len()];
        let corners = self.corners(random);
        let [a, b, c] = corners;
        let near = self.point(random, 1.0);
        match number % 10 {
            0 => from(&self.seen.primary),
            1 => from(&self.seen.shadow),
            2 => from(&self.seen.diffuse),
            3 => Ray::new(near, a - near),
            4 => Ray::new(near, on_edge(corners, random) - near),
            5 => {
                // Along an axis through a vertex: the other coordinates are the vertex's own.
                let axis = Vec3::AXES[below(random, 3)];
                let way = if random.next() < 0.5 { axis } else { -axis };
                Ray::new(a - way * (self.size * random.next()), way)
            }
            6 => {
                // In the plane of a triangle, from outside or inside of it.
                let (s, t) = (4.0 * random.next() - 1.5, 4.0 * random.next() - 1.5);
                let origin = a + s * (b - a) + t * (c - a);
                Ray::new(origin, on_edge(corners, random) - origin)
            }
            7 => {
                // From up to 1e6 times the scene's size.
                let far = 10.0_f32.powf(6.0 * random.next());
                let origin = self.point(random, far);
                let target = if random.next() < 0.5 { a } else { on_edge(corners, random) };
                Ray::new(origin, target - origin)
            }
            8 => {
                let tiny = [0.0, -0.0, 1e-45, 1e-39, 1e-30][below(random, 5)];
                let keep = below(random, 7) + 1;
                let target = self.point(random, 1.0);
                let component = |axis: usize| if keep >> axis & 1 == 1 { target[axis] - near[axis] } else { tiny };
                let origin = if random.next() < 0.5 { near } else { a };
                Ray::new(origin, Vec3::new(component(0), component(1), component(2)))
            }
            _ => {
                // From one vertex to another's, with any length.
                let other = self.corners(random)[0];
                let length = [1.0, 1e-20, 1e20, 3.0][below(random, 4)];
                Ray::new(a, length * (other - a))
            }
        }
    }

    fn corners(&self, random: &mut Random) -> [Vec3; 3] {
        let mesh = &self.scene.mesh;
        let mut corners = mesh.triangles[below(random, mesh.triangles.len())];
        corners.rotate_left(below(random, 3));
        corners.map(|corner| mesh.positions[corner as usize])
    }

    /// A place in a cube around the scene, so many times as large as it.
    fn point(&self, random: &mut Random, scale: f32) -> Vec3 {
        let place = Vec3::new(random.next(), random.next(), random.next()) - 0.5;
        self.middle + scale * self.size * place
    }
}

/// The middle of an edge, or anywhere on it as nearly as `f32` allows.
fn on_edge([a, b, _]: [Vec3; 3], random: &mut Random) -> Vec3 {
    let share = if random.next() < 0.5 { 0.5 } else { random.next() };
    a + share * (b - a)
}

fn below(random: &mut Random, count: usize) -> usize {
    ((random.next() * count as f32) as usize).min(count - 1)
}
