use super::object::{mesh_type, write_mesh_lines, write_triangles};
use super::unrendered;
use super::words::{Writer, color, floats, number, quote};
use crate::scene_file::{Light, MeshForm};

pub(super) fn write_light(writer: &mut Writer, light: &Light) {
    writer.block("light", |writer| match light {
        Light::Point { color: tint, power, position } => {
            writer.line("type point");
            match power {
                Some(power) => {
                    writer.field("color", Some(color(tint)));
                    writer.field("power", Some(number(power.value)));
                }
                None => writer.field("power", Some(color(tint))),
            }
            writer.field("p", Some(floats(&**position)));
        }
        Light::Mesh { name, emission, radiance, samples, mesh } => {
            let kind = if mesh.form == MeshForm::Generic { "meshlight" } else { mesh_type(mesh.form) };
            writer.field("type", Some(kind));
            writer.field("name", name.as_ref().map(|name| quote(name)));
            writer.field("emit", Some(color(emission)));
            writer.field("radiance", radiance.map(|radiance| number(radiance.value)));
            writer.field("samples", samples.map(|samples| samples.value));
            match mesh.form {
                MeshForm::Generic => write_triangles(writer, mesh),
                MeshForm::Lines | MeshForm::FlatLines => write_mesh_lines(writer, mesh),
            }
        }
        Light::Unrendered(light) => unrendered::write_typed(writer, light),
        Light::Unknown(light) => unrendered::write_unknown(writer, light),
    });
}
