use geometry::conformance::wild_vectors;
use geometry::{Interval, Ray};
use glam::Vec3;
use proptest::prelude::*;
use proptest::sample::Index;

use super::{Thing, points};

/// A ray, or how to aim one at the triangles among things.
#[derive(Clone, Debug)]
pub enum Aim {
    /// Wherever it goes.
    Free(Ray),
    /// From a point at a place of a triangle.
    At {
        /// The origin.
        from: Vec3,
        /// The triangle.
        triangle: Index,
        /// The corners' shares in the place: a corner, a place on an edge, one inside.
        weights: [f32; 3],
        /// What the way there is multiplied with.
        length: f32,
    },
    /// In a triangle's plane, from one place of it to another.
    Within {
        /// The triangle.
        triangle: Index,
        /// The corners' shares in the origin, which may be outside.
        from: [f32; 3],
        /// Their shares in the place that the ray is aimed at.
        to: [f32; 3],
    },
}

impl Aim {
    /// The ray at these things.
    pub fn ray(&self, things: &[Thing]) -> Ray {
        let corners_of = |thing: &Thing| if let Thing::Triangle(corners) = thing { Some(*corners) } else { None };
        let triangles: Vec<[Vec3; 3]> = things.iter().filter_map(corners_of).collect();
        let place = |index: &Index, [a, b, c]: [f32; 3]| {
            if triangles.is_empty() {
                return Vec3::new(a, b, c);
            }
            let corners = triangles[index.index(triangles.len())];
            a * corners[0] + b * corners[1] + c * corners[2]
        };
        match self {
            Self::Free(ray) => *ray,
            Self::At { from, triangle, weights, length } => {
                Ray::new(*from, (place(triangle, *weights) - *from) * *length)
            }
            Self::Within { triangle, from, to } => {
                let origin = place(triangle, *from);
                Ray::new(origin, place(triangle, *to) - origin)
            }
        }
    }
}

/// Rays in general, along axes and faces, with components zero and denormal, from up to 1e7 away, aimed at corners, edges and places
/// of triangles, running in their planes, and with numbers of any kind.
pub fn aims() -> impl Strategy<Value = Aim> {
    let far = || prop_oneof![4 => Just(1.0_f32), 1 => Just(1e3_f32), 1 => Just(1e6_f32), 1 => Just(4e6_f32)];
    let length = || prop_oneof![3 => Just(1.0_f32), 1 => 1e-3_f32..1e3, 1 => Just(1e-20_f32), 1 => Just(1e20_f32)];
    let around = prop_oneof![weights(), (-3.0_f32..3.0, -3.0_f32..3.0).prop_map(|(a, b)| [a, b, 1.0 - a - b])];
    let free = |origin, direction| Aim::Free(Ray::new(origin, direction));
    prop_oneof![
        (points(), points()).prop_map(move |(origin, direction)| free(origin, direction)),
        (points(), nearly_along_axes(), far()).prop_map(move |(origin, direction, far)| free(origin * far, direction)),
        (points(), points(), far(), length())
            .prop_map(move |(origin, target, far, length)| { free(origin * far, (target - origin * far) * length) }),
        (points(), far(), any::<Index>(), weights(), length()).prop_map(|(from, far, triangle, weights, length)| {
            Aim::At { from: from * far, triangle, weights, length }
        }),
        (any::<Index>(), around, weights()).prop_map(|(triangle, from, to)| Aim::Within { triangle, from, to }),
        (wild_vectors(), wild_vectors()).prop_map(move |(origin, direction)| free(origin, direction)),
    ]
}

/// Directions some of whose components are zero, of either sign, or hardly more.
pub(super) fn nearly_along_axes() -> impl Strategy<Value = Vec3> {
    let tiny = prop_oneof![Just(0.0_f32), Just(1e-45), Just(1e-39), Just(1e-30)];
    (points(), 0_usize..8, tiny).prop_map(|(direction, keep, tiny)| {
        let component =
            |axis: usize| if keep >> axis & 1 == 1 { direction[axis] } else { tiny.copysign(direction[axis]) };
        Vec3::new(component(0), component(1), component(2))
    })
}

/// Of a triangle's corners: one alone, a place on an edge, one inside.
pub(super) fn weights() -> impl Strategy<Value = [f32; 3]> {
    let corner = prop::sample::select(vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let edge = (0.0_f32..1.0, 0_usize..3).prop_map(|(a, turn)| {
        let mut weights = [a, 1.0 - a, 0.0];
        weights.rotate_left(turn);
        weights
    });
    let inside = (0.0_f32..1.0, 0.0_f32..1.0).prop_map(|(a, b)| [a * (1.0 - b), (1.0 - a) * (1.0 - b), b]);
    prop_oneof![corner, edge, inside]
}

/// Everything ahead, up to the tip, everywhere, and others.
pub fn intervals() -> impl Strategy<Value = Interval> {
    prop_oneof![
        Just(Interval::FORWARD),
        Just(Interval::SEGMENT),
        Just(Interval { min: f32::NEG_INFINITY, max: f32::INFINITY }),
        (-2.0_f32..2.0, 0.0_f32..4.0).prop_map(|(min, length)| Interval { min, max: min + length })
    ]
}
