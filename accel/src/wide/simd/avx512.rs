use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

use super::{Isa, Lanes, avx2::Eight};

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
    type F32x8 = Eight;
    type F32x16 = Sixteen;

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

/// 512 bits.
#[derive(Clone, Copy)]
pub(in crate::wide) struct Sixteen(__m512);

impl Add for Sixteen {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_add_ps(self.0, other.0) })
    }
}

impl Sub for Sixteen {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_sub_ps(self.0, other.0) })
    }
}

impl Div for Sixteen {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_div_ps(self.0, other.0) })
    }
}

impl Mul for Sixteen {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_mul_ps(self.0, other.0) })
    }
}

impl Lanes<Avx512> for Sixteen {
    type Row = [f32; 16];

    #[inline(always)]
    fn splat(_: Avx512, value: f32) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_set1_ps(value) })
    }

    #[inline(always)]
    #[rustfmt::skip]
    fn of_each(_: Avx512, number: impl Fn(usize) -> f32) -> Self {
        let [a, b, c, d, e, f, g, h] = [number(0), number(1), number(2), number(3), number(4), number(5), number(6), number(7)];
        let [i, j, k, l, m, n, o, p] = [number(8), number(9), number(10), number(11), number(12), number(13), number(14), number(15)];
        // SAFETY: kind 1.
        Self(unsafe { _mm512_setr_ps(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p) })
    }

    #[inline(always)]
    fn load(_: Avx512, from: &[f32; 16]) -> Self {
        // SAFETY: kinds 1 and 2.
        Self(unsafe { _mm512_loadu_ps(from.as_ptr()) })
    }

    #[inline(always)]
    fn store(self, to: &mut [f32; 16]) {
        // SAFETY: kinds 1 and 2.
        unsafe { _mm512_storeu_ps(to.as_mut_ptr(), self.0) }
    }

    #[inline(always)]
    fn times_plus(self, factor: Self, plus: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_fmadd_ps(self.0, factor.0, plus.0) })
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_min_ps(self.0, other.0) })
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_max_ps(self.0, other.0) })
    }

    #[inline(always)]
    fn min_by_bits(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe {
            let (own, other) = (_mm512_castps_si512(self.0), _mm512_castps_si512(other.0));
            _mm512_castsi512_ps(_mm512_min_epi32(own, other))
        })
    }

    #[inline(always)]
    fn max_by_bits(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe {
            let (own, other) = (_mm512_castps_si512(self.0), _mm512_castps_si512(other.0));
            _mm512_castsi512_ps(_mm512_max_epi32(own, other))
        })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_andnot_ps(_mm512_set1_ps(-0.0), self.0) })
    }

    #[inline(always)]
    fn with_sign_of(self, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_or_ps(self.0, _mm512_and_ps(_mm512_set1_ps(-0.0), other.0)) })
    }

    #[inline(always)]
    fn or_where(self, lanes: u32, other: Self) -> Self {
        // SAFETY: kind 1.
        Self(unsafe { _mm512_mask_blend_ps(lanes as __mmask16, self.0, other.0) })
    }

    #[inline(always)]
    fn lt(self, other: Self) -> u32 {
        // SAFETY: kind 1.
        unsafe { u32::from(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(self.0, other.0)) }
    }

    #[inline(always)]
    fn le(self, other: Self) -> u32 {
        // SAFETY: kind 1.
        unsafe { u32::from(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(self.0, other.0)) }
    }

    #[inline(always)]
    fn least(self) -> f32 {
        // SAFETY: kind 1.
        unsafe { _mm512_reduce_min_ps(self.0) }
    }

    #[inline(always)]
    fn greatest(self) -> f32 {
        // SAFETY: kind 1.
        unsafe { _mm512_reduce_max_ps(self.0) }
    }
}
