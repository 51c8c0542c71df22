use super::{Transform, Triple};
use crate::span::Spanned;

/// `camera { ... }`
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// What forms the picture, with the place of its type.
    pub lens: Spanned<Lens>,
    /// Where the camera stands.
    pub placement: CameraPlacement,
    /// `shutter OPEN CLOSE`: the time in which the picture is taken; not rendered.
    pub shutter: Option<Spanned<[f32; 2]>>,
}

/// What forms the picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Lens {
    /// `pinhole`: everything is sharp.
    Pinhole(View),
    /// `thinlens`: sharp at one distance.
    Thin {
        /// What it sees.
        view: View,
        /// `fdist`: the distance of the plane in focus, along the view axis, greater than 0.
        focus_distance: Spanned<f32>,
        /// `lensr`: the radius of the lens, 0 or greater.
        radius: Spanned<f32>,
        /// `sides`: the lens is a regular polygon of that many sides; fewer than 3 or `None`: a disc.
        sides: Option<Spanned<u32>>,
        /// `rotation`: turns the polygon, in degrees.
        rotation: Option<Spanned<f32>>,
    },
    /// `spherical`: all around; not rendered.
    Spherical,
    /// `fisheye`: half of all around, in a disc; not rendered.
    Fisheye,
}

/// What a plane of projection shows.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// The full horizontal angle in degrees, of any size: the plane is twice the tangent of its half wide. From 180 to 360, and
    /// below 0, that is negative, and the picture turned by half a turn.
    pub fov: Spanned<f32>,
    /// Width over height of the image plane (not of the picture), not 0. Below 0 the picture is upside down.
    pub aspect: Spanned<f32>,
    /// `shift x y`: moves the image plane, in units of the image plane at distance 1.
    pub shift: Option<Spanned<[f32; 2]>>,
}

/// Where a camera stands and looks.
#[derive(Clone, Debug, PartialEq)]
pub enum CameraPlacement {
    /// `eye`, `target` and `up`. They do not define a view when the eye is at the target or `up` points along the view.
    LookAt {
        /// Where the camera stands.
        eye: Spanned<Triple>,
        /// The point in the middle of the picture (without `shift`).
        target: Spanned<Triple>,
        /// A direction that is up in the picture.
        up: Spanned<Triple>,
    },
    /// `transform <matrix>`: from the camera's space (looks along -z, x right, y up) into the world's.
    Transform(Spanned<Transform>),
    /// `steps N times T0 T1` and N placements, none of them moving: a camera that moves. The first is rendered.
    Moving {
        /// When it stands at the first and at the last.
        times: Spanned<[f32; 2]>,
        /// At least one.
        steps: Vec<CameraPlacement>,
    },
}
