use super::unrendered;
use super::words::{Writer, floats, number, quote};
use crate::scene_file::{Instance, Mesh, MeshForm, Object, ParticleSource, PerVertex, PlaneOrientation, Shape};
use crate::scene_file::{SphereForm, Subdivision, Transform, TransformStep};
use crate::span::Spanned;

pub(super) fn write_object(writer: &mut Writer, object: &Object) {
    writer.block("object", |writer| {
        if object.noinstance.is_some() {
            writer.line("noinstance");
        }
        write_names(writer, "shader", &object.shaders);
        write_names(writer, "modifier", &object.modifiers);
        if let Some(transform) = &object.transform {
            write_transform(writer, "transform", transform);
        }
        writer.field("accel", object.accelerator.as_ref().map(|name| quote(name)));
        let name = object.name.as_ref().map(|name| quote(&name.value));
        match &object.shape.value {
            Shape::Unrendered(shape) => {
                writer.field("name", name);
                unrendered::write_typed(writer, shape);
            }
            Shape::Unknown(shape) => {
                writer.field("name", name);
                unrendered::write_unknown(writer, shape);
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
            write_transform(writer, "transform", transform);
        }
        write_names(writer, "shader", &instance.shaders);
        write_names(writer, "modifier", &instance.modifiers);
    });
}

/// A transform behind the word `before`, which may be empty.
pub(super) fn write_transform(writer: &mut Writer, before: &str, transform: &Transform) {
    let space = if before.is_empty() { "" } else { " " };
    match transform {
        Transform::Row(elements) => writer.line(&format!("{before}{space}row {}", floats(elements))),
        Transform::Col(elements) => writer.line(&format!("{before}{space}col {}", floats(elements))),
        Transform::Moving { times, steps } => {
            writer.line(&format!("{before}{space}steps {} times {}", steps.len(), floats(&**times)));
            for step in steps {
                write_transform(writer, "", step);
            }
        }
        Transform::Steps(steps) => writer.block(before, |writer| {
            for step in steps {
                writer.line(&match **step {
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
        Shape::Box => "box",
        Shape::Mesh(mesh) => mesh_type(mesh.form),
        Shape::FileMesh { .. } => "file-mesh",
        Shape::Bezier(_) => "bezier-mesh",
        Shape::Cylinder => "cylinder",
        Shape::Torus { .. } => "torus",
        Shape::Sphereflake { .. } => "sphereflake",
        Shape::Teapot(_) => "teapot",
        Shape::Gumbo(_) => "gumbo",
        Shape::Particles { .. } => "particles",
        // They name themselves.
        Shape::Unrendered(_) | Shape::Unknown(_) => "",
    }
}

pub(super) fn mesh_type(form: MeshForm) -> &'static str {
    match form {
        MeshForm::Generic => "generic-mesh",
        MeshForm::Lines => "mesh",
        MeshForm::FlatLines => "flat-mesh",
    }
}

fn write_shape(writer: &mut Writer, shape: &Shape) {
    match shape {
        Shape::Sphere(SphereForm::Unit) | Shape::Box | Shape::Cylinder | Shape::Unrendered(_) | Shape::Unknown(_) => {}
        Shape::Sphere(SphereForm::CenterRadius { center, radius }) => {
            writer.field("c", Some(floats(&**center)));
            writer.field("r", Some(number(radius.value)));
        }
        Shape::Plane { point, orientation } => {
            writer.field("p", Some(floats(&**point)));
            match orientation {
                PlaneOrientation::Normal(normal) => writer.field("n", Some(floats(&**normal))),
                PlaneOrientation::Points(points) => {
                    for point in points {
                        writer.field("p", Some(floats(&**point)));
                    }
                }
            }
        }
        Shape::Mesh(mesh) => write_mesh(writer, mesh),
        Shape::FileMesh { file, smooth } => {
            writer.field("filename", Some(quote(file)));
            writer.field("smooth_normals", smooth.map(|smooth| smooth.value));
        }
        Shape::Bezier(bezier) => {
            let [along_u, along_v] = bezier.size.value;
            writer.field("n", Some(format!("{along_u} {along_v}")));
            writer.field("wrap", bezier.wrap.map(|wrap| format!("{} {}", wrap[0], wrap[1])));
            writer.line("points");
            write_rows(writer, &bezier.points);
            write_subdivision(writer, &bezier.subdivision);
        }
        Shape::Torus { radii } => writer.field("r", Some(floats(&**radii))),
        Shape::Sphereflake { level, axis, radius } => {
            writer.field("level", level.map(|level| level.value));
            writer.field("axis", axis.map(|axis| floats(&*axis)));
            writer.field("radius", radius.map(|radius| number(radius.value)));
        }
        Shape::Teapot(subdivision) | Shape::Gumbo(subdivision) => write_subdivision(writer, subdivision),
        Shape::Particles { centers, count, radius } => {
            match centers {
                ParticleSource::Points(points) => {
                    writer.field("points", Some(points.len()));
                    write_rows(writer, points);
                }
                ParticleSource::File { name, little_endian } => {
                    let order = if little_endian.is_some() { " little_endian" } else { "" };
                    writer.line(&format!("filename {}{order}", quote(name)));
                }
            }
            writer.field("num", count.map(|count| count.value));
            writer.field("radius", Some(number(radius.value)));
        }
    }
}

fn write_subdivision(writer: &mut Writer, subdivision: &Subdivision) {
    writer.field("subdivs", subdivision.count.map(|count| count.value));
    writer.field("smooth", subdivision.smooth.map(|smooth| smooth.value));
}

fn write_rows<const N: usize>(writer: &mut Writer, rows: &[[f32; N]]) {
    for row in rows {
        writer.line(&floats(row));
    }
}

/// The fields of a mesh of whatever form.
fn write_mesh(writer: &mut Writer, mesh: &Mesh) {
    match mesh.form {
        MeshForm::Generic => write_generic_mesh(writer, mesh),
        MeshForm::Lines | MeshForm::FlatLines => write_mesh_lines(writer, mesh),
    }
}

fn write_generic_mesh(writer: &mut Writer, mesh: &Mesh) {
    write_triangles(writer, mesh);
    // Sunflow insists on both.
    write_per_vertex(writer, "normals", &mesh.normals);
    write_per_vertex(writer, "uvs", &mesh.uvs);
    if let Some(shaders) = &mesh.face_shaders {
        writer.line("face_shaders");
        for shader in shaders.iter() {
            writer.line(&shader.to_string());
        }
    }
}

pub(super) fn write_triangles(writer: &mut Writer, mesh: &Mesh) {
    writer.field("points", Some(mesh.points.len()));
    write_rows(writer, &mesh.points);
    writer.field("triangles", Some(mesh.triangles.len()));
    for [a, b, c] in mesh.triangles.iter() {
        writer.line(&format!("{a} {b} {c}"));
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
    write_rows(writer, rows);
}

/// Both values of a point stand in its line; where the mesh has none, zeros do.
pub(super) fn write_mesh_lines(writer: &mut Writer, mesh: &Mesh) {
    writer.line(&format!("{} {}", mesh.points.len(), mesh.triangles.len()));
    for (at, point) in mesh.points.iter().enumerate() {
        let (normal, uv) = (at_point(&mesh.normals, at), at_point(&mesh.uvs, at));
        writer.line(&format!("v {} {} {}", floats(point), floats(&normal), floats(&uv)));
    }
    for [a, b, c] in mesh.triangles.iter() {
        writer.line(&format!("t {a} {b} {c}"));
    }
}

fn at_point<const N: usize>(values: &PerVertex<N>, at: usize) -> [f32; N] {
    match values {
        PerVertex::Vertex(rows) => rows.get(at).copied().unwrap_or([0.0; N]),
        PerVertex::None | PerVertex::FaceVarying(_) => [0.0; N],
    }
}
