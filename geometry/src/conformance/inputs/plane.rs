use std::ops::Range;

use glam::{DVec3, Vec3};
use proptest::prelude::*;

use super::{Aimed, frame, in_plane, magnitude, slope, unit_vector};
use crate::{Plane, Ray};

/// How a plane is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneGiven {
    /// See [`Plane::from_normal`].
    ByNormal {
        /// A point of the plane.
        point: Vec3,
        /// Of any length.
        normal: Vec3,
    },
    /// See [`Plane::from_points`].
    ByPoints {
        /// The texture's origin.
        point: Vec3,
        /// The end of its first edge.
        along_u: Vec3,
        /// The end of its second edge.
        along_v: Vec3,
    },
}

impl PlaneGiven {
    /// The plane, if there is one.
    pub fn plane(&self) -> Option<Plane> {
        match *self {
            Self::ByNormal { point, normal } => Plane::from_normal(point, normal),
            Self::ByPoints { point, along_u, along_v } => Plane::from_points(point, along_u, along_v),
        }
    }
}

/// Planes whose point is up to 1e6 away from the hit and from the origin of space; rays from 1e-3 to 1e6 away, some parallel to
/// 1e-6, from both sides and pointing both ways.
pub fn planes() -> impl Strategy<Value = Aimed<PlaneGiven>> {
    let place = (prop_oneof![Just(0.0), magnitude(1e-3, 1e6)], unit_vector());
    let away = prop_oneof![Just(0.0), magnitude(1e-3, 1e6)];
    let edges = (any::<bool>(), magnitude(1e-3, 1e3), magnitude(1e-3, 1e3), 0.1..3.0);
    let line = (magnitude(1e-3, 1e6), slope(), magnitude(1e-3, 1e3), 0.0..6.3);
    (frame(), place, away, edges, line).prop_map(|(frame, (far, side), away, edges, line)| {
        let point = side * far;
        let (by_points, along_u, along_v, angle) = edges;
        let shape = if by_points {
            PlaneGiven::ByPoints {
                point: point.as_vec3(),
                along_u: (point + frame.x_axis * along_u).as_vec3(),
                along_v: (point + in_plane(frame, angle) * along_v).as_vec3(),
            }
        } else {
            PlaneGiven::ByNormal { point: point.as_vec3(), normal: (frame.z_axis * along_u).as_vec3() }
        };
        let (distance, slope, length, heading) = line;
        let direction = (in_plane(frame, heading) + frame.z_axis * slope).normalize();
        let hit = point + frame.y_axis * away;
        Aimed { shape, ray: Ray::new((hit - direction * distance).as_vec3(), (direction * length).as_vec3()) }
    })
}

/// Planes as one draws them on paper, by points or by a normal, near the origin of space; and rays of some length that are so many units
/// before them and meet them at such a cosine, positive from the front.
pub fn drawn_planes(cosine: Range<f64>, ahead: Range<f64>, length: f64) -> impl Strategy<Value = Aimed<PlaneGiven>> {
    let point = [-2.0..2.0_f64, -2.0..2.0, -2.0..2.0].prop_map(DVec3::from);
    let beside = (0.0..6.3_f64, 0.0..2.0_f64);
    (frame(), point, any::<bool>(), beside, cosine, 0.0..6.3_f64, ahead).prop_map(
        move |(frame, point, by_points, (around, off), cosine, heading, ahead)| {
            let shape = if by_points {
                PlaneGiven::ByPoints {
                    point: point.as_vec3(),
                    along_u: (point + frame.x_axis).as_vec3(),
                    along_v: (point + in_plane(frame, 1.0)).as_vec3(),
                }
            } else {
                PlaneGiven::ByNormal { point: point.as_vec3(), normal: frame.z_axis.as_vec3() }
            };
            let along = in_plane(frame, heading) * f64::sqrt(1.0 - cosine * cosine);
            let direction = along - frame.z_axis * cosine;
            let origin = point + in_plane(frame, around) * off - direction * ahead;
            Aimed { shape, ray: Ray::new(origin.as_vec3(), (direction * length).as_vec3()) }
        },
    )
}
