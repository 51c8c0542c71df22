//! Cuts a source into words. Sunflow's rules decide (they are few), softened where real files need it.
//!
//! Words stand between white space; a `"` begins and ends a word that may hold spaces; `%` or `#` at the start of a word
//! drops the rest of the line; the words `/*` and `*/` enclose a comment. Sunflow knows these marks and braces as words of their own only;
//! here a brace that is glued to a word, as in `shader{` or `0.5}`, is cut off, unless the word looks like a name in braces, as
//! `{id}` or `a{b}` do, and `/*word` begins a comment that ends with the next `*/` of any kind.

use crate::number::Number;
use crate::span::{FileId, Span};

/// One word of the source: a brace, a keyword, a number, a name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Token<'s> {
    /// The word without its quotes.
    pub(crate) text: &'s str,
    /// Where it stands, quotes included.
    pub(crate) span: Span,
}

impl Token<'_> {
    pub(crate) fn is_open(&self) -> bool {
        self.text == "{"
    }

    pub(crate) fn is_close(&self) -> bool {
        self.text == "}"
    }

    /// Whether it has no quotes.
    pub(crate) fn is_bare(&self) -> bool {
        (self.span.end - self.span.start) as usize == self.text.len()
    }

    /// Whether it begins with a quote that its line ended: the place holds one mark, and not two.
    pub(crate) fn is_quote_without_end(&self) -> bool {
        (self.span.end - self.span.start) as usize == self.text.len() + 1
    }
}

/// What a source is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Piece<'s> {
    Word(Token<'s>),
    /// With the marks that begin and end it.
    Comment(Token<'s>),
}

/// The rest of a source that is still to be cut. A copy of it can run ahead.
#[derive(Clone, Debug)]
pub(crate) struct Lexer<'s> {
    source: &'s str,
    position: usize,
    file: FileId,
    unclosed_comment: Option<Span>,
}

impl<'s> Lexer<'s> {
    /// Starts at the beginning. The source must be shorter than 4 GiB.
    pub(crate) fn new(source: &'s str, file: FileId) -> Self {
        Self { source, position: 0, file, unclosed_comment: None }
    }

