use super::{Color, Other, Triple};

/// `light { type KIND ... }`
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// What kind of light.
    pub kind: LightKind,
}

/// What kind of light.
#[derive(Clone, Debug, PartialEq)]
pub enum LightKind {
    /// `point`: `color <color> power <float> p <point>`
    Point {
        /// Its colour.
        color: Color,
        /// Its power. `None` is the old form `power <color> p <point>`, where the colour is colour times power.
        power: Option<f32>,
        /// Where it stands.
        position: Triple,
    },
    /// Any other type: not rendered.
    Other(Other),
}
