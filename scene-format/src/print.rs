//! Writes a scene as `.sc` text.

mod object;
mod shader;
mod words;

use crate::scene_file::{Bucket, Camera, CameraPlacement, Image, Lens, LightKind, TraceDepths};
use crate::scene_file::{SceneFile, Statement};
use words::{Writer, color, floats, number, quote};

/// The text of a scene. Reading it gives the same scene again, every bit of every number included.
///
/// An include is written as its statement alone. What the format cannot say is written as near to it as can be: it has no
/// way to write a `"` or a line break within a word, nor the words `{` and `}` as names, nor numbers that are not finite.
pub fn print(scene: &SceneFile) -> String {
    let mut writer = Writer::default();
    for statement in &scene.statements {
        write_statement(&mut writer, &statement.value);
    }
    writer.into_text()
}

fn write_statement(writer: &mut Writer, statement: &Statement) {
    match statement {
        Statement::Image(image) => write_image(writer, image),
        Statement::Bucket(bucket) => writer.line(&format!("bucket {} {}", bucket.size, order(*bucket))),
        Statement::TraceDepths(depths) => write_trace_depths(writer, *depths),
        Statement::Background(background) => {
            writer.block("background", |writer| writer.line(&format!("color {}", color(*background))));
        }
        Statement::Camera(camera) => write_camera(writer, camera),
        Statement::Shader(shader) => shader::write_shader(writer, shader),
        Statement::Object(object) => object::write_object(writer, object),
        Statement::Instance(instance) => object::write_instance(writer, instance),
        Statement::Light(light) => write_light(writer, &light.kind),
        Statement::TexturePath(directory) => writer.line(&format!("texturepath {}", quote(&directory.value))),
        Statement::IncludePath(directory) => writer.line(&format!("includepath {}", quote(&directory.value))),
        Statement::Include { path, .. } => writer.line(&format!("include {}", quote(&path.value))),
        Statement::Other(other) => writer.words(&quote(&other.keyword.value), &other.words),
    }
}

fn write_image(writer: &mut Writer, image: &Image) {
    writer.block("image", |writer| {
        writer.field("resolution", image.resolution.map(|[width, height]| format!("{width} {height}")));
        writer.field("sampler", image.sampler.as_deref().map(quote));
        writer.field("aa", image.aa.map(|[min, max]| format!("{min} {max}")));
        writer.field("samples", image.samples);
        writer.field("contrast", image.contrast.map(number));
        writer.field("filter", image.filter.as_deref().map(quote));
        writer.field("jitter", image.jitter);
    });
}

fn order(bucket: Bucket) -> String {
    let name = bucket.order.name();
    if bucket.reversed { format!("\"reverse {name}\"") } else { name.to_owned() }
}

fn write_trace_depths(writer: &mut Writer, depths: TraceDepths) {
    writer.block("trace-depths", |writer| {
        writer.field("diff", depths.diffuse);
        writer.field("refl", depths.reflection);
        writer.field("refr", depths.refraction);
    });
}

fn write_camera(writer: &mut Writer, camera: &Camera) {
    writer.block("camera", |writer| {
        writer.line(match camera.lens {
            Lens::Pinhole => "type pinhole",
            Lens::Thin { .. } => "type thinlens",
        });
        match &camera.placement {
            CameraPlacement::LookAt { eye, target, up, .. } => {
                writer.field("eye", Some(floats(eye)));
                writer.field("target", Some(floats(target)));
                writer.field("up", Some(floats(up)));
            }
            CameraPlacement::Transform(transform) => object::write_transform(writer, &transform.value),
        }
        writer.field("fov", Some(number(camera.fov.value)));
        writer.field("aspect", Some(number(camera.aspect.value)));
        writer.field("shift", camera.shift.map(|shift| floats(&shift)));
        if let Lens::Thin { focus_distance, radius, sides, rotation } = camera.lens {
            writer.field("fdist", Some(number(focus_distance)));
            writer.field("lensr", Some(number(radius)));
            writer.field("sides", sides);
            writer.field("rotation", rotation.map(number));
        }
    });
}

fn write_light(writer: &mut Writer, light: &LightKind) {
    writer.block("light", |writer| match light {
        LightKind::Point { color: tint, power, position } => {
            writer.line("type point");
            match power {
                Some(power) => {
                    writer.field("color", Some(color(*tint)));
                    writer.field("power", Some(number(*power)));
                }
                None => writer.field("power", Some(color(*tint))),
            }
            writer.field("p", Some(floats(position)));
        }
        LightKind::Other(other) => writer.words(&format!("type {}", quote(&other.keyword.value)), &other.words),
    });
}
