//! NaN and infinity in every input: a defined answer, and no panic.

use geometry::conformance::{times, wild_numbers};
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use render::{Camera, Frame, Pinhole, ThinLens};

fn wild() -> impl Strategy<Value = DVec3> {
    [wild_numbers(), wild_numbers(), wild_numbers()].prop_map(|v| DVec3::from(v.map(f64::from)))
}

fn wild_pair() -> impl Strategy<Value = DVec2> {
    [wild_numbers(), wild_numbers()].prop_map(|v| DVec2::from(v.map(f64::from)))
}

proptest! {
    #![proptest_config(times(32))]

    /// Axes are unit vectors or there is no view; a ray's direction is a unit vector or NaN, and a ray along NaN meets nothing.
    #[test]
    fn a_camera_makes_a_ray_that_is_one_or_meets_nothing(
        eye in wild(), target in wild(), up in wild(), film in wild_pair(), fov in wild_numbers(), aspect in wild_numbers(),
        lens in wild_pair(), focus in wild_numbers(), radius in wild_numbers(), sides in any::<u32>(),
    ) {
        let Some(frame) = Frame::look_at(eye, target, up) else { return Ok(()) };
        for axis in [frame.right, frame.up, frame.forward] {
            prop_assert!(axis.is_normalized(), "{:?}", frame);
        }
        let frame = frame.seeing(fov.into(), aspect.into());
        let thin_lens = ThinLens {
            frame, focus_distance: focus.into(), radius: radius.into(), sides, rotation_degrees: fov.into(),
        };
        for camera in [&Pinhole { frame } as &dyn Camera, &thin_lens] {
            let direction = camera.ray(film, &|| lens).direction;
            prop_assert!(direction.is_nan() || direction.is_normalized(), "{}", direction);
        }
    }
}
