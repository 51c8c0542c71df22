//! stub

pub mod scenes;
