//! One file for each command.

pub(crate) mod accuracy;
pub(crate) mod bench;
pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod convert;
pub(crate) mod explain_error;
pub(crate) mod fmt;
pub(crate) mod inspect;
pub(crate) mod parity;
pub(crate) mod render;
pub(crate) mod scenes;
