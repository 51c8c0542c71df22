//! The `girasol` program: the reference renderer with all of its commands.

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run(render::Modules::default())
}
