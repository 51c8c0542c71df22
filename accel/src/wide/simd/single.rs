use super::Lanes;

/// One lane, with any instructions: a number of one ray, before it is put into all lanes.
impl<I: Copy> Lanes<I> for f32 {
    type Row = f32;

    #[inline(always)]
    fn splat(_: I, value: f32) -> Self {
        value
    }

    #[inline(always)]
    fn of_each(_: I, number: impl Fn(usize) -> f32) -> Self {
        number(0)
    }

    #[inline(always)]
    fn load(_: I, from: &f32) -> Self {
        *from
    }

    #[inline(always)]
    fn store(self, to: &mut f32) {
        *to = self;
    }

    #[inline(always)]
    fn times_plus(self, factor: Self, plus: Self) -> Self {
        self * factor + plus
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self::abs(self)
    }

    #[inline(always)]
    fn with_sign_of(self, other: Self) -> Self {
        self.copysign(other)
    }

    #[inline(always)]
    fn or_where(self, lanes: u32, other: Self) -> Self {
        if lanes & 1 == 1 { other } else { self }
    }

    #[inline(always)]
    fn lt(self, other: Self) -> u32 {
        u32::from(self < other)
    }

    #[inline(always)]
    fn le(self, other: Self) -> u32 {
        u32::from(self <= other)
    }

    #[inline(always)]
    fn least(self) -> f32 {
        self
    }

    #[inline(always)]
    fn greatest(self) -> f32 {
        self
    }
}
