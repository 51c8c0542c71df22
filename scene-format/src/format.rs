//! Lays a scene's text out anew. Word by word, not by way of the data: so nothing that stands in a file is lost, be it a comment
//! or a word that nobody knows.

use crate::Diagnostic;
use crate::lexer::{Lexer, Piece, Token};
use crate::parser::{Mark, marks_of};

/// The same scene in one style: a field on a line, two spaces of indentation for each block, single spaces between words, braces
/// that stand alone as Sunflow wants them, at most one empty line. Comments stay where they are; numbers and names stay as they
/// are written. To format it again changes nothing.
///
/// # Errors
/// The first error of the scene, which keeps its structure from being known. Includes are not looked at.
pub fn format(source: &str) -> Result<String, Diagnostic> {
    let marks = marks_of(source)?;
    let mut layout = Layout { source, marks: &marks, lines: String::new(), groups: Vec::new(), ..Layout::default() };
    let mut lexer = Lexer::new(source, 0);
    while let Some(piece) = lexer.piece() {
        match piece {
            Piece::Comment(comment) => layout.comment(comment),
            Piece::Word(word) => {
                if let Some(end) = layout.word(word) {
                    lexer.seek(end);
                }
            }
        }
    }
    Ok(layout.finish())
}

/// The text in the making.
#[derive(Default)]
struct Layout<'s> {
    source: &'s str,
    /// Those that are still to come.
    marks: &'s [(u32, Mark)],
    lines: String,
    /// The braces that are open, and whether a line begins within each.
    groups: Vec<Group>,
    /// Where the last piece ended.
    end: usize,
    /// The next piece begins a line whatever it is.
    line_is_full: bool,
    /// A block that stands alone was closed: an empty line sets it off from what follows.
    block_is_over: bool,
    /// Words that nobody knows stay in the lines that they are in.
    keeps_lines: bool,
}

#[derive(Clone, Copy, Default)]
struct Group {
    has_lines: bool,
}

impl<'s> Layout<'s> {
    fn comment(&mut self, comment: Token<'s>) {
        let start = comment.span.start as usize;
        if self.newlines_before(start) == 0 && !self.lines.is_empty() && !self.line_is_full {
            self.lines.push_str("  ");
        } else {
            self.new_line(start, 0);
        }
        self.lines.push_str(comment.text.trim_end());
        self.line_is_full = true;
        self.end = comment.span.end as usize;
    }

    /// Writes a word; and program text after it, whose end it gives.
    fn word(&mut self, word: Token<'s>) -> Option<u32> {
        let start = word.span.start as usize;
        let (begins, code) = self.marks_at(word.span.start, word.span.end);
        let closes = word.is_close();
        if closes {
            let group = self.groups.pop().unwrap_or_default();
            let apart = group.has_lines || begins == Some(Mark::BlockEnd);
            self.block_is_over = false;
            if apart {
                // No empty line before a brace.
                self.end = start;
                self.new_line(start, 0);
            } else {
                self.space(start);
            }
        } else {
            match begins {
                Some(Mark::Statement | Mark::Field | Mark::BlockEnd) => self.new_line(start, 0),
                Some(Mark::Row) => self.new_line(start, 1),
                // Behind a comment that ends its line, too: the next time they would be in a line of their own.
                _ if self.keeps_lines && (self.newlines_before(start) > 0 || self.line_is_full) => {
                    self.new_line(start, 0);
                }
                _ => self.space(start),
            }
        }
        self.write(word);
        self.end = word.span.end as usize;
        if word.is_open() {
            self.groups.push(Group::default());
        }
        if closes && self.groups.is_empty() {
            self.block_is_over = true;
        }
        let end = code?;
        let text = self.source.get(self.end..end as usize).unwrap_or_default();
        self.lines.push_str(text.replace("\r\n", "\n").trim_end_matches([' ', '\t']));
        self.end = end as usize;
        self.line_is_full = !self.lines.ends_with('\n');
        Some(end)
    }

    /// What begins with a word, and where the program text ends that begins behind it.
    fn marks_at(&mut self, start: u32, end: u32) -> (Option<Mark>, Option<u32>) {
        let (mut begins, mut code) = (None, None);
        // The next word may be glued to this one, and begin where it ends: only program text belongs to this one there.
        let is_here =
            |(place, mark): &&(u32, Mark)| *place < end || (*place == end && matches!(mark, Mark::Code { .. }));
        while let Some(&(place, mark)) = self.marks.first().filter(is_here) {
            self.marks = self.marks.get(1..).unwrap_or_default();
            match mark {
                Mark::Code { end } => code = Some(end),
                Mark::Unknown if place == start => self.keeps_lines = true,
                mark if place == start => {
                    self.keeps_lines = false;
                    begins = begins.or(Some(mark));
                }
                _ => {}
            }
        }
        // A word that nobody knows begins no field.
        (begins.filter(|mark| !(self.keeps_lines && *mark == Mark::Field)), code)
    }

    /// A space before the next word, or a line of its own where the last one is full.
    fn space(&mut self, start: usize) {
        if self.line_is_full {
            self.new_line(start, 1);
        } else if !self.lines.is_empty() && !self.lines.ends_with('\n') {
            self.lines.push(' ');
        }
    }

    /// Begins a line, after an empty one where the source has one.
    fn new_line(&mut self, start: usize, deeper: usize) {
        let at_opening = self.groups.last().is_some_and(|group| !group.has_lines);
        let empty = !at_opening && (self.block_is_over || self.newlines_before(start) > 1);
        if !self.lines.is_empty() {
            if !self.lines.ends_with('\n') {
                self.lines.push('\n');
            }
            if empty {
                self.lines.push('\n');
            }
        }
        if let Some(group) = self.groups.last_mut() {
            group.has_lines = true;
        }
        self.block_is_over = false;
        self.line_is_full = false;
        self.lines.extend(std::iter::repeat_n("  ", self.groups.len() + deeper));
    }

    fn newlines_before(&self, start: usize) -> usize {
        self.source.get(self.end..start).unwrap_or_default().bytes().filter(|&byte| byte == b'\n').count()
    }

    fn is_quoted(&self, word: Token<'_>) -> bool {
        self.source.as_bytes().get(word.span.start as usize) == Some(&b'"')
    }

    /// A word as it is written; a quote that its line ended gets its second mark.
    fn write(&mut self, word: Token<'_>) {
        if self.is_quoted(word) {
            self.lines.push('"');
            self.lines.push_str(word.text);
            self.lines.push('"');
        } else {
            self.lines.push_str(word.text);
        }
    }

    fn finish(mut self) -> String {
        self.lines.truncate(self.lines.trim_end().len());
        if !self.lines.is_empty() {
            self.lines.push('\n');
        }
        self.lines
    }
}
