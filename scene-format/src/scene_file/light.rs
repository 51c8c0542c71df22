use super::{Color, Mesh, Triple, Unknown, Unrendered};
use crate::span::Spanned;

/// `light { type KIND ... }`
#[derive(Clone, Debug, PartialEq)]
pub enum Light {
    /// `point`: `color <color> power <float> p <point>`
    Point {
        /// Its colour.
        color: Spanned<Color>,
        /// Its power. `None` is the old form `power <color> p <point>`, where the colour is colour times power.
        power: Option<Spanned<f32>>,
        /// Where it stands.
        position: Spanned<Triple>,
    },
    /// `meshlight`, or `mesh` in the old form: triangles that shine; not rendered.
    Mesh {
        /// `name NAME`
        name: Option<Spanned<String>>,
        /// `emit <color>`
        emission: Spanned<Color>,
        /// `radiance <float>`: multiplies the colour.
        radiance: Option<Spanned<f32>>,
        /// `samples <int>`
        samples: Option<Spanned<u32>>,
        /// The triangles, with the place of the type.
        mesh: Box<Spanned<Mesh>>,
    },
    /// Another type of Sunflow's: not rendered.
    Unrendered(Unrendered),
    /// A type that nobody knows.
    Unknown(Unknown),
}
