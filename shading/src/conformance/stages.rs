use geometry::conformance::{magnitude, unit_vector};
use geometry::{Sphere, Surface};
use glam::{DVec3, Vec2};
use proptest::prelude::*;

use super::{Lamp, Stage, colors};
use crate::{Bounces, Color};

/// The cosine between a ray's way back and the normal.
fn cosines() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 0.05..1.0, 1 => magnitude(1e-2, 1e-1), 1 => Just(1.0)]
}

/// Stages without lights, that a ray comes straight down to, from outside.
pub fn straight() -> impl Strategy<Value = Stage> {
    seen(Just(1.0), false, Just(0.0))
}

/// Those that a ray comes to from outside, slanted down to a cosine of 1e-2.
pub fn from_outside() -> impl Strategy<Value = Stage> {
    seen(cosines(), false, Just(0.0))
}

/// Those that a ray comes to through the inside of the body.
pub fn from_inside() -> impl Strategy<Value = Stage> {
    seen(cosines(), true, Just(0.0))
}

/// Those whose shading normal leans up to 10 degrees from the true one, as a mesh's own does. What is mirrored at it stays before the surface.
pub fn leaning() -> impl Strategy<Value = Stage> {
    prop_oneof![seen(0.5..1.0, false, 0.02..0.17), seen(0.5..1.0, true, 0.02..0.17)]
}

/// All of these.
pub fn stages() -> impl Strategy<Value = Stage> {
    prop_oneof![3 => from_outside(), 3 => from_inside(), 2 => leaning()]
}

/// Those that are seen so flat that what is mirrored at the leaning normal goes through the surface.
pub fn mirrored_through() -> impl Strategy<Value = Stage> {
    let flat = || seen(0.05..0.15, false, 0.2..0.4);
    let goes_through = |stage: &Stage| {
        let seen_from_front = stage.direction.dot(stage.surface.shading_normal) < -0.02;
        seen_from_front && stage.mirrored().dot(stage.outward()) < -0.02
    };
    flat().prop_filter("mirrored to where it came from", goes_through)
}

/// Stages with two lights anywhere around.
pub fn lamps(stages: impl Strategy<Value = Stage>) -> impl Strategy<Value = Stage> {
    let lamp = || {
        let place = (unit_vector(), 0.5..8.0).prop_map(|(side, distance)| side * distance);
        (place, colors(), 0.5_f32..20.0)
    };
    (stages, lamp(), lamp()).prop_map(|(stage, one, other)| {
        let at = stage.surface.position.as_dvec3();
        let lamp = |(place, color, power): (DVec3, _, _)| Lamp { position: (at + place).as_vec3(), color, power };
        Stage { lamps: [one, other].map(|drawn| Some(lamp(drawn))), ..stage }
    })
}

/// Stages with one light on the viewer's side of both normals, 0.3 to 8 away, anywhere from straight above to a cosine of 0.05; no ambient light.
pub fn lit(stages: impl Strategy<Value = Stage>) -> impl Strategy<Value = Stage> {
    let lamp = (0.05..1.0, 0.0..6.3, 0.3..8.0, colors(), 0.5_f32..20.0);
    let stages = (stages, lamp).prop_map(|(stage, (cosine, around, distance, color, power))| {
        let side = stage.normal();
        let to_light = side * cosine + in_plane(side, around) * f64::sqrt(1.0 - cosine * cosine);
        with_lamp(&stage, to_light * distance, color, power)
    });
    stages.prop_filter("behind the true surface", |stage| stage.to_lamp().dot(stage.outward()) > 0.0)
}

/// Those with one light behind both normals.
pub fn lit_from_behind(stages: impl Strategy<Value = Stage>) -> impl Strategy<Value = Stage> {
    lit(stages).prop_map(|stage| {
        let to_light = stage.to_lamp();
        let mirrored = to_light - 2.0 * to_light.dot(stage.outward()) * stage.outward();
        let [lamp, _] = stage.lamps;
        let lamp = lamp.map(|lamp| Lamp { position: (stage.surface.position.as_dvec3() + mirrored).as_vec3(), ..lamp });
        Stage { lamps: [lamp, None], ..stage }
    })
}

