use render::Modules;

use crate::accuracy::{Effort, instructions::run_kernel, report};
use crate::args::AccuracyArguments;
use crate::interrupt::Interrupt;
use crate::output::{check_place, write_file};
use crate::progress::Progress;
use crate::report::{self, Failure};
use crate::scenes::{self, EmbeddedScene};

pub(crate) fn run(arguments: &AccuracyArguments, modules: Modules) -> Result<(), Failure> {
    if let Some(wanted) = &arguments.run_kernel {
        run_kernel(&modules.kernels, wanted, arguments.seed);
        return Ok(());
    }
    let interrupt = Interrupt::listen()?;
    let json = arguments.json.clone().unwrap_or_else(|| arguments.output.with_extension("json"));
    if json == arguments.output {
        return Err(Failure::new(format!("`{}` cannot be both the page and the JSON", json.display()))
            .help("choose two names with -o and --json"));
    }
    check_place(&arguments.output)?;
    check_place(&json)?;
    let effort = if arguments.quick { Effort::quick(arguments.seed) } else { Effort::full(arguments.seed) };
    let wanted =
        |scene: &&EmbeddedScene| arguments.scenes.is_empty() || arguments.scenes.iter().any(|name| name == scene.name);
    let scenes: Vec<&EmbeddedScene> = scenes::all().iter().filter(wanted).collect();
    let report = report(&modules, &effort, &scenes, Progress::counting("measurements", "accuracy", arguments.quiet))?;
    let numbers = format!("{:#}\n", report.json);
    interrupt.undivided(|| {
        write_file(&arguments.output, report.html.as_bytes())?;
        write_file(&json, numbers.as_bytes())
    })?;
    if !arguments.quiet {
        report::line(format!("{}: the page; {}: the same numbers", arguments.output.display(), json.display()));
    }
    Ok(())
}
