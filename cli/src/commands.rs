//! One file for each command.

pub(crate) mod accuracy;
pub(crate) mod bench;
pub(crate) mod check;
pub(crate) mod compare;
pub(crate) mod completions;
pub(crate) mod convert;
pub(crate) mod explain_error;
pub(crate) mod fmt;
#[cfg(feature = "conformance")]
pub(crate) mod grade;
pub(crate) mod inspect;
#[cfg(feature = "conformance")]
pub(crate) mod new;
pub(crate) mod parity;
pub(crate) mod render;
pub(crate) mod scenes;
