use std::cell::Cell;

use crate::progress::Progress;

/// How far the measurements are, in steps of some tenths of a second.
pub(crate) struct Steps {
    progress: Progress,
    done: Cell<usize>,
    total: usize,
}

impl Steps {
    /// Begins, when it is known how many there will be.
    pub(crate) fn start(total: usize, progress: Progress) -> Self {
        progress.advance(0, total);
        Self { progress, done: Cell::new(0), total }
    }

    /// One more is done.
    pub(crate) fn advance(&self) {
        self.done.set(self.done.get() + 1);
        self.progress.advance(self.done.get(), self.total.max(self.done.get()));
    }

    /// Ends.
    pub(crate) fn finish(&self) {
        self.progress.finish();
    }
}
