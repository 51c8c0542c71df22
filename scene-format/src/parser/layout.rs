use super::Parser;
use crate::lexer::Token;
use crate::span::FileId;

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
}

/// The marks of the scene file itself, in the order of their places in bytes.
pub(crate) type Marks = Vec<(u32, Mark)>;

/// The scene file itself.
const SCENE_FILE: FileId = 0;

impl Parser<'_> {
    /// Notes what begins with a word, when somebody wants to know.
    pub(super) fn mark(&mut self, token: Token<'_>, mark: Mark) {
        if let Some(marks) = self.context.marks.as_mut().filter(|_| token.span.file == SCENE_FILE) {
            marks.push((token.span.start, mark));
        }
    }

    /// Whether somebody wants to know the layout.
    pub(super) fn marks_rows(&self) -> bool {
        self.context.marks.is_some()
    }
}
