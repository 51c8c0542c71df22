//! What holds for every scene: it survives printing and reading, and no text whatever breaks the reader.

mod diagnostics;
mod includes;
mod layout;
mod round_trip;
mod tolerance;
mod totality;

use std::fmt::Write;

use scene_format::scene_file::{Object, Shader, Statement};
use scene_format::{FileError, Files, NoFiles, Parsed, Severity, parse};

/// Files that stand in a table: path and text.
struct Table(&'static [(&'static str, &'static str)]);

impl Files for Table {
    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        let file = self.0.iter().find(|(name, _)| *name == path);
        file.map(|(_, text)| text.as_bytes().to_vec()).ok_or(FileError::NotFound)
    }
}

fn read(source: &str) -> Parsed<'_> {
    parse("scene.sc", source, &NoFiles)
}

/// The statements of a scene that must have no error.
fn statements(source: &str) -> Vec<Statement> {
    let parsed = read(source);
    let error = parsed.diagnostics.iter().find(|diagnostic| diagnostic.severity == Severity::Error);
    assert_eq!(error, None, "in {source}");
    parsed.scene.statements.into_iter().map(|statement| statement.value).collect()
}

fn shader(source: &str) -> Shader {
    match statements(source).as_slice() {
        [Statement::Shader(shader)] => shader.clone(),
        other => panic!("not one shader: {other:?}"),
    }
}

fn object(source: &str) -> Object {
    match statements(source).as_slice() {
        [Statement::Object(object)] => object.clone(),
        other => panic!("not one object: {other:?}"),
    }
}

/// All messages, one a line: `file:line:column: severity[code]: message [label] {note} (help)`.
fn messages(parsed: &Parsed<'_>) -> String {
    let mut text = String::new();
    for diagnostic in &parsed.diagnostics {
        let place = |span| {
            let at = parsed.sources.line_column(span);
            format!("{}:{}:{}", parsed.sources.files[span.file as usize].name, at.line, at.column)
        };
        write!(
            text,
            "{}: {}[{}]: {}",
            place(diagnostic.span),
            diagnostic.severity,
            diagnostic.code,
            diagnostic.message
        )
        .unwrap();
        if !diagnostic.label.is_empty() {
            write!(text, " [{}]", diagnostic.label).unwrap();
        }
        for (span, words) in &diagnostic.notes {
            write!(text, " {{{}: {words}}}", place(*span)).unwrap();
        }
        if let Some(help) = &diagnostic.help {
            write!(text, " ({help})").unwrap();
        }
        text.push('\n');
    }
    text
}
