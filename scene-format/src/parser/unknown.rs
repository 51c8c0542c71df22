use super::Parser;
use super::block::{Field, kept};
use super::keywords::{nearest, statements};
use super::layout::Mark;
use super::report::{Read, comment_help, quoted};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::Unknown;
use crate::span::Spanned;

/// Words that are kept.
type Words = Vec<Spanned<String>>;

impl<'s> Parser<'s> {
    /// Keeps a word of a block of which nothing is known, and with a brace all up to the one that closes it.
    pub(super) fn collect(&mut self, first: Token<'s>, words: &mut Words) -> Read<Field> {
        self.mark(first, Mark::Unknown);
        words.push(self.kept_with_code(first));
        if first.is_open() {
            let inside = self.cursor.depth();
            while self.cursor.depth() >= inside && !self.cursor.at_statement() {
                let Some(word) = self.cursor.next() else { break };
                words.push(self.kept_with_code(word));
            }
        }
        Ok(Field::Known)
    }

    /// A word that was taken, and with `<code>` all lines up to `</code>`, as one word with them.
    ///
    /// Program text is not made of the format's words: a `%` in it is no comment.
    fn kept_with_code(&mut self, word: Token<'s>) -> Spanned<String> {
        let mut word = kept(word);
        let code = (word.value == "<code>").then(|| self.code_lines()).flatten();
        if let Some(lines) = code {
            for line in lines.iter().map(|line| line.text).chain(["</code>"]) {
                word.value.push('\n');
                word.value.push_str(line);
            }
            word.span = word.span.to(self.cursor.previous());
        }
        word
    }

    /// A word that begins no statement: skipped with its block, or up to the next statement.
    pub(super) fn unknown_statement(&mut self, keyword: Token<'s>) -> Read<Unknown> {
        let message = format!("unknown statement {}", quoted(keyword));
        if let Some(meant) = nearest(keyword.text, &statements()) {
            let error = Diagnostic::error(Code::UnknownStatement, keyword.span, message).label("expected a statement");
            return self.fail(error.help(format!("did you mean `{meant}`?")));
        }
        self.mark(keyword, Mark::Unknown);
        let warning = Diagnostic::warning(Code::UnknownStatement, keyword.span, message)
            .label("skipped, with all that belongs to it");
        self.context.report(Diagnostic { help: comment_help(keyword.text).map(str::to_owned), ..warning });
        let (first, mut words) = (self.kept_with_code(keyword), Vec::new());
        while !self.cursor.at_statement() && !self.at_other_line() {
            let Some(word) = self.cursor.peek().filter(|word| !word.is_close()) else { break };
            if word.is_open() {
                self.unknown_block(keyword, &mut words)?;
                break;
            }
            self.cursor.next();
            words.push(self.kept_with_code(word));
        }
        Ok(Unknown { keyword: first, words })
    }

    /// A statement that `at_statement` does not tell, since blocks have fields of its name.
    fn at_other_line(&self) -> bool {
        self.cursor.peek().is_some_and(|word| word.text == "accel" || word.text == "filter")
    }

    /// A block of which nothing is known: it may hold blocks that look like statements, so it ends where its braces
    /// balance. Only when they do not, it ends before the next statement.
    fn unknown_block(&mut self, keyword: Token<'s>, words: &mut Words) -> Read<()> {
        let (cursor, kept_before) = (self.cursor.clone(), words.len());
        if !self.unbalanced {
            while let Some(word) = self.cursor.next() {
                words.push(self.kept_with_code(word));
                if self.cursor.depth() == 0 {
                    return Ok(());
                }
            }
            // Told once for the file: a second search to its end would say the same.
            self.unbalanced = true;
            self.cursor = cursor;
            words.truncate(kept_before);
        }
        let block = self.open(keyword, &[], &[])?;
        words.push(Spanned::new("{".to_owned(), self.cursor.previous()));
        self.fields(&block, |parser, field| parser.collect(field, words))?;
        words.push(Spanned::new("}".to_owned(), self.cursor.previous()));
        Ok(())
    }
}
