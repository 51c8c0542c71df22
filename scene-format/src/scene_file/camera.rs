use super::{Transform, Triple};
use crate::span::{Span, Spanned};

/// `camera { ... }`
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// What forms the picture.
    pub lens: Lens,
    /// Where the camera stands.
    pub placement: CameraPlacement,
    /// The full horizontal angle of view in degrees, strictly between 0 and 180.
    pub fov: Spanned<f32>,
    /// Width over height of the image plane (not of the picture), greater than 0.
    pub aspect: Spanned<f32>,
    /// `shift x y`: moves the image plane, in units of the image plane at distance 1.
    pub shift: Option<[f32; 2]>,
}

/// What forms the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lens {
    /// `pinhole`: everything is sharp.
    Pinhole,
    /// `thinlens`: sharp at one distance.
    Thin {
        /// `fdist`: the distance of the plane in focus, along the view axis, greater than 0.
        focus_distance: f32,
        /// `lensr`: the radius of the lens, 0 or greater.
        radius: f32,
        /// `sides`: the lens is a regular polygon of that many sides; fewer than 3 or `None`: a disc.
        sides: Option<u32>,
        /// `rotation`: turns the polygon, in degrees.
        rotation: Option<f32>,
    },
}

/// Where a camera stands and looks. As everywhere, the place in the source does not count when two are compared.
#[derive(Clone, Debug)]
pub enum CameraPlacement {
    /// `eye`, `target` and `up`. They do not define a view when the eye is at the target or `up` points along the view.
    LookAt {
        /// Where the camera stands.
        eye: Triple,
        /// The point in the middle of the picture (without `shift`).
        target: Triple,
        /// A direction that is up in the picture.
        up: Triple,
        /// The three together.
        span: Span,
    },
    /// `transform <matrix>`: from the camera's space (looks along -z, x right, y up) into the world's.
    Transform(Spanned<Transform>),
}

impl PartialEq for CameraPlacement {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (
                Self::LookAt { eye, target, up, span: _ },
                Self::LookAt { eye: other_eye, target: other_target, up: other_up, span: _ },
            ) => (eye, target, up) == (other_eye, other_target, other_up),
            (Self::Transform(transform), Self::Transform(other)) => transform == other,
            _ => false,
        }
    }
}
