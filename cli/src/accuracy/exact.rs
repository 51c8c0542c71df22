//! Numbers of 106 bits: the truth that kernels are held against, 53 bits beyond `f64` and 82 beyond `f32`.

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::{DVec3, Vec3};

/// The unevaluated sum of two `f64`, the second at most half an ulp of the first ("double-double").
///
/// (Dekker: A Floating-Point Technique for Extending the Available Precision, 1971; the algorithms as analysed by Joldes, Muller,
/// Popescu: Tight and Rigorous Error Bounds for Basic Building Blocks of Double-Word Arithmetic, ACM TOMS 2017.) Sum, difference and
/// product are right to a few 2^-106. Numbers must stay between 2^-400 and 2^400.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Exact {
    high: f64,
    low: f64,
}

impl Exact {
    /// The nearest `f64`.
    pub(crate) fn approximate(self) -> f64 {
        self.high
    }

    /// How far an `f32` is from it, without rounding the number first.
    pub(crate) fn distance(self, other: f32) -> f64 {
        (self - Self::from(other)).high.abs()
    }

    pub(crate) fn is_positive(self) -> bool {
        self.high > 0.0
    }

    pub(crate) fn is_negative(self) -> bool {
        self.high < 0.0
    }

    /// NaN below zero.
    pub(crate) fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::from(self.high.sqrt());
        }
        let root = self.high.sqrt();
        let rest = self - product(root, root);
        sum_of_ordered(root, rest.high / (2.0 * root))
    }

    pub(crate) fn min(self, other: Self) -> Self {
        if (other - self).is_negative() { other } else { self }
    }

    pub(crate) fn max(self, other: Self) -> Self {
        if (other - self).is_positive() { other } else { self }
    }
}

impl From<f64> for Exact {
    fn from(number: f64) -> Self {
        Self { high: number, low: 0.0 }
    }
}

impl From<f32> for Exact {
    fn from(number: f32) -> Self {
        Self::from(f64::from(number))
    }
}

/// `a + b` exactly. (Knuth's two-sum.)
fn sum(a: f64, b: f64) -> Exact {
    let high = a + b;
    let b_in_sum = high - a;
    Exact { high, low: (a - (high - b_in_sum)) + (b - b_in_sum) }
}

/// `a + b` exactly, for `|a| >= |b|`. (Dekker's fast two-sum.)
fn sum_of_ordered(a: f64, b: f64) -> Exact {
    let high = a + b;
    Exact { high, low: b - (high - a) }
}

/// `a * b` exactly. (Dekker's product, by Veltkamp's splitting.)
fn product(a: f64, b: f64) -> Exact {
    let split = |x: f64| {
        let big = x * f64::from((1 << 27) + 1);
        let high = big - (big - x);
        (high, x - high)
    };
    let high = a * b;
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    Exact { high, low: ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2 }
}

impl Add for Exact {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let highs = sum(self.high, other.high);
        let lows = sum(self.low, other.low);
        let first = sum_of_ordered(highs.high, highs.low + lows.high);
        sum_of_ordered(first.high, lows.low + first.low)
    }
}

impl Neg for Exact {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Exact {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Exact {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let highs = product(self.high, other.high);
        sum_of_ordered(highs.high, highs.low + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Exact {
    type Output = Self;

    /// Long division, three digits of base 2^53.
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::from(second);
        let third = rest.high / other.high;
        sum_of_ordered(first, second) + Self::from(third)
    }
}

/// A vector of such numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ExactVector(pub(crate) [Exact; 3]);

impl From<DVec3> for ExactVector {
    fn from(v: DVec3) -> Self {
        Self(v.to_array().map(Exact::from))
    }
}

impl From<Vec3> for ExactVector {
    fn from(v: Vec3) -> Self {
        v.as_dvec3().into()
    }
}

impl ExactVector {
    fn zip(self, other: Self, f: impl Fn(Exact, Exact) -> Exact) -> Self {
        Self([0, 1, 2].map(|axis| f(self.0[axis], other.0[axis])))
    }

    pub(crate) fn minus(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }

    pub(crate) fn times(self, factor: Exact) -> Self {
        Self(self.0.map(|x| x * factor))
    }

    pub(crate) fn dot(self, other: Self) -> Exact {
        let [x, y, z] = self.zip(other, |a, b| a * b).0;
        x + y + z
    }

    pub(crate) fn cross(self, other: Self) -> Self {
        let minor = |i: usize, j: usize| self.0[i] * other.0[j] - self.0[j] * other.0[i];
        Self([minor(1, 2), minor(2, 0), minor(0, 1)])
    }

    pub(crate) fn approximate(self) -> DVec3 {
        DVec3::from(self.0.map(Exact::approximate))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::random::Random;
    use dashu_ratio::Relaxed as Rational;

    fn rational(number: Exact) -> Rational {
        Rational::try_from(number.high).unwrap() + Rational::try_from(number.low).unwrap()
    }

    /// Numbers of about 106 bits that differ in size, and nearly equal ones, which cancel.
    fn pairs() -> impl Iterator<Item = (Exact, Exact)> {
        let mut random = Random::new(0, "pairs");
        (0..20_000).map(move |round| {
            let mut number = || {
                let high = random.magnitude(1e-20, 1e20);
                sum(high, high * random.between(-1e-17, 1e-17))
            };
            let (a, b) = (number(), number());
            if round % 2 == 0 { (a, b) } else { (a, -(a + a * Exact::from(random.magnitude(1e-30, 1e-3)))) }
        })
    }

    /// The error of a result, relative to a number that its size is to be judged by.
    fn relative(found: Exact, truth: &Rational, size: &Rational) -> f64 {
        ((rational(found) - truth) / size).to_f64_fast().abs()
    }

    #[test]
    fn the_four_operations_and_the_root_are_right_to_a_hundred_bits() {
        let bound = libm::exp2(-101.0);
        for (a, b) in pairs() {
            let (x, y) = (rational(a), rational(b));
            let sum = &x + &y;
            assert!(relative(a + b, &sum, &sum) < bound, "{a:?} + {b:?}");
            assert!(relative(a * b, &(&x * &y), &(&x * &y)) < bound, "{a:?} * {b:?}");
            assert!(relative(a / b, &(&x / &y), &(&x / &y)) < bound, "{a:?} / {b:?}");
            let root = rational(a.sqrt());
            assert!(relative(a, &(&root * &root), &x) < 2.0 * bound, "root of {a:?}");
        }
    }
}
