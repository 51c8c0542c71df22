use glam::DVec2;
use scene_format::{
    Code, Diagnostic, Span,
    scene_file::{self, CameraPlacement, Lens, View},
};

use super::placement::{dvec3, invertible};
use crate::{Camera, Frame, Pinhole, ThinLens};

/// A camera of a scene file; `None` for one of a type that is not rendered.
pub(super) fn camera(camera: &scene_file::Camera) -> Result<Option<Box<dyn Camera>>, Diagnostic> {
    Ok(Some(match &*camera.lens {
        Lens::Pinhole(view) => Box::new(Pinhole { frame: seeing(camera, view)? }),
        // A lens without width is a pinhole, and needs no lens samples.
        Lens::Thin { view, radius, .. } if radius.value == 0.0 => Box::new(Pinhole { frame: seeing(camera, view)? }),
        Lens::Thin { view, focus_distance, radius, sides, rotation } => Box::new(ThinLens {
            frame: seeing(camera, view)?,
            focus_distance: focus_distance.value.into(),
            radius: radius.value.into(),
            sides: sides.map_or(0, |sides| sides.value),
            rotation_degrees: rotation.map_or(0.0, |rotation| rotation.value).into(),
        }),
        Lens::Spherical | Lens::Fisheye => return Ok(None),
    }))
}

fn seeing(camera: &scene_file::Camera, view: &View) -> Result<Frame, Diagnostic> {
    let [x, y] = view.shift.map_or([0.0; 2], |shift| shift.value);
    let placed = frame(&camera.placement, camera.lens.span)?.seeing(view.fov.value.into(), view.aspect.value.into());
    Ok(Frame { shift: DVec2::new(x.into(), y.into()), ..placed })
}

fn frame(placement: &CameraPlacement, camera: Span) -> Result<Frame, Diagnostic> {
    match placement {
        CameraPlacement::LookAt { eye, target, up } => {
            Frame::look_at(dvec3(eye.value), dvec3(target.value), dvec3(up.value)).ok_or_else(|| {
                let span = eye.span.to(target.span).to(up.span);
                let why = if eye == target {
                    "`eye` and `target` are the same point"
                } else {
                    "`up` is zero, or points along the view"
                };
                Diagnostic::error(Code::NoView, span, "this camera has no direction to look in")
                    .label(why)
                    .help("let `target` be another point than `eye`, and `up` any direction that is up in the picture")
            })
        }
        CameraPlacement::Moving { steps, .. } => match steps.first() {
            Some(first) => frame(first, camera),
            None => Err(Diagnostic::error(Code::NoView, camera, "this camera moves through no place at all")),
        },
        CameraPlacement::Transform(written) => {
            let to_world = invertible(Some(written))?;
            let axes = to_world.linear;
            Ok(Frame {
                eye: to_world.translation,
                right: axes.x_axis,
                up: axes.y_axis,
                // A camera looks down its own -z.
                forward: -axes.z_axis,
                half: DVec2::ONE,
                shift: DVec2::ZERO,
            })
        }
    }
}