    /// The next word outside comments.
    pub(crate) fn next(&mut self) -> Option<Token<'s>> {
        loop {
            if let Piece::Word(word) = self.piece()? {
                return Some(word);
            }
        }
    }

    /// The next word or comment.
    pub(crate) fn piece(&mut self) -> Option<Piece<'s>> {
        self.skip_blanks();
        let start = self.position;
        match self.byte(start)? {
            b'%' | b'#' => {
                self.position = self.find(start, ends_line);
                return Some(Piece::Comment(self.token(start)));
            }
            b'"' => return Some(Piece::Word(self.quoted())),
            _ => {}
        }
        let word = self.bare();
        if !word.text.starts_with("/*") {
            return Some(Piece::Word(word));
        }
        let closed = if word.text == "/*" { self.skip_comment() } else { self.skip_glued_comment(word.span) };
        if !closed {
            self.unclosed_comment = Some(Span { end: word.span.start + 2, ..word.span });
        }
        Some(Piece::Comment(self.token(start)))
    }

    /// All from a byte up to here.
    fn token(&self, start: usize) -> Token<'s> {
        Token { text: self.text(start, self.position), span: self.span(start, self.position) }
    }

    /// Where a comment begins that nothing closes; known once the last word was read.
    pub(crate) fn unclosed_comment(&self) -> Option<Span> {
        self.unclosed_comment
    }

    /// How many bytes are left: an upper bound for the words that may still come.
    pub(crate) fn remaining(&self) -> usize {
        self.source.len().saturating_sub(self.position)
    }

    /// The empty place after the last byte.
    pub(crate) fn end(&self) -> Span {
        self.span(self.source.len(), self.source.len())
    }

    /// Goes to a byte of the source: the next word begins there or later.
    pub(crate) fn seek(&mut self, position: u32) {
        self.position = position as usize;
    }

    /// The rest of this line, uncut: for program text that stands in a scene.
    pub(crate) fn line(&mut self) -> Option<Token<'s>> {
        let rest = self.source.get(self.position..).filter(|rest| !rest.is_empty())?;
        let line = rest.split_inclusive('\n').next()?;
        let start = self.position;
        self.position += line.len();
        let text = line.trim_end_matches(['\n', '\r']);
        Some(Token { text, span: self.span(start, start + text.len()) })
    }

    /// Reads plain numbers from a byte of the source on into the places given: how many, and where the last one stands. Stops
    /// before anything else, and before a number that needs a closer look.
    pub(crate) fn numbers<T: Number>(&mut self, from: u32, numbers: &mut [T]) -> (usize, Option<Span>) {
        let (count, last) = scan_numbers(self.source.as_bytes(), from as usize, numbers);
        if let Some((_, end)) = last {
            self.position = end;
        }
        (count, last.map(|(start, end)| self.span(start, end)))
    }

    /// Reads rows of a letter and `N` plain numbers each, at most so many: how many, and where the last number stands. Stops before
    /// a row that is anything else.
    pub(crate) fn lettered_rows<const N: usize, T: Number>(
        &mut self,
        from: u32,
        letter: u8,
        most: usize,
        mut each: impl FnMut([T; N]),
    ) -> (usize, Option<Span>) {
        let bytes = self.source.as_bytes();
        let (mut at, mut last, mut count) = (from as usize, None, 0);
        while count < most {
            let start = past_blanks(bytes, at);
            if bytes.get(start) != Some(&letter) || !bytes.get(start + 1).is_some_and(is_plain_blank) {
                break;
            }
            let mut row = [T::default(); N];
            let (found, end) = scan_numbers(bytes, start + 1, &mut row);
            let Some((_, behind)) = end.filter(|_| found == N) else { break };
            each(row);
            (at, last) = (behind, end);
            count += 1;
        }
        self.position = if count > 0 { at } else { self.position };
        (count, last.map(|(start, end)| self.span(start, end)))
    }

    /// A word in quotes. It ends with its line at the latest; there are no escapes.
    fn quoted(&mut self) -> Token<'s> {
        let start = self.position;
        let end = self.find(start + 1, |byte| byte == b'"' || ends_line(byte));
        self.position = if self.byte(end) == Some(b'"') { end + 1 } else { end };
        Token { text: self.text(start + 1, end), span: self.span(start, self.position) }
    }

    fn bare(&mut self) -> Token<'s> {
        let start = self.position;
        self.position = self.bare_end(start);
        Token { text: self.text(start, self.position), span: self.span(start, self.position) }
    }

    /// The end of the bare word that begins at `start`, before a brace that is only glued to it.
    fn bare_end(&self, start: usize) -> usize {
        let brace_first = self.byte(start).is_some_and(is_brace);
        // Decided before the word's end is looked for, so that a million braces in a row do not take their square in time.
        if brace_first && self.byte(start + 1).is_none_or(is_brace) {
            return start + 1;
        }
        let mut end = start;
        while self.byte(end).is_some_and(|byte| byte != b'"') && self.blank(end) == 0 {
            end += 1;
        }
        let word = self.text(start, end);
        let braces = ['{', '}'];
        // `object{shader`, `1}object`; but `a{b}` and `{name}` are names in Sunflow, and stay so.
        let is_glued = || word.len() <= LONGEST_GLUED && !is_balanced(word);
        if brace_first {
            let rest = word.get(1..).unwrap_or_default();
            let cut = !rest.contains(braces) || is_number(rest.trim_end_matches(braces)) || is_glued();
            return if cut { start + 1 } else { end };
        }
        let stem = word.trim_end_matches(braces);
        match stem.find(braces) {
            None => start + stem.len(),
            Some(first) if is_glued() => start + first,
            Some(_) => end,
        }
    }

    /// Skips to behind the `*/` that closes a comment; whether there is one.
    fn skip_comment(&mut self) -> bool {
        // Within a comment, words are cut as outside: a `*/` behind a `%` does not count.
        loop {
            self.skip_blanks();
            match self.byte(self.position) {
                None => return false,
                Some(b'%' | b'#') => self.position = self.find(self.position, ends_line),
                Some(b'"') => {
                    if self.quoted().text == "*/" {
                        return true;
                    }
                }
                Some(_) => {
                    if self.bare().text == "*/" {
                        return true;
                    }
                }
            }
        }
    }

    /// Skips to behind the next `*/` after a `/*` that is glued to a word; whether there is one.
    fn skip_glued_comment(&mut self, word: Span) -> bool {
        let inside = word.start as usize + 2;
        let length = self.source.get(inside..).and_then(|rest| rest.find("*/"));
        self.position = length.map_or(self.source.len(), |length| inside + length + 2);
        length.is_some()
    }

    fn skip_blanks(&mut self) {
        loop {
            match self.blank(self.position) {
                0 => return,
                length => self.position += length,
            }
        }
    }

    /// The length in bytes of the white space character at a byte; 0 when there is none. Byte order marks count: one stands at the
    /// beginning of each file that was put into this one.
    fn blank(&self, at: usize) -> usize {
        match self.byte(at) {
            Some(b'\t'..=b'\r' | b' ' | 0x1c..=0x1f) => 1,
            Some(0x80..) => {
                let character = self.source.get(at..).and_then(|rest| rest.chars().next());
                character.filter(|&it| it.is_whitespace() || it == '\u{feff}').map_or(0, char::len_utf8)
            }
            _ => 0,
        }
    }

    fn find(&self, from: usize, stop: impl Fn(u8) -> bool) -> usize {
        let rest = self.source.as_bytes().get(from..).unwrap_or_default();
        rest.iter().position(|&byte| stop(byte)).map_or(self.source.len(), |offset| from + offset)
    }

    fn byte(&self, at: usize) -> Option<u8> {
        self.source.as_bytes().get(at).copied()
    }

    fn text(&self, start: usize, end: usize) -> &'s str {
        self.source.get(start..end).unwrap_or_default()
    }

    fn span(&self, start: usize, end: usize) -> Span {
        Span { file: self.file, start: start as u32, end: end as u32 }
    }
}

