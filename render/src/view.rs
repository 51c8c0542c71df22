use geometry::Transform;
use glam::{DVec2, DVec3};

use crate::{Camera, Frame, Pinhole, ThinLens};

/// What a scene says of its camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Where it stands and looks.
    pub place: Viewpoint,
    /// The full horizontal angle of view in degrees, of any size. A plane shows more than 0 and less than 180; beyond
    /// them the tangent is negative, and the picture turned by half a turn.
    pub fov_degrees: f64,
    /// The image plane's width over its height, not 0. Below 0 the picture is upside down.
    pub aspect: f64,
    /// Moves the image plane, in units of the plane at distance 1.
    pub shift: DVec2,
    /// `None`: everything is sharp.
    pub lens: Option<Lens>,
}

/// Where a camera stands and looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Viewpoint {
    /// From a point to another.
    LookAt {
        /// Where it stands.
        eye: DVec3,
        /// What it looks at.
        target: DVec3,
        /// A direction that is up in the picture, of any length; seldom at right angles to the view.
        up: DVec3,
    },
    /// From the camera's space, where it looks along -z, x to the right and y upwards, to the world. It has an inverse. Axes that are no unit
    /// vectors stretch the picture.
    Transform(Transform),
}

/// A lens with a width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// The distance of the plane in focus, along the view axis; greater than 0.
    pub focus_distance: f64,
    /// Its radius, greater than 0.
    pub radius: f64,
    /// A regular polygon of that many sides, its corners at the radius; a disc below 3.
    pub sides: u32,
    /// The direction of the polygon's first corner, in degrees from right, towards up.
    pub rotation_degrees: f64,
}

/// The camera of a view; `None` where eye, target and up define none: the eye in its target, or up along the view.
pub fn camera(view: &View) -> Option<Box<dyn Camera>> {
    let frame = Frame { shift: view.shift, ..frame(&view.place)?.seeing(view.fov_degrees, view.aspect) };
    Some(match view.lens {
        None => Box::new(Pinhole { frame }),
        Some(Lens { focus_distance, radius, sides, rotation_degrees }) => {
            Box::new(ThinLens { frame, focus_distance, radius, sides, rotation_degrees })
        }
    })
}

fn frame(place: &Viewpoint) -> Option<Frame> {
    match *place {
        Viewpoint::LookAt { eye, target, up } => Frame::look_at(eye, target, up),
        Viewpoint::Transform(to_world) => {
            let axes = to_world.linear;
            Some(Frame {
                eye: to_world.translation,
                right: axes.x_axis,
                up: axes.y_axis,
                forward: -axes.z_axis,
                half: DVec2::ONE,
                shift: DVec2::ZERO,
            })
        }
    }
}
