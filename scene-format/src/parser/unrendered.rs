use super::Parser;
use super::block::{Block, Field as Found, kept};
use super::report::Read;
use crate::grammar::{FieldForm, Form, TypeForm, form_of};
use crate::lexer::Token;
use crate::scene_file::{Field, Kind, Unknown, Unrendered, Value};
use crate::span::Spanned;

/// A block of a type that is not rendered, in the making.
pub(super) enum OtherFields<'s> {
    /// A type of Sunflow's.
    Unrendered { kind: Token<'s>, form: TypeForm, fields: Vec<Field> },
    /// A type that nobody knows.
    Unknown { kind: Token<'s>, words: Vec<Spanned<String>> },
}

impl<'s> OtherFields<'s> {
    pub(super) fn new(kind: Token<'s>, types: &[TypeForm]) -> Self {
        match form_of(kind.text, types) {
            Some(form) => Self::Unrendered { kind, form, fields: Vec::new() },
            None => Self::Unknown { kind, words: Vec::new() },
        }
    }

    pub(super) fn finish(self) -> Kind {
        match self {
            Self::Unrendered { kind, fields, .. } => Kind::Unrendered(Unrendered { kind: kept(kind), fields }),
            Self::Unknown { kind, words } => Kind::Unknown(Unknown { keyword: kept(kind), words }),
        }
    }
}

impl<'s> Parser<'s> {
    /// A field of a block that is not rendered.
    pub(super) fn other_field(&mut self, other: &mut OtherFields<'s>, field: Token<'s>) -> Read<Found> {
        match other {
            OtherFields::Unrendered { form: (_, forms), fields, .. } => self.typed_field(forms, fields, field),
            OtherFields::Unknown { words, .. } => self.collect(field, words),
        }
    }

    /// All fields of a block without types.
    pub(super) fn typed_block(&mut self, keyword: Token<'s>, (_, forms): TypeForm) -> Read<Unrendered> {
        let names: Vec<&str> = forms.iter().map(|(name, _)| *name).collect();
        let block = self.open(keyword, &names, &[])?;
        let mut fields = Vec::new();
        self.fields(&block, |parser, field| parser.typed_field(forms, &mut fields, field))?;
        Ok(Unrendered { kind: kept(keyword), fields })
    }

    /// A block that has types, all of them not rendered, and perhaps a name.
    pub(super) fn block_of_kind(
        &mut self,
        block: &Block<'s>,
        types: &[TypeForm],
        effect: &str,
    ) -> Read<(Option<Spanned<String>>, Kind)> {
        let known: Vec<&str> = types.iter().map(|(name, _)| *name).collect();
        let kind = self.find_type(block, &known)?;
        let mut other = OtherFields::new(kind, types);
        if matches!(other, OtherFields::Unknown { .. }) {
            self.warn_of_unknown(block, kind, &known, effect);
        }
        let mut name = None;
        self.fields(block, |parser, field| match field.text {
            "type" => parser.word(field).map(|_| Found::Known),
            "name" if block.fields.contains(&"name") => {
                let given = parser.string(field)?;
                parser.claim(&given);
                name = Some(given);
                Ok(Found::Known)
            }
            _ => parser.other_field(&mut other, field),
        })?;
        Ok((name, other.finish()))
    }

    fn typed_field(&mut self, forms: &[FieldForm], fields: &mut Vec<Field>, field: Token<'s>) -> Read<Found> {
        let Some((_, values)) = forms.iter().find(|(name, _)| *name == field.text) else { return Ok(Found::Unknown) };
        let mut read = Vec::new();
        for form in *values {
            if matches!(form, Form::MaybeInteger | Form::MaybeNumber) && !self.at_number() {
                continue;
            }
            let start = self.cursor.here();
            let value = self.value_of(*form, field)?;
            read.push(Spanned::new(value, start.to(self.cursor.previous())));
        }
        fields.push(Field { name: kept(field), values: read });
        Ok(Found::Known)
    }

    fn value_of(&mut self, form: Form, field: Token<'s>) -> Read<Value> {
        Ok(match form {
            Form::Number | Form::MaybeNumber => Value::Number(self.number(field)?),
            Form::Integer | Form::MaybeInteger => {
                Value::Integer(self.integer(field, i32::MIN.into()..=i32::MAX.into())? as i32)
            }
            Form::Flag => Value::Flag(self.boolean(field)?.value),
            Form::Word => Value::Word(self.word(field)?.text.to_owned()),
            Form::Color => Value::Color(self.color(field)?.value),
            Form::Triple => Value::Numbers(self.floats::<3>(field)?.to_vec()),
            Form::Quadruple => Value::Numbers(self.floats::<4>(field)?.to_vec()),
            Form::List => Value::List(self.number_list(field)?),
            Form::Code => Value::Code(self.code(field)?),
        })
    }

    /// The lines after `<code>`, the word last taken, up to `</code>`.
    fn code(&mut self, field: Token<'s>) -> Read<Vec<String>> {
        match self.code_lines() {
            Some(lines) => Ok(lines.into_iter().map(|line| line.text.to_owned()).collect()),
            None => {
                let message = format!("`{}` needs a line `</code>` after it", field.text);
                self.fail_expected(message, "program text and `</code>`")
            }
        }
    }
}
