//! The kits of what colours a hit, and their inputs: optics and lights, with the cases that break naive formulas made common.
//!
//! A kit is a module with a list `LAWS`, from the easiest law to the hardest; its macro names each as a test of a part of your own:
//! `shading::mirror_conformance!(my_mirror);`. A shader is held against formulas in `f64`, on a [`Stage`]: a point, a few lights and something in
//! their way. [`geometry::conformance`] tells what a law is, and has the numbers and vectors that the inputs are made of.

pub mod constant;
pub mod falloff;
pub mod glass;
mod lit;
pub mod mirror;
pub mod phong;
pub mod soft_shadows;
mod stage;
mod stages;
pub mod texture;

use geometry::conformance::{magnitude, unit_vector};
use glam::{DVec3, Vec3};
use proptest::prelude::*;

pub use stage::{Lamp, Shown, Stage, sky};
pub use stages::{
    blocked_at, from_inside, from_outside, lamps, leaning, lit, lit_from_behind, lit_through_the_surface,
    mirrored_through, stages, straight, undimmed,
};

use crate::{Absorption, Color};

/// A ray that comes to a border between two media.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arriving {
    /// The ray's direction: a unit vector to a rounding.
    pub direction: Vec3,
    /// The border's normal on the ray's side: a unit vector to a rounding.
    pub normal: Vec3,
    /// The index of refraction on the ray's side over that on the other.
    pub eta: f32,
}

/// Rays at borders of `eta` 0.1 to 10, everywhere from straight down to flat to 1e-7, and within 8 u (u = 2^-24) of the critical angle.
pub fn arriving() -> impl Strategy<Value = Arriving> {
    let cosine =
        prop_oneof![0.0..1.0, magnitude(1e-7, 1.0), Just(1.0), magnitude(1e-12, 1e-2).prop_map(|off| 1.0 - off)];
    let anywhere = (unit_vector(), 0.0..6.3, magnitude(0.1, 10.0), cosine)
        .prop_map(|(normal, around, eta, cosine)| arrive(normal, around, eta, cosine));
    prop_oneof![3 => anywhere, 1 => nearly_critical()]
}

/// Rays whose sine is within 8 u of `1 / eta`: above it all is reflected, below it the refracted ray runs along the border.
pub fn nearly_critical() -> impl Strategy<Value = Arriving> {
    (unit_vector(), 0.0..6.3, magnitude(1.0, 10.0), -8.0..8.0).prop_map(
        |(normal, around, eta, off): (_, _, f64, f64)| {
            // Of the index as it is stored.
            let eta = f64::from(eta as f32);
            let sine = (1.0 + off * f64::from(f32::EPSILON) / 2.0) / eta;
            arrive(normal, around, eta, f64::sqrt((1.0 - sine * sine).max(0.0)))
        },
    )
}

/// Distances from a light and its power: 1e-6 to 1e6, often nearly equal.
pub fn lit_from() -> impl Strategy<Value = (f32, f32)> {
    let power = magnitude(1e-6, 1e6);
    let apart = prop_oneof![
        magnitude(1e-6, 1e6).prop_map(|apart| apart - 1.0),
        magnitude(1e-8, 1e-2),
        magnitude(1e-8, 1e-2).prop_map(|off| -off),
        Just(-1.0),
        Just(0.0),
    ];
    (power, apart).prop_map(|(power, apart)| ((power * (1.0 + apart)) as f32, power as f32))
}

/// Colours: channels from 0 to 1, often these.
pub fn colors() -> impl Strategy<Value = Color> {
    let channel = || prop_oneof![1 => Just(0.0_f32), 1 => Just(1.0), 4 => 0.0_f32..1.0];
    [channel(), channel(), channel()].prop_map(Color::from)
}

/// What glass absorbs, and a way through it: from a millionth of the distance that it is given for to a hundred of these.
pub fn absorbed() -> impl Strategy<Value = (Absorption, f32)> {
    let channel =
        || prop_oneof![Just(0.0_f32), Just(1.0), 0.0_f32..1.0, magnitude(1e-7, 1e-2).prop_map(|off| 1.0 - off as f32)];
    (magnitude(1e-3, 1e3), [channel(), channel(), channel()], magnitude(1e-6, 1e2)).prop_map(
        |(distance, color, ways)| {
            (Absorption { distance: distance as f32, color: Color::from(color) }, (ways * distance) as f32)
        },
    )
}

fn arrive(normal: DVec3, around: f64, eta: f64, cosine: f64) -> Arriving {
    let (x, y) = normal.any_orthonormal_pair();
    let (sin, cos) = libm::sincos(around);
    let along = (x * cos + y * sin) * f64::sqrt(1.0 - cosine * cosine);
    Arriving { direction: (along - normal * cosine).as_vec3(), normal: normal.as_vec3(), eta: eta as f32 }
}
