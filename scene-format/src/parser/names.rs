use std::collections::HashMap;

use super::Parser;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::span::{Span, Spanned};

/// The names given so far, and where. Shaders, objects, instances and modifiers share them.
#[derive(Default)]
pub(super) struct Names(HashMap<String, Span>);

impl Parser<'_> {
    /// Notes a name, and warns when it is taken.
    pub(super) fn claim(&mut self, name: &Spanned<String>) {
        if let Some(first) = self.context.names.0.get(&name.value) {
            let warning =
                Diagnostic::warning(Code::RepeatedName, name.span, format!("the name `{}` is given twice", name.value))
                    .label("left out, as Sunflow does")
                    .note(*first, "first given here")
                    .help("give each shader, object, instance and modifier a name of its own");
            self.context.report(warning);
        } else {
            self.context.names.0.insert(name.value.clone(), name.span);
        }
    }
}
