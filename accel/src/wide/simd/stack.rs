use std::mem::MaybeUninit;

use super::super::MOST_PENDING;

/// Room for a [`Stack`]. Its memory is not cleared for each ray, which would cost as much as a node.
///
/// It starts at a cache line, as a [`super::Line`] does, and so all that is kept beside it: what registers have no room for as well.
#[repr(align(64))]
pub(in crate::wide) struct Room<T: Copy>([MaybeUninit<T>; MOST_PENDING]);

impl<T: Copy> Room<T> {
    #[inline(always)]
    pub(in crate::wide) fn new() -> Self {
        Self([const { MaybeUninit::uninit() }; MOST_PENDING])
    }
}

/// What a ray has still to visit. The room is not part of it, so that its length can stand in a register.
pub(in crate::wide) struct Stack<'a, T: Copy> {
    entries: &'a mut [MaybeUninit<T>; MOST_PENDING],
    /// At most `MOST_PENDING`; the entries below it are written.
    length: usize,
}

impl<'a, T: Copy> Stack<'a, T> {
    #[inline(always)]
    pub(in crate::wide) fn within(room: &'a mut Room<T>) -> Self {
        Self { entries: &mut room.0, length: 0 }
    }

    /// # Panics
    /// If the stack is full: [`MOST_PENDING`] says why it never is.
    #[inline(always)]
    pub(in crate::wide) fn push(&mut self, entry: T) {
        self.entries[self.length].write(entry);
        self.length += 1;
    }

    #[inline(always)]
    pub(in crate::wide) fn pop(&mut self) -> Option<T> {
        self.length = self.length.checked_sub(1)?;
        // SAFETY: kind 3: the entry was below the length.
        Some(unsafe { self.entries[self.length].assume_init() })
    }

    /// Without so many of the last entries.
    #[inline(always)]
    pub(in crate::wide) fn shorten(&mut self, entries: usize) {
        self.length -= entries;
    }

    #[inline(always)]
    pub(in crate::wide) fn len(&self) -> usize {
        self.length
    }

    /// The entries from a length on, the latest last.
    #[inline(always)]
    pub(in crate::wide) fn since(&mut self, length: usize) -> &mut [T] {
        let entries = &mut self.entries[length..self.length];
        // SAFETY: kind 3; a `MaybeUninit<T>` is laid out as a `T`.
        unsafe { &mut *(std::ptr::from_mut(entries) as *mut [T]) }
    }
}
