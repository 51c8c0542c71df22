use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul};

/// A colour or an amount of light: linear sRGB, not clamped.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Color {
    /// Red.
    pub r: f32,
    /// Green.
    pub g: f32,
    /// Blue.
    pub b: f32,
}

impl Color {
    /// No light.
    pub const BLACK: Self = Self::grey(0.0);
    /// All light.
    pub const WHITE: Self = Self::grey(1.0);

    /// A colour from its channels.
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Self { r, g, b }
    }

    /// The same in every channel.
    pub const fn grey(value: f32) -> Self {
        Self::new(value, value, value)
    }

    /// A function of each channel.
    #[must_use]
    pub fn map(self, f: impl Fn(f32) -> f32) -> Self {
        Self::new(f(self.r), f(self.g), f(self.b))
    }

    /// The channels: red, green, blue.
    pub fn to_array(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }
}

impl From<[f32; 3]> for Color {
    fn from([r, g, b]: [f32; 3]) -> Self {
        Self { r, g, b }
    }
}

impl Add for Color {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.r + other.r, self.g + other.g, self.b + other.b)
    }
}

impl AddAssign for Color {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

/// Light through a filter, or off a surface: channel by channel.
impl Mul for Color {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}

impl Mul<f32> for Color {
    type Output = Self;
    fn mul(self, by: f32) -> Self {
        self.map(|channel| channel * by)
    }
}

impl Div<f32> for Color {
    type Output = Self;
    fn div(self, by: f32) -> Self {
        self.map(|channel| channel / by)
    }
}

impl Sum for Color {
    fn sum<I: Iterator<Item = Self>>(colors: I) -> Self {
        colors.fold(Self::BLACK, Add::add)
    }
}
