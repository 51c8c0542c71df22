//! Surfaces to leave: a ray that starts on one must meet the next, and not the one that it starts from.

use glam::{DMat3, DVec3, Vec3};
use proptest::prelude::*;

use super::{PlaneGiven, frame, in_plane, magnitude, unit_vector};
use crate::{Ray, Sphere, Transform, Triangle};

/// The distance between two surfaces of scale 1: some eighty roundings of their coordinates.
pub const GAP: f64 = 1e-5;

/// Two surfaces [`GAP`] apart, of any scale from 1e-3 to 1e6.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apart<S> {
    /// The surface that the ray meets, and that is to be left.
    pub first: S,
    /// The surface on the other side of the gap.
    pub second: S,
    /// The size of both, no less than half their distance from the origin of space.
    pub scale: f32,
    /// A ray at the first.
    pub ray: Ray,
    /// From there into the gap, steeply enough to meet the second: of any length.
    pub leaving: Vec3,
}

/// A cube of twelve triangles, and a ray at one of its faces, often near an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubeEdge {
    /// Places [`crate::unit_cube`], whose side is 1.
    pub place: Transform,
    /// A ray at a face, from outside or from inside.
    pub ray: Ray,
    /// To any side, of any length.
    pub leaving: Vec3,
}

/// Two parallel planes; the ray meets the first from either side.
pub fn planes_apart() -> impl Strategy<Value = Apart<PlaneGiven>> {
    flat().prop_map(|(scale, frame, center, ray, leaving)| {
        let at = |height: f64| {
            let point = (center + frame.z_axis * (height * scale)).as_vec3();
            PlaneGiven::ByNormal { point, normal: frame.z_axis.as_vec3() }
        };
        Apart { first: at(0.0), second: at(GAP), scale: scale as f32, ray, leaving }
    })
}

/// Two parallel triangles; the ray meets the first so far inside that the second is met, too.
pub fn triangles_apart() -> impl Strategy<Value = Apart<Triangle>> {
    flat().prop_map(|(scale, frame, center, ray, leaving)| {
        let at = |height: f64| {
            let corner = |degrees: f64| {
                let around = in_plane(frame, degrees.to_radians()) + frame.z_axis * height;
                (center + around * scale).as_vec3()
            };
            Triangle { corners: [corner(0.0), corner(120.0), corner(240.0)] }
        };
        Apart { first: at(0.0), second: at(GAP), scale: scale as f32, ray, leaving }
    })
}

/// A sphere and a larger one around it. The first is the inner one, left outwards, or the outer one, left inwards.
pub fn spheres_apart() -> impl Strategy<Value = Apart<Sphere>> {
    (scaled(), spot_on_unit_sphere(), heading(0.1), any::<bool>()).prop_map(
        |((scale, center), (spot, origin), heading, inwards)| {
            let sphere = |radius: f64| Sphere { center: center.as_vec3(), radius: (radius * scale) as f32 };
            let spheres = [sphere(0.5), sphere(0.5 + GAP)];
            let [target, origin] = [spot, origin].map(|point| (center + point * (0.5 * scale)).as_vec3());
            let ray = Ray::new(origin, target - origin);
            apart(spheres, inwards, scale, ray, heading, spot)
        },
    )
}

/// An ellipsoid (axes 1 : 5) and a larger one around it, left as in [`spheres_apart`].
pub fn ellipsoids_apart() -> impl Strategy<Value = Apart<Transform>> {
    let shape = (frame(), [magnitude(0.2, 1.0), magnitude(0.2, 1.0), magnitude(0.2, 1.0)]);
    (scaled(), shape, spot_on_unit_sphere(), heading(0.5), any::<bool>()).prop_map(
        |((scale, center), (turn, axes), (spot, origin), heading, inwards)| {
            let ellipsoid = |by: f64| Transform {
                linear: turn * DMat3::from_diagonal(DVec3::from(axes)) * (by * scale),
                translation: center,
            };
            // The gap is narrowest along the shortest axis.
            let shortest = axes.into_iter().fold(1.0, f64::min);
            let ellipsoids = [ellipsoid(0.5), ellipsoid(0.5 + GAP / shortest)];
            let [target, origin] = [spot, origin].map(|point| ellipsoids[0].point(point).as_vec3());
            let ray = Ray::new(origin, target - origin);
            let normal = (ellipsoids[0].normals() * spot).normalize();
            apart(ellipsoids, inwards, scale, ray, heading, normal)
        },
    )
}

