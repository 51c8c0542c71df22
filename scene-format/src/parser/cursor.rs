use super::keywords::{BLOCKS, LINES};
use crate::lexer::{Lexer, Token};
use crate::number::Number;
use crate::span::{FileId, Span};

/// Stands between two words of a source, sees the next one, and counts the braces that are open.
///
/// A copy of it can run ahead, or back.
#[derive(Clone)]
pub(super) struct Cursor<'s> {
    lexer: Lexer<'s>,
    ahead: Option<Token<'s>>,
    previous: Span,
    previous_closes: bool,
    depth: u32,
    no_more_ends: bool,
    unclosed_quotes: Vec<Span>,
}

impl<'s> Cursor<'s> {
    pub(super) fn new(source: &'s str, file: FileId) -> Self {
        let mut lexer = Lexer::new(source, file);
        let ahead = lexer.next();
        Self {
            lexer,
            ahead,
            previous: Span { file, start: 0, end: 0 },
            previous_closes: false,
            depth: 0,
            no_more_ends: false,
            unclosed_quotes: Vec::new(),
        }
    }

    /// The next word, not yet taken.
    pub(super) fn peek(&self) -> Option<Token<'s>> {
        self.ahead
    }

    /// Takes the next word.
    pub(super) fn next(&mut self) -> Option<Token<'s>> {
        /// Copies of a cursor take these with them: nobody needs more to see what is wrong.
        const MOST_QUOTES: usize = 8;
        let token = self.ahead?;
        if token.is_quote_without_end() && self.unclosed_quotes.len() < MOST_QUOTES {
            self.unclosed_quotes.push(token.span);
        }
        self.previous = token.span;
        self.previous_closes = token.is_close();
        self.depth = match token.text {
            "{" => self.depth.saturating_add(1),
            "}" => self.depth.saturating_sub(1),
            _ => self.depth,
        };
        self.ahead = self.lexer.next();
        Some(token)
    }

    /// Takes the next word unless it is a brace; whether it did.
    pub(super) fn skip_name(&mut self) -> bool {
        self.ahead.is_some_and(|token| !token.is_open() && !token.is_close()) && self.next().is_some()
    }

    /// How many braces are open before the next word.
    pub(super) fn depth(&self) -> u32 {
        self.depth
    }

    /// Goes on as if every brace had been closed.
    pub(super) fn forget_depth(&mut self) {
        self.depth = 0;
    }

    /// Goes on as if the innermost brace had been closed.
    pub(super) fn assume_closed(&mut self) {
        self.depth = self.depth.saturating_sub(1);
    }

    /// The place of the word last taken.
    pub(super) fn previous(&self) -> Span {
        self.previous
    }

    /// Whether the word last taken was a closing brace.
    pub(super) fn previous_closes(&self) -> bool {
        self.previous_closes
    }

    /// The place of the next word, or the end of the source.
    pub(super) fn here(&self) -> Span {
        self.ahead.map_or_else(|| self.lexer.end(), |token| token.span)
    }

    /// An upper bound for the words that may still come.
    pub(super) fn remaining(&self) -> usize {
        self.lexer.remaining() + self.ahead.map_or(0, |token| token.text.len())
    }

    /// The words taken so far, or the first of them, whose quote their line ended.
    pub(super) fn unclosed_quotes(&self) -> &[Span] {
        &self.unclosed_quotes
    }

    pub(super) fn unclosed_comment(&self) -> Option<Span> {
        self.lexer.unclosed_comment()
    }

    /// Whether a statement begins with the next word. No field of any block looks like one, so inside a block it means that
    /// the block's closing brace is missing.
    pub(super) fn at_statement(&self) -> bool {
        self.ahead.is_some_and(|token| {
            let opens = || self.lexer.clone().next().is_some_and(|next| next.is_open());
            LINES.contains(&token.text) || (BLOCKS.contains(&token.text) && opens())
        })
    }

    /// Takes as many numbers as there are places for, and gives how many that were: those in plain decimal form that white space
    /// alone separates. What stands before the first other word is left to [`Self::next`], whatever it is.
    ///
    /// A mesh is nothing but such numbers; cut into words one by one, they would take three times as long.
    pub(super) fn take_numbers<T: Number>(&mut self, numbers: &mut [T]) -> usize {
        let Some(first) = self.ahead else { return 0 };
        let (count, last) = self.lexer.numbers(first.span.start, numbers);
        self.go_on_behind(last);
        count
    }

    /// Takes rows of a letter and `N` numbers each, at most so many, as [`Self::take_numbers`] does.
    pub(super) fn take_rows<const N: usize, T: Number>(
        &mut self,
        letter: u8,
        most: usize,
        each: impl FnMut([T; N]),
    ) -> usize {
        let Some(first) = self.ahead else { return 0 };
        let (count, last) = self.lexer.lettered_rows(first.span.start, letter, most, each);
        self.go_on_behind(last);
        count
    }

    fn go_on_behind(&mut self, last: Option<Span>) {
        if let Some(last) = last {
            self.previous = last;
            self.previous_closes = false;
            self.ahead = self.lexer.next();
        }
    }

    /// The lines after the word last taken, up to the one that begins with the word `end`, which is taken too; `None` when
    /// there is no such line. A source is asked for one `end` only.
    pub(super) fn lines_until(&mut self, end: &str) -> Option<Vec<Token<'s>>> {
        if self.no_more_ends {
            return None;
        }
        let mut lexer = self.lexer.clone();
        lexer.seek(self.previous.end);
        lexer.line(); // what is left of this line
        let mut lines = Vec::new();
        while let Some(line) = lexer.line() {
            let indented = line.text.len() - line.text.trim_start().len();
            let behind = line.text.trim_start().strip_prefix(end);
            if behind.is_some_and(|rest| rest.is_empty() || rest.starts_with(char::is_whitespace)) {
                let start = line.span.start + indented as u32;
                self.previous = Span { start, end: start + end.len() as u32, ..line.span };
                self.previous_closes = false;
                lexer.seek(self.previous.end);
                self.ahead = lexer.next();
                self.lexer = lexer;
                return Some(lines);
            }
            lines.push(line);
        }
        // Further on there is none either: not searched again, or the time would grow by the square.
        self.no_more_ends = true;
        None
    }
}
