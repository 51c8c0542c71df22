use clap::CommandFactory;

use crate::args::{Arguments, CompletionsArguments};
use crate::output;
use crate::report::Failure;

pub(crate) fn run(arguments: &CompletionsArguments) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "girasol", &mut script);
    output::print(&String::from_utf8_lossy(&script))
}
