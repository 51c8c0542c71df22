use std::ops::Range;

use glam::{DVec3, Vec3};
use proptest::prelude::*;

use super::{Aimed, frame, in_plane, magnitude, slope, unit_vector};
use crate::{Ray, Triangle};

/// Triangles of size 1e-6 to 1e7, aspect 1 to 1e6, up to 1e6 sizes from the origin of space; rays from 1e-3 to 1e6 sizes away,
/// some edge-on to 1e-6, aimed at the inside, at what lies around, and as exactly as `f32` allows at edges and corners.
pub fn triangles() -> impl Strategy<Value = Aimed<Triangle>> {
    let place = (magnitude(1e-6, 1e7), prop_oneof![Just(0.0), magnitude(1.0, 1e6)], unit_vector());
    let shape = (prop_oneof![Just(1.0), magnitude(1.0, 1e6)], -1.0..2.0_f64);
    let line = (magnitude(1e-3, 1e6), slope(), magnitude(1e-3, 1e3), 0.0..6.3);
    (frame(), place, shape, barycentric(), line).prop_map(|(frame, place, (aspect, lean), [wa, wb, wc], line)| {
        let (size, far, side) = place;
        let a = side * far * size;
        let b = a + frame.x_axis * size;
        let c = a + frame.x_axis * (lean * size) + frame.y_axis * (size / aspect);
        let corners = [a.as_vec3(), b.as_vec3(), c.as_vec3()];
        let [a, b, c] = corners.map(|corner| corner.as_dvec3());
        let target = (a * wa + b * wb + c * wc).as_vec3();
        let (distance, slope, length, heading) = line;
        let direction = (in_plane(frame, heading) + frame.z_axis * slope).normalize();
        let origin = (target.as_dvec3() - direction * distance * size).as_vec3();
        // A power of two keeps an exact aim exact.
        let length = libm::exp2(libm::rint(libm::log2(length))) as f32;
        Aimed { shape: Triangle { corners }, ray: Ray::new(origin, (target - origin) * length) }
    })
}

/// Triangles whose corners lie exactly in a row, or on each other, up to 1e6 sizes from the origin of space; rays straight at them.
///
/// The corners are whole numbers below 2^24, which no rounding moves, or differ along one axis alone.
pub fn flat_triangles() -> impl Strategy<Value = Aimed<Triangle>> {
    let whole = |most: i32| [-most..=most, -most..=most, -most..=most].prop_map(|v| Vec3::from(v.map(|x| x as f32)));
    let order = prop::sample::select(vec![[0, 1, 2], [1, 0, 2], [0, 2, 1], [0, 0, 1], [0, 0, 0]]);
    let start = prop_oneof![whole(1000), whole(1_000_000)];
    let row = (start, prop_oneof![whole(1), whole(1000)], order)
        .prop_map(|(start, step, order)| order.map(|steps| start + steps as f32 * step));
    let place = (unit_vector(), magnitude(1e-3, 1e7)).prop_map(|(side, far)| side * far);
    let along = || (magnitude(1e-3, 1e6), any::<bool>()).prop_map(|(along, back)| if back { -along } else { along });
    let along_axis = (place, 0..3_usize, [along(), along(), along()]).prop_map(|(place, axis, places)| {
        places.map(|along| {
            let mut corner = place.as_vec3();
            corner[axis] = along as f32;
            corner
        })
    });
    let aim = (barycentric(), magnitude(1e-3, 1e6), unit_vector());
    (prop_oneof![row, along_axis], aim).prop_map(|(corners, ([wa, wb, wc], far, side))| {
        let [a, b, c] = corners.map(|corner| corner.as_dvec3());
        let target = (a * wa + b * wb + c * wc).as_vec3();
        let origin = (target.as_dvec3() + side * far).as_vec3();
        Aimed { shape: Triangle { corners }, ray: Ray::new(origin, target - origin) }
    })
}

