use glam::DVec2;
use scene_format::{
    Diagnostic,
    scene_file::{self, CameraPlacement, Lens},
};

use super::placement::{dvec3, invertible};
use crate::{Camera, Frame, Pinhole, ThinLens};

/// A camera of a scene file.
pub(super) fn camera(camera: &scene_file::Camera) -> Result<Box<dyn Camera>, Diagnostic> {
    let [x, y] = camera.shift.unwrap_or_default();
    let placed = frame(&camera.placement)?.seeing(camera.fov.value.into(), camera.aspect.value.into());
    let frame = Frame { shift: DVec2::new(x.into(), y.into()), ..placed };
    Ok(match camera.lens {
        Lens::Pinhole => Box::new(Pinhole { frame }),
        // A lens without width is a pinhole, and needs no lens samples.
        Lens::Thin { radius: 0.0, .. } => Box::new(Pinhole { frame }),
        Lens::Thin { focus_distance, radius, sides, rotation } => Box::new(ThinLens {
            frame,
            focus_distance: focus_distance.into(),
            radius: radius.into(),
            sides: sides.unwrap_or(0),
            rotation_degrees: rotation.unwrap_or(0.0).into(),
        }),
    })
}

fn frame(placement: &CameraPlacement) -> Result<Frame, Diagnostic> {
    match placement {
        CameraPlacement::LookAt { eye, target, up, span } => Frame::look_at(dvec3(*eye), dvec3(*target), dvec3(*up))
            .ok_or_else(|| {
                let why = if eye == target {
                    "`eye` and `target` are the same point"
                } else {
                    "`up` is zero, or points along the view"
                };
                Diagnostic::error(*span, "this camera has no direction to look in")
                    .label(why)
                    .help("let `target` be another point than `eye`, and `up` any direction that is up in the picture")
            }),
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
