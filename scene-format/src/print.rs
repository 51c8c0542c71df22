//! Writes a scene as `.sc` text.

mod light;
mod object;
mod shader;
mod unrendered;
mod words;

use crate::format;
use crate::lexer::is_number;
use crate::scene_file::{Bucket, Camera, CameraPlacement, Image, Lens, TraceDepths, View};
use crate::scene_file::{SceneFile, Statement};
use words::{Writer, color, floats, kept, number, quote};

/// The text of a scene, in the style of [`format()`]. Reading it gives the same scene again, every bit of every number included.
///
/// An include is written as its statement alone. What the format cannot say is written as near to it as can be: it has no
/// way to write a `"` or a line break within a word, nor the words `{` and `}` as names, nor numbers that are not finite.
pub fn print(scene: &SceneFile) -> String {
    let mut writer = Writer::default();
    for statement in &scene.statements {
        write_statement(&mut writer, &statement.value);
    }
    let text = writer.into_text();
    // A scene that a program made may hold what is an error to read: it stays as it is.
    format(&text).unwrap_or(text)
}

fn write_statement(writer: &mut Writer, statement: &Statement) {
    match statement {
        Statement::Image(image) => write_image(writer, image),
        Statement::Bucket(bucket) => writer.line(&format!("bucket {} {}", bucket.size.value, order(bucket))),
        Statement::TraceDepths(depths) => write_trace_depths(writer, depths),
        Statement::Background(background) => {
            writer.block("background", |writer| writer.line(&format!("color {}", color(background))));
        }
        Statement::Camera(camera) => write_camera(writer, camera),
        Statement::Shader(shader) => shader::write_shader(writer, shader),
        Statement::Object(object) => object::write_object(writer, object),
        Statement::Instance(instance) => object::write_instance(writer, instance),
        Statement::Light(light) => light::write_light(writer, light),
        Statement::Modifier { name, kind } => writer.block("modifier", |writer| {
            writer.line(&format!("name {}", quote(name)));
            unrendered::write_kind(writer, kind);
        }),
        Statement::Gi(kind) => writer.block("gi", |writer| unrendered::write_kind(writer, kind)),
        Statement::Photons(block) | Statement::LightServer(block) => {
            writer.block(&block.kind, |writer| unrendered::write_fields(writer, &block.fields));
        }
        Statement::Override { shader, photons } => {
            writer.line(&format!("override {} {}", quote(shader), photons.value));
        }
        Statement::Accelerator(name) => writer.line(&format!("accel {}", quote(name))),
        Statement::Filter { name, size } => {
            let size = size.map_or_else(String::new, |size| format!(" {}", floats(&*size)));
            writer.line(&format!("filter {}{size}", quote(name)));
        }
        Statement::TexturePath(directory) => writer.line(&format!("texturepath {}", quote(directory))),
        Statement::IncludePath(directory) => writer.line(&format!("includepath {}", quote(directory))),
        Statement::Include { path, .. } => writer.line(&format!("include {}", quote(path))),
        // Behind a filter without a size, a bare number would be its size.
        Statement::Unknown(unknown) if is_number(&unknown.keyword) => {
            writer.words(&format!("\"{}\"", *unknown.keyword), &unknown.words);
        }
        Statement::Unknown(unknown) => writer.words(&kept(&unknown.keyword), &unknown.words),
    }
}

fn write_image(writer: &mut Writer, image: &Image) {
    writer.block("image", |writer| {
        writer.field("resolution", image.resolution.map(|size| format!("{} {}", size[0], size[1])));
        writer.field("sampler", image.sampler.as_ref().map(|name| quote(name)));
        writer.field("aa", image.aa.map(|aa| format!("{} {}", aa[0], aa[1])));
        writer.field("samples", image.samples.map(|samples| samples.value));
        writer.field("contrast", image.contrast.map(|contrast| number(contrast.value)));
        writer.field("filter", image.filter.as_ref().map(|name| quote(name)));
        writer.field("jitter", image.jitter.map(|jitter| jitter.value));
        writer.field("show-aa", image.show_aa.map(|show| show.value));
        writer.field("cache", image.cache.map(|cache| cache.value));
        writer.field("output", image.output.as_ref().map(|name| quote(name)));
    });
}

fn order(bucket: &Bucket) -> String {
    let name = bucket.order.name();
    if bucket.reversed { format!("\"reverse {name}\"") } else { name.to_owned() }
}

fn write_trace_depths(writer: &mut Writer, depths: &TraceDepths) {
    writer.block("trace-depths", |writer| {
        writer.field("diff", depths.diffuse.map(|depth| depth.value));
        writer.field("refl", depths.reflection.map(|depth| depth.value));
        writer.field("refr", depths.refraction.map(|depth| depth.value));
    });
}

fn write_camera(writer: &mut Writer, camera: &Camera) {
    writer.block("camera", |writer| {
        writer.line(match *camera.lens {
            Lens::Pinhole(_) => "type pinhole",
            Lens::Thin { .. } => "type thinlens",
            Lens::Spherical => "type spherical",
            Lens::Fisheye => "type fisheye",
        });
        writer.field("shutter", camera.shutter.map(|times| floats(&*times)));
        write_placement(writer, &camera.placement);
        match &*camera.lens {
            Lens::Pinhole(view) => write_view(writer, view),
            Lens::Thin { view, focus_distance, radius, sides, rotation } => {
                write_view(writer, view);
                writer.field("fdist", Some(number(focus_distance.value)));
                writer.field("lensr", Some(number(radius.value)));
                writer.field("sides", sides.map(|sides| sides.value));
                writer.field("rotation", rotation.map(|rotation| number(rotation.value)));
            }
            Lens::Spherical | Lens::Fisheye => {}
        }
    });
}

fn write_placement(writer: &mut Writer, placement: &CameraPlacement) {
    match placement {
        CameraPlacement::LookAt { eye, target, up } => {
            writer.field("eye", Some(floats(&**eye)));
            writer.field("target", Some(floats(&**target)));
            writer.field("up", Some(floats(&**up)));
        }
        CameraPlacement::Transform(transform) => object::write_transform(writer, "transform", transform),
        CameraPlacement::Moving { times, steps } => {
            writer.line(&format!("steps {} times {}", steps.len(), floats(&**times)));
            for step in steps {
                match step {
                    CameraPlacement::LookAt { .. } => writer.block("", |writer| write_placement(writer, step)),
                    _ => write_placement(writer, step),
                }
            }
        }
    }
}

fn write_view(writer: &mut Writer, view: &View) {
    writer.field("fov", Some(number(view.fov.value)));
    writer.field("aspect", Some(number(view.aspect.value)));
    writer.field("shift", view.shift.map(|shift| floats(&*shift)));
}
