//! Ctrl-C ends the program at once, but not in the middle of putting a file in place.

use std::process;
use std::sync::{Arc, Mutex, PoisonError};

use crate::report::{self, Failure};

/// The exit code of a program that SIGINT has ended: 128 + 2.
const INTERRUPTED: i32 = 130;

/// Held while a file is put in place.
#[derive(Clone, Default)]
pub(crate) struct Interrupt {
    writing: Arc<Mutex<()>>,
}

impl Interrupt {
    /// From here on Ctrl-C ends the program with exit code 130.
    pub(crate) fn listen() -> Result<Self, Failure> {
        let interrupt = Self::default();
        let writing = Arc::clone(&interrupt.writing);
        ctrlc::set_handler(move || {
            let _done = writing.lock().unwrap_or_else(PoisonError::into_inner);
            // Ends the line of a progress bar.
            report::line("\ninterrupted");
            process::exit(INTERRUPTED);
        })
        .map_err(|error| Failure::of("Ctrl-C cannot be caught", error))?;
        Ok(interrupt)
    }

    /// Does something that Ctrl-C must not cut in two.
    pub(crate) fn undivided<T>(&self, action: impl FnOnce() -> T) -> T {
        let _writing = self.writing.lock().unwrap_or_else(PoisonError::into_inner);
        action()
    }
}
