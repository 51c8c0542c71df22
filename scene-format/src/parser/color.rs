use super::Parser;
use super::keywords::nearest;
use super::report::{Read, quoted};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::number::float;
use crate::scene_file::Color;
use crate::span::Spanned;

const SPACES: &[&str] = &["sRGB nonlinear", "sRGB linear", "XYZ", "blackbody"];

impl<'s> Parser<'s> {
    /// Three numbers, or a colour space and its numbers in braces.
    pub(super) fn color(&mut self, field: Token<'s>) -> Read<Spanned<Color>> {
        self.placed(|parser| {
            let Some(open) = parser.take("{") else {
                return Ok(Color::Bare(parser.floats(field)?.value));
            };
            let space = parser.word(field)?;
            let words: Vec<&str> = space.text.split_whitespace().collect();
            let color = match words.join(" ").as_str() {
                "sRGB nonlinear" => Color::SrgbNonlinear(parser.floats(field)?.value),
                "sRGB linear" => Color::SrgbLinear(parser.floats(field)?.value),
                "sRGB" => parser.unquoted_srgb(field)?,
                "XYZ" => Color::Xyz(parser.floats(field)?.value),
                "blackbody" => {
                    Color::Blackbody(parser.float_that(space, "greater than 0", |kelvin| kelvin > 0.0)?.value)
                }
                _ if words.first() == Some(&"spectrum") => parser.spectrum(space, &words)?,
                _ => return parser.unknown_space(space),
            };
            parser.close_group(open, "the colour")?;
            Ok(color)
        })
    }

    /// A colour follows: not the next field.
    pub(super) fn at_color(&self) -> bool {
        self.at_number() || self.cursor.peek().is_some_and(|token| token.is_open())
    }

    /// The quotes around `sRGB linear` were forgotten: what is meant is clear all the same.
    fn unquoted_srgb(&mut self, field: Token<'s>) -> Read<Color> {
        if self.take("nonlinear").is_some() {
            Ok(Color::SrgbNonlinear(self.floats(field)?.value))
        } else if self.take("linear").is_some() {
            Ok(Color::SrgbLinear(self.floats(field)?.value))
        } else {
            self.fail_expected("the colour space is incomplete", "`nonlinear` or `linear`")
        }
    }

    /// `"spectrum MIN MAX" N v1 ... vN`; the quotes may be missing here, too.
    fn spectrum(&mut self, space: Token<'s>, words: &[&str]) -> Read<Color> {
        let range = match words {
            [_] => self.floats(space)?.value,
            [_, min, max] => match (float(min), float(max)) {
                (Ok(min), Ok(max)) => [min, max],
                (Err(bad), _) | (_, Err(bad)) => return self.bad_spectrum(space, bad.code()),
            },
            _ => return self.bad_spectrum(space, Code::UnknownColorSpace),
        };
        let values = self.number_list(space)?;
        if values.is_empty() {
            return self.bad_spectrum(space, Code::OutOfRange);
        }
        Ok(Color::Spectrum { range, values })
    }

    fn bad_spectrum<T>(&mut self, space: Token<'_>, code: Code) -> Read<T> {
        let error = Diagnostic::error(code, space.span, "a spectrum needs two wavelengths, a count and its values");
        self.fail(error.help("400 to 700 nanometres in three values: `{ \"spectrum 400 700\" 3 0.2 0.5 0.3 }`"))
    }

    fn unknown_space<T>(&mut self, space: Token<'_>) -> Read<T> {
        let message = format!("unknown colour space {}", quoted(space));
        let error = Diagnostic::error(Code::UnknownColorSpace, space.span, message);
        let known = "expected \"sRGB nonlinear\", \"sRGB linear\", XYZ, blackbody or \"spectrum MIN MAX\"";
        self.fail(match nearest(space.text, SPACES) {
            Some(meant) => error.label(known).help(format!("did you mean \"{meant}\"?")),
            None => error.label(known),
        })
    }
}
