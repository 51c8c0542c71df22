//! Grades the parts that a program has of its own: each law of their kits in a process of its own, and a time against the reference's.
//!
//! ```text
//!   grade ── for each law ──> the same program, `examine PART LAW`  ── result file ──> a mark
//!     |                         limits itself in memory; is ended at the time limit
//!     `── once ─────────────> the same program, `examine-speed`     ── result file ──> a time
//! ```
//!
//! So an endless loop, a stack overflow or an abort costs its own points and no others. It is no wall against a program that cheats: its
//! own part runs in the process that reports about it. See the page for teachers.

mod answer;
mod exam;
mod examinee;
mod gradescope;
mod json;
mod junit;
mod limits;
mod points;
mod process;
mod sheet;
mod speed;
mod summary;

pub(crate) use answer::{Answer, Reason, Report};
pub(crate) use exam::{Exam, exams};
pub(crate) use examinee::{examine, examine_speed};
pub(crate) use gradescope::gradescope;
pub(crate) use json::json;
pub(crate) use junit::junit;
pub(crate) use limits::Limits;
pub(crate) use points::Points;
pub(crate) use process::run;
pub(crate) use sheet::{Mark, Sheet};
pub(crate) use speed::Speed;
pub(crate) use summary::summary;

/// Whether a report shows what would let a student rebuild the cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cases {
    Shown,
    /// Neither the seed nor a case, nor what was found there.
    Hidden,
}
