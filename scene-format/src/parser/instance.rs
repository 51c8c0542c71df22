use super::Parser;
use super::block::Field;
use super::object::Common;
use super::report::Read;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::Instance;

const FIELDS: &[&str] = &["name", "geometry", "transform", "shader", "shaders", "modifier", "modifiers"];

impl<'s> Parser<'s> {
    pub(super) fn instance(&mut self, keyword: Token<'s>) -> Read<Instance> {
        let block = self.open(keyword, FIELDS, &[])?;
        let mut common = Common::default();
        let mut geometry = None;
        self.fields(&block, |parser, field| {
            if field.text != "geometry" {
                return parser.common_field(&mut common, field);
            }
            geometry = Some(parser.string(field)?);
            Ok(Field::Known)
        })?;
        if common.shaders.is_empty() {
            let warning = Diagnostic::warning(Code::NoShader, keyword.span, "the instance names no shader");
            self.context.report(warning.help("write `shader <name>`: an instance does not take its geometry's"));
        }
        let geometry = self.require(&block, geometry, "geometry", "geometry <name of an object>")?;
        let Common { name, shaders, modifiers, transform } = common;
        Ok(Instance { name, geometry, transform, shaders, modifiers })
    }
}
