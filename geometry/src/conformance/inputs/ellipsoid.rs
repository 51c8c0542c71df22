use glam::{DMat3, DVec3};
use proptest::prelude::*;

use super::{Aimed, frame, magnitude, sphere::unit_sphere_line, unit_vector};
use crate::{Ray, Transform};

/// The rays of [`spheres`] at a unit sphere, under maps that turn, shear, mirror and stretch it (axes 1 : 1e3) and move it.
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
