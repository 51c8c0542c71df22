//! The meshes: five kinds of scene that trouble accelerators in different ways.

use std::f32::consts::TAU;

use geometry::Mesh;
use glam::{Vec2, Vec3};

/// A mesh, with where to look at it from and to, and its light.
pub struct Scene {
    pub mesh: Mesh,
    pub eye: Vec3,
    pub target: Vec3,
    pub light: Vec3,
}

/// Makes a scene.
pub type Make = fn() -> Scene;

pub fn all() -> [(&'static str, Make); 5] {
    [
        ("knot 72 k", || knot(1200, 30)),
        ("knot 1 M", || knot(4200, 120)),
        ("fence", fence),
        ("stadium", stadium),
        ("body", body),
    ]
}

/// A bumpy tube along a torus knot: as organic as a formula.
pub fn knot(along: u32, around: u32) -> Scene {
    let center = |s: f32| {
        let (p, q) = (2.0 * s, 3.0 * s);
        let ring = 2.0 + q.cos();
        Vec3::new(ring * p.cos(), ring * p.sin(), -q.sin())
    };
    let point = |i: u32, j: u32| {
        let s = TAU * (i % along) as f32 / along as f32;
        let a = TAU * (j % around) as f32 / around as f32;
        let forward = (center(s + 1e-3) - center(s - 1e-3)).normalize();
        let side = forward.cross(Vec3::Z).normalize();
        let up = side.cross(forward);
        let radius = 0.45 + 0.05 * (9.0 * s + 3.0 * a).sin() + 0.02 * (40.0 * s - 5.0 * a).sin();
        center(s) + radius * (a.cos() * side + a.sin() * up)
    };
    let mesh = grid(along, around, point);
    Scene { mesh, eye: Vec3::new(1.0, -6.0, 5.0), target: Vec3::ZERO, light: Vec3::new(4.0, -5.0, 8.0) }
}

/// Thin diagonal wires, crossing, of triangles 200 times as long as wide.
fn fence() -> Scene {
    let mut mesh = Mesh::default();
    let (wires, pieces) = (1200, 25);
    // A wire is square. A piece is sqrt(2) 20 / pieces long, a side sqrt(2) times the radius wide.
    let radius = 20.0 / pieces as f32 / 200.0;
    for wire in 0..2 * wires {
        let side = if wire % 2 == 0 { 1.0 } else { -1.0 };
        let start = (wire / 2) as f32 / wires as f32 * 40.0 - 20.0;
        let point = |i: u32, j: u32| {
            let s = i as f32 / pieces as f32 * 20.0 - 10.0;
            let a = TAU * (j % 4) as f32 / 4.0;
            let wave = 0.02 * (8.0 * s + start).sin();
            Vec3::new(start + side * s + radius * a.cos(), wave + radius * a.sin(), s)
        };
        let first = mesh.positions.len() as u32;
        for i in 0..=pieces {
            mesh.positions.extend((0..4).map(|j| point(i, j)));
        }
        for i in 0..pieces {
            for j in 0..4 {
                let at = |i: u32, j: u32| first + 4 * i + j % 4;
                mesh.triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                mesh.triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
    }
    Scene { mesh, eye: Vec3::new(0.5, -4.0, 0.3), target: Vec3::ZERO, light: Vec3::new(3.0, -9.0, 5.0) }
}

/// Many small spheres in a big room: the teapot in the stadium.
fn stadium() -> Scene {
    let mut mesh = Mesh::default();
    let mut random = Random(7);
    for _ in 0..400 {
        let center = 8.0 * (Vec3::new(random.next(), random.next(), random.next()) - 0.5);
        let radius = 0.1 + 0.2 * random.next();
        add(&mut mesh, sphere(32, 20, |direction| center + radius * direction));
    }
    let corner = |i: u32| Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32) * 100.0 - 50.0;
    let room = Mesh {
        positions: (0..8).map(corner).collect(),
        triangles: [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
            .iter()
            .flat_map(|&[a, b, c, d]: &[u32; 4]| [[a, b, c], [a, c, d]])
            .collect(),
        ..Mesh::default()
    };
    add(&mut mesh, room);
    Scene { mesh, eye: Vec3::new(9.0, -7.0, 4.0), target: Vec3::ZERO, light: Vec3::new(20.0, -10.0, 40.0) }
}

/// A body of few faces, each cut into many equal triangles, on a floor.
fn body() -> Scene {
    let coarse = |direction: Vec3| {
        let lobes = (3.0 * direction.x).sin() * (2.0 * direction.y + 1.0).cos() + (4.0 * direction.z).sin();
        direction * Vec3::new(1.0, 0.7, 1.2) * (1.0 + 0.2 * lobes)
    };
    let mut mesh = sphere(12, 8, coarse);
    for _ in 0..4 {
        mesh = subdivided(&mesh);
    }
    let floor = grid_flat(80, |at| Vec3::new(6.0 * at.x - 3.0, 6.0 * at.y - 3.0, -1.3));
    add(&mut mesh, floor);
    Scene { mesh, eye: Vec3::new(2.0, -3.2, 1.4), target: Vec3::new(0.0, 0.0, -0.2), light: Vec3::new(3.0, -2.0, 4.0) }
}

/// A closed surface of two angles.
fn grid(along: u32, around: u32, point: impl Fn(u32, u32) -> Vec3) -> Mesh {
    let at = |i: u32, j: u32| i % along * around + j % around;
    Mesh {
        positions: (0..along * around).map(|k| point(k / around, k % around)).collect(),
        triangles: (0..along * around)
            .flat_map(|k| {
                let (i, j) = (k / around, k % around);
                [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
            })
            .collect(),
        ..Mesh::default()
    }
}

fn grid_flat(n: u32, point: impl Fn(Vec2) -> Vec3) -> Mesh {
    let at = |i: u32, j: u32| i * (n + 1) + j;
    let place = |k: u32| Vec2::new((k / (n + 1)) as f32, (k % (n + 1)) as f32) / n as f32;
    Mesh {
        positions: (0..(n + 1) * (n + 1)).map(|k| point(place(k))).collect(),
        triangles: (0..n * n)
            .flat_map(|k| {
                let (i, j) = (k / n, k % n);
                [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
            })
            .collect(),
        ..Mesh::default()
    }
}

/// A sphere by degrees of longitude and latitude, its points moved.
fn sphere(around: u32, down: u32, place: impl Fn(Vec3) -> Vec3) -> Mesh {
    let at = |i: u32, j: u32| i * around + j % around;
    let point = |k: u32| {
        let (a, b) = (TAU * (k % around) as f32 / around as f32, 0.5 * TAU * (k / around) as f32 / down as f32);
        place(Vec3::new(b.sin() * a.cos(), b.sin() * a.sin(), b.cos()))
    };
    let faces = (0..down * around).flat_map(|k| {
        let (i, j) = (k / around, k % around);
        let upper = (i > 0).then(|| [at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        let lower = (i + 1 < down).then(|| [at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
        upper.into_iter().chain(lower)
    });
    Mesh { positions: (0..(down + 1) * around).map(point).collect(), triangles: faces.collect(), ..Mesh::default() }
}

/// Each triangle cut into four equal ones.
fn subdivided(mesh: &Mesh) -> Mesh {
    let mut finer = Mesh::default();
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|corner| mesh.positions[corner as usize]);
        let first = finer.positions.len() as u32;
        finer.positions.extend([a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)]);
        finer
            .triangles
            .extend([[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]].map(|face| face.map(|corner| first + corner)));
    }
    finer
}

fn add(mesh: &mut Mesh, other: Mesh) {
    let first = mesh.positions.len() as u32;
    mesh.positions.extend(other.positions);
    mesh.triangles.extend(other.triangles.into_iter().map(|face| face.map(|corner| first + corner)));
}

/// Numbers from 0 to 1 (Steele, Lea, Flood: SplitMix, 2014).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ z >> 31) >> 40) as f32 / (1 << 24) as f32
    }
}
