use glam::DVec2;
use scene_format::{
    Code, Diagnostic, Span,
    scene_file::{self, CameraPlacement},
};

use super::placement::{dvec3, invertible};
use crate::{Camera, Lens, Modules, View, Viewpoint};

/// A camera of a scene file; `None` for one of a type that is not rendered.
pub(super) fn camera(camera: &scene_file::Camera, modules: &Modules) -> Result<Option<Box<dyn Camera>>, Diagnostic> {
    let Some((seen, lens)) = lens(&camera.lens) else { return Ok(None) };
    let [x, y] = seen.shift.map_or([0.0; 2], |shift| shift.value);
    let view = View {
        place: viewpoint(&camera.placement, camera.lens.span)?,
        fov_degrees: seen.fov.value.into(),
        aspect: seen.aspect.value.into(),
        shift: DVec2::new(x.into(), y.into()),
        lens,
    };
    match (modules.camera)(&view) {
        Some(made) => Ok(Some(made)),
        None => Err(no_view(&camera.placement, camera.lens.span)),
    }
}

/// What is seen, and through what.
fn lens(lens: &scene_file::Lens) -> Option<(&scene_file::View, Option<Lens>)> {
    match lens {
        scene_file::Lens::Pinhole(view) => Some((view, None)),
        // A lens without width is a pinhole, and needs no lens samples.
        scene_file::Lens::Thin { view, radius, .. } if radius.value == 0.0 => Some((view, None)),
        scene_file::Lens::Thin { view, focus_distance, radius, sides, rotation } => {
            let lens = Lens {
                focus_distance: focus_distance.value.into(),
                radius: radius.value.into(),
                sides: sides.map_or(0, |sides| sides.value),
                rotation_degrees: rotation.map_or(0.0, |rotation| rotation.value).into(),
            };
            Some((view, Some(lens)))
        }
        scene_file::Lens::Spherical | scene_file::Lens::Fisheye => None,
    }
}

/// Where it stands; what moves stands where its first step puts it.
fn viewpoint(placement: &CameraPlacement, camera: Span) -> Result<Viewpoint, Diagnostic> {
    match placement {
        CameraPlacement::LookAt { eye, target, up } => {
            Ok(Viewpoint::LookAt { eye: dvec3(eye.value), target: dvec3(target.value), up: dvec3(up.value) })
        }
        CameraPlacement::Transform(written) => Ok(Viewpoint::Transform(invertible(Some(written))?)),
        CameraPlacement::Moving { steps, .. } => match steps.first() {
            Some(first) => viewpoint(first, camera),
            None => Err(Diagnostic::error(Code::NoView, camera, "this camera moves through no place at all")),
        },
    }
}

fn no_view(placement: &CameraPlacement, camera: Span) -> Diagnostic {
    let (span, why) = match placement {
        CameraPlacement::Moving { steps, .. } if !steps.is_empty() => return no_view(&steps[0], camera),
        CameraPlacement::LookAt { eye, target, up } if eye == target => {
            (eye.span.to(target.span).to(up.span), "`eye` and `target` are the same point")
        }
        CameraPlacement::LookAt { eye, target, up } => {
            (eye.span.to(target.span).to(up.span), "`up` is zero, or points along the view")
        }
        _ => (camera, "its transform gives none"),
    };
    Diagnostic::error(Code::NoView, span, "this camera has no direction to look in")
        .label(why)
        .help("let `target` be another point than `eye`, and `up` any direction that is up in the picture")
}
