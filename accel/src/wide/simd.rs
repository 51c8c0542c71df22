//! Vectors of eight numbers and of sixteen, in three instruction sets.
//!
//! A traversal is written once, over [`Isa`], and compiled three times: for AVX-512, for AVX2, and for any processor. Which one runs is
//! asked of the processor when the accelerator is built. All three do the same IEEE operations in the same order, so they give the same
//! bits; what may be fused ([`Lanes::times_plus`]) only leaves boxes out, within a bound that allows for either.
//!
//! # Safety
//!
//! The only `unsafe` of the project stands in this module and its children. It is of three kinds:
//!
//! 1. *Instructions the processor may not have.* A value of [`Avx2`] or [`Avx512`] can be made only by its `detect`, which asks the
//!    processor; a vector can be made only from such a value, or from another vector. So whoever holds a vector runs on a processor
//!    that has its instructions, and each operation on it is sound. `vectorize` enters code compiled for the instructions, and
//!    takes such a value, too.
//! 2. *Loads and stores.* Each takes a reference to an array of just the vector's size, and is of the kind that asks for no alignment.
//! 3. *The stack's memory that is not yet written* ([`Stack`]): read only below its length, all of which `push` has written.
#![allow(unsafe_code)]

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
mod pair;
mod portable;
mod single;
mod stack;

use std::ops::{Add, Div, Mul, Sub};

#[cfg(target_arch = "x86_64")]
pub(super) use avx2::Avx2;
#[cfg(target_arch = "x86_64")]
pub(super) use avx512::Avx512;
pub(super) use portable::Portable;
pub(super) use stack::{Room, Stack};

/// An instruction set that this processor has.
pub(super) trait Isa: Copy {
    /// Eight `f32`: a number of each triangle of a block.
    type F32x8: Lanes<Self, Row = [f32; 8]>;
    /// Sixteen `f32`: a number of each box of a node, of each ray of a packet.
    type F32x16: Lanes<Self, Row = [f32; 16]>;

    /// Runs code compiled for the instruction set. What it calls must be `#[inline(always)]` to be compiled with it.
    fn vectorize<R>(self, code: impl FnOnce() -> R) -> R;
}

/// Asks for memory that will be read soon; where the processor cannot be asked, nothing is done.
#[inline(always)]
pub(super) fn prefetch<T>(soon: &T) {
    #[cfg(target_arch = "x86_64")]
    for line in (0..size_of::<T>()).step_by(64) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: kind 1, for every x86-64 has it. Nothing is read: any address will do.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(soon).cast::<i8>().wrapping_add(line)) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = soon;
}

/// A number of each box of a node, or of each ray of a packet, in memory: a cache line.
///
/// Were it not aligned, it would be up to where the caller's stack begins whether it is written into two lines, and the processor waits when it
/// is read back: a tenth of all the time, in some runs of a program and not in others.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub(super) struct Line(pub(super) [f32; 16]);

impl Line {
    #[inline(always)]
    pub(super) fn of<I: Isa>(lanes: &I::F32x16) -> Self {
        let mut line = Self([0.0; 16]);
        lanes.store(&mut line.0);
        line
    }

    #[inline(always)]
    pub(super) fn lanes<I: Isa>(&self, isa: I) -> I::F32x16 {
        I::F32x16::load(isa, &self.0)
    }
}

/// The bits of a number that are set, from the lowest.
#[inline(always)]
pub(super) fn bits(mut set: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lowest = (set != 0).then_some(set.trailing_zeros() as usize);
        set &= set.wrapping_sub(1);
        lowest
    })
}

/// Each component, changed. (`array::map` is not always compiled for the instructions of who calls it.)
#[inline(always)]
pub(super) fn map<T, U>([x, y, z]: &[T; 3], change: impl Fn(&T) -> U) -> [U; 3] {
    [change(x), change(y), change(z)]
}

/// Some numbers, one in each lane.
///
/// Comparisons give a bit for each lane. What minimum and maximum of a NaN are is not said.
pub(super) trait Lanes<I>:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// As many numbers, in memory.
    type Row: Copy;

    /// The same number in all lanes.
    fn splat(isa: I, value: f32) -> Self;
    /// A number for each lane, as it is asked for: without a detour through memory, on which a processor waits until all have been written.
    fn of_each(isa: I, number: impl Fn(usize) -> f32) -> Self;
    /// Lane by lane from memory.
    fn load(isa: I, from: &Self::Row) -> Self;
    /// Lane by lane to memory.
    fn store(self, to: &mut Self::Row);
    /// `self * factor + plus`, rounded once or twice as the processor likes: for what has slack for both.
    fn times_plus(self, factor: Self, plus: Self) -> Self;
    /// The lesser, lane by lane.
    fn min(self, other: Self) -> Self;
    /// The greater, lane by lane.
    fn max(self, other: Self) -> Self;
    /// As [`Self::min`], by comparing bits as whole numbers, which many processors do in one step and not in four: of two negative numbers it may be the
    /// greater.
    #[inline(always)]
    fn min_by_bits(self, other: Self) -> Self {
        self.min(other)
    }
    /// As [`Self::max`], by comparing bits as whole numbers: of two negative ones it may be the lesser.
    #[inline(always)]
    fn max_by_bits(self, other: Self) -> Self {
        self.max(other)
    }
    /// Without its sign.
    fn abs(self) -> Self;
    /// With the sign of another, lane by lane; its own must be positive.
    fn with_sign_of(self, other: Self) -> Self;
    /// With the other's numbers in the lanes whose bits are set.
    fn or_where(self, lanes: u32, other: Self) -> Self;
    /// A bit for each lane that is less than the other's; none for a NaN.
    fn lt(self, other: Self) -> u32;
    /// A bit for each lane that is no greater than the other's; none for a NaN.
    fn le(self, other: Self) -> u32;
    /// The least of all lanes.
    fn least(self) -> f32;
    /// The greatest of all lanes.
    fn greatest(self) -> f32;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every pair of some numbers, in the first lane.
    fn check<I: Isa>(isa: I) {
        let numbers = [f32::NEG_INFINITY, -2.0, -1.0, -0.0, 0.0, f32::MIN_POSITIVE, 1.0, 2.0, f32::INFINITY];
        let of_two = |a: f32, b: f32, pick: fn(I::F32x16, I::F32x16) -> I::F32x16| {
            Line::of::<I>(&pick(I::F32x16::splat(isa, a), I::F32x16::splat(isa, b))).0[0]
        };
        for (a, b) in numbers.into_iter().flat_map(|a| numbers.map(|b| (a, b))) {
            let (least, greatest) = (of_two(a, b, Lanes::min_by_bits), of_two(a, b, Lanes::max_by_bits));
            if a >= 0.0 && b >= 0.0 || a * b < 0.0 {
                assert_eq!((least, greatest), (a.min(b), a.max(b)), "{a} and {b}");
            } else {
                assert!([a, b].contains(&least) && [a, b].contains(&greatest), "{a} and {b}: {least}, {greatest}");
            }
        }
    }

    #[test]
    fn bits_find_the_lesser_and_the_greater_but_of_two_negative_numbers_it_may_be_the_other() {
        check(Portable);
        #[cfg(target_arch = "x86_64")]
        {
            Avx2::detect().into_iter().for_each(check);
            Avx512::detect().into_iter().for_each(check);
        }
    }
}
