//! The truth that laws hold parts against: rational numbers, which round nowhere, and what the laws ask of them.
//!
//! Every `f32` and `f64` is a rational number, and so is every polynomial of them. Where the truth is a root, the quadratic's signs
//! on both sides of the claim decide.

use std::cmp::Ordering;

use dashu_float::{FBig, round::mode::HalfEven};
pub use dashu_ratio::Relaxed as Exact;
use glam::{DVec3, Vec3};

/// The relative error of a few roundings in `f64`: 2^-52, in which the laws count what a kernel's steps may lose.
pub const DOUBLE: f64 = f64::EPSILON;

/// Half the distance from 1 to the next `f32`.
pub const SINGLE: f64 = f32::EPSILON as f64 / 2.0;

/// How far a `t` may be from the truth in units of its last place: half for its own rounding, a fiftieth for the steps before.
pub const ULPS: f64 = 0.51;

/// A number as it is.
///
/// # Panics
///
/// If it is infinite or no number.
pub fn exact(number: impl Into<f64>) -> Exact {
    Exact::try_from(number.into()).expect("finite")
}

/// The range of truths that `t` may stand for: so many units of its last place, and an absolute error.
pub fn truths(t: f32, ulps: f64, error: f64) -> [Exact; 2] {
    let middle = exact(t);
    let side = |neighbour: f32| &middle + exact(ulps) * (exact(neighbour) - &middle);
    [side(t.next_down()) - exact(error), side(t.next_up()) + exact(error)]
}

/// Whether a number lies in a range, ends included.
pub fn is_within(number: &Exact, [low, high]: &[Exact; 2]) -> bool {
    low <= number && number <= high
}

/// A number to about the precision of `f64`.
pub fn approximate(number: &Exact) -> f64 {
    number.to_f64_fast()
}

/// A number to 256 bits, for what has no rational value.
pub type Real = FBig<HalfEven>;

const PRECISION: usize = 256;

/// A number to 256 bits.
pub fn real(number: &Exact) -> Real {
    let whole = |part: Real| part.with_precision(PRECISION).value();
    whole(Real::from(number.numerator().clone())) / whole(Real::from(number.denominator().clone()))
}

/// Half the circumference of a circle of radius 1.
pub fn pi() -> Real {
    Real::pi(PRECISION)
}

/// How far two places are apart on a circle of circumference 1.
pub fn apart_on_circle(a: f32, b: &Real) -> f64 {
    let off = real(&exact(a)) - b;
    (&off - off.round()).to_f64().value().abs()
}

/// A vector without rounding.
#[derive(Clone, Debug, PartialEq)]
pub struct Vector(pub [Exact; 3]);

impl From<DVec3> for Vector {
    fn from(v: DVec3) -> Self {
        Self(v.to_array().map(exact))
    }
}

impl From<Vec3> for Vector {
    fn from(v: Vec3) -> Self {
        v.as_dvec3().into()
    }
}

impl Vector {
    fn zip(&self, other: &Self, f: impl Fn(&Exact, &Exact) -> Exact) -> Self {
        Self([0, 1, 2].map(|axis| f(&self.0[axis], &other.0[axis])))
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        self.zip(other, |a, b| a + b)
    }

    /// The difference.
    pub fn minus(&self, other: &Self) -> Self {
        self.zip(other, |a, b| a - b)
    }

    /// The scalar product.
    pub fn dot(&self, other: &Self) -> Exact {
        let [x, y, z] = self.zip(other, |a, b| a * b).0;
        x + y + z
    }

    /// The vector product.
    pub fn cross(&self, other: &Self) -> Self {
        let minor = |i: usize, j: usize| &self.0[i] * &other.0[j] - &self.0[j] * &other.0[i];
        Self([minor(1, 2), minor(2, 0), minor(0, 1)])
    }

    /// To about the precision of `f64`.
    pub fn approximate(&self) -> DVec3 {
        DVec3::from(self.0.each_ref().map(approximate))
    }
}

/// `a t^2 + 2 half_b t + c` with `a > 0`.
#[derive(Clone, Debug)]
pub struct Quadratic {
    /// Greater than 0.
    pub a: Exact,
    /// Half of what `t` is multiplied with.
    pub half_b: Exact,
    /// The value at `t = 0`.
    pub c: Exact,
}

impl Quadratic {
    /// A quarter of the discriminant: there are roots if it is at least 0.
    pub fn discriminant(&self) -> Exact {
        &self.half_b * &self.half_b - &self.a * &self.c
    }

    /// Both roots to the precision of `f64`, the lesser first, if there are any.
    pub fn roots(&self) -> Option<[f64; 2]> {
        let discriminant = self.discriminant();
        if discriminant < Exact::ZERO {
            return None;
        }
        let reach = real(&discriminant).sqrt();
        let root = |reach: Real| ((reach - real(&self.half_b)) / real(&self.a)).to_f64().value();
        Some([root(-reach.clone()), root(reach)])
    }

    /// How the lesser root compares with a number, if there are roots.
    fn compare_lesser(&self, x: &Exact) -> Ordering {
        // Half the derivative: negative left of the vertex.
        let slope = &self.a * x + &self.half_b;
        let value = (&self.a * x + exact(2.0) * &self.half_b) * x + &self.c;
        if slope <= Exact::ZERO { value.cmp(&Exact::ZERO) } else { Ordering::Less }
    }

    /// How a root compares with a number: the lesser (0) or the greater (1).
    fn compare(&self, root: usize, x: &Exact) -> Ordering {
        if root == 0 {
            return self.compare_lesser(x);
        }
        let mirrored = Self { half_b: -self.half_b.clone(), ..self.clone() };
        mirrored.compare_lesser(&-x.clone()).reverse()
    }

    /// The first root greater than 0.
    pub fn first_ahead(&self) -> Option<usize> {
        if self.discriminant() < Exact::ZERO {
            return None;
        }
        (0..2).find(|&root| self.compare(root, &Exact::ZERO).is_gt())
    }

    /// Whether a root lies in a range, ends included.
    pub fn root_is_within(&self, root: usize, [low, high]: &[Exact; 2]) -> bool {
        self.compare(root, low).is_ge() && self.compare(root, high).is_le()
    }
}
