use std::fmt::Display;

use crate::scene_file::Color;
use crate::span::Spanned;

/// Puts lines together. Nothing is indented here: the layout is that of `format`.
#[derive(Default)]
pub(super) struct Writer {
    text: String,
}

impl Writer {
    pub(super) fn into_text(self) -> String {
        self.text
    }

    pub(super) fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// A field and its value; nothing for `None`.
    pub(super) fn field(&mut self, name: &str, value: Option<impl Display>) {
        if let Some(value) = value {
            self.line(&format!("{name} {value}"));
        }
    }

    /// A block in braces with what `content` writes.
    pub(super) fn block(&mut self, keyword: &str, content: impl FnOnce(&mut Self)) {
        self.line(&format!("{keyword}{}{{", if keyword.is_empty() { "" } else { " " }));
        content(self);
        self.line("}");
    }

    /// Words that were kept as they are, in a row.
    pub(super) fn words(&mut self, first: &str, words: &[Spanned<String>]) {
        let words = words.iter().map(|word| format!(" {}", kept(word)));
        self.line(&format!("{first}{}", words.collect::<String>()));
    }

    /// Program text after the word that begins it.
    pub(super) fn code(&mut self, begin: &str, lines: &[String]) {
        self.line(begin);
        self.raw(lines.iter().map(String::as_str));
        self.line("</code>");
    }

    /// Lines as they are.
    fn raw<'l>(&mut self, lines: impl Iterator<Item = &'l str>) {
        for line in lines {
            self.text.push_str(line);
            self.text.push('\n');
        }
    }
}

/// A word as the reader takes it for one: in quotes unless it is made of letters, digits and a few safe signs. Words of the
/// format itself stay bare.
pub(super) fn quote(word: &str) -> String {
    let safe = |character: char| character.is_ascii_alphanumeric() || "._-+:/@<>".contains(character);
    if word == "{" || word == "}" || (!word.is_empty() && word.chars().all(safe)) {
        word.to_owned()
    } else {
        // There are no escapes.
        let word: String = word.chars().map(|c| if matches!(c, '"' | '\n' | '\r') { '\'' } else { c }).collect();
        format!("\"{word}\"")
    }
}

/// A word of a block that nobody knows; program text, which is one word with line breaks, stays as it is.
pub(super) fn kept(word: &str) -> String {
    if word.starts_with("<code>\n") { word.to_owned() } else { quote(word) }
}

/// The shortest digits that give the same float again.
pub(super) fn number(number: f32) -> String {
    let size = number.abs();
    if size == 0.0 || (1e-5..1e9).contains(&size) { number.to_string() } else { format!("{number:e}") }
}

pub(super) fn floats(numbers: &[f32]) -> String {
    numbers.iter().map(|&value| number(value)).collect::<Vec<_>>().join(" ")
}

pub(super) fn color(color: &Color) -> String {
    match color {
        Color::Bare(channels) => floats(channels),
        Color::SrgbNonlinear(channels) => format!("{{ \"sRGB nonlinear\" {} }}", floats(channels)),
        Color::SrgbLinear(channels) => format!("{{ \"sRGB linear\" {} }}", floats(channels)),
        Color::Xyz(channels) => format!("{{ XYZ {} }}", floats(channels)),
        Color::Blackbody(kelvin) => format!("{{ blackbody {} }}", number(*kelvin)),
        Color::Spectrum { range, values } => {
            format!("{{ \"spectrum {}\" {} {} }}", floats(range), values.len(), floats(values))
        }
    }
}
