use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use render::{Modules, Settings};
use scene_format::Severity;

use super::{allow_fragment, is_fragment};
use crate::args::CheckArguments;
use crate::input::{Examined, SceneSource};
use crate::options::RenderOptions;
use crate::output::print;
use crate::report::Failure;
use crate::table::{Align, markdown};

/// The pictures that show whether a scene renders: nobody sees them.
const SIZE: [u32; 2] = [64, 48];

/// So many threads' stacks would hold folders in folders without end.
const DEEPEST: usize = 64;

/// One file of the folder.
struct Row {
    name: String,
    statements: usize,
    warnings: usize,
    errors: usize,
    rendered: String,
}

/// Checks every scene of a folder and of those below.
pub(super) fn run(arguments: &CheckArguments, modules: Modules) -> Result<(), Failure> {
    let folder = Path::new(&arguments.scene);
    let mut paths = Vec::new();
    scenes_below(folder, DEEPEST, &mut paths)?;
    paths.sort();
    if paths.is_empty() {
        return Err(Failure::new(format!("there is no .sc file in `{}`", folder.display())));
    }
    let rows: Vec<Row> = paths.iter().map(|path| row(folder, path, modules)).collect();
    print(&table(&rows))?;
    let failed = rows.iter().filter(|row| row.errors > 0 || (arguments.strict && row.warnings > 0)).count();
    if failed > 0 {
        return Err(Failure::new(format!("{failed} of {} scenes are not without fault", rows.len())));
    }
    Ok(())
}

fn scenes_below(folder: &Path, depth: usize, paths: &mut Vec<PathBuf>) -> Result<(), Failure> {
    let failed = |error| Failure::of(format!("`{}` cannot be read", folder.display()), error);
    for entry in fs::read_dir(folder).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        let path = entry.path();
        // Links are not followed: they may lead round in a circle.
        let is_folder = entry.file_type().map_err(failed)?.is_dir();
        if is_folder && depth > 0 {
            scenes_below(&path, depth - 1, paths)?;
        } else if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("sc")) {
            paths.push(path);
        }
    }
    Ok(())
}

fn row(folder: &Path, path: &Path, modules: Modules) -> Row {
    let name = path.strip_prefix(folder).unwrap_or(path).display().to_string();
    let source = match SceneSource::file(path) {
        Ok(source) => source,
        Err(failure) => return Row { name, statements: 0, warnings: 0, errors: 1, rendered: failure.to_string() },
    };
    let parsed = source.parse(&modules);
    let Examined { mut diagnostics, assembled } = source.examine(&parsed, &RenderOptions::default(), modules);
    let fragment = diagnostics.iter().any(is_fragment);
    diagnostics.iter_mut().for_each(allow_fragment);
    let count = |severity| diagnostics.iter().filter(|diagnostic| diagnostic.severity == severity).count();
    let first_error = diagnostics.iter().find(|diagnostic| diagnostic.severity == Severity::Error);
    let rendered = match (first_error, assembled) {
        (Some(error), _) => {
            let place = parsed.sources.line_column(error.span);
            format!("no, line {}: {}", place.line, error.message)
        }
        (None, _) if fragment => "no: it has no camera".to_owned(),
        (None, None) => "no".to_owned(),
        (None, Some(assembled)) => {
            let settings = Settings { size: SIZE, crop: None, aa: 0, samples: 1, ..assembled.settings };
            match assembled.scene.render(&settings, &|_| ControlFlow::Continue(())) {
                Some(film) if film.pixels.iter().all(|pixel| pixel.to_array().iter().all(|c| c.is_finite())) => {
                    "yes".to_owned()
                }
                _ => "no: its colours are not finite".to_owned(),
            }
        }
    };
    let statements = parsed.scene.statements.len();
    Row { name, statements, warnings: count(Severity::Warning), errors: count(Severity::Error), rendered }
}

fn table(rows: &[Row]) -> String {
    let headings = [
        ("file", Align::Left),
        ("read", Align::Left),
        ("warnings", Align::Right),
        ("errors", Align::Right),
        ("rendered", Align::Left),
    ];
    let cells: Vec<Vec<String>> = rows
        .iter()
        .map(|row| {
            let read = if row.statements > 0 { "yes" } else { "no" };
            // A bar would begin a cell.
            let cell = |text: &str| text.replace('|', "/");
            vec![
                cell(&row.name),
                read.to_owned(),
                row.warnings.to_string(),
                row.errors.to_string(),
                cell(&row.rendered),
            ]
        })
        .collect();
    let count = |holds: fn(&&Row) -> bool| rows.iter().filter(holds).count();
    format!(
        "{}\n{} files: {} read, {} without errors, {} rendered\n",
        markdown(&headings, &cells),
        rows.len(),
        count(|row| row.statements > 0),
        count(|row| row.errors == 0),
        count(|row| row.rendered == "yes")
    )
}
