use std::mem::MaybeUninit;

use super::super::MOST_PENDING;

/// What a ray has still to visit. Its memory is not cleared for each ray, which would cost as much as a node.
pub(in crate::wide) struct Stack<T: Copy> {
    entries: [MaybeUninit<T>; MOST_PENDING],
    /// At most `MOST_PENDING`; the entries below it are written.
    length: usize,
}

impl<T: Copy> Stack<T> {
    #[inline(always)]
    pub(in crate::wide) fn new() -> Self {
        Self { entries: [const { MaybeUninit::uninit() }; MOST_PENDING], length: 0 }
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
