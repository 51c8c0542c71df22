//! What people are told, on stderr.

use std::fmt::Display;
use std::io::{IsTerminal, Write};
use std::ops::Range;

use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use scene_format::{Diagnostic, Severity, Sources, Span};

/// At most so many warnings are shown before a rendering; `check` shows them all.
const WARNINGS_BEFORE_A_RENDERING: usize = 10;

/// Lines of more bytes than this are shown in part.
const LONG: usize = 800;

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

/// A diagnostic as one JSON object, for tools: places count from 1, columns in characters.
pub(crate) fn json(diagnostic: &Diagnostic, sources: &Sources<'_>) -> String {
    let place = |span: Span| {
        let (start, end) = (sources.line_column(span), sources.line_column(Span { start: span.end, ..span }));
        serde_json::json!({
            "file": sources.files.get(span.file as usize).map(|source| &source.name),
            "line": start.line,
            "column": start.column,
            "end": { "line": end.line, "column": end.column },
        })
    };
    let mut object = serde_json::json!({
        "severity": diagnostic.severity.to_string(),
        "code": diagnostic.code.as_str(),
        "message": diagnostic.message,
        "label": diagnostic.label,
        "help": diagnostic.help,
        "notes": diagnostic.notes.iter().map(|(span, words)| {
            let mut note = place(*span);
            note["message"] = words.as_str().into();
            note
        }).collect::<Vec<_>>(),
        "included": sources.included_at(diagnostic.span.file).map(place).collect::<Vec<_>>(),
    });
    if let (serde_json::Value::Object(object), serde_json::Value::Object(mut at)) =
        (&mut object, place(diagnostic.span))
    {
        object.append(&mut at);
    }
    object.to_string()
}

impl Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
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

/// Shows something that may have gone wrong.
pub(crate) fn warning(message: &str, help: &str) {
    line(renderer().render(&[Level::WARNING.primary_title(message).element(Level::HELP.message(help))]));
}

/// Shows what there is to say about a scene.
pub(crate) fn diagnostics(diagnostics: &[Diagnostic], sources: &Sources<'_>, show: Show) {
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

/// Fails if there is a warning among what was said about a scene.
pub(crate) fn refuse_warnings(label: &str, read: &[Diagnostic], assembled: &[Diagnostic]) -> Result<(), Failure> {
    let diagnostics = [read, assembled].concat();
    if diagnostics.is_empty() {
        return Ok(());
    }
    let failure = Failure::new(format!("`{label}` has {}", counted(&diagnostics)));
    Err(failure.help("without `--strict` it would be rendered all the same"))
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

fn rendered(diagnostic: &Diagnostic, sources: &Sources<'_>, renderer: &Renderer) -> String {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let title = level.primary_title(&diagnostic.message).id(diagnostic.code.as_str());
    let mut group: Group<'_> = title.elements(None::<Snippet<'_, Annotation<'_>>>);
    group = with_snippet(group, sources, diagnostic.span, &diagnostic.label, AnnotationKind::Primary);
    for (span, words) in &diagnostic.notes {
        group = group.element(Level::NOTE.message(words));
        group = with_snippet(group, sources, *span, "", AnnotationKind::Context);
    }
    for span in sources.included_at(diagnostic.span.file) {
        let place = sources.line_column(span);
        let name = sources.files.get(span.file as usize).map_or("", |source| &source.name);
        group = group.element(Level::NOTE.message(format!("included by {name}:{}:{}", place.line, place.column)));
    }
    if let Some(help) = &diagnostic.help {
        group = group.element(Level::HELP.message(help));
    }
    renderer.render(&[group])
}

/// Adds the lines around a place, with the place underlined: only these lines, since a scene may have a million others, and of a very
/// long line only a part.
fn with_snippet<'a>(
    group: Group<'a>,
    sources: &'a Sources<'_>,
    span: Span,
    label: &'a str,
    kind: AnnotationKind,
) -> Group<'a> {
    let Some(source) = sources.files.get(span.file as usize) else { return group };
    let (start, end) = (span.start as usize, span.end.max(span.start) as usize);
    let Some(lines) = whole_lines(&source.text, start..end) else { return group };
    let shown = if lines.len() > LONG { around(&source.text, &lines, start..end) } else { lines.clone() };
    let mut annotation = kind.span(start - shown.start..end.min(shown.end) - shown.start);
    if !label.is_empty() {
        annotation = annotation.label(label);
    }
    let place = sources.line_column(Span { start: lines.start as u32, ..span });
    // A carriage return would be shown; a space keeps all places.
    let text = source.text[shown.clone()].replace('\r', " ");
    let snippet = Snippet::source(text).line_start(place.line as usize).annotation(annotation);
    if shown == lines {
        return group.element(snippet.path(&*source.name));
    }
    // The snippet cannot know at which column it begins.
    let place = sources.line_column(span);
    let origin = Origin::path(&*source.name).line(place.line as usize).char_column(place.column as usize);
    group.element(origin).element(snippet)
}

/// The part of some lines that lies around a place.
fn around(text: &str, lines: &Range<usize>, place: Range<usize>) -> Range<usize> {
    let start = text.floor_char_boundary(place.start.saturating_sub(LONG / 8).max(lines.start));
    let end = text.ceil_char_boundary(place.end.min(place.start + LONG / 2).saturating_add(LONG / 8).min(lines.end));
    start..end
}

/// A range grown to whole lines, at most the first three; `None` if it is no range of the text.
fn whole_lines(text: &str, range: Range<usize>) -> Option<Range<usize>> {
    let start = text.get(..range.start)?.rfind('\n').map_or(0, |newline| newline + 1);
    let mut newlines = text.get(range.start..)?.match_indices('\n').map(|(at, _)| range.start + at);
    let third = newlines.clone().nth(2).unwrap_or(text.len());
    let end = newlines.find(|&newline| newline >= range.end).unwrap_or(text.len());
    Some(start..end.min(third))
}