/// Cubes of side 1e-3 to 1e6, turned or along the axes, and rays at their faces, down to 1e-6 sides from an edge.
pub fn cube_edges() -> impl Strategy<Value = CubeEdge> {
    let from_edge = || prop_oneof![magnitude(1e-6, 0.5), Just(GAP)];
    let spot = (from_edge(), from_edge(), any::<[bool; 3]>(), 0..3_usize);
    let line = (unit_vector(), 0.1..2.0_f64, magnitude(1e-3, 1e3));
    (scaled(), frame(), spot, line, (unit_vector(), magnitude(1e-3, 1e3))).prop_map(
        |((scale, center), turn, (across, along, sides, axis), (from, distance, length), (leaving, long))| {
            let place = Transform { linear: turn * scale, translation: center };
            let sign = |side: usize| if sides[side] { 1.0 } else { -1.0 };
            let mut spot = DVec3::ZERO;
            spot[axis] = 0.5 * sign(0);
            spot[(axis + 1) % 3] = (0.5 - across) * sign(1);
            spot[(axis + 2) % 3] = (0.5 - along) * sign(2);
            let [target, origin] = [spot, spot + from * distance].map(|point| place.point(point).as_vec3());
            let ray = Ray::new(origin, (target - origin) * length as f32);
            CubeEdge { place, ray, leaving: (leaving * long).as_vec3() }
        },
    )
}

/// A scale, and a centre no farther off.
fn scaled() -> impl Strategy<Value = (f64, DVec3)> {
    let off = prop_oneof![Just(0.0), 0.0..1.0];
    (magnitude(1e-3, 1e6), off, unit_vector()).prop_map(|(scale, off, side)| (scale, side * (off * scale)))
}

/// A direction as a plane's normal sees it: its part along the normal (1) and its part along the plane.
fn heading(least_cosine: f64) -> impl Strategy<Value = (f64, f64, f64)> {
    (least_cosine..1.0, 0.0..6.3, magnitude(1e-3, 1e3))
}

fn headed((cosine, around, length): (f64, f64, f64), normal: DVec3) -> DVec3 {
    let (x, y) = normal.any_orthonormal_pair();
    (normal * cosine + in_plane(DMat3::from_cols(x, y, normal), around) * f64::sqrt(1.0 - cosine * cosine)) * length
}

/// Scale, axes and centre of a plane, a ray that meets it within a fifth of the scale, and a direction to its front.
fn flat() -> impl Strategy<Value = (f64, DMat3, DVec3, Ray, Vec3)> {
    let line = (0.0..6.3, 0.0..0.2_f64, heading(0.1), 0.1..2.0_f64, any::<bool>());
    (scaled(), frame(), line, heading(0.1)).prop_map(|((scale, center), frame, line, leaving)| {
        let (around, off, from, distance, behind) = line;
        let spot = center + in_plane(frame, around) * (off * scale);
        let side = if behind { -frame.z_axis } else { frame.z_axis };
        let origin = (spot + headed(from, side).normalize() * (distance * scale)).as_vec3();
        let ray = Ray::new(origin, spot.as_vec3() - origin);
        (scale, frame, center, ray, headed(leaving, frame.z_axis).as_vec3())
    })
}

/// A point of the unit sphere, and one outside or inside, from which it is the first to be met.
fn spot_on_unit_sphere() -> impl Strategy<Value = (DVec3, DVec3)> {
    (unit_vector(), heading(0.1), any::<bool>(), 0.1..2.0_f64).prop_map(|(spot, from, inside, distance)| {
        let direction = headed(from, if inside { -spot } else { spot }).normalize();
        // From inside, nearer than the chord's other end.
        let distance = if inside { 0.4 * distance * -spot.dot(direction) } else { distance };
        (spot, spot + direction * distance)
    })
}

/// `surfaces` are the inner and the outer one.
fn apart<S: Copy>(
    surfaces: [S; 2],
    inwards: bool,
    scale: f64,
    ray: Ray,
    heading: (f64, f64, f64),
    normal: DVec3,
) -> Apart<S> {
    let [inner, outer] = surfaces;
    let (first, second, side) = if inwards { (outer, inner, -normal) } else { (inner, outer, normal) };
    Apart { first, second, scale: scale as f32, ray, leaving: headed(heading, side).as_vec3() }
}