/// Whether a word can only be meant as a number. `inf` and `nan` are names as well, and do not count.
pub(crate) fn is_number(word: &str) -> bool {
    word.bytes().any(|byte| byte.is_ascii_digit()) && crate::number::float(word).is_ok()
}

/// Plain numbers from a byte on, as many as there are places for: how many, and where the last one begins and ends.
fn scan_numbers<T: Number>(bytes: &[u8], from: usize, numbers: &mut [T]) -> (usize, Option<(usize, usize)>) {
    let (mut at, mut last, mut count) = (from, None, 0);
    for place in numbers {
        let start = past_blanks(bytes, at);
        let Some((number, end)) = T::scan(bytes, start) else { break };
        if !bytes.get(end).is_none_or(is_plain_blank) {
            break;
        }
        *place = number;
        (at, last) = (end, Some((start, end)));
        count += 1;
    }
    (count, last)
}

fn past_blanks(bytes: &[u8], mut at: usize) -> usize {
    while bytes.get(at).is_some_and(is_plain_blank) {
        at += 1;
    }
    at
}

fn is_plain_blank(byte: &u8) -> bool {
    matches!(byte, b' ' | b'\n' | b'\t' | b'\r')
}

/// Words of more bytes are not cut at a brace in their middle: each piece takes a look at all that is left of the word, so a million
/// of them would take their square in time.
const LONGEST_GLUED: usize = 80;

/// Whether every brace of a word has another that answers to it.
fn is_balanced(word: &str) -> bool {
    let open = word.bytes().try_fold(0usize, |open, byte| match byte {
        b'{' => Some(open + 1),
        b'}' => open.checked_sub(1),
        _ => Some(open),
    });
    open == Some(0)
}

fn is_brace(byte: u8) -> bool {
    byte == b'{' || byte == b'}'
}

