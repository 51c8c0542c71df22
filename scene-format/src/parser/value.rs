use std::fmt;
use std::ops::RangeInclusive;

use super::report::Read;
use super::{Parser, Reported};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lexer::{Token, is_number};
use crate::number::{self, BadNumber, Number};
use crate::span::Spanned;

impl<'s> Parser<'s> {
    /// A word that is no brace: a name, a type.
    pub(super) fn word(&mut self, field: Token<'_>) -> Read<Token<'s>> {
        match self.cursor.peek() {
            Some(token) if !token.is_open() && !token.is_close() => {
                self.cursor.next();
                Ok(token)
            }
            _ => self.fail_expected(format!("`{}` needs a word after it", field.text), "a word"),
        }
    }

    /// A word to keep, with its place.
    pub(super) fn string(&mut self, field: Token<'_>) -> Read<Spanned<String>> {
        let token = self.word(field)?;
        Ok(Spanned::new(token.text.to_owned(), token.span))
    }

    /// What `read` reads, with its place.
    pub(super) fn placed<T>(&mut self, read: impl FnOnce(&mut Self) -> Read<T>) -> Read<Spanned<T>> {
        let start = self.cursor.here();
        let value = read(self)?;
        Ok(Spanned::new(value, start.to(self.cursor.previous())))
    }

    /// A number of any kind.
    pub(super) fn number<T: Number>(&mut self, field: Token<'_>) -> Read<T> {
        match self.cursor.peek().map(|token| T::read(token.text)) {
            Some(Ok(number)) => {
                self.cursor.next();
                Ok(number)
            }
            Some(Err(bad)) => self.bad_number(field, T::KIND, bad),
            None => self.bad_number(field, T::KIND, BadNumber::NotANumber),
        }
    }

    /// Reports that the next word is not the number that `field` needs.
    pub(super) fn bad_number<T>(&mut self, field: Token<'_>, expected: &str, bad: BadNumber) -> Read<T> {
        let found = self.found();
        let message = match bad {
            BadNumber::NotFinite => format!("{found} is not a finite number"),
            BadNumber::OutOfRange => format!("{found} is out of range for `{}`", field.text),
            BadNumber::NotANumber => format!("`{}` needs {expected}", field.text),
        };
        let error = Diagnostic::error(bad.code(), self.cursor.here(), message)
            .label(format!("expected {expected}, found {found}"));
        let error = match self.number_help(bad) {
            Some(help) => error.help(help),
            None => error,
        };
        self.fail(error)
    }

    /// What to do about a number that is none, where it can be told.
    pub(super) fn number_help(&self, bad: BadNumber) -> Option<&'static str> {
        let word = self.cursor.peek()?.text;
        match bad {
            BadNumber::NotFinite => Some("numbers go up to 3.4e38 in size"),
            BadNumber::NotANumber if word.contains(',') && word.bytes().any(|byte| byte.is_ascii_digit()) => {
                Some("numbers are separated by white space alone, and have a point, not a comma")
            }
            BadNumber::NotANumber if is_number(word) => Some("write it without a point or exponent"),
            BadNumber::NotANumber | BadNumber::OutOfRange => None,
        }
    }

    pub(super) fn float(&mut self, field: Token<'_>) -> Read<Spanned<f32>> {
        self.placed(|parser| parser.number(field))
    }

    /// So many floats.
    pub(super) fn floats<const N: usize>(&mut self, field: Token<'_>) -> Read<Spanned<[f32; N]>> {
        self.placed(|parser| {
            let mut numbers = [0.0; N];
            for number in &mut numbers {
                *number = parser.number(field)?;
            }
            Ok(numbers)
        })
    }

    /// A float that must fulfil a condition, which `condition` words: "greater than 0".
    pub(super) fn float_that(
        &mut self,
        field: Token<'_>,
        condition: &str,
        holds: impl Fn(f32) -> bool,
    ) -> Read<Spanned<f32>> {
        let found = self.found();
        let number = self.float(field)?;
        if holds(number.value) {
            return Ok(number);
        }
        let message = format!("`{}` must be {condition}", field.text);
        self.fail(Diagnostic::error(Code::OutOfRange, number.span, message).label(format!("found {found}")))
    }

    /// A whole number within a range.
    pub(super) fn integer(&mut self, field: Token<'_>, range: RangeInclusive<i64>) -> Read<i64> {
        let expected = if range.contains(&-1) { "a whole number" } else { "a whole number from 0 on" };
        let found = self.found();
        let Some(token) = self.cursor.peek() else {
            return self.bad_number(field, expected, BadNumber::NotANumber);
        };
        let number = match number::integer(token.text) {
            Ok(number) => number,
            Err(bad) => return self.bad_number(field, expected, bad),
        };
        self.cursor.next();
        if range.contains(&number) {
            return Ok(number);
        }
        let message = format!("`{}` must be from {} to {}", field.text, range.start(), range.end());
        self.fail(Diagnostic::error(Code::OutOfRange, token.span, message).label(format!("found {found}")))
    }

    /// A count that Sunflow takes as 0 when it is negative.
    pub(super) fn count(&mut self, field: Token<'_>) -> Read<Spanned<u32>> {
        self.placed(|parser| {
            let number = parser.integer(field, i32::MIN.into()..=i32::MAX.into())?;
            Ok(u32::try_from(number).unwrap_or(0))
        })
    }

    /// `true` in any case; everything else is false, as in Sunflow, but not in silence.
    pub(super) fn boolean(&mut self, field: Token<'_>) -> Read<Spanned<bool>> {
        let token = self.word(field)?;
        let value = token.text.eq_ignore_ascii_case("true");
        if !value && !token.text.eq_ignore_ascii_case("false") {
            let message = format!("`{}` needs `true` or `false`", field.text);
            let warning = Diagnostic::warning(Code::NotAFlag, token.span, message);
            self.context.report(warning.label("read as `false`"));
        }
        Ok(Spanned::new(value, token.span))
    }

    /// Takes the next word when it is this one.
    pub(super) fn take(&mut self, word: &str) -> Option<Token<'s>> {
        let token = self.cursor.peek().filter(|token| token.text == word)?;
        self.cursor.next();
        Some(token)
    }

    /// Takes the next word, which must be this one.
    pub(super) fn expect(&mut self, word: &str, message: impl fmt::Display) -> Read<Token<'s>> {
        match self.take(word) {
            Some(token) => Ok(token),
            None => self.fail_expected(message.to_string(), &format!("`{word}`")),
        }
    }

    /// Takes the brace that closes a group of values. When it is not there, the group counts as closed all the same: what
    /// follows belongs to the block around it.
    pub(super) fn close_group(&mut self, open: Token<'_>, group: &str) -> Read<()> {
        if self.take("}").is_some() {
            return Ok(());
        }
        let label = format!("expected `}}`, found {}", self.found());
        let error = Diagnostic::error(Code::UnclosedGroup, self.cursor.here(), format!("{group} is not closed"))
            .label(label)
            .note(open.span, "opened here")
            .help("put a `}` before this");
        self.context.report(error);
        self.cursor.assume_closed();
        Err(Reported)
    }

    pub(super) fn at_number(&self) -> bool {
        self.cursor.peek().is_some_and(|token| is_number(token.text))
    }
}
