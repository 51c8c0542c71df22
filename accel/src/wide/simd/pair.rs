use std::ops::{Add, Div, Mul, Sub};

use super::Lanes;

/// Two vectors of eight, as one of sixteen.
#[derive(Clone, Copy)]
pub(in crate::wide) struct Pair<L>(L, L);

impl<L> Pair<L> {
    #[inline(always)]
    fn both(self, other: Self, operation: impl Fn(L, L) -> L) -> Self {
        Self(operation(self.0, other.0), operation(self.1, other.1))
    }
}

impl<L: Add<Output = L>> Add for Pair<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.both(other, L::add)
    }
}

impl<L: Sub<Output = L>> Sub for Pair<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.both(other, L::sub)
    }
}

impl<L: Mul<Output = L>> Mul for Pair<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.both(other, L::mul)
    }
}

impl<L: Div<Output = L>> Div for Pair<L> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.both(other, L::div)
    }
}

/// The first eight of sixteen numbers, and the others.
#[inline(always)]
fn halves(row: &[f32; 16]) -> [&[f32; 8]; 2] {
    let (halves, _) = row.as_chunks();
    [&halves[0], &halves[1]]
}

impl<I: Copy, L: Lanes<I, Row = [f32; 8]>> Lanes<I> for Pair<L> {
    type Row = [f32; 16];

    #[inline(always)]
    fn splat(isa: I, value: f32) -> Self {
        Self(L::splat(isa, value), L::splat(isa, value))
    }

    #[inline(always)]
    fn of_each(isa: I, number: impl Fn(usize) -> f32) -> Self {
        Self(
            L::of_each(isa, &number),
            L::of_each(
                isa,
                #[inline(always)]
                |lane| number(lane + 8),
            ),
        )
    }

    #[inline(always)]
    fn load(isa: I, from: &[f32; 16]) -> Self {
        let [low, high] = halves(from);
        Self(L::load(isa, low), L::load(isa, high))
    }

    #[inline(always)]
    fn store(self, to: &mut [f32; 16]) {
        let (halves, _) = to.as_chunks_mut();
        self.0.store(&mut halves[0]);
        self.1.store(&mut halves[1]);
    }

    #[inline(always)]
    fn times_plus(self, factor: Self, plus: Self) -> Self {
        Self(self.0.times_plus(factor.0, plus.0), self.1.times_plus(factor.1, plus.1))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.both(other, L::min)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.both(other, L::max)
    }

    #[inline(always)]
    fn min_by_bits(self, other: Self) -> Self {
        self.both(other, L::min_by_bits)
    }

    #[inline(always)]
    fn max_by_bits(self, other: Self) -> Self {
        self.both(other, L::max_by_bits)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs(), self.1.abs())
    }

    #[inline(always)]
    fn with_sign_of(self, other: Self) -> Self {
        self.both(other, L::with_sign_of)
    }

    #[inline(always)]
    fn or_where(self, lanes: u32, other: Self) -> Self {
        Self(self.0.or_where(lanes, other.0), self.1.or_where(lanes >> 8, other.1))
    }

    #[inline(always)]
    fn lt(self, other: Self) -> u32 {
        self.0.lt(other.0) | self.1.lt(other.1) << 8
    }

    #[inline(always)]
    fn le(self, other: Self) -> u32 {
        self.0.le(other.0) | self.1.le(other.1) << 8
    }

    #[inline(always)]
    fn least(self) -> f32 {
        self.0.min(self.1).least()
    }

    #[inline(always)]
    fn greatest(self) -> f32 {
        self.0.max(self.1).greatest()
    }
}
