use super::words::{Writer, color, number, quote};
use crate::scene_file::{Paint, Shader, ShaderKind};

pub(super) fn write_shader(writer: &mut Writer, shader: &Shader) {
    writer.block("shader", |writer| {
        writer.field("name", Some(quote(&shader.name.value)));
        write_kind(writer, &shader.kind);
    });
}

fn write_kind(writer: &mut Writer, kind: &ShaderKind) {
    match kind {
        ShaderKind::Constant(tint) => {
            writer.line("type constant");
            writer.field("color", Some(color(*tint)));
        }
        ShaderKind::Diffuse(paint) => {
            writer.line("type diffuse");
            write_paint(writer, paint);
        }
        ShaderKind::Phong { diffuse, specular, exponent, samples } => {
            writer.line("type phong");
            write_paint(writer, diffuse);
            writer.field("spec", Some(format!("{} {}", color(*specular), number(*exponent))));
            writer.field("samples", *samples);
        }
        ShaderKind::Mirror(tint) => {
            writer.line("type mirror");
            writer.field("refl", Some(color(*tint)));
        }
        ShaderKind::Glass { eta, color: tint, absorption } => {
            writer.line("type glass");
            writer.field("eta", Some(number(*eta)));
            writer.field("color", Some(color(*tint)));
            writer.field("absorption.distance", absorption.distance.map(number));
            writer.field("absorption.color", absorption.color.map(color));
        }
        ShaderKind::Shiny { diffuse, reflection } => {
            writer.line("type shiny");
            write_paint(writer, diffuse);
            writer.field("refl", Some(number(*reflection)));
        }
        // Its paint is read from the words.
        ShaderKind::Other { block, .. } => {
            writer.words(&format!("type {}", quote(&block.keyword.value)), &block.words);
        }
    }
}

fn write_paint(writer: &mut Writer, paint: &Paint) {
    match paint {
        Paint::Color(tint) => writer.field("diff", Some(color(*tint))),
        Paint::Texture(file) => writer.field("texture", Some(quote(&file.value))),
    }
}
