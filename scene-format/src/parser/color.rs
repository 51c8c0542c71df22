use super::Parser;
use super::keywords::nearest;
use super::report::{Read, quoted};
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::Color;

const SPACES: &[&str] = &["sRGB nonlinear", "sRGB linear", "XYZ"];

impl<'s> Parser<'s> {
    /// Three numbers, or a colour space and its numbers in braces.
    pub(super) fn color(&mut self, field: Token<'s>) -> Read<Color> {
        let Some(open) = self.take("{") else {
            return Ok(Color::Bare(self.floats(field)?));
        };
        let space = self.word(field)?;
        let color = match space.text {
            "sRGB nonlinear" => Color::SrgbNonlinear(self.floats(field)?),
            "sRGB linear" => Color::SrgbLinear(self.floats(field)?),
            "sRGB" => self.unquoted_srgb(field)?,
            "XYZ" => Color::Xyz(self.floats(field)?),
            "blackbody" => {
                let _kelvin: [f32; 1] = self.floats(field)?;
                self.unrendered_space(space)
            }
            spectrum if spectrum.split_whitespace().next() == Some("spectrum") => self.spectrum(field, space)?,
            _ => return self.unknown_space(space),
        };
        self.close_group(open, "the colour")?;
        Ok(color)
    }

    /// A colour follows: not the next field.
    pub(super) fn at_color(&self) -> bool {
        self.at_number() || self.cursor.peek().is_some_and(|token| token.is_open())
    }

    /// The quotes around `sRGB linear` were forgotten: what is meant is clear all the same.
    fn unquoted_srgb(&mut self, field: Token<'s>) -> Read<Color> {
        if self.take("nonlinear").is_some() {
            Ok(Color::SrgbNonlinear(self.floats(field)?))
        } else if self.take("linear").is_some() {
            Ok(Color::SrgbLinear(self.floats(field)?))
        } else {
            self.fail_expected("the colour space is incomplete", "`nonlinear` or `linear`")
        }
    }

    /// `"spectrum MIN MAX" N v1 ... vN`
    fn spectrum(&mut self, field: Token<'s>, space: Token<'s>) -> Read<Color> {
        let count = self.count(field)?;
        for _ in 0..count {
            self.float(field)?;
        }
        Ok(self.unrendered_space(space))
    }

    fn unrendered_space(&mut self, space: Token<'_>) -> Color {
        let warning = Diagnostic::warning(space.span, format!("colours by {} are not rendered", quoted(space)))
            .label("taken as white")
            .help("write the colour as `{ \"sRGB nonlinear\" r g b }`");
        self.context.report(warning);
        Color::Bare([1.0; 3])
    }

    fn unknown_space<T>(&mut self, space: Token<'_>) -> Read<T> {
        let error = Diagnostic::error(space.span, format!("unknown colour space {}", quoted(space)));
        let known = "expected \"sRGB nonlinear\", \"sRGB linear\", XYZ, blackbody or \"spectrum MIN MAX\"";
        self.fail(match nearest(space.text, SPACES) {
            Some(meant) => error.label(known).help(format!("did you mean \"{meant}\"?")),
            None => error.label(known),
        })
    }
}
