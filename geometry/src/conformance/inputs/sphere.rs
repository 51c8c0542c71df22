use std::ops::Range;

use glam::DVec3;
use proptest::prelude::*;

use super::{Aimed, frame, magnitude, unit_vector};
use crate::{Ray, Sphere};

/// Spheres of radius 1e-6 to 1e6, up to 1e6 radii from the origin of space; rays from the centre, from just inside, on or just
/// outside the surface and from up to 1e6 radii away; through the sphere, past it, and grazing it to 1e-7.
pub fn spheres() -> impl Strategy<Value = Aimed<Sphere>> {
    let place = (magnitude(1e-6, 1e6), prop_oneof![Just(0.0), magnitude(1.0, 1e6)], unit_vector());
    (place, unit_sphere_line(), magnitude(1e-3, 1e3)).prop_map(
        |((radius, offset, side), (origin, direction), length)| {
            let center = side * offset * radius;
            Aimed {
                shape: Sphere { center: center.as_vec3(), radius: radius as f32 },
                ray: Ray::new((center + origin * radius).as_vec3(), (direction * length).as_vec3()),
            }
        },
    )
}

/// Spheres as one draws them on paper: of radius 0.5 to 2, near the origin of space; and rays whose point nearest the centre is so many
/// radii ahead of their origin and so many beside the centre. The direction's length is given.
pub fn drawn_spheres(
    ahead: Range<f64>,
    beside: Range<f64>,
    length: Range<f64>,
) -> impl Strategy<Value = Aimed<Sphere>> {
    let center = [-2.0..2.0_f64, -2.0..2.0, -2.0..2.0].prop_map(DVec3::from);
    (center, 0.5..2.0_f64, frame(), ahead, beside, length).prop_map(|(center, radius, frame, ahead, beside, length)| {
        let nearest = center + frame.x_axis * (beside * radius);
        let origin = nearest - frame.z_axis * (ahead * radius);
        Aimed {
            shape: Sphere { center: center.as_vec3(), radius: radius as f32 },
            ray: Ray::new(origin.as_vec3(), (frame.z_axis * length).as_vec3()),
        }
    })
}

/// A line as the unit sphere at the origin sees it: origin and unit direction.
pub(crate) fn unit_sphere_line() -> impl Strategy<Value = (DVec3, DVec3)> {
    let near = || magnitude(1e-8, 1e-4);
    let distance = prop_oneof![
        2 => 0.0..1.0,
        3 => magnitude(1.0, 10.0),
        3 => magnitude(1e2, 1e6),
        1 => Just(1.0),
        2 => near().prop_map(|off| 1.0 - off),
        2 => near().prop_map(|off| 1.0 + off),
    ];
    let grazing = || magnitude(1e-7, 1e-2);
    let passing = prop_oneof![
        3 => 0.0..2.0,
        1 => grazing().prop_map(|off| 1.0 - off),
        1 => grazing().prop_map(|off| 1.0 + off),
    ];
    (frame(), distance, passing, prop_oneof![3 => Just(1.0), 1 => Just(-1.0)]).prop_map(
        |(frame, distance, passing, sign): (_, f64, f64, f64)| {
            let passing = if passing > distance { 0.5 * passing * distance } else { passing };
            let along = f64::sqrt(distance * distance - passing * passing);
            (frame.x_axis * passing - frame.z_axis * (sign * along), frame.z_axis)
        },
    )
}
