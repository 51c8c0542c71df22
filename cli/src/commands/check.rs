mod folder;

use std::path::Path;

use render::Modules;
use scene_format::{Code, Diagnostic, Severity};

use crate::args::{CheckArguments, MessageFormat};
use crate::input::{SceneSource, has_errors};
use crate::options::RenderOptions;
use crate::output::print;
use crate::report::{self, Failure, Show};

pub(crate) fn run(arguments: &CheckArguments, modules: Modules) -> Result<(), Failure> {
    if Path::new(&arguments.scene).is_dir() {
        return folder::run(arguments, modules);
    }
    let source = SceneSource::find(&arguments.scene)?;
    let parsed = source.parse(&modules);
    let mut diagnostics = source.examine(&parsed, &RenderOptions::default(), modules).diagnostics;
    diagnostics.iter_mut().for_each(allow_fragment);
    match arguments.format {
        MessageFormat::Text => report::diagnostics(&diagnostics, &parsed.sources, Show::All),
        MessageFormat::Json => {
            let lines = diagnostics.iter().map(|diagnostic| report::json(diagnostic, &parsed.sources) + "\n");
            print(&lines.collect::<String>())?;
        }
    }
    let (label, counted) = (source.label(), report::counted(&diagnostics));
    if has_errors(&diagnostics) {
        return Err(Failure::new(format!("`{label}` cannot be rendered: {counted}")));
    }
    if arguments.strict && !diagnostics.is_empty() {
        return Err(Failure::new(format!("`{label}` has {counted}")).help("without `--strict` that is no failure"));
    }
    if arguments.format == MessageFormat::Text {
        let can = if diagnostics.iter().any(is_fragment) { "can be included" } else { "can be rendered" };
        report::line(format!("`{label}` {can}: {counted}"));
    }
    Ok(())
}

fn is_fragment(diagnostic: &Diagnostic) -> bool {
    diagnostic.code == Code::NoCamera
}

/// A file without a camera is none to be rendered, but may well be one that others include.
fn allow_fragment(diagnostic: &mut Diagnostic) {
    if is_fragment(diagnostic) {
        diagnostic.severity = Severity::Warning;
    }
}