/// Weights of three corners that add up to 1: inside, on edges and corners, just off them, and outside.
fn barycentric() -> impl Strategy<Value = [f64; 3]> {
    let inside = (0.0..1.0, 0.0..1.0).prop_map(|(a, b): (f64, f64)| [a * (1.0 - b), b, (1.0 - a) * (1.0 - b)]);
    let edge = (0.0..1.0).prop_map(|a: f64| [a, 1.0 - a, 0.0]);
    let beside = (0.0..1.0, magnitude(1e-9, 1e-1), any::<bool>()).prop_map(|(a, off, out)| {
        let off = if out { -off } else { off };
        [a * (1.0 - off), (1.0 - a) * (1.0 - off), off]
    });
    let around = (-1.0..2.0, -1.0..2.0).prop_map(|(a, b): (f64, f64)| [a, b, 1.0 - a - b]);
    let weights = prop_oneof![3 => inside, 1 => edge, 1 => Just([1.0, 0.0, 0.0]), 1 => beside, 1 => around];
    (weights, 0..3_usize).prop_map(|([a, b, c], turn)| match turn {
        0 => [a, b, c],
        1 => [c, a, b],
        _ => [b, c, a],
    })
}

/// A triangle as one draws it on paper: its edges 0.5 to 3 long, not flat, near the origin of space; and a place inside it that a ray
/// is aimed at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnTriangle {
    /// The corners.
    pub corners: [Vec3; 3],
    /// The corners' shares in the place, each 0.1 at least.
    pub weights: [f64; 3],
    /// The direction: to the back, not flat.
    pub direction: DVec3,
    /// How far the place is ahead, in directions.
    pub ahead: f64,
}

impl DrawnTriangle {
    /// A ray at the place.
    pub fn inside(&self) -> Aimed<Triangle> {
        self.aimed(self.weights, self.direction)
    }

    /// A ray at the place, from the other side.
    pub fn from_behind(&self) -> Aimed<Triangle> {
        let normal = Triangle { corners: self.corners }.scaled_normal().normalize();
        self.aimed(self.weights, self.direction.reflect(normal))
    }

    /// A ray past the edge across from a corner, by a tenth of the height at least.
    pub fn beyond(&self, corner: usize) -> Aimed<Triangle> {
        let mut weights = self.weights;
        let weight = weights[corner];
        weights[corner] = -weight;
        weights[(corner + 1) % 3] *= (1.0 + weight) / (1.0 - weight);
        weights[(corner + 2) % 3] *= (1.0 + weight) / (1.0 - weight);
        self.aimed(weights, self.direction)
    }

    fn aimed(&self, [wa, wb, wc]: [f64; 3], direction: DVec3) -> Aimed<Triangle> {
        let [a, b, c] = self.corners.map(|corner| corner.as_dvec3());
        let origin = a * wa + b * wb + c * wc - direction * self.ahead;
        Aimed { shape: Triangle { corners: self.corners }, ray: Ray::new(origin.as_vec3(), direction.as_vec3()) }
    }
}

/// Such triangles, so many units ahead of a ray with a direction of some length.
pub fn drawn_triangles(ahead: Range<f64>, length: f64) -> impl Strategy<Value = DrawnTriangle> {
    let start = [-2.0..2.0_f64, -2.0..2.0, -2.0..2.0].prop_map(DVec3::from);
    let shape = (0.5..2.0_f64, 0.2..0.8_f64, 0.5..2.0_f64);
    let weights = (0.1..0.4_f64, 0.1..0.4_f64).prop_map(|(b, c)| [1.0 - b - c, b, c]);
    (frame(), start, shape, weights, (0.0..1.0_f64, 0.0..6.3_f64), ahead).prop_map(
        move |(frame, a, (width, lean, height), weights, (slope, heading), ahead)| {
            let b = a + frame.x_axis * width;
            let c = a + frame.x_axis * (lean * width) + frame.y_axis * height;
            let direction = (in_plane(frame, heading) * slope - frame.z_axis).normalize() * length;
            let corners = [a, b, c].map(|corner| corner.as_vec3());
            DrawnTriangle { corners, weights, direction, ahead: ahead / length }
        },
    )
}
