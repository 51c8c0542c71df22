//! Where something stands in the source: byte ranges, and their lines and columns.

use std::borrow::Cow;
use std::ops::Deref;

/// A file's number within one [`Sources`]; 0 is the scene file itself, the others are its includes.
pub type FileId = u32;

/// A range of bytes in a source file. `end` is one past the last byte.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Span {
    /// The file that the range lies in.
    pub file: FileId,
    /// The first byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The smallest range that holds both; both must lie in the same file.
    pub fn to(self, other: Self) -> Self {
        debug_assert_eq!(self.file, other.file);
        Self { file: self.file, start: self.start.min(other.start), end: self.end.max(other.end) }
    }
}

/// A value and where it was read. Two are equal when their values are: a position is no part of the scene.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spanned<T> {
    /// What was read.
    pub value: T,
    /// Where it stands.
    pub span: Span,
}

impl<T> Spanned<T> {
    /// A value at a place.
    pub fn new(value: T, span: Span) -> Self {
        Self { value, span }
    }
}

impl<T> From<T> for Spanned<T> {
    /// A value that no file holds, for scenes made by a program.
    fn from(value: T) -> Self {
        Self { value, span: Span::default() }
    }
}

impl<T> Deref for Spanned<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.value
    }
}

impl<T: PartialEq> PartialEq for Spanned<T> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

/// The text of a file that took part in a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source<'s> {
    /// The name that messages show.
    pub name: String,
    /// The whole text. That of the scene file itself is borrowed from the caller: it may be large.
    pub text: Cow<'s, str>,
    /// For an include: the place of the `include` statement that brought the file in.
    pub included_at: Option<Span>,
}

/// All files that took part in a scene, by [`FileId`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sources<'s> {
    /// File 0 is the scene file itself.
    pub files: Vec<Source<'s>>,
}

/// A place as people count it: line and column from 1, the column in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineColumn {
    /// The line, from 1.
    pub line: u32,
    /// The column in characters, from 1.
    pub column: u32,
}

impl Sources<'_> {
    /// The `include` statements that led to a file, the innermost first; none for the scene file itself.
    pub fn included_at(&self, file: FileId) -> impl Iterator<Item = Span> {
        let above = |file: FileId| self.files.get(file as usize).and_then(|source| source.included_at);
        // An include has a greater number than the file that names it, so this ends.
        std::iter::successors(above(file), move |span| above(span.file))
    }

    /// The line and column of a span's first byte.
    ///
    /// Takes time in proportion to the file: it is called for messages alone. A span of no known file is line 1, column 1.
    pub fn line_column(&self, span: Span) -> LineColumn {
        let before = self
            .files
            .get(span.file as usize)
            .and_then(|source| source.text.get(..span.start as usize))
            .unwrap_or_default();
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        LineColumn {
            line: 1 + before.bytes().filter(|&byte| byte == b'\n').count() as u32,
            column: 1 + before[line_start..].chars().count() as u32,
        }
    }
}
