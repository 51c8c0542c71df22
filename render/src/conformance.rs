//! The kits of the parts of this crate, and their inputs: far eyes, narrow views, places of the picture to look through.
//!
//! A kit is a module with a list `LAWS`, from the easiest law to the hardest; its macro names each as a test of a part of your own:
//! `render::sampler_conformance!(my_sampler);`. [`geometry::conformance`] tells what a law is, and has the numbers and vectors that the inputs
//! are made of.

pub mod sampler;

use geometry::conformance::{magnitude, unit_vector};
use glam::{DVec2, DVec3};
use proptest::prelude::*;

use crate::{Frame, Pinhole, ThinLens};

/// A camera as a scene describes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Where it stands: up to 1e6 away.
    pub eye: DVec3,
    /// Where it looks: 1e-3 to 1e6 from the eye.
    pub target: DVec3,
    /// Up in the picture, of any length; never along the view.
    pub up: DVec3,
    /// The full horizontal angle of view in degrees: 0.01 to 150.
    pub fov_degrees: f64,
    /// Width over height.
    pub aspect: f64,
    /// Moves the image plane.
    pub shift: DVec2,
}

impl View {
    /// A camera there, if it sees anything.
    pub fn frame(&self) -> Option<Frame> {
        let frame = Frame::look_at(self.eye, self.target, self.up)?.seeing(self.fov_degrees, self.aspect);
        Some(Frame { shift: self.shift, ..frame })
    }

    /// As a pinhole camera.
    pub fn pinhole(&self) -> Option<Pinhole> {
        Some(Pinhole { frame: self.frame()? })
    }

    /// As a thin lens that is sharp at a distance.
    pub fn thin_lens(&self, focus_distance: f64, radius: f64, sides: u32) -> Option<ThinLens> {
        Some(ThinLens { frame: self.frame()?, focus_distance, radius, sides, rotation_degrees: 30.0 })
    }
}

/// Views whose numbers are an `f32`'s, as those of a file are.
pub fn views() -> impl Strategy<Value = View> {
    let place = (unit_vector(), prop_oneof![Just(0.0), magnitude(1.0, 1e6)]).prop_map(|(side, far)| side * far);
    let towards = (unit_vector(), magnitude(1e-3, 1e6)).prop_map(|(forward, distance)| forward * distance);
    let fov = prop_oneof![2 => 40.0..90.0, 1 => magnitude(0.01, 150.0), 1 => Just(0.01)];
    let shift = prop_oneof![2 => Just(DVec2::ZERO), 1 => (-1.0..1.0, -1.0..1.0).prop_map(|(x, y)| DVec2::new(x, y))];
    (place, towards, unit_vector(), fov, magnitude(0.1, 10.0), shift).prop_filter_map(
        "the eye in its target, or up along the view",
        |(eye, towards, up, fov_degrees, aspect, shift)| {
            let eye = eye.as_vec3().as_dvec3();
            let target = (eye + towards).as_vec3().as_dvec3();
            let up = up.as_vec3().as_dvec3();
            let rises = (target - eye).cross(up).length() > 1e-2 * (target - eye).length();
            rises.then_some(View { eye, target, up, fov_degrees, aspect, shift: shift.as_vec2().as_dvec2() })
        },
    )
}

/// Places of the picture and of the unit square: its edges, its corners and all between.
pub fn places() -> impl Strategy<Value = DVec2> {
    let number = || prop_oneof![3 => 0.0..1.0, 1 => Just(0.0), 1 => Just(0.5), 1 => Just(1.0)];
    (number(), number()).prop_map(|(x, y)| DVec2::new(x, y))
}