/// Those whose light is before the mesh's leaning normal, and behind the true surface.
pub fn lit_through_the_surface() -> impl Strategy<Value = Stage> {
    let lamp = (0.1..0.9, 0.3..8.0, colors(), 0.5_f32..20.0);
    (leaning(), lamp).prop_map(|(stage, (share, distance, color, power))| {
        // Between the two tangent planes, in the plane of both normals.
        let (normal, outward) = (stage.normal(), stage.outward());
        let along = normal.reject_from(outward).normalize();
        let lean = libm::acos(normal.dot(outward).min(1.0));
        let (sin, cos) = libm::sincos(share * lean);
        with_lamp(&stage, (along * cos - outward * sin) * distance, color, power)
    })
}

/// With something opaque on the line from the point through its light, at so many times the light's distance.
pub fn blocked_at(
    stages: impl Strategy<Value = Stage>,
    place: impl Strategy<Value = f64>,
) -> impl Strategy<Value = Stage> {
    (stages, place).prop_map(|(stage, place)| {
        let to_light = stage.to_lamp();
        let center = (stage.surface.position.as_dvec3() + to_light * place).as_vec3();
        Stage { blocker: Some(Sphere { center, radius: (0.15 * to_light.length()) as f32 }), ..stage }
    })
}

/// With a light of such power that its light has not fallen off there.
pub fn undimmed(stages: impl Strategy<Value = Stage>) -> impl Strategy<Value = Stage> {
    stages.prop_map(|stage| Stage {
        lamps: stage.lamps.map(|lamp| lamp.map(|lamp| Lamp { power: 1e9, ..lamp })),
        ..stage
    })
}

fn with_lamp(stage: &Stage, to_light: DVec3, color: Color, power: f32) -> Stage {
    let position = (stage.surface.position.as_dvec3() + to_light).as_vec3();
    Stage { lamps: [Some(Lamp { position, color, power }), None], ambient: 0.0, ..stage.clone() }
}

fn seen(
    cosine: impl Strategy<Value = f64>,
    inside: bool,
    lean: impl Strategy<Value = f64>,
) -> impl Strategy<Value = Stage> {
    let place = (unit_vector(), prop_oneof![Just(0.0), 0.1..10.0]).prop_map(|(side, far)| side * far);
    let uv = (-2.0_f32..3.0, -2.0_f32..3.0).prop_map(|(u, v)| Vec2::new(u, v));
    let bounces =
        (1..6_u32, 1..6_u32).prop_map(|(reflections, refractions)| Bounces::of_camera_ray(reflections, refractions));
    let angles = (cosine, 0.0..6.3, lean, 0.0..6.3);
    (place, unit_vector(), angles, 0.1_f32..10.0, uv, bounces, 0.1_f32..0.9).prop_map(
        move |(place, normal, (cosine, around, lean, lean_around), distance, uv, bounces, ambient)| {
            let from = if inside { -normal } else { normal };
            let direction = in_plane(normal, around) * f64::sqrt(1.0 - cosine * cosine) - from * cosine;
            let (sin, cos) = libm::sincos(lean);
            let shading = normal * cos + in_plane(normal, lean_around) * sin;
            let surface = Surface::rounded(place.as_vec3(), 10.0, normal.as_vec3());
            Stage {
                direction: direction.normalize().as_vec3(),
                distance,
                surface: Surface { shading_normal: shading.normalize().as_vec3(), ..surface },
                uv,
                bounces,
                lamps: [None; 2],
                blocker: None,
                ambient,
            }
        },
    )
}

/// A direction at right angles to a normal.
pub(super) fn in_plane(normal: DVec3, angle: f64) -> DVec3 {
    let (x, y) = normal.any_orthonormal_pair();
    let (sin, cos) = libm::sincos(angle);
    x * cos + y * sin
}
