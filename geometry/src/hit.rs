/// Where a ray meets one primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intersection {
    /// How far along the ray, in multiples of its direction.
    pub t: f32,
    /// A triangle's barycentric weight of its second corner; 0 for other primitives, which need none.
    pub u: f32,
    /// A triangle's barycentric weight of its third corner; 0 for other primitives.
    pub v: f32,
}

impl Intersection {
    /// An intersection with a primitive whose surface follows from `t` alone.
    pub fn at(t: f32) -> Self {
        Self { t, u: 0.0, v: 0.0 }
    }

    /// With the number of the primitive that was met.
    pub fn on(self, primitive: u32) -> Hit {
        Hit { t: self.t, u: self.u, v: self.v, primitive }
    }
}

/// Where a ray meets which primitive of a set: 16 bytes. All else is computed for the nearest hit alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// As in [`Intersection`].
    pub t: f32,
    /// As in [`Intersection`].
    pub u: f32,
    /// As in [`Intersection`].
    pub v: f32,
    /// The primitive's number in its set.
    pub primitive: u32,
}

impl Hit {
    /// The hit without its primitive.
    pub fn intersection(self) -> Intersection {
        Intersection { t: self.t, u: self.u, v: self.v }
    }

    /// Whether this hit comes before another: by distance, and at equal distance by the lower number, so that the answer does
    /// not depend on the order in which primitives are tried.
    pub fn is_before(self, other: Self) -> bool {
        self.t < other.t || (self.t == other.t && self.primitive < other.primitive)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_hit_comes_before_and_of_equally_near_ones_the_lower_number() {
        let hit = |t, primitive| Intersection::at(t).on(primitive);
        assert!(hit(1.0, 7).is_before(hit(2.0, 3)) && !hit(2.0, 3).is_before(hit(1.0, 7)));
        assert!(hit(1.0, 3).is_before(hit(1.0, 7)) && !hit(1.0, 7).is_before(hit(1.0, 3)));
        assert!(!hit(1.0, 3).is_before(hit(1.0, 3)), "not before itself");
    }
}
