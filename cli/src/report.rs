//! What people are told, on stderr.

use std::fmt::Display;
use std::io::{IsTerminal, Write};
use std::ops::Range;

use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet};
use scene_format::{Diagnostic, Severity, Sources, Span};

/// At most so many warnings are shown before a rendering; `check` shows them all.
const WARNINGS_BEFORE_A_RENDERING: usize = 10;

/// Why a command did not do what it was asked.
#[derive(Debug)]
pub(crate) struct Failure {
    message: String,
    help: Option<String>,
}

impl Failure {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), help: None }
    }

    pub(crate) fn help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    pub(crate) fn of(what: impl Display, error: impl Display) -> Self {
        Self::new(format!("{what}: {error}"))
    }
}

/// Which diagnostics to show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Show {
    /// All of them.
    All,
    /// All errors, and the first warnings.
    BeforeRendering,
    /// Errors alone.
    Errors,
}

/// Writes a line to stderr. Nobody can be told when that fails.
pub(crate) fn line(text: impl Display) {
    let _ = writeln!(std::io::stderr(), "{text}");
}

/// Shows why a command failed.
pub(crate) fn failure(failure: &Failure) {
    let help = failure.help.as_deref().map(|help| Level::HELP.message(help));
    line(renderer().render(&[Level::ERROR.primary_title(&failure.message).elements(help)]));
}

/// Shows what there is to say about a scene.
pub(crate) fn diagnostics(diagnostics: &[Diagnostic], sources: &Sources, show: Show) {
    let is_error = |diagnostic: &&Diagnostic| diagnostic.severity == Severity::Error;
    let warnings = diagnostics.iter().filter(|diagnostic| !is_error(diagnostic));
    let shown = match show {
        Show::All => usize::MAX,
        Show::BeforeRendering => WARNINGS_BEFORE_A_RENDERING,
        Show::Errors => 0,
    };
    for diagnostic in warnings.clone().take(shown).chain(diagnostics.iter().filter(is_error)) {
        line(rendered(diagnostic, sources, &renderer()));
        line("");
    }
    let left_out = warnings.count().saturating_sub(shown);
    if show == Show::BeforeRendering && left_out > 0 {
        line(format!("... and {left_out} more warnings; `girasol check` shows them all"));
    }
}

/// "2 errors and 1 warning", for sentences.
pub(crate) fn counted(diagnostics: &[Diagnostic]) -> String {
    let count = |severity| diagnostics.iter().filter(|diagnostic| diagnostic.severity == severity).count();
    let named = |count: usize, name: &str| match count {
        0 => None,
        1 => Some(format!("1 {name}")),
        _ => Some(format!("{count} {name}s")),
    };
    let parts: Vec<_> = [named(count(Severity::Error), "error"), named(count(Severity::Warning), "warning")]
        .into_iter()
        .flatten()
        .collect();
    if parts.is_empty() { "no errors or warnings".to_owned() } else { parts.join(" and ") }
}

/// With colours on a terminal, unless the user wants none (<https://no-color.org>).
fn renderer() -> Renderer {
    let colourless = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    if std::io::stderr().is_terminal() && !colourless { Renderer::styled() } else { Renderer::plain() }
}

fn rendered(diagnostic: &Diagnostic, sources: &Sources, renderer: &Renderer) -> String {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let mut group: Group<'_> = level.primary_title(&diagnostic.message).elements(None::<Snippet<'_, Annotation<'_>>>);
    if let Some(snippet) = snippet(sources, diagnostic.span, &diagnostic.label, AnnotationKind::Primary) {
        group = group.element(snippet);
    }
    for (span, words) in &diagnostic.notes {
        group = group.element(Level::NOTE.message(words));
        if let Some(snippet) = snippet(sources, *span, "", AnnotationKind::Context) {
            group = group.element(snippet);
        }
    }
    if let Some(help) = &diagnostic.help {
        group = group.element(Level::HELP.message(help));
    }
    renderer.render(&[group])
}

/// The lines around a place, with the place underlined: only these lines, since a scene may have a million others.
fn snippet<'a>(
    sources: &'a Sources,
    span: Span,
    label: &'a str,
    kind: AnnotationKind,
) -> Option<Snippet<'a, Annotation<'a>>> {
    let source = sources.files.get(span.file as usize)?;
    let text = &source.text;
    let lines = whole_lines(text, span.start as usize..(span.end as usize).max(span.start as usize))?;
    let underlined = span.start as usize - lines.start..(span.end as usize).min(lines.end) - lines.start;
    let mut annotation = kind.span(underlined);
    if !label.is_empty() {
        annotation = annotation.label(label);
    }
    let first_line = sources.line_column(Span { start: lines.start as u32, ..span }).line as usize;
    // A carriage return would be shown; a space keeps all places.
    let shown = text[lines].replace('\r', " ");
    Some(Snippet::source(shown).line_start(first_line).path(&*source.name).annotation(annotation))
}

/// A range grown to whole lines, at most the first three; `None` if it is no range of the text.
fn whole_lines(text: &str, range: Range<usize>) -> Option<Range<usize>> {
    let start = text.get(..range.start)?.rfind('\n').map_or(0, |newline| newline + 1);
    let mut newlines = text.get(range.start..)?.match_indices('\n').map(|(at, _)| range.start + at);
    let third = newlines.clone().nth(2).unwrap_or(text.len());
    let end = newlines.find(|&newline| newline >= range.end).unwrap_or(text.len());
    Some(start..end.min(third))
}
