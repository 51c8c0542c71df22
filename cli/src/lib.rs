//! The commands of the `girasol` program, as a library: a crate of one's own becomes a whole renderer with
//!
//! ```no_run
//! fn main() -> std::process::ExitCode {
//!     cli::run(render::Modules { accelerator: accel::none, ..render::Modules::default() })
//! }
//! ```
//!
//! This is the only crate that touches files, clocks and the terminal. Messages go to stderr; what was asked for goes to stdout
//! or into a file. Exit codes: 0 all went well, 1 something failed, 2 the command line is wrong, 130 interrupted.

mod accuracy;
mod args;
mod commands;
mod compare;
mod comparison;
#[cfg(feature = "conformance")]
mod grade;
mod input;
mod interrupt;
pub mod metrics;
#[cfg(feature = "conformance")]
mod new;
mod options;
mod output;
mod parts;
mod progress;
mod report;
pub mod scenes;
mod table;

use std::process::ExitCode;

use clap::Parser;
use rayon::ThreadPoolBuilder;
use render::Modules;

use args::{Arguments, Command};
use options::RenderOptions;

/// Runs the program with its command line and the given parts.
pub fn run(modules: Modules) -> ExitCode {
    let command = Arguments::parse().command;
    if let Some(threads) = command.render_options().and_then(RenderOptions::threads) {
        // Meshes are generated and trees are built by as many, too. It can only fail where threads cannot be had: then by the caller alone.
        ThreadPoolBuilder::new().num_threads(threads.get()).build_global().ok();
    }
    let result = match command {
        Command::Render(arguments) => commands::render::run(&arguments, modules),
        Command::Check(arguments) => commands::check::run(&arguments, modules),
        Command::Fmt(arguments) => commands::fmt::run(&arguments),
        Command::ExplainError(arguments) => commands::explain_error::run(&arguments),
        Command::Convert(arguments) => commands::convert::run(&arguments),
        Command::Inspect(arguments) => commands::inspect::run(&arguments, modules),
        Command::Scenes(arguments) => commands::scenes::run(&arguments),
        Command::Bench(arguments) => commands::bench::run(&arguments, modules),
        Command::Accuracy(arguments) => commands::accuracy::run(&arguments, modules),
        Command::Compare(arguments) => commands::compare::run(&arguments, modules),
        #[cfg(feature = "conformance")]
        Command::New(arguments) => commands::new::run(&arguments),
        #[cfg(feature = "conformance")]
        Command::Grade(arguments) => commands::grade::run(&arguments, &modules),
        #[cfg(feature = "conformance")]
        Command::Examine(arguments) => grade::examine(&arguments, modules),
        #[cfg(feature = "conformance")]
        Command::ExamineSpeed(arguments) => grade::examine_speed(&arguments, modules),
        Command::Parity(arguments) => commands::parity::run(&arguments, modules),
        Command::Completions(arguments) => commands::completions::run(&arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            report::failure(&failure);
            ExitCode::FAILURE
        }
    }
}
