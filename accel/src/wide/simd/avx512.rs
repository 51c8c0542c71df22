use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

use super::{Isa, Lanes};

/// AVX-512: twice the registers, comparisons into masks, and vectors of 512 bits for eight `f64`.
#[derive(Clone, Copy)]
pub(in crate::wide) struct Avx512(());

impl Avx512 {
    /// If this processor has it.
    pub(in crate::wide) fn detect() -> Option<Self> {
        let detected = is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512vl")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("bmi2")
            && is_x86_feature_detected!("lzcnt")
            && is_x86_feature_detected!("popcnt");
        detected.then_some(Self(()))
    }
}

impl Isa for Avx512 {
    type F32 = Eight;

    #[inline(always)]
    fn vectorize<R>(self, code: impl FnOnce() -> R) -> R {
        #[target_feature(enable = "avx512f,avx512vl,avx512dq,bmi1,fma,bmi2,lzcnt,popcnt")]
        fn compiled_for_it<R>(code: impl FnOnce() -> R) -> R {
            code()
        }
        // SAFETY: kind 1; `detect` has asked for each of these features.
        unsafe { compiled_for_it(code) }
    }
}

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

impl Lanes<Avx512> for Eight {
    #[inline(always)]
    fn splat(_: Avx512, value: f32) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_set1_ps(value) })
    }

    #[inline(always)]
    fn load(_: Avx512, from: &[f32; 8]) -> Self {
        // SAFETY: kinds 1 and 2.
        Self(unsafe { _mm256_loadu_ps(from.as_ptr()) })
    }

    #[inline(always)]
    fn store(self, to: &mut [f32; 8]) {
        // SAFETY: kinds 1 and 2.
        unsafe { _mm256_storeu_ps(to.as_mut_ptr(), self.0) }
    }

    #[inline(always)]
    fn times_less(self, factor: Self, less: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm256_fmsub_ps(self.0, factor.0, less.0) })
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
    fn lt(self, other: Self) -> u32 {
        // SAFETY: kind 1.
        unsafe { u32::from(_mm256_cmp_ps_mask::<_CMP_LT_OQ>(self.0, other.0)) }
    }

    #[inline(always)]
    fn le(self, other: Self) -> u32 {
        // SAFETY: kind 1.
        unsafe { u32::from(_mm256_cmp_ps_mask::<_CMP_LE_OQ>(self.0, other.0)) }
    }
}
