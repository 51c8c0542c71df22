//! Numbers of 256 bits and vectors of them, and what the laws ask of them.

use dashu_float::{FBig, round::mode::HalfEven};
use glam::Vec3;
use proptest::prelude::*;

pub(crate) type Real = FBig<HalfEven>;

/// Half the distance from 1 to the next `f32`.
pub(crate) const SINGLE: f64 = f32::EPSILON as f64 / 2.0;

const PRECISION: usize = 256;

/// A number as it is.
pub(crate) fn real(number: impl Into<f64>) -> Real {
    Real::try_from(number.into()).expect("finite").with_precision(PRECISION).value()
}

pub(crate) fn pi() -> Real {
    Real::pi(PRECISION)
}

pub(crate) fn approximate(number: &Real) -> f64 {
    number.to_f64().value()
}

/// The claim is the truth to 0.51 units in its last place: rounded, after steps that are as good as exact.
pub(crate) fn is_right(claim: f32, truth: &Real) -> Result<(), TestCaseError> {
    if *truth > real(f32::MAX) {
        prop_assert!(claim >= f32::MAX);
        return Ok(());
    }
    let off = approximate(&(real(claim) - truth)).abs();
    let ulp = f64::from(claim.next_up()) - f64::from(claim);
    prop_assert!(off <= 0.51 * ulp, "{} is off by {} ulp", claim, off / ulp);
    Ok(())
}

#[derive(Clone, Debug)]
pub(crate) struct Vector(pub(crate) [Real; 3]);

impl Vector {
    /// A vector of the same direction and length 1.
    pub(crate) fn unit(v: Vec3) -> Self {
        Self(v.to_array().map(real)).normalized()
    }

    pub(crate) fn normalized(&self) -> Self {
        self.times(&(real(1.0) / self.dot(self).sqrt()))
    }

    pub(crate) fn dot(&self, other: &Self) -> Real {
        let [x, y, z] = [0, 1, 2].map(|axis| &self.0[axis] * &other.0[axis]);
        x + y + z
    }

    pub(crate) fn times(&self, by: &Real) -> Self {
        Self(self.0.each_ref().map(|x| x * by))
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self([0, 1, 2].map(|axis| &self.0[axis] + &other.0[axis]))
    }

    /// The angle between this unit vector and a claim, if that is small; otherwise what it is in length.
    pub(crate) fn distance(&self, claim: Vec3) -> f64 {
        let off = Self(claim.to_array().map(real)).plus(&self.times(&real(-1.0)));
        approximate(&off.dot(&off)).sqrt()
    }
}
