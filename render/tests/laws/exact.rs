//! Numbers of 256 bits and vectors of them.

use dashu_float::{FBig, round::mode::HalfEven};
use glam::DVec3;

pub(crate) type Real = FBig<HalfEven>;

/// Half the distance from 1 to the next `f32`.
pub(crate) const SINGLE: f64 = f32::EPSILON as f64 / 2.0;

const PRECISION: usize = 256;

/// A number as it is.
pub(crate) fn real(number: impl Into<f64>) -> Real {
    Real::try_from(number.into()).expect("finite").with_precision(PRECISION).value()
}

/// The tangent of half an angle in degrees.
pub(crate) fn tangent_of_half(degrees: f64) -> Real {
    (real(degrees) * Real::pi(PRECISION) / real(360.0)).tan()
}

#[derive(Clone, Debug)]
pub(crate) struct Vector(pub(crate) [Real; 3]);

impl From<DVec3> for Vector {
    fn from(v: DVec3) -> Self {
        Self(v.to_array().map(real))
    }
}

impl Vector {
    pub(crate) fn dot(&self, other: &Self) -> Real {
        let [x, y, z] = [0, 1, 2].map(|axis| &self.0[axis] * &other.0[axis]);
        x + y + z
    }

    pub(crate) fn cross(&self, other: &Self) -> Self {
        let minor = |i: usize, j: usize| &self.0[i] * &other.0[j] - &self.0[j] * &other.0[i];
        Self([minor(1, 2), minor(2, 0), minor(0, 1)])
    }

    pub(crate) fn normalized(&self) -> Self {
        self.times(&(real(1.0) / self.dot(self).sqrt()))
    }

    pub(crate) fn times(&self, by: &Real) -> Self {
        Self(self.0.each_ref().map(|x| x * by))
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self([0, 1, 2].map(|axis| &self.0[axis] + &other.0[axis]))
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.times(&real(-1.0)))
    }

    /// The sine of the angle to another direction.
    pub(crate) fn sine(&self, other: &Self) -> f64 {
        let (a, b) = (self.normalized(), other.normalized());
        let across = a.cross(&b);
        across.dot(&across).sqrt().to_f64().value()
    }
}
