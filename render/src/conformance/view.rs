use geometry::Transform;
use geometry::conformance::{magnitude, unit_vector};
use glam::{DMat3, DVec2, DVec3};
use proptest::prelude::*;

use crate::{Lens, View, Viewpoint};

/// Views whose numbers are an `f32`'s, as those of a file are: without lens, from eyes up to 1e6 away, at targets 1e-3 to 1e6 from these, of
/// 0.01 to 150 degrees; never along up, which is of any length and seldom at right angles.
pub fn views() -> impl Strategy<Value = View> {
    let place = (unit_vector(), prop_oneof![Just(0.0), magnitude(1.0, 1e6)]).prop_map(|(side, far)| side * far);
    let towards = (unit_vector(), magnitude(1e-3, 1e6)).prop_map(|(forward, distance)| forward * distance);
    let fov = prop_oneof![2 => 40.0..90.0, 1 => magnitude(0.01, 150.0), 1 => Just(0.01)];
    let shift = prop_oneof![2 => Just(DVec2::ZERO), 1 => (-1.0..1.0, -1.0..1.0).prop_map(|(x, y)| DVec2::new(x, y))];
    looking(place, towards, fov, shift)
}

/// Views of an ordinary scene: eyes and targets a few units apart, 30 to 85 degrees, not shifted.
pub fn ordinary_views() -> impl Strategy<Value = View> {
    let place = (unit_vector(), 0.0..10.0).prop_map(|(side, far)| side * far);
    let towards = (unit_vector(), 0.5..10.0).prop_map(|(forward, distance)| forward * distance);
    looking(place, towards, 30.0..85.0, Just(DVec2::ZERO))
}

fn looking(
    place: impl Strategy<Value = DVec3>,
    towards: impl Strategy<Value = DVec3>,
    fov: impl Strategy<Value = f64>,
    shift: impl Strategy<Value = DVec2>,
) -> impl Strategy<Value = View> {
    let up = (unit_vector(), magnitude(0.1, 10.0)).prop_map(|(up, length)| up * length);
    (place, towards, up, fov, magnitude(0.1, 10.0), shift).prop_filter_map(
        "the eye in its target, or up along the view",
        |(eye, towards, up, fov_degrees, aspect, shift)| {
            let eye = eye.as_vec3().as_dvec3();
            let target = (eye + towards).as_vec3().as_dvec3();
            let up = up.as_vec3().as_dvec3();
            let rises = (target - eye).cross(up).length() > 1e-2 * (target - eye).length() * up.length();
            let place = Viewpoint::LookAt { eye, target, up };
            rises.then_some(View { place, fov_degrees, aspect, shift: shift.as_vec2().as_dvec2(), lens: None })
        },
    )
}

/// The same view, placed by a transform.
pub fn by_transform(view: &View) -> View {
    let axes = Axes::of(view);
    let linear = DMat3::from_cols(axes.right, axes.up, -axes.forward);
    View { place: Viewpoint::Transform(Transform { linear, translation: axes.eye }), ..*view }
}

/// Lenses of a ten-thousandth to half of their distance in focus: discs, and polygons of up to 7 sides.
pub fn lenses() -> impl Strategy<Value = Lens> {
    let sides = prop_oneof![Just(0_u32), 3_u32..8];
    (magnitude(1e-2, 1e4), magnitude(1e-4, 0.5), sides, -360.0..360.0).prop_map(
        |(focus_distance, width, sides, rotation_degrees)| Lens {
            focus_distance,
            radius: width * focus_distance,
            sides,
            rotation_degrees,
        },
    )
}

/// Places of the picture and of the unit square: its edges, its corners and all between.
pub fn places() -> impl Strategy<Value = DVec2> {
    let number = || prop_oneof![3 => 0.0..1.0, 1 => Just(0.0), 1 => Just(0.5), 1 => Just(1.0)];
    (number(), number()).prop_map(|(x, y)| DVec2::new(x, y))
}

/// The axes that a view asks for, computed anew: in `f64` from an `f32`'s numbers, right to some 2^-50.
#[derive(Clone, Copy, Debug)]
pub struct Axes {
    /// Where the camera stands.
    pub eye: DVec3,
    /// To the right in the picture.
    pub right: DVec3,
    /// Up in it.
    pub up: DVec3,
    /// Into it.
    pub forward: DVec3,
}

impl Axes {
    /// Those of a view that is one.
    pub fn of(view: &View) -> Self {
        match view.place {
            Viewpoint::LookAt { eye, target, up } => {
                let forward = (target - eye).normalize();
                let up = up.normalize().reject_from(forward).normalize();
                Self { eye, right: forward.cross(up), up, forward }
            }
            Viewpoint::Transform(Transform { linear, translation }) => {
                Self { eye: translation, right: linear.x_axis, up: linear.y_axis, forward: -linear.z_axis }
            }
        }
    }

    /// From the eye to the place on the image plane, at distance 1.
    pub fn towards(&self, view: &View, film: DVec2) -> DVec3 {
        let half_width = libm::tan(view.fov_degrees.to_radians() / 2.0);
        let half = DVec2::new(half_width, half_width / view.aspect);
        let on_plane = view.shift + half * (2.0 * film - DVec2::ONE);
        self.forward + self.right * on_plane.x + self.up * on_plane.y
    }
}
