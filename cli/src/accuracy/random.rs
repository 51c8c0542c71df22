//! Random inputs that are the same on every run and every machine.

use glam::{DMat3, DVec3};

/// A generator of 64-bit numbers. (SplitMix64; Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, OOPSLA 2014.)
pub(crate) struct Random {
    state: u64,
}

impl Random {
    /// The numbers of a seed for one purpose: another name gives others.
    pub(crate) fn new(seed: u64, purpose: &str) -> Self {
        let mut random = Self { state: seed };
        for byte in purpose.bytes() {
            random.state = random.bits() ^ u64::from(byte);
        }
        random
    }

    fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 to below 1.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Spread evenly.
    pub(crate) fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.unit()
    }

    /// With a logarithm that is spread evenly, between two numbers greater than 0.
    pub(crate) fn magnitude(&mut self, from: f64, to: f64) -> f64 {
        if from == to { from } else { libm::exp(self.between(libm::log(from), libm::log(to))) }
    }

    /// 1 or -1.
    pub(crate) fn sign(&mut self) -> f64 {
        if self.bits() >> 63 == 0 { 1.0 } else { -1.0 }
    }

    /// One of them.
    pub(crate) fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.unit() * choices.len() as f64) as usize]
    }

    /// Three perpendicular unit vectors, right-handed, turned any way.
    pub(crate) fn frame(&mut self) -> DMat3 {
        let z = self.direction();
        let (x, y) = z.any_orthonormal_pair();
        let (sin, cos) = libm::sincos(self.between(0.0, std::f64::consts::TAU));
        let x = x * cos + y * sin;
        DMat3::from_cols(x, z.cross(x), z)
    }

    /// A unit vector, spread evenly over the sphere.
    pub(crate) fn direction(&mut self) -> DVec3 {
        let height = self.between(-1.0, 1.0);
        let (sin, cos) = libm::sincos(self.between(0.0, std::f64::consts::TAU));
        let width = (1.0 - height * height).sqrt();
        DVec3::new(cos * width, sin * width, height)
    }
}
