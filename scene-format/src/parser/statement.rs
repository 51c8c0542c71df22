use super::Parser;
use super::block::kept;
use super::report::Read;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::grammar;
use crate::lexer::Token;
use crate::scene_file::{Kind, Statement};

impl<'s> Parser<'s> {
    /// A statement that is read and not rendered, with a warning that says what the picture loses.
    pub(super) fn unrendered_statement(&mut self, keyword: Token<'s>) -> Read<Statement> {
        let effect = match keyword.text {
            "gi" => return self.global_illumination(keyword).map(Statement::Gi),
            "photons" => "there are no caustics",
            "lightserver" => "an old form of `trace-depths`, `gi` and `photons`",
            "modifier" => "surfaces that name it stay smooth",
            "override" => "objects keep their own shaders",
            "accel" => "the picture does not depend on it",
            "filter" => "outside the `image` block it does nothing",
            _ => return self.unknown_statement(keyword).map(Statement::Unknown),
        };
        self.warn_of_ignored(keyword, effect);
        Ok(match keyword.text {
            "photons" => Statement::Photons(self.typed_block(keyword, grammar::PHOTONS)?),
            "lightserver" => Statement::LightServer(self.typed_block(keyword, grammar::LIGHT_SERVER)?),
            "modifier" => {
                let block = self.open(keyword, &["name", "type"], grammar::MODIFIERS)?;
                let (name, kind) = self.block_of_kind(&block, grammar::MODIFIERS, "ignored")?;
                Statement::Modifier { name: self.require(&block, name, "name", "name <name>")?, kind }
            }
            "override" => Statement::Override { shader: self.string(keyword)?, photons: self.boolean(keyword)? },
            "accel" => Statement::Accelerator(kept(self.word(keyword)?)),
            _ => {
                let name = self.string(keyword)?;
                // A number in quotes is how a statement that nobody knows is printed.
                let is_bare = self.cursor.peek().is_some_and(|word| word.is_bare());
                let size = if is_bare && self.at_number() { Some(self.floats(keyword)?) } else { None };
                Statement::Filter { name, size }
            }
        })
    }

    fn warn_of_ignored(&mut self, keyword: Token<'_>, effect: &str) {
        let warning = Diagnostic::warning(Code::Ignored, keyword.span, format!("`{}` is ignored", keyword.text));
        self.context.report(warning.label(effect));
    }

    /// A `gi` block, whose types `none` and `null` ask for what is rendered anyway.
    fn global_illumination(&mut self, keyword: Token<'s>) -> Read<Kind> {
        let block = self.open(keyword, &["type"], grammar::GI)?;
        let (_, kind) = self.block_of_kind(&block, grammar::GI, "ignored")?;
        if !matches!(&kind, Kind::Unrendered(block) if matches!(block.kind.as_str(), "none" | "null")) {
            self.warn_of_ignored(keyword, "surfaces get light from the lights alone");
        }
        Ok(kind)
    }
}
