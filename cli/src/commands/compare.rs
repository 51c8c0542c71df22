use std::path::PathBuf;

use render::Modules;

use crate::args::CompareArguments;
use crate::compare::{Contest, Parts, page, summary};
use crate::input::SceneSource;
use crate::interrupt::Interrupt;
use crate::output::{check_place, print, write_file};
use crate::parts::{Part, listed, swapped};
use crate::report::{self, Failure};

pub(crate) fn run(arguments: &CompareArguments, modules: Modules) -> Result<(), Failure> {
    let interrupt = Interrupt::listen()?;
    let source = SceneSource::find(&arguments.scene.scene)?;
    let output = arguments.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}-compare.html", source.name)));
    check_place(&output)?;
    let own = arguments.options.modules(modules);
    let parts = set_back(&arguments.with, &own)?;
    let contest = Contest::hold(&source, arguments, modules, &parts)?;
    print(&summary(&contest)?)?;
    let html = page(&contest)?;
    interrupt.undivided(|| write_file(&output, html.as_bytes()))?;
    if !arguments.quiet {
        report::line(format!("{}: both pictures, their difference, and a slider", output.display()));
    }
    Ok(())
}

/// The parts that are to be set back: of those wanted the ones that differ, or all that do.
fn set_back(wanted: &[Parts], own: &Modules) -> Result<Vec<Part>, Failure> {
    let swapped = swapped(own);
    let asked: Vec<Part> = wanted.iter().flat_map(|parts| parts.parts()).collect();
    let parts: Vec<Part> = swapped.iter().copied().filter(|part| asked.is_empty() || asked.contains(part)).collect();
    if !parts.is_empty() {
        return Ok(parts);
    }
    let failure = if asked.is_empty() {
        Failure::new("there is nothing to compare: every part of this program is the reference's")
    } else {
        Failure::new(format!("there is nothing to compare: {} is the reference's in this program", listed(&asked)))
    };
    Err(failure.help(if swapped.is_empty() {
        "a program of your own has parts of its own: `girasol new` makes one; and options choose others, as \
         `--accelerator octree` does"
            .to_owned()
    } else {
        format!("this program has {} of its own", listed(&swapped))
    }))
}
