//! This crate's own reader keeps the laws of its kit.

scene_format::parser_conformance!(scene_format::parse_within);
