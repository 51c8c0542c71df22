use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use geometry::conformance::Trial;
use render::Modules;
use serde_json::Value;

use crate::args::GradeArguments;
use crate::grade::{self, Answer, Cases, Exam, Limits, Mark, Points, Reason, Sheet, Speed, exams};
use crate::interrupt::Interrupt;
use crate::output::{check_place, print, write_file};
use crate::parts::{Part, swapped};
use crate::progress::Progress;
use crate::report::{self, Failure};

pub(crate) fn run(arguments: &GradeArguments, modules: &Modules) -> Result<(), Failure> {
    let interrupt = Interrupt::listen()?;
    let files = [&arguments.junit, &arguments.gradescope, &arguments.json];
    files.into_iter().flatten().try_for_each(|path| check_place(path))?;
    let parts = parts(arguments, modules)?;
    let points = arguments.weights.as_deref().map_or_else(|| Ok(Points::default()), read_points)?;
    if !Limits::LIMITS_MEMORY {
        report::warning("this system does not limit the memory of a process", "only time is limited");
    }
    let sheet = sheet(arguments, &parts, &points)?;
    print(&grade::summary(&sheet))?;
    let lines = |value: &Value| format!("{value:#}\n").into_bytes();
    let reports: Vec<(&PathBuf, Vec<u8>)> = [
        (&arguments.junit, grade::junit(&sheet)?.into_bytes()),
        (&arguments.gradescope, lines(&grade::gradescope(&sheet))),
        (&arguments.json, lines(&grade::json(&sheet))),
    ]
    .into_iter()
    .filter_map(|(path, bytes)| Some((path.as_ref()?, bytes)))
    .collect();
    interrupt.undivided(|| reports.iter().try_for_each(|(path, bytes)| write_file(path, bytes)))
}

/// The parts that were named, or those that the program has of its own; each once, in their own order.
fn parts(arguments: &GradeArguments, modules: &Modules) -> Result<Vec<Part>, Failure> {
    let mut parts = if arguments.parts.is_empty() { swapped(modules) } else { arguments.parts.clone() };
    parts.sort();
    parts.dedup();
    if parts.is_empty() {
        let failure = Failure::new("there is nothing to grade: every part of this program is the reference's");
        return Err(
            failure.help("name the parts to grade, as in `grade sphere plane`, or run it in a program of your own")
        );
    }
    Ok(parts)
}

fn read_points(path: &Path) -> Result<Points, Failure> {
    let name = path.display().to_string();
    let text = fs::read_to_string(path).map_err(|error| Failure::of(format!("`{name}` cannot be read"), error))?;
    Points::read(&name, &text)
}

/// Tries all laws, one after the other, so that they do not slow each other, and measures the speed.
fn sheet(arguments: &GradeArguments, parts: &[Part], points: &Points) -> Result<Sheet, Failure> {
    let default = Trial::default();
    let trial = Trial {
        cases: arguments.cases.map_or(default.cases, |cases| cases.get().into()),
        seed: arguments.seed.unwrap_or(default.seed),
    };
    let laws: Vec<(Part, Exam)> =
        parts.iter().flat_map(|&part| exams(part).into_iter().map(move |exam| (part, exam))).collect();
    let progress = Progress::counting("laws", "grading", arguments.quiet);
    let mut marks = Vec::new();
    for (number, (part, exam)) in laws.iter().enumerate() {
        progress.advance(number, laws.len());
        marks.push(mark(arguments, *part, exam, &trial, points)?);
    }
    progress.finish();
    let speed = if arguments.no_speed { None } else { Some(speed(arguments, points)?) };
    let cases = if arguments.hide_seed { Cases::Hidden } else { Cases::Shown };
    Ok(Sheet { marks, speed, seed: trial.seed, case_count: trial.cases, cases })
}

fn mark(arguments: &GradeArguments, part: Part, exam: &Exam, trial: &Trial, points: &Points) -> Result<Mark, Failure> {
    let limits = arguments.limits();
    let name = part.name();
    let numbers = [trial.seed.to_string(), trial.cases.to_string()];
    let command = ["examine", &name, exam.law, "--seed", &numbers[0], "--cases", &numbers[1]];
    let start = Instant::now();
    let ended = grade::run(&limited(&command, limits), limits)?;
    let time = start.elapsed();
    let answer = ended.map_or_else(Answer::Died, |value| {
        let strange = || Answer::Died(Reason::Other("its answer is not one".to_owned()));
        Answer::read(&value).unwrap_or_else(strange)
    });
    Ok(Mark { part, law: exam.law, usually: exam.usually, answer, most: points.of(part, exam.law), time })
}

/// The time against the reference's, what it is worth, and what it could be.
fn speed(arguments: &GradeArguments, points: &Points) -> Result<(Result<Speed, Reason>, f64, f64), Failure> {
    let limits = arguments.limits();
    let ended = grade::run(&limited(&["examine-speed", &arguments.scene], limits), limits)?;
    let strange = || Reason::Other("its answer is no time".to_owned());
    let speed = ended.and_then(|value| Speed::read(&value).ok_or_else(strange));
    let reached = speed.as_ref().map_or(0.0, |speed| points.speed.of(speed));
    Ok((speed, reached, points.speed.points))
}

/// A command with the limits that it is to keep.
fn limited(command: &[&str], limits: Limits) -> Vec<String> {
    let mut arguments: Vec<String> = command.iter().map(|&word| word.to_owned()).collect();
    for (name, value) in
        [("--memory-limit", limits.memory.to_string()), ("--time-limit", limits.time.as_secs_f64().to_string())]
    {
        arguments.extend([name.to_owned(), value]);
    }
    arguments
}
