use std::path::{Path, PathBuf};

use glam::Vec3;
use scene_format::scene_file::{Mesh, Object, PerVertex, Shape, Statement};
use scene_format::{FileError, Limits, SceneFile, Spanned, print, read_mesh, smooth_normals};

use crate::args::{Axis, ConvertArguments};
use crate::input::read;
use crate::output::write_file;
use crate::report::{self, Failure};

pub(crate) fn run(arguments: &ConvertArguments) -> Result<(), Failure> {
    let path = &arguments.mesh;
    let name = path.display().to_string();
    let bytes = read(path).map_err(|error| match error {
        FileError::NotFound => Failure::new(format!("there is no mesh `{name}`")),
        FileError::Unreadable(reason) => Failure::of(format!("`{name}` cannot be read"), reason),
    })?;
    let mut mesh = read_mesh(&name, &bytes, &Limits::default())
        .map_err(|error| Failure::of(format!("`{name}` is no mesh that can be read"), error))?;
    if arguments.smooth && *mesh.normals == PerVertex::None {
        smooth_normals(&mut mesh);
    }
    let is_obj = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("obj"));
    let up = arguments.up.unwrap_or(if is_obj { Axis::Y } else { Axis::Z });
    let (points, triangles) = (mesh.points.len(), mesh.triangles.len());
    let Some(text) = scene_around(mesh, up) else {
        return Err(Failure::new(format!("there is no triangle in `{name}`, or they all lie in one point")));
    };
    let output = arguments.output.clone().unwrap_or_else(|| beside(path));
    write_file(&output, text.as_bytes())?;
    report::line(format!("{}: {points} points and {triangles} triangles", output.display()));
    Ok(())
}

/// The mesh's name with `.sc`, here.
fn beside(mesh: &Path) -> PathBuf {
    PathBuf::from(mesh.file_stem().unwrap_or_default()).with_extension("sc")
}

/// The text of a scene that shows a mesh; `None` if there is nothing to see.
fn scene_around(mesh: Mesh, up: Axis) -> Option<String> {
    let corners = mesh.triangles.as_flattened().iter().filter_map(|&corner| mesh.points.get(corner as usize));
    let (min, max) = corners
        .map(|point| Vec3::from(*point))
        .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), point| (min.min(point), max.max(point)));
    let (center, radius) = (min * 0.5 + max * 0.5, (max * 0.5 - min * 0.5).length());
    if !(radius > 0.0 && radius.is_finite()) {
        return None;
    }
    let (up, towards_viewer, aside) = match up {
        Axis::Y => (Vec3::Y, Vec3::Z, Vec3::X),
        Axis::Z => (Vec3::Z, Vec3::NEG_Y, Vec3::X),
    };
    // A ball of that radius fills the height of the picture: it is 40 degrees wide and 3/4 as high, so to its upper edge
    // tan = tan(20) 3/4, the angle 15.3 degrees, and 1 / sin is 3.8.
    let eye = center + (towards_viewer * 2.0 + aside + up * 0.8).normalize() * (4.0 * radius);
    let light = center + (towards_viewer * 2.0 - aside * 1.5 + up * 3.0).normalize() * (5.0 * radius);
    let floor = center + up * (min - center).dot(up);
    let [center, eye, light, floor, up] =
        [center, eye, light, floor, up].map(|Vec3 { x, y, z }| format!("{x} {y} {z}"));
    // With the linear falloff three quarters of the light arrive.
    let power = 20.0 * radius;
    let around = format!(
        "image {{
  resolution 800 600
  aa 0 1
  samples 4
}}

camera {{
  type pinhole
  eye {eye}
  target {center}
  up {up}
  fov 40
  aspect 1.3333334
}}

light {{
  type point
  color 1 1 1
  power {power}
  p {light}
}}

shader {{
  name mesh.shader
  type phong
  diff {{ \"sRGB nonlinear\" 0.8 0.75 0.65 }}
  spec 0.2 0.2 0.2 40
  samples 0
}}

shader {{
  name floor.shader
  type diffuse
  diff {{ \"sRGB nonlinear\" 0.6 0.62 0.66 }}
}}

object {{
  shader floor.shader
  type plane
  p {floor}
  n {up}
}}

"
    );
    let object = Object {
        shaders: vec![Spanned::from("mesh.shader".to_owned())],
        modifiers: Vec::new(),
        transform: None,
        noinstance: None,
        accelerator: None,
        name: Some(Spanned::from("mesh".to_owned())),
        shape: Shape::Mesh(mesh).into(),
    };
    Some(around + &print(&SceneFile { statements: vec![Statement::Object(object).into()] }))
}
