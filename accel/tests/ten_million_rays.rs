//! Ten million rays of all kinds at the kinds of scene that trouble accelerators: the wide octree returns the hits of asking every primitive, bit
//! for bit. On small scenes, for half of the rays, every primitive is asked. On large ones, where that would take days, the plain
//! octree is, which is argued and tested by itself; and for a sample of the rays every primitive as well.

#[path = "../benches/peers/meshes.rs"]
#[expect(unreachable_pub, reason = "shared with the bench against peers")]
mod meshes;
#[path = "../benches/peers/rays.rs"]
#[expect(unreachable_pub, reason = "shared with the bench against peers")]
mod rays;

use accel::{none, octree, wide};
use geometry::{Ellipsoid, Hit, Interval, Mesh, Primitives, Ray, Sphere, Transform};
use glam::{DVec3, Vec3};
use meshes::{Random, Scene};
use rayon::prelude::*;
use rays::{Rays, SHADOW};

/// Who tells what is right.
#[derive(Clone, Copy, PartialEq)]
enum Truth {
    /// Asking every primitive.
    EveryPrimitive,
    /// The plain octree; and every primitive, for the first ray of every so many batches.
    PlainOctree,
}

/// How many rays each scene gets in the whole run, and who tells what is right. The plain octree takes long over the fence's thin triangles.
const SCENES: [(&str, u64, Truth); 8] = [
    ("small knot", 2_000_000, Truth::EveryPrimitive),
    ("balls among triangles", 1_500_000, Truth::EveryPrimitive),
    ("needles", 1_500_000, Truth::EveryPrimitive),
    ("body", 1_500_000, Truth::PlainOctree),
    ("knot 72 k", 1_500_000, Truth::PlainOctree),
    ("knot 1 M", 1_000_000, Truth::PlainOctree),
    ("stadium", 800_000, Truth::PlainOctree),
    ("fence", 200_000, Truth::PlainOctree),
];

/// Rays that are traced together.
const BATCH: u64 = 256;

/// Every so many batches, the first ray is asked of every primitive.
const SAMPLED: u64 = 16;

/// All of them: `cargo test --release -p accel --test ten_million_rays -- --ignored --nocapture`.
#[test]
#[ignore = "takes minutes"]
fn ten_million_rays_find_what_they_should() {
    assert_eq!(SCENES.iter().map(|(_, rays, _)| rays).sum::<u64>(), 10_000_000);
    for (name, rays, truth) in SCENES {
        find_what_they_should(name, truth, rays / BATCH);
    }
}

#[test]
fn some_of_them_do_so_every_time() {
    // The others take seconds to build.
    for (name, rays, truth) in &SCENES[..5] {
        find_what_they_should(name, *truth, rays / BATCH / 200);
    }
}

#[expect(clippy::print_stdout, reason = "the long run tells how far it is, with `--nocapture`")]
fn find_what_they_should(name: &str, truth: Truth, batches: u64) {
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
            let is_sampled = number % (BATCH * SAMPLED) == 0;
            let asks_octree = truth == Truth::PlainOctree || is_sampled;
            let asks_every = truth == Truth::EveryPrimitive || is_sampled;
            let told_by = [(asks_octree, &octree), (asks_every, &every)];
            let alone = [wide.closest(ray, Interval::FORWARD), together];
            // Two ways to ask the same: what is hit, and whether something is hit up to t = 1.
            let near = [wide.any(ray, SHADOW), blocked];
            for (_, truth) in told_by.into_iter().filter(|(is_asked, _)| *is_asked) {
                let (hit, is_near) = (truth.closest(ray, Interval::FORWARD), truth.any(ray, SHADOW));
                if alone.iter().any(|&found| bits(found) != bits(hit)) || near != [is_near; 2] {
                    return Some(format!(
                        "{name}, ray {number}: {ray:?}: {hit:?}, {is_near}; but alone and in a batch {alone:?}, {near:?}"
                    ));
                }
            }
        }
        None
    };
    let differences: Vec<_> = (0..batches).into_par_iter().filter_map(differ).collect();
    assert!(differences.is_empty(), "{} of {batches} batches differ; the first: {}", differences.len(), differences[0]);
    println!("{name}, {} primitives: {batches} batches of {BATCH} rays", primitives.len());
}

fn bits(hit: Option<Hit>) -> Option<[u32; 4]> {
    hit.map(|Hit { t, u, v, primitive }| [t.to_bits(), u.to_bits(), v.to_bits(), primitive])
}

fn scene(name: &str) -> (Scene, Primitives) {
    let small = || meshes::knot(60, 10);
    let scene = match name {
        "small knot" | "balls among triangles" => small(),
        "needles" => Scene { mesh: needles(), ..small() },
        _ => meshes::all().into_iter().find(|(known, _)| *known == name).expect("a mesh of the bench").1(),
    };
    let mut primitives = Primitives::default();
    if name == "balls among triangles" {
        add_balls(&mut primitives);
    }
    primitives.add_mesh(scene.mesh.clone());
    (scene, primitives)
}

/// Triangles a thousand times as long as wide, which the wide octree cuts in pieces.
fn needles() -> Mesh {
    let mut random = Random(5);
    let mut point = |size: f32| size * (Vec3::new(random.next(), random.next(), random.next()) - 0.5);
    let mut mesh = Mesh::default();
    for number in 0..1000 {
        let (start, way) = (point(6.0), point(3.0));
        mesh.positions.extend([start, start + way, start + 0.5 * way + 1e-3 * point(3.0)]);
        mesh.triangles.push([3 * number, 3 * number + 1, 3 * number + 2]);
    }
    mesh
}

/// Spheres and ellipsoids in and around the knot, some of them twice.
fn add_balls(primitives: &mut Primitives) {
    let mut random = Random(3);
    for number in 0..400 {
        let center = 6.0 * Vec3::new(random.next(), random.next(), random.next()) - 3.0;
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
