use super::Parser;
use super::block::{Block, Field, kept, texts};
use super::keywords::{nearest, statements};
use super::report::{Read, quoted};
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::Other;

impl<'s> Parser<'s> {
    /// A statement that is read over, with a warning that says what the picture loses.
    pub(super) fn other_statement(&mut self, keyword: Token<'s>) -> Read<Other> {
        let words = match keyword.text {
            "gi" => self.ignored_block(keyword, "surfaces get light from the lights alone")?,
            "photons" => self.ignored_block(keyword, "there are no caustics")?,
            "lightserver" => self.ignored_block(keyword, "an old form of `trace-depths`, `gi` and `photons`")?,
            "modifier" => self.ignored_modifier(keyword)?,
            "override" => self.ignored_words(keyword, 2, "objects keep their own shaders")?,
            "accel" => self.ignored_words(keyword, 1, "the picture does not depend on it")?,
            "filter" => self.ignored_filter(keyword)?,
            _ => return self.unknown_statement(keyword),
        };
        Ok(Other { keyword: kept(keyword), words: texts(&words) })
    }

    /// All words of a block that is not understood.
    pub(super) fn other_fields(&mut self, block: &Block<'s>) -> Read<Vec<Token<'s>>> {
        let mut words = Vec::new();
        self.fields(block, |parser, field| parser.collect(field, &mut words))?;
        Ok(words)
    }

    /// Keeps a word, and with a brace all up to the one that closes it.
    pub(super) fn collect(&mut self, first: Token<'s>, words: &mut Vec<Token<'s>>) -> Read<Field> {
        self.keep(first, words);
        if first.is_open() {
            let inside = self.cursor.depth();
            while self.cursor.depth() >= inside && !self.cursor.at_statement() {
                let Some(word) = self.cursor.next() else { break };
                self.keep(word, words);
            }
        }
        Ok(Field::Known)
    }

    /// Keeps a word that was taken, and with `<code>` all lines up to `</code>`.
    ///
    /// Program text is not made of the format's words: a `%` in it is no comment. Each line is kept as one word.
    fn keep(&mut self, word: Token<'s>, words: &mut Vec<Token<'s>>) {
        words.push(word);
        let code = (word.text == "<code>").then(|| self.cursor.lines_until("</code>")).flatten();
        if let Some(lines) = code {
            let end = ["</code>"];
            words.extend(lines.into_iter().chain(end).map(|text| Token { text, span: word.span }));
        }
    }

    fn warn_ignored(&mut self, keyword: Token<'_>, effect: &str) {
        let warning = Diagnostic::warning(keyword.span, format!("`{}` is ignored", keyword.text)).label(effect);
        self.context.report(warning);
    }

    fn ignored_block(&mut self, keyword: Token<'s>, effect: &str) -> Read<Vec<Token<'s>>> {
        self.warn_ignored(keyword, effect);
        let block = self.open(keyword, &[])?;
        let open = Token { text: "{", span: self.cursor.previous() };
        let mut words = vec![open];
        words.append(&mut self.other_fields(&block)?);
        words.push(Token { text: "}", span: self.cursor.previous() });
        Ok(words)
    }

    fn ignored_modifier(&mut self, keyword: Token<'s>) -> Read<Vec<Token<'s>>> {
        let words = self.ignored_block(keyword, "surfaces that name it stay smooth")?;
        if let Some(name) = words.iter().skip_while(|word| word.text != "name").nth(1) {
            self.claim(&kept(*name));
        }
        Ok(words)
    }

    fn ignored_words(&mut self, keyword: Token<'s>, count: usize, effect: &str) -> Read<Vec<Token<'s>>> {
        self.warn_ignored(keyword, effect);
        (0..count).map(|_| self.word(keyword)).collect()
    }

    /// `filter NAME [SIZE SIZE]`
    fn ignored_filter(&mut self, keyword: Token<'s>) -> Read<Vec<Token<'s>>> {
        let mut words = self.ignored_words(keyword, 1, "outside the `image` block it does nothing")?;
        for _ in 0..2 {
            if self.at_number() {
                words.extend(self.cursor.next());
            }
        }
        Ok(words)
    }

    /// A word that begins no statement: skipped with its block, or up to the next statement.
    fn unknown_statement(&mut self, keyword: Token<'s>) -> Read<Other> {
        let message = format!("unknown statement {}", quoted(keyword));
        if let Some(meant) = nearest(keyword.text, &statements()) {
            let error = Diagnostic::error(keyword.span, message).label("expected a statement");
            return self.fail(error.help(format!("did you mean `{meant}`?")));
        }
        let warning = Diagnostic::warning(keyword.span, message);
        self.context.report(warning.label("skipped, with all that belongs to it"));
        let mut words = Vec::new();
        while !self.cursor.at_statement() && !self.at_other_line() {
            let Some(word) = self.cursor.peek().filter(|word| !word.is_close()) else { break };
            if word.is_open() {
                self.unknown_block(keyword, &mut words)?;
                break;
            }
            self.cursor.next();
            self.keep(word, &mut words);
        }
        Ok(Other { keyword: kept(keyword), words: texts(&words) })
    }

    /// A statement that `at_statement` does not tell, since blocks have fields of its name.
    fn at_other_line(&self) -> bool {
        self.cursor.peek().is_some_and(|word| word.text == "accel" || word.text == "filter")
    }

    /// A block of which nothing is known: it may hold blocks that look like statements, so it ends where its braces
    /// balance. Only when they do not, it ends before the next statement.
    fn unknown_block(&mut self, keyword: Token<'s>, words: &mut Vec<Token<'s>>) -> Read<()> {
        let (cursor, kept_before) = (self.cursor.clone(), words.len());
        if !self.unbalanced {
            while let Some(word) = self.cursor.next() {
                self.keep(word, words);
                if self.cursor.depth() == 0 {
                    return Ok(());
                }
            }
            // Told once for the file: a second search to its end would say the same.
            self.unbalanced = true;
            self.cursor = cursor;
            words.truncate(kept_before);
        }
        let block = self.open(keyword, &[])?;
        let inner = self.other_fields(&block)?;
        let brace = |text| Token { text, span: keyword.span };
        words.push(brace("{"));
        words.extend(inner);
        words.push(brace("}"));
        Ok(())
    }
}
