//! The tests of the whole stand in `tests/`.
