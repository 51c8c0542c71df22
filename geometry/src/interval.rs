/// An open interval of `t`: both ends lie outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end.
    pub min: f32,
    /// The upper end.
    pub max: f32,
}

impl Interval {
    /// Everything in front of a ray's origin.
    pub const FORWARD: Self = Self { min: 0.0, max: f32::INFINITY };

    /// Everything strictly between a ray's origin and the tip of its direction: what can block a light there.
    pub const SEGMENT: Self = Self { min: 0.0, max: 1.0 };

    /// Whether `t` lies strictly inside. NaN lies nowhere.
    pub fn contains(self, t: f32) -> bool {
        self.min < t && t < self.max
    }

    /// The part below `max`.
    #[must_use]
    pub fn up_to(self, max: f32) -> Self {
        Self { max, ..self }
    }
}
