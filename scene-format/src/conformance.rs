//! The kit of a reader of `.sc` scenes, and its inputs: scenes of every form that the format has.
//!
//! A kit is a module with a list `LAWS`, from the easiest law to the hardest; its macro names each as a test of a part of your own:
//! `scene_format::parser_conformance!(my_parse);`. [`geometry::conformance`] tells what a law is.

mod common;
pub mod parser;
mod scenes;

pub use common::{common_scene, common_statement};
pub use scenes::{float, scene, statement};
