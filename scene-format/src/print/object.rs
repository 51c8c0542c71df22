use super::words::{Writer, floats, number, quote};
use crate::scene_file::{Instance, Mesh, MeshForm, Object, PerVertex, PlaneOrientation, Shape, SphereForm};
use crate::scene_file::{Transform, TransformStep};
use crate::span::Spanned;

pub(super) fn write_object(writer: &mut Writer, object: &Object) {
    writer.block("object", |writer| {
        if object.noinstance {
            writer.line("noinstance");
        }
        write_names(writer, "shader", &object.shaders);
        write_names(writer, "modifier", &object.modifiers);
        if let Some(transform) = &object.transform {
            write_transform(writer, &transform.value);
        }
        let name = object.name.as_ref().map(|name| quote(&name.value));
        match &object.shape.value {
            Shape::Other(other) => {
                writer.field("name", name);
                writer.words(&format!("type {}", quote(&other.keyword.value)), &other.words);
            }
            shape => {
                writer.field("type", Some(kind(shape)));
                writer.field("name", name);
                write_shape(writer, shape);
            }
        }
    });
}

pub(super) fn write_instance(writer: &mut Writer, instance: &Instance) {
    writer.block("instance", |writer| {
        writer.field("name", instance.name.as_ref().map(|name| quote(&name.value)));
        writer.field("geometry", Some(quote(&instance.geometry.value)));
        if let Some(transform) = &instance.transform {
            write_transform(writer, &transform.value);
        }
        write_names(writer, "shader", &instance.shaders);
        write_names(writer, "modifier", &instance.modifiers);
    });
}

pub(super) fn write_transform(writer: &mut Writer, transform: &Transform) {
    match transform {
        Transform::Row(elements) => writer.field("transform row", Some(floats(elements))),
        Transform::Col(elements) => writer.field("transform col", Some(floats(elements))),
        Transform::Steps(steps) => writer.block("transform", |writer| {
            for step in steps {
                writer.line(&match *step {
                    TransformStep::Translate(by) => format!("translate {}", floats(&by)),
                    TransformStep::ScaleUniform(by) => format!("scaleu {}", number(by)),
                    TransformStep::Scale(by) => format!("scale {}", floats(&by)),
                    TransformStep::ScaleX(by) => format!("scalex {}", number(by)),
                    TransformStep::ScaleY(by) => format!("scaley {}", number(by)),
                    TransformStep::ScaleZ(by) => format!("scalez {}", number(by)),
                    TransformStep::RotateX(degrees) => format!("rotatex {}", number(degrees)),
                    TransformStep::RotateY(degrees) => format!("rotatey {}", number(degrees)),
                    TransformStep::RotateZ(degrees) => format!("rotatez {}", number(degrees)),
                    TransformStep::Rotate { axis, degrees } => format!("rotate {} {}", floats(&axis), number(degrees)),
                });
            }
        }),
    }
}

/// `shader a`, or `shaders 2 a b`.
fn write_names(writer: &mut Writer, field: &str, names: &[Spanned<String>]) {
    match names {
        [] => {}
        [name] => writer.field(field, Some(quote(&name.value))),
        names => {
            let quoted: Vec<String> = names.iter().map(|name| quote(&name.value)).collect();
            writer.line(&format!("{field}s {} {}", names.len(), quoted.join(" ")));
        }
    }
}

fn kind(shape: &Shape) -> &'static str {
    match shape {
        Shape::Sphere(_) => "sphere",
        Shape::Plane { .. } => "plane",
        Shape::Box | Shape::Other(_) => "box",
        Shape::Mesh(mesh) => match mesh.form {
            MeshForm::Generic => "generic-mesh",
            MeshForm::Lines => "mesh",
            MeshForm::FlatLines => "flat-mesh",
        },
    }
}

fn write_shape(writer: &mut Writer, shape: &Shape) {
    match shape {
        Shape::Sphere(SphereForm::Unit) | Shape::Box | Shape::Other(_) => {}
        Shape::Sphere(SphereForm::CenterRadius { center, radius }) => {
            writer.field("c", Some(floats(center)));
            writer.field("r", Some(number(*radius)));
        }
        Shape::Plane { point, orientation } => {
            writer.field("p", Some(floats(point)));
            match orientation {
                PlaneOrientation::Normal(normal) => writer.field("n", Some(floats(normal))),
                PlaneOrientation::Points(points) => {
                    for point in points {
                        writer.field("p", Some(floats(point)));
                    }
                }
            }
        }
        Shape::Mesh(mesh) if mesh.form == MeshForm::Generic => write_generic_mesh(writer, mesh),
        Shape::Mesh(mesh) => write_mesh_lines(writer, mesh),
    }
}

fn write_generic_mesh(writer: &mut Writer, mesh: &Mesh) {
    writer.field("points", Some(mesh.points.len()));
    for point in &mesh.points {
        writer.line(&floats(point));
    }
    writer.field("triangles", Some(mesh.triangles.len()));
    for [a, b, c] in &mesh.triangles {
        writer.line(&format!("{a} {b} {c}"));
    }
    write_per_vertex(writer, "normals", &mesh.normals);
    write_per_vertex(writer, "uvs", &mesh.uvs);
    if let Some(shaders) = &mesh.face_shaders {
        writer.line("face_shaders");
        for shader in shaders {
            writer.line(&shader.to_string());
        }
    }
}

fn write_per_vertex<const N: usize>(writer: &mut Writer, field: &str, values: &PerVertex<N>) {
    let rows = match values {
        PerVertex::None => {
            writer.line(&format!("{field} none"));
            return;
        }
        PerVertex::Vertex(rows) => {
            writer.line(&format!("{field} vertex"));
            rows.as_slice()
        }
        PerVertex::FaceVarying(corners) => {
            writer.line(&format!("{field} facevarying"));
            corners.as_flattened()
        }
    };
    for row in rows {
        writer.line(&floats(row));
    }
}

/// Both values of a point stand in its line; where the mesh has none, zeros do.
fn write_mesh_lines(writer: &mut Writer, mesh: &Mesh) {
    writer.line(&format!("{} {}", mesh.points.len(), mesh.triangles.len()));
    for (at, point) in mesh.points.iter().enumerate() {
        let (normal, uv) = (at_point(&mesh.normals, at), at_point(&mesh.uvs, at));
        writer.line(&format!("v {} {} {}", floats(point), floats(&normal), floats(&uv)));
    }
    for [a, b, c] in &mesh.triangles {
        writer.line(&format!("t {a} {b} {c}"));
    }
}

fn at_point<const N: usize>(values: &PerVertex<N>, at: usize) -> [f32; N] {
    match values {
        PerVertex::Vertex(rows) => rows.get(at).copied().unwrap_or([0.0; N]),
        PerVertex::None | PerVertex::FaceVarying(_) => [0.0; N],
    }
}
