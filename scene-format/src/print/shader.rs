use super::unrendered;
use super::words::{Writer, color, number, quote};
use crate::scene_file::{Paint, Shader, ShaderKind};

pub(super) fn write_shader(writer: &mut Writer, shader: &Shader) {
    writer.block("shader", |writer| {
        writer.field("name", Some(quote(&shader.name)));
        write_kind(writer, &shader.kind);
    });
}

fn write_kind(writer: &mut Writer, kind: &ShaderKind) {
    match kind {
        ShaderKind::Constant(tint) => {
            writer.line("type constant");
            writer.field("color", Some(color(tint)));
        }
        ShaderKind::Diffuse(paint) => {
            writer.line("type diffuse");
            write_paint(writer, paint);
        }
        ShaderKind::Phong { diffuse, specular, exponent, samples } => {
            writer.line("type phong");
            write_paint(writer, diffuse);
            writer.field("spec", Some(format!("{} {}", color(specular), number(exponent.value))));
            writer.field("samples", samples.map(|samples| samples.value));
        }
        ShaderKind::Mirror(tint) => {
            writer.line("type mirror");
            writer.field("refl", Some(color(tint)));
        }
        ShaderKind::Glass { eta, color: tint, absorption } => {
            writer.line("type glass");
            writer.field("eta", Some(number(eta.value)));
            writer.field("color", Some(color(tint)));
            writer.field("absorption.distance", absorption.distance.map(|distance| number(distance.value)));
            writer.field("absorption.color", absorption.color.as_ref().map(|tint| color(tint)));
        }
        ShaderKind::Shiny { diffuse, reflection } => {
            writer.line("type shiny");
            write_paint(writer, diffuse);
            writer.field("refl", Some(number(reflection.value)));
        }
        ShaderKind::Unrendered(block) => unrendered::write_typed(writer, block),
        // Its paint is read from the words.
        ShaderKind::Unknown { block, .. } => unrendered::write_unknown(writer, block),
    }
}

fn write_paint(writer: &mut Writer, paint: &Paint) {
    match paint {
        Paint::Color(tint) => writer.field("diff", Some(color(tint))),
        Paint::Texture(file) => writer.field("texture", Some(quote(&file.value))),
    }
}
