use std::ops::Range;

use glam::{DVec3, Vec3};
use proptest::prelude::*;

use super::{Aimed, magnitude, unit_vector};
use crate::{Aabb, Ray};

/// Boxes, flat ones included and down to 1e-44 in size; origins in the planes of faces, on edges and corners, inside, and up to 1e6 sizes away;
/// directions at faces, edges and corners and along them, with components 0, -0 and denormal.
pub fn boxes() -> impl Strategy<Value = Aimed<Aabb>> {
    prop_oneof![4 => boxes_at_any_side(), 1 => boxes_along_an_edge()]
}

fn box_shapes() -> impl Strategy<Value = Aabb> {
    let extent = || prop_oneof![1 => Just(0.0), 3 => magnitude(1e-3, 1.0)];
    let size = prop_oneof![7 => magnitude(1e-3, 1e6), 1 => magnitude(1e-44, 1e-30)];
    let place = (size, prop_oneof![Just(0.0), magnitude(1.0, 1e6)], unit_vector());
    (place, [extent(), extent(), extent()]).prop_map(|((size, far, side), extent)| {
        let min = (side * far * size).as_vec3();
        Aabb { min, max: (min.as_dvec3() + DVec3::from(extent) * size).as_vec3() }
    })
}

/// Rays that run exactly in an edge's line, from before the box, from within the edge, or from behind.
fn boxes_along_an_edge() -> impl Strategy<Value = Aimed<Aabb>> {
    let start = prop_oneof![Just(0.0), Just(1.0), 0.0..1.0, -1.0..2.0, magnitude(1.0, 1e6).prop_map(|far| -far)];
    let sign = || prop_oneof![Just(1.0_f32), Just(-1.0)];
    (box_shapes(), 0..3_usize, any::<[bool; 2]>(), start, [sign(), sign(), sign()], magnitude(1e-3, 1e3)).prop_map(
        |(shape, axis, upper, start, signs, length)| {
            let mut origin = shape.min;
            for (other, upper) in [(axis + 1) % 3, (axis + 2) % 3].into_iter().zip(upper) {
                origin[other] = if upper { shape.max[other] } else { shape.min[other] };
            }
            let (low, high) = (f64::from(shape.min[axis]), f64::from(shape.max[axis]));
            origin[axis] = (low + start * (high - low)) as f32;
            let mut direction = Vec3::ZERO;
            direction[axis] = length as f32;
            Aimed { shape, ray: Ray::new(origin, direction * Vec3::from(signs)) }
        },
    )
}

fn boxes_at_any_side() -> impl Strategy<Value = Aimed<Aabb>> {
    let place = || prop_oneof![Just(0.0), Just(1.0), 0.0..1.0, -1.0..2.0];
    let far = || prop_oneof![3 => Just(0.0), 1 => magnitude(1.0, 1e6), 1 => magnitude(1.0, 1e6).prop_map(|far| -far)];
    let origin = [(place(), far()), (place(), far()), (place(), far())];
    let step = || {
        let sign = prop_oneof![Just(1.0_f32), Just(-1.0)];
        let tiny = prop_oneof![Just(0.0), Just(1e-45_f32), Just(1e-40), Just(f32::MIN_POSITIVE), Just(1e-30)];
        prop_oneof![3 => Just(None), 1 => (sign, tiny).prop_map(|(sign, tiny)| Some(sign * tiny))]
    };
    let target = [(place(), step()), (place(), step()), (place(), step())];
    (box_shapes(), origin, target, magnitude(1e-3, 1e3)).prop_map(|(shape, origin, target, length)| {
        let coordinate = |axis: usize, place: f64| match place {
            0.0 => shape.min[axis],
            1.0 => shape.max[axis],
            _ => (f64::from(shape.min[axis]) * (1.0 - place) + f64::from(shape.max[axis]) * place) as f32,
        };
        let size = f64::from(shape.extent().max_element());
        let start = |axis: usize| match origin[axis] {
            (place, 0.0) => coordinate(axis, place),
            (place, far) => (f64::from(coordinate(axis, place)) + far * size) as f32,
        };
        let towards = |axis: usize| match target[axis] {
            (_, Some(step)) => step,
            (place, None) => (coordinate(axis, place) - start(axis)) * length as f32,
        };
        let origin = Vec3::new(start(0), start(1), start(2));
        Aimed { shape, ray: Ray::new(origin, Vec3::new(towards(0), towards(1), towards(2))) }
    })
}

/// Boxes as one draws them on paper: edges of 0.5 to 2, near the origin of space; and rays whose point nearest the middle is so many half
/// edges (of the longest) ahead of their origin, and so many (of the shortest) beside the middle. No component of a direction is small.
pub fn drawn_boxes(ahead: Range<f64>, beside: Range<f64>) -> impl Strategy<Value = Aimed<Aabb>> {
    let min = [-2.0..2.0_f64, -2.0..2.0, -2.0..2.0].prop_map(DVec3::from);
    let edges = [0.5..2.0_f64, 0.5..2.0, 0.5..2.0].prop_map(DVec3::from);
    let direction = [0.2..1.0_f64, 0.2..1.0, 0.2..1.0].prop_map(DVec3::from);
    (min, edges, direction, 0..8_u32, ahead, beside, 0.0..6.3_f64).prop_map(
        |(min, edges, mut direction, signs, ahead, beside, around)| {
            for axis in (0..3).filter(|axis| signs >> axis & 1 == 1) {
                direction[axis] = -direction[axis];
            }
            let shape = Aabb { min: min.as_vec3(), max: (min + edges).as_vec3() };
            let (x, y) = direction.normalize().any_orthonormal_pair();
            let (sin, cos) = libm::sincos(around);
            let nearest = min + edges * 0.5 + (x * cos + y * sin) * (beside * 0.5 * edges.min_element());
            let reach = if ahead.abs() > 1.0 { edges.length() } else { edges.min_element() };
            let origin = nearest - direction.normalize() * (ahead * 0.5 * reach);
            Aimed { shape, ray: Ray::new(origin.as_vec3(), direction.as_vec3()) }
        },
    )
}
