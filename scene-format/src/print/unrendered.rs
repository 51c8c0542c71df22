use super::words::{Writer, color, floats, number, quote};
use crate::scene_file::{Field, Kind, Unknown, Unrendered, Value};

pub(super) fn write_kind(writer: &mut Writer, kind: &Kind) {
    match kind {
        Kind::Unrendered(block) => write_typed(writer, block),
        Kind::Unknown(block) => write_unknown(writer, block),
    }
}

/// The type, and its fields.
pub(super) fn write_typed(writer: &mut Writer, block: &Unrendered) {
    writer.field("type", Some(quote(&block.kind)));
    write_fields(writer, &block.fields);
}

pub(super) fn write_unknown(writer: &mut Writer, block: &Unknown) {
    writer.words(&format!("type {}", quote(&block.keyword)), &block.words);
}

pub(super) fn write_fields(writer: &mut Writer, fields: &[Field]) {
    for field in fields {
        if let [value] = field.values.as_slice()
            && let Value::Code(lines) = &value.value
        {
            writer.code(&field.name, lines);
            continue;
        }
        let values = field.values.iter().map(|value| format!(" {}", text(value)));
        writer.line(&format!("{}{}", field.name.value, values.collect::<String>()));
    }
}

fn text(value: &Value) -> String {
    match value {
        Value::Number(value) => number(*value),
        Value::Integer(value) => value.to_string(),
        Value::Flag(value) => value.to_string(),
        Value::Word(word) => quote(word),
        Value::Color(value) => color(value),
        Value::Numbers(values) => floats(values),
        Value::List(values) if values.is_empty() => "0".to_owned(),
        Value::List(values) => format!("{} {}", values.len(), floats(values)),
        // It has lines of its own.
        Value::Code(_) => String::new(),
    }
}