fn ends_line(byte: u8) -> bool {
    byte == b'\n' || byte == b'\r'
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(source: &str) -> Vec<&str> {
        let mut lexer = Lexer::new(source, 0);
        std::iter::from_fn(|| lexer.next()).map(|token| token.text).collect()
    }

    #[test]
    fn words_stand_between_white_space_of_any_kind() {
        assert_eq!(words("a b\tc\r\nd\u{b}e\u{3000}f"), ["a", "b", "c", "d", "e", "f"]);
    }

    #[test]
    fn a_comment_begins_only_at_the_start_of_a_word() {
        assert_eq!(words("a % b\nc#d # e\n%%f\ng"), ["a", "c#d", "g"]);
    }

    #[test]
    fn a_block_comment_ends_with_a_word_of_its_own() {
        assert_eq!(words("a /* b\nc*/ d */ e"), ["a", "e"]);
    }

    #[test]
    fn a_comment_that_is_glued_to_words_ends_with_any_mark() {
        assert_eq!(words("a /*camera {\n}*/ b /*c*/ d /*/ e */ f g/*h"), ["a", "b", "d", "f", "g/*h"]);
    }

    #[test]
    fn a_comment_end_behind_a_line_comment_does_not_count() {
        assert_eq!(words("a /* % */ b\n */ c"), ["a", "c"]);
    }

    #[test]
    fn a_comment_that_nothing_closes_takes_the_rest_and_is_told() {
        let mut lexer = Lexer::new("a /* b", 0);
        assert_eq!(lexer.next().map(|token| token.text), Some("a"));
        assert_eq!(lexer.next(), None);
        assert_eq!(lexer.unclosed_comment(), Some(Span { file: 0, start: 2, end: 4 }));
    }

    #[test]
    fn quotes_keep_spaces_and_separate_words() {
        assert_eq!(words("\"a b\"c d\"e\" \"#f\" \"\" \"/*\" g"), ["a b", "c", "d", "e", "#f", "", "/*", "g"]);
    }

    #[test]
    fn a_quote_ends_with_its_line() {
        assert_eq!(words("\"a b\r\nc"), ["a b", "c"]);
    }

    #[test]
    fn braces_glued_to_words_are_cut_off() {
        assert_eq!(
            words("shader{ {\"a\" 1 2.5} {} {1} }} {x"),
            ["shader", "{", "{", "a", "1", "2.5", "}", "{", "}", "{", "1", "}", "}", "}", "{", "x"]
        );
    }

    #[test]
    fn a_name_in_braces_stays_whole() {
        assert_eq!(words("{374CF8A3-C899} a{b}"), ["{374CF8A3-C899}", "a{b}"]);
    }

    #[test]
    fn a_brace_in_the_middle_of_a_word_cuts_it_where_no_other_answers_to_it() {
        assert_eq!(words("object{shader r}light{type"), ["object", "{", "shader", "r", "}", "light", "{", "type"]);
        let long = format!("{}{{x", "a".repeat(LONGEST_GLUED));
        assert_eq!(words(&long), [long.as_str()]);
    }

    #[test]
    fn a_byte_order_mark_is_skipped_and_counted_wherever_it_stands() {
        let mut lexer = Lexer::new("\u{feff}image\n\u{feff}{", 0);
        let token = lexer.next().unwrap();
        assert_eq!((token.text, token.span), ("image", Span { file: 0, start: 3, end: 8 }));
        assert_eq!(lexer.next().map(|token| token.text), Some("{"));
    }

    #[test]
    fn a_span_holds_the_quotes() {
        let mut lexer = Lexer::new(" \"a b\" ", 7);
        assert_eq!(lexer.next().unwrap().span, Span { file: 7, start: 1, end: 6 });
    }

    #[test]
    fn a_line_is_handed_out_uncut() {
        let mut lexer = Lexer::new("x % \"y\r\nz", 0);
        let lines: Vec<&str> = std::iter::from_fn(|| lexer.line()).map(|line| line.text).collect();
        assert_eq!(lines, ["x % \"y", "z"]);
    }
}
