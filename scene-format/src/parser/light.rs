use super::Parser;
use super::block::{Field, kept, texts};
use super::report::Read;
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::{Color, Light, LightKind, Other, Triple};

const TYPES: &[&str] = &["point"];
const FIELDS: &[&str] = &["type", "color", "power", "p"];

/// What stands after `power`.
enum Power {
    Number(f32),
    /// The old form: colour times power.
    Color(Color),
}

impl<'s> Parser<'s> {
    pub(super) fn light(&mut self, keyword: Token<'s>) -> Read<Light> {
        let block = self.open(keyword, FIELDS)?;
        let kind = self.find_type(&block, TYPES)?;
        if kind.text != "point" {
            self.warn_of_type(&block, kind, TYPES, "gives no light");
            let words = texts(&self.other_fields(&block)?);
            return Ok(Light { kind: LightKind::Other(Other { keyword: kept(kind), words: without_type(words) }) });
        }
        let mut color: Option<Color> = None;
        let mut power: Option<Power> = None;
        let mut position: Option<Triple> = None;
        self.fields(&block, |parser, field| {
            match field.text {
                "type" => {
                    parser.word(field)?;
                }
                "color" => color = Some(parser.color(field)?),
                "power" => power = Some(parser.power(field)?),
                "p" => position = Some(parser.floats(field)?),
                _ => return Ok(Field::Unknown),
            }
            Ok(Field::Known)
        })?;
        let position = self.require(&block, position, "p", "p x y z");
        let power = self.require(&block, power, "power", "power <number>");
        let (color, power) = match (power?, color) {
            (Power::Color(color), None) => (color, None),
            (Power::Number(power), color) => (self.require(&block, color, "color", "color r g b")?, Some(power)),
            (Power::Color(_), Some(_)) => {
                let error = Diagnostic::error(keyword.span, "the light has two colours");
                return self.fail(error.help("after `color`, `power` is one number"));
            }
        };
        Ok(Light { kind: LightKind::Point { color, power, position: position? } })
    }

    fn power(&mut self, field: Token<'s>) -> Read<Power> {
        if self.cursor.peek().is_some_and(|token| token.is_open()) {
            return Ok(Power::Color(self.color(field)?));
        }
        let first = self.float(field)?;
        if !self.at_number() {
            return Ok(Power::Number(first));
        }
        let [green, blue] = self.floats(field)?;
        Ok(Power::Color(Color::Bare([first, green, blue])))
    }
}

/// The words of a block without `type` and the type itself.
fn without_type(mut words: Vec<String>) -> Vec<String> {
    if let Some(at) = words.iter().position(|word| word == "type") {
        words.drain(at..(at + 2).min(words.len()));
    }
    words
}
