use super::{Context, Parser};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Severity};
use crate::lexer::Token;

/// What a reading function gives when there is nothing to give: the error is in the list already.
#[derive(Debug)]
pub(super) struct Reported;

/// A value, or an error that has been reported.
pub(super) type Read<T> = Result<T, Reported>;

impl Context {
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        if diagnostic.severity == Severity::Error {
            self.errors += 1;
        }
        let most = self.limits.messages;
        if self.diagnostics.len() < most {
            self.diagnostics.push(diagnostic);
        } else if self.diagnostics.len() == most {
            // An error: among what is left out there may be one.
            let message = format!("more than {most} messages: the others are left out");
            self.diagnostics.push(Diagnostic::error(Code::OverLimit, diagnostic.span, message));
        }
    }
}

impl Parser<'_> {
    /// Reports an error and gives up this value.
    pub(super) fn fail<T>(&mut self, error: Diagnostic) -> Read<T> {
        self.context.report(error);
        Err(Reported)
    }

    /// Reports that something else should stand where the next word stands.
    pub(super) fn fail_expected<T>(&mut self, message: impl Into<String>, expected: &str) -> Read<T> {
        let label = format!("expected {expected}, found {}", self.found());
        let error = Diagnostic::error(Code::Expected, self.cursor.here(), message).label(label);
        self.fail(error)
    }

    /// The next word, as messages show it.
    pub(super) fn found(&self) -> String {
        self.cursor.peek().map_or_else(|| "the end of the file".to_owned(), quoted)
    }
}

/// What to do about a word that begins a comment in other languages, and none here.
pub(super) fn comment_help(word: &str) -> Option<&'static str> {
    (word.starts_with("//") || word.starts_with(';')).then_some("a comment begins with `%` or `#`")
}

/// A word as messages show it, cut when it is long.
pub(super) fn quoted(token: Token<'_>) -> String {
    const LONGEST: usize = 40;
    match token.text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("`{}...`", token.text.get(..end).unwrap_or_default()),
        None => format!("`{}`", token.text),
    }
}
