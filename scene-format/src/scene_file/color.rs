use crate::span::Spanned;

/// A colour as written. Which numbers a renderer makes of it is the renderer's affair; see each variant for the meaning.
#[derive(Clone, Debug, PartialEq)]
pub enum Color {
    /// `r g b` without braces: linear sRGB primaries, not clamped.
    Bare([f32; 3]),
    /// `{ "sRGB nonlinear" r g b }`: sRGB-encoded, each channel clamped to 0..1 before decoding.
    SrgbNonlinear([f32; 3]),
    /// `{ "sRGB linear" r g b }`: linear sRGB primaries, not clamped.
    SrgbLinear([f32; 3]),
    /// `{ XYZ x y z }`: CIE 1931 XYZ; channels may come out negative.
    Xyz([f32; 3]),
    /// `{ blackbody T }`: the light of a black body of T kelvin, in watts for each square metre and metre of wavelength: very
    /// large numbers.
    Blackbody(f32),
    /// `{ "spectrum MIN MAX" N v1 ... vN }`
    Spectrum {
        /// The wavelengths between which it is known, in nanometres, the shorter first; it is 0 outside.
        range: [f32; 2],
        /// The first stands at the beginning of the range, each next one N-th part of the range further on; linear in between,
        /// constant behind the last.
        values: Vec<f32>,
    },
}

/// What covers a surface: one colour, or an image.
#[derive(Clone, Debug, PartialEq)]
pub enum Paint {
    /// `diff <color>`
    Color(Spanned<Color>),
    /// `texture <file>`: the file's name as written.
    Texture(Spanned<String>),
}
