use super::Parser;
use crate::lexer::Token;
use crate::span::{FileId, Span};

/// What begins with a word, as far as it matters for how the text is laid out in lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    /// A statement.
    Statement,
    /// A field of a block.
    Field,
    /// A row of numbers, a name or a step on a line of its own.
    Row,
    /// The brace that closes a block.
    BlockEnd,
    /// Words that nobody knows: from here to the next mark lines stay as they are.
    Unknown,
    /// Program text, up to a byte.
    Code {
        /// Where the word `</code>` stands.
        end: u32,
    },
}

/// The marks of the scene file itself, in the order of their places in bytes.
pub(crate) type Marks = Vec<(u32, Mark)>;

/// The scene file itself.
const SCENE_FILE: FileId = 0;

impl<'s> Parser<'s> {
    /// Notes what begins with a word, when somebody wants to know.
    pub(super) fn mark(&mut self, token: Token<'_>, mark: Mark) {
        if let Some(marks) = self.context.marks.as_mut().filter(|_| token.span.file == SCENE_FILE) {
            marks.push((token.span.start, mark));
        }
    }

    /// The lines of program text behind `<code>`, the word last taken, up to `</code>`.
    pub(super) fn code_lines(&mut self) -> Option<Vec<Token<'s>>> {
        let begin = Span { start: self.cursor.previous().end, ..self.cursor.previous() };
        let lines = self.cursor.lines_until("</code>")?;
        let end = self.cursor.previous().start;
        self.mark(Token { text: "", span: begin }, Mark::Code { end });
        Some(lines)
    }

    /// Whether somebody wants to know the layout.
    pub(super) fn marks_rows(&self) -> bool {
        self.context.marks.is_some()
    }
}
