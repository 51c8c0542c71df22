//! The rays: what a renderer asks of a scene.

use std::f32::consts::TAU;

use geometry::{Interval, Primitives, Ray};
use glam::Vec3;

use crate::meshes::{Random, Scene};

/// The picture's edge in pixels.
const EDGE: u32 = 512;
/// The edge of a bucket.
const BUCKET: u32 = 32;
/// The edge of a tile of rays that stand together.
const TILE: u32 = 4;

pub struct Rays {
    pub primary: Vec<Ray>,
    /// From where the primary rays arrive to the light, at `t = 1`.
    pub shadow: Vec<Ray>,
    /// From there to anywhere above the surface.
    pub diffuse: Vec<Ray>,
}

/// A picture's rays: bucket by bucket, in each tile by tile.
pub fn of(scene: &Scene, primitives: &Primitives, closest: impl Fn(&Ray) -> Option<geometry::Hit>) -> Rays {
    let forward = (scene.target - scene.eye).normalize();
    let right = forward.cross(Vec3::Z).normalize();
    let up = right.cross(forward);
    let mut random = Random(1);
    let mut rays = Rays { primary: Vec::new(), shadow: Vec::new(), diffuse: Vec::new() };
    for number in 0..EDGE * EDGE {
        let [x, y] = pixel(number);
        let across = |pixel: u32| 2.0 * (pixel as f32 + 0.5) / EDGE as f32 - 1.0;
        let ray = Ray::new(scene.eye, forward + 0.55 * (across(x) * right - across(y) * up));
        rays.primary.push(ray);
        if let Some(hit) = closest(&ray) {
            let surface = primitives.surface(&ray, &hit);
            let normal = surface.geometric_normal;
            let normal = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
            // A little off the surface: far enough for all who take part.
            let origin = surface.position + 1e-4 * normal;
            rays.shadow.push(Ray::new(origin, scene.light - origin));
            let (z, angle) = (2.0 * random.next() - 1.0, TAU * random.next());
            let ring = (1.0 - z * z).sqrt();
            rays.diffuse.push(Ray::new(origin, normal + 0.999 * Vec3::new(ring * angle.cos(), ring * angle.sin(), z)));
        }
    }
    rays
}

fn pixel(number: u32) -> [u32; 2] {
    let place = |number: u32, width: u32| [number % width, number / width];
    let (in_tile, tile) = (number % (TILE * TILE), number / (TILE * TILE));
    let in_row = BUCKET / TILE;
    let (in_bucket, bucket) = (tile % (in_row * in_row), tile / (in_row * in_row));
    let places = [(place(bucket, EDGE / BUCKET), BUCKET), (place(in_bucket, in_row), TILE), (place(in_tile, TILE), 1)];
    places.iter().fold([0, 0], |[x, y], &(place, size)| [x + place[0] * size, y + place[1] * size])
}

/// What a ray of each kind asks about.
pub const SHADOW: Interval = Interval::SEGMENT;
