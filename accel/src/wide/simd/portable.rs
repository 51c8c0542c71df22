use std::array::from_fn;
use std::ops::{Add, Div, Mul, Sub};

use super::{Isa, Lanes, pair::Pair};

/// What every processor has. The compiler makes of these loops whatever vectors the target is known to have.
#[derive(Clone, Copy)]
pub(in crate::wide) struct Portable;

#[derive(Clone, Copy)]
pub(in crate::wide) struct Eight([f32; 8]);

impl Isa for Portable {
    type F32x8 = Eight;
    type F32x16 = Pair<Eight>;

    #[inline(always)]
    fn vectorize<R>(self, code: impl FnOnce() -> R) -> R {
        code()
    }
}

impl Add for Eight {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] + other.0[i]))
    }
}

impl Sub for Eight {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] - other.0[i]))
    }
}

impl Div for Eight {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] / other.0[i]))
    }
}

impl Mul for Eight {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] * other.0[i]))
    }
}

impl Lanes<Portable> for Eight {
    type Row = [f32; 8];

    #[inline(always)]
    fn splat(_: Portable, value: f32) -> Self {
        Self([value; 8])
    }

    #[inline(always)]
    fn of_each(_: Portable, number: impl Fn(usize) -> f32) -> Self {
        Self(from_fn(number))
    }

    #[inline(always)]
    fn load(_: Portable, from: &[f32; 8]) -> Self {
        Self(*from)
    }

    #[inline(always)]
    fn store(self, to: &mut [f32; 8]) {
        *to = self.0;
    }

    #[inline(always)]
    fn times_plus(self, factor: Self, plus: Self) -> Self {
        self * factor + plus
    }

    // Written as the processors' instructions do it, which is cheaper than f32::min.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(from_fn(|i| if self.0[i] < other.0[i] { self.0[i] } else { other.0[i] }))
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(from_fn(|i| if self.0[i] > other.0[i] { self.0[i] } else { other.0[i] }))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(f32::abs))
    }

    #[inline(always)]
    fn with_sign_of(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i].copysign(other.0[i])))
    }

    #[inline(always)]
    fn or_where(self, lanes: u32, other: Self) -> Self {
        Self(from_fn(|i| if lanes >> i & 1 == 1 { other.0[i] } else { self.0[i] }))
    }

    #[inline(always)]
    fn lt(self, other: Self) -> u32 {
        (0..8).fold(0, |bits, i| bits | u32::from(self.0[i] < other.0[i]) << i)
    }

    #[inline(always)]
    fn le(self, other: Self) -> u32 {
        (0..8).fold(0, |bits, i| bits | u32::from(self.0[i] <= other.0[i]) << i)
    }

    #[inline(always)]
    fn least(self) -> f32 {
        self.0.into_iter().fold(f32::INFINITY, |a, b| if a < b { a } else { b })
    }

    #[inline(always)]
    fn greatest(self) -> f32 {
        self.0.into_iter().fold(f32::NEG_INFINITY, |a, b| if a > b { a } else { b })
    }
}
