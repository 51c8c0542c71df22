use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

use super::{Avx512, Isa, Lanes, pair::Pair};

/// AVX2: vectors of 256 bits.
#[derive(Clone, Copy)]
pub(in crate::wide) struct Avx2(());

impl Avx2 {
    /// If this processor has it.
    pub(in crate::wide) fn detect() -> Option<Self> {
        let detected = is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("bmi2")
            && is_x86_feature_detected!("lzcnt")
            && is_x86_feature_detected!("popcnt");
        detected.then_some(Self(()))
    }
}

impl Isa for Avx2 {
    type F32x8 = Eight;
    type F32x16 = Pair<Eight>;

    #[inline(always)]
    fn vectorize<R>(self, code: impl FnOnce() -> R) -> R {
        #[target_feature(enable = "avx2,bmi1,fma,bmi2,lzcnt,popcnt")]
        fn compiled_for_it<R>(code: impl FnOnce() -> R) -> R {
            code()
        }
        // SAFETY: kind 1; `detect` has asked for each of these features.
        unsafe { compiled_for_it(code) }
    }
}

/// An instruction set with all of AVX2.
pub(in crate::wide) trait HasAvx2: Isa {
    /// A bit for each lane that compares so: a processor with AVX-512 compares into a mask, others into a vector.
    fn compare<const PREDICATE: i32>(left: Eight, right: Eight) -> u32;
}

impl HasAvx2 for Avx2 {
    #[inline(always)]
    fn compare<const PREDICATE: i32>(left: Eight, right: Eight) -> u32 {
        // SAFETY: kind 1.
        unsafe { _mm256_movemask_ps(_mm256_cmp_ps::<PREDICATE>(left.0, right.0)) as u32 }
    }
}

impl HasAvx2 for Avx512 {
    #[inline(always)]
    fn compare<const PREDICATE: i32>(left: Eight, right: Eight) -> u32 {
        // SAFETY: kind 1.
        unsafe { u32::from(_mm256_cmp_ps_mask::<PREDICATE>(left.0, right.0)) }
    }
}

/// 256 bits.
#[derive(Clone, Copy)]
pub(in crate::wide) struct Eight(__m256);

impl Add for Eight {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_add_ps(self.0, other.0) })
    }
}

impl Sub for Eight {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_sub_ps(self.0, other.0) })
    }
}

impl Div for Eight {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_div_ps(self.0, other.0) })
    }
}

impl Mul for Eight {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_mul_ps(self.0, other.0) })
    }
}

impl<I: HasAvx2> Lanes<I> for Eight {
    type Row = [f32; 8];

    #[inline(always)]
    fn splat(_: I, value: f32) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_set1_ps(value) })
    }

    #[inline(always)]
    #[rustfmt::skip]
    fn of_each(_: I, number: impl Fn(usize) -> f32) -> Self {
        let [a, b, c, d, e, f, g, h] = [number(0), number(1), number(2), number(3), number(4), number(5), number(6), number(7)];
        // SAFETY: kind 1.
        Self(unsafe { _mm256_setr_ps(a, b, c, d, e, f, g, h) })
    }

    #[inline(always)]
    fn load(_: I, from: &[f32; 8]) -> Self {
        // SAFETY: kinds 1 and 2.
        Self(unsafe { _mm256_loadu_ps(from.as_ptr()) })
    }

    #[inline(always)]
    fn store(self, to: &mut [f32; 8]) {
        // SAFETY: kinds 1 and 2.
        unsafe { _mm256_storeu_ps(to.as_mut_ptr(), self.0) }
    }

    #[inline(always)]
    fn times_plus(self, factor: Self, plus: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_fmadd_ps(self.0, factor.0, plus.0) })
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_min_ps(self.0, other.0) })
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_max_ps(self.0, other.0) })
    }

    #[inline(always)]
    fn min_by_bits(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe {
            let (own, other) = (_mm256_castps_si256(self.0), _mm256_castps_si256(other.0));
            _mm256_castsi256_ps(_mm256_min_epi32(own, other))
        })
    }

    #[inline(always)]
    fn max_by_bits(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe {
            let (own, other) = (_mm256_castps_si256(self.0), _mm256_castps_si256(other.0));
            _mm256_castsi256_ps(_mm256_max_epi32(own, other))
        })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_andnot_ps(_mm256_set1_ps(-0.0), self.0) })
    }

    #[inline(always)]
    fn with_sign_of(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_or_ps(self.0, _mm256_and_ps(_mm256_set1_ps(-0.0), other.0)) })
    }

    #[inline(always)]
    fn or_where(self, lanes: u32, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe {
            let lane_bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
            let chosen = _mm256_and_si256(_mm256_set1_epi32(lanes as i32), lane_bits);
            let chosen = _mm256_cmpeq_epi32(chosen, lane_bits);
            _mm256_blendv_ps(self.0, other.0, _mm256_castsi256_ps(chosen))
        })
    }

    #[inline(always)]
    fn lt(self, other: Self) -> u32 {
        I::compare::<_CMP_LT_OQ>(self, other)
    }

    #[inline(always)]
    fn le(self, other: Self) -> u32 {
        I::compare::<_CMP_LE_OQ>(self, other)
    }

    #[inline(always)]
    fn least(self) -> f32 {
        // SAFETY: kind 1.
        unsafe {
            let four = _mm_min_ps(_mm256_castps256_ps128(self.0), _mm256_extractf128_ps::<1>(self.0));
            let two = _mm_min_ps(four, _mm_movehl_ps(four, four));
            _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)))
        }
    }

    #[inline(always)]
    fn greatest(self) -> f32 {
        // SAFETY: kind 1.
        unsafe {
            let four = _mm_max_ps(_mm256_castps256_ps128(self.0), _mm256_extractf128_ps::<1>(self.0));
            let two = _mm_max_ps(four, _mm_movehl_ps(four, four));
            _mm_cvtss_f32(_mm_max_ss(two, _mm_movehdup_ps(two)))
        }
    }
}
