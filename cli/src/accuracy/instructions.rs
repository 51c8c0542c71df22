//! Instructions of a test: counted by valgrind, where it is installed.
//!
//! Hardware counters would need a privilege that few machines give. Valgrind's tool callgrind runs a program on a simulated processor
//! and counts every instruction of it; so this program has itself run twice with a kernel, once going through the
//! cases more often, and takes the difference.

use std::collections::BTreeMap;

use super::kernels::Role;

/// What was counted.
#[derive(Debug, Default)]
pub(crate) struct Counts {
    counted: BTreeMap<(String, &'static str, String), f64>,
    why_not: Option<String>,
}

impl Counts {
    /// Instructions of a test, if they were counted.
    pub(crate) fn of(&self, primitive: &str, role: Role, family: &str) -> Option<f64> {
        self.counted.get(&(primitive.to_owned(), role.name(), family.to_owned())).copied()
    }

    /// How they were counted, or why they were not, for readers.
    pub(crate) fn explanation(&self) -> String {
        match &self.why_not {
            None => "Instructions of a test, with the call through a pointer, were counted by Valgrind's callgrind."
                .to_owned(),
            Some(why) => format!("Instructions were not counted: {why}."),
        }
    }
}
