//! The `girasol` program for the tests to run.

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run(render::Modules::default())
}
