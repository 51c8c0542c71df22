use std::ops::Range;

use glam::{DMat3, DVec3};
use proptest::prelude::*;

use super::{Aimed, frame, magnitude, sphere::unit_sphere_line, unit_vector};
use crate::{Ray, Transform};

/// The rays of [`super::spheres`] at a unit sphere, under maps that turn, shear, mirror and stretch it (axes 1 : 1e3) and move it.
pub fn ellipsoids() -> impl Strategy<Value = Aimed<Transform>> {
    let axes = [magnitude(1.0, 1e3), magnitude(1.0, 1e3), magnitude(1.0, 1e3)];
    let map = (frame(), axes, -1.0..1.0, frame(), any::<bool>(), magnitude(1e-3, 1e3));
    let map = map.prop_map(|(turn, [x, y, z], shear, last_turn, mirror, size)| {
        let mirror = if mirror { -1.0 } else { 1.0 };
        let shear = DMat3::from_cols(DVec3::X, DVec3::new(shear, 1.0, 0.0), DVec3::Z);
        last_turn * shear * DMat3::from_diagonal(DVec3::new(x, y, z * mirror)) * turn * size
    });
    let translation = (prop_oneof![Just(0.0), magnitude(1.0, 1e6)], unit_vector()).prop_map(|(far, side)| side * far);
    (map, translation, unit_sphere_line()).prop_map(|(linear, translation, (origin, direction))| {
        let shape = Transform { linear, translation };
        Aimed { shape, ray: Ray::new(shape.point(origin).as_vec3(), shape.direction(direction).as_vec3()) }
    })
}

/// The unit sphere turned and moved by up to 3 along each axis; rays as of [`super::drawn_spheres`].
pub fn moved_spheres(
    ahead: Range<f64>,
    beside: Range<f64>,
    length: Range<f64>,
) -> impl Strategy<Value = Aimed<Transform>> {
    drawn(frame(), ahead, beside, length)
}

/// The same under maps that stretch it (0.5 to 2 along each axis), shear and mirror it, with directions of length 0.5 to 2.
pub fn drawn_ellipsoids(ahead: Range<f64>, beside: Range<f64>) -> impl Strategy<Value = Aimed<Transform>> {
    let axes = [0.5..2.0_f64, 0.5..2.0, 0.5..2.0];
    let map = (frame(), axes, -0.5..0.5, frame(), any::<bool>()).prop_map(|(turn, [x, y, z], shear, last, mirror)| {
        let mirror = if mirror { -1.0 } else { 1.0 };
        let shear = DMat3::from_cols(DVec3::X, DVec3::new(shear, 1.0, 0.0), DVec3::Z);
        last * shear * DMat3::from_diagonal(DVec3::new(x, y, z * mirror)) * turn
    });
    drawn(map, ahead, beside, 0.5..2.0)
}

fn drawn(
    linear: impl Strategy<Value = DMat3>,
    ahead: Range<f64>,
    beside: Range<f64>,
    length: Range<f64>,
) -> impl Strategy<Value = Aimed<Transform>> {
    let translation = [-3.0..3.0_f64, -3.0..3.0, -3.0..3.0].prop_map(DVec3::from);
    (linear, translation, frame(), ahead, beside, length).prop_map(
        |(linear, translation, line, ahead, beside, length)| {
            let shape = Transform { linear, translation };
            let origin = line.x_axis * beside - line.z_axis * ahead;
            // So that a map of lengths leaves the ray's direction as long as was asked for.
            let direction = shape.direction(line.z_axis).normalize() * length;
            Aimed { shape, ray: Ray::new(shape.point(origin).as_vec3(), direction.as_vec3()) }
        },
    )
}
