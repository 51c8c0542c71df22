use super::keywords::nearest;
use super::layout::Mark;
use super::report::{Read, comment_help, quoted};
use super::{Parser, Reported};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::grammar::TypeForm;
use crate::lexer::{Token, is_number};
use crate::number::Number;
use crate::span::{Span, Spanned};

/// The fields, of any block, that are followed by a name.
const NAMING: &[&str] = &[
    "name",
    "shader",
    "modifier",
    "texture",
    "diff.texture",
    "spec.texture",
    "accel",
    "filename",
    "image",
    "typename",
];

/// The fields, of any block, that are followed by a count and so many names.
const LISTING: &[&str] = &["shaders", "modifiers"];

/// A statement's block in braces that is being read.
pub(super) struct Block<'s> {
    /// The statement's keyword, which messages name the block by.
    pub(super) keyword: Token<'s>,
    /// The words that begin its fields, of whatever type the block is.
    pub(super) fields: Vec<&'static str>,
    /// The keyword and the opening brace.
    pub(super) opened: Span,
    depth: u32,
    errors_before: usize,
}

/// Whether a word was the beginning of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Field {
    Known,
    Unknown,
}

impl<'s> Parser<'s> {
    /// Takes the brace that opens a statement's block. `fields` and those of all `types` are the words that may begin its fields.
    pub(super) fn open(&mut self, keyword: Token<'s>, fields: &[&'static str], types: &[TypeForm]) -> Read<Block<'s>> {
        let Some(brace) = self.take("{") else {
            let error = Diagnostic::error(
                Code::MissingBlock,
                self.cursor.here(),
                format!("`{}` needs a block after it", keyword.text),
            );
            let label = format!("expected `{{`, found {}", self.found());
            return self.fail(error.label(label));
        };
        let opened = keyword.span.to(brace.span);
        let of_types = types.iter().flat_map(|(_, fields)| fields.iter().map(|(name, _)| *name));
        let fields = fields.iter().copied().chain(of_types).collect();
        Ok(Block { keyword, fields, opened, depth: self.cursor.depth(), errors_before: self.context.errors })
    }

    /// Reads fields in whatever order they come, up to the closing brace. `read` gets each field's first word, already
    /// taken. An error in a field does not end the block, but makes the whole of it fail.
    pub(super) fn fields(
        &mut self,
        block: &Block<'s>,
        mut read: impl FnMut(&mut Self, Token<'s>) -> Read<Field>,
    ) -> Read<()> {
        let mut seen: Vec<Token<'_>> = Vec::new();
        loop {
            let Some(token) = self.cursor.peek().filter(|_| !self.cursor.at_statement()) else {
                return self.unclosed(block);
            };
            self.cursor.next();
            if token.is_close() {
                self.mark(token, Mark::BlockEnd);
                return if self.context.errors == block.errors_before { Ok(()) } else { Err(Reported) };
            }
            self.mark(token, Mark::Field);
            match read(self, token) {
                Ok(Field::Known) if block.fields.contains(&token.text) => {
                    self.warn_of_repetition(&seen, token);
                    seen.push(token);
                }
                Ok(Field::Known) => {}
                Ok(Field::Unknown) => self.unknown_field(block, token),
                Err(Reported) => self.skip_field(block),
            }
        }
    }

    /// A field that the block cannot do without: reports it when it is missing. `form` is how it is written.
    pub(super) fn require<T>(&mut self, block: &Block<'_>, field: Option<T>, name: &str, form: &str) -> Read<T> {
        if let Some(field) = field {
            return Ok(field);
        }
        let error = Diagnostic::error(
            Code::MissingField,
            self.cursor.previous(),
            format!("the {} has no `{name}`", block.keyword.text),
        )
        .label(format!("expected `{form}` before this"))
        .note(block.opened, "the block begins here");
        self.fail(error)
    }

    /// The word after `type`, wherever that stands in the block. It decides how the other fields are read.
    pub(super) fn find_type(&mut self, block: &Block<'_>, known: &[&str]) -> Read<Token<'s>> {
        let mut ahead = self.cursor.clone();
        while !ahead.at_statement() {
            let Some(token) = ahead.next().filter(|_| ahead.depth() >= block.depth) else { break };
            if ahead.depth() != block.depth {
                continue;
            }
            // Whatever comes is a name, be it `type`.
            if NAMING.contains(&token.text) {
                ahead.skip_name();
            } else if LISTING.contains(&token.text) {
                let count = ahead.peek().and_then(|count| u32::read(count.text).ok()).unwrap_or(0);
                // The count itself, too.
                (0..=count).take_while(|_| ahead.skip_name()).for_each(drop);
            }
            if token.text == "type" {
                match ahead.next() {
                    Some(kind) if !kind.is_open() && !kind.is_close() => return Ok(kind),
                    _ => break,
                }
            }
        }
        let error =
            Diagnostic::error(Code::MissingType, block.opened, format!("the {} has no `type`", block.keyword.text))
                .label("expected `type <type>` in this block")
                .help(format!("types that are rendered: {}", known.join(", ")));
        self.fail(error)
    }

    /// Warns that a block's type is one of Sunflow's that is not rendered; `effect` says what that does to the picture.
    pub(super) fn warn_of_unrendered(&mut self, block: &Block<'_>, kind: Token<'_>, rendered: &[&str], effect: &str) {
        let message = format!("{}s of type {} are not rendered", block.keyword.text, quoted(kind));
        let warning = Diagnostic::warning(Code::TypeNotRendered, kind.span, message).label(effect);
        self.context.report(match rendered {
            [] => warning,
            _ => warning.help(format!("types that are rendered: {}", rendered.join(", "))),
        });
    }

    /// Warns that nobody knows a block's type.
    pub(super) fn warn_of_unknown(&mut self, block: &Block<'_>, kind: Token<'_>, known: &[&str], effect: &str) {
        let help = match nearest(kind.text, known) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => format!("the types are {}", known.join(", ")),
        };
        let message = format!("unknown {} type {}", block.keyword.text, quoted(kind));
        let warning = Diagnostic::warning(Code::UnknownType, kind.span, message);
        self.context.report(warning.label(effect).help(help));
    }

    /// After an error in a statement: goes on behind it.
    pub(super) fn skip_statement(&mut self) {
        while self.cursor.depth() > 0 {
            if self.cursor.at_statement() || self.cursor.next().is_none() {
                self.cursor.forget_depth();
                return;
            }
        }
        // A block that was closed is over; a statement without braces goes on up to the next one.
        while !self.at_block_end() && !self.cursor.at_statement() && self.cursor.peek().is_some() {
            self.cursor.next();
        }
    }

    fn at_block_end(&self) -> bool {
        self.cursor.depth() == 0 && self.cursor.previous_closes()
    }

    /// After an error in a field: goes on at the next one.
    fn skip_field(&mut self, block: &Block<'_>) {
        while let Some(token) = self.cursor.peek() {
            let at_field = token.is_close() || block.fields.contains(&token.text);
            if self.cursor.at_statement() || (self.cursor.depth() == block.depth && at_field) {
                return;
            }
            self.cursor.next();
        }
    }

    fn unknown_field(&mut self, block: &Block<'_>, token: Token<'_>) {
        let what = block.keyword.text;
        let diagnostic = if is_number(token.text) {
            Diagnostic::warning(
                Code::StrayNumber,
                token.span,
                format!("the number {} belongs to no field", quoted(token)),
            )
            .label("skipped")
            .help("remove it, or write the word before it that says what it is")
        } else if block.fields.contains(&token.text) {
            let message = format!("{} means nothing in a {what} of this type", quoted(token));
            Diagnostic::warning(Code::MeaninglessField, token.span, message).label("skipped")
        } else if let Some(meant) = nearest(token.text, &block.fields).or_else(|| shorter(token.text, &block.fields)) {
            Diagnostic::error(Code::UnknownWord, token.span, format!("unknown word {} in this {what}", quoted(token)))
                .label("not known here")
                .help(format!("did you mean `{meant}`?"))
        } else {
            let message = format!("unknown word {} in this {what}", quoted(token));
            let warning = Diagnostic::warning(Code::UnknownWord, token.span, message)
                .label("skipped, up to the next word that is known");
            Diagnostic { help: comment_help(token.text).map(str::to_owned), ..warning }
        };
        self.context.report(diagnostic.note(block.opened, "the block begins here"));
        self.skip_field(block);
    }

    fn warn_of_repetition(&mut self, seen: &[Token<'_>], token: Token<'_>) {
        if let Some(first) = seen.iter().find(|seen| seen.text == token.text) {
            let warning =
                Diagnostic::warning(Code::RepeatedField, token.span, format!("`{}` is given twice", token.text))
                    .label("the last one holds")
                    .note(first.span, "first given here");
            self.context.report(warning);
        }
    }

    fn unclosed<T>(&mut self, block: &Block<'_>) -> Read<T> {
        self.cursor.forget_depth();
        let error = Diagnostic::error(
            Code::UnclosedBlock,
            self.cursor.here(),
            format!("the {} has no closing brace", block.keyword.text),
        )
        .label(format!("expected `}}`, found {}", self.found()))
        .note(block.opened, "the block begins here")
        .help("put a `}` at the end of the block");
        self.fail(error)
    }
}

/// The known word that `word` spells out: `diff` for `diffuse`.
fn shorter(word: &str, known: &[&'static str]) -> Option<&'static str> {
    let spells_out = |known: &str| {
        let rest = word.strip_prefix(known).filter(|_| known.len() > 2);
        rest.is_some_and(|rest| rest.bytes().all(|byte| byte.is_ascii_lowercase()))
    };
    known.iter().copied().find(|known| spells_out(known))
}

/// A word with its place, to keep.
pub(super) fn kept(token: Token<'_>) -> Spanned<String> {
    Spanned::new(token.text.to_owned(), token.span)
}
