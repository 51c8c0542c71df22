//! Where a ray starts that leaves a surface: a shadow ray, a mirrored one, a refracted one.
//!
//! The idea: the computed point is not quite on the surface. A ray from a hair behind it meets the surface once more, and the picture gets
//! acne; one that starts too far off jumps over what is close, and light leaks in. So it starts as near as the point is known, and no nearer.
//!
//! ```text
//!           start  o----> direction
//!       +----------|---+
//!   ----|----- p --|---|---- surface: somewhere in the box of the error around p
//!       +--------------+
//! ```
//!
//! **The contract** of [`crate::RayOrigin`]: of a [`crate::Surface`], whose point lies within `error` of the true one, and a direction of any
//! length but 0: a point on the side that the direction goes to, no farther off than twice the error.
//!
//! **The laws** stand below from the easiest on. The hard cases: directions within a rounding of the tangent plane; spheres so far off that the
//! grid of `f32` is as coarse as they are; gaps of 1e-5 between surfaces in scenes of 1e-3 and of 1e6; a cube's edge from inside.
//! Which side a point is on is decided in rational numbers.
//!
//! **Literature.** Pharr, Jakob, Humphreys: Physically Based Rendering, 4th ed. 2023, section 6.8.6. Wächter, Binder: A Fast and Robust Method
//! for Avoiding Self-Intersection, Ray Tracing Gems, 2019, chapter 6. Woo, Pearce, Ouellette: It's Really Not a Rendering Bug, You
//! See..., IEEE CG&A, 1996.
//!
//! **Exercises.** 1. Pass the kit up to `the_directions_length_does_not_matter` with a constant. 2. For which scenes does it fail from there on? Ask
//! `girasol accuracy`. 3. Pass it all. 4. Beat the reference: the ray that starts nearest without meeting its surface.
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | the origin of space | [`a_ray_starts_at_its_surface`] |
//! | the point itself | [`a_ray_starts_on_the_side_that_it_goes_to`] |
//! | always outwards | [`a_ray_starts_on_the_side_that_it_goes_to`] |
//! | along the direction, not made a unit vector | [`the_directions_length_does_not_matter`] |
//! | the shading normal | [`the_shading_normal_does_not_matter`] |
//! | a constant along the normal | [`a_large_scene_is_left`] |
//! | never less than a constant | [`a_small_scene_is_not_jumped_over`] |
//! | a share of the point's own coordinates | [`a_triangle_is_not_met_again`] |

use glam::{DMat3, DVec3, Vec3};
use proptest::prelude::*;

use super::exact::{Exact, SINGLE, Vector, exact};
use super::{
    Aimed, Counterexample, Cube, Figure, GAP, Ink, Trial, Verdict, cube_edges, drawn_triangles, ellipsoid, ellipsoids,
    ellipsoids_apart, magnitude, plane, planes, planes_apart, spheres, spheres_apart, triangle, triangles,
    triangles_apart, unit_vector,
};
use crate::{Ellipsoid, Interval, Primitive, Ray, RayOrigin, Sphere, Surface, Transform, Triangle};

/// The part: a plain function, the field `ray_origin` of `render::Modules`.
pub type Part = RayOrigin;

/// Within a hundredth of a triangle as one draws it on paper.
pub fn a_ray_starts_at_its_surface(part: &Part, trial: &Trial) -> Verdict {
    trial.search((drawn(), unit_vector()), |&(aimed, direction)| {
        let Some(surface) = surface(&aimed) else { return Ok(()) };
        let origin = part(&surface, direction);
        if (origin - surface.position).length() < 1e-2 {
            return Ok(());
        }
        Err(wrong(&surface, direction, &format!("a point near {:?}", surface.position), origin))
    })
}

/// To the front or to the back.
pub fn a_ray_starts_on_the_side_that_it_goes_to(part: &Part, trial: &Trial) -> Verdict {
    trial.search((drawn(), steep()), |&(aimed, direction)| is_on_its_side(part, &aimed, direction))
}

/// A thousandth or a thousand times as long a direction makes no difference to the side, nor to the distance.
pub fn the_directions_length_does_not_matter(part: &Part, trial: &Trial) -> Verdict {
    trial.search((drawn(), steep(), magnitude(1e-6, 1e6)), |&(aimed, direction, length)| {
        is_on_its_side(part, &aimed, direction * length)?;
        let Some(surface) = surface(&aimed) else { return Ok(()) };
        let origin = part(&surface, direction * length);
        if (origin - surface.position).length() < 1e-2 {
            return Ok(());
        }
        Err(wrong(&surface, direction * length, &format!("a point near {:?}", surface.position), origin))
    })
}

/// A mesh's own normals say how it is lit, not where it is.
pub fn the_shading_normal_does_not_matter(part: &Part, trial: &Trial) -> Verdict {
    trial.search((drawn(), steep(), unit_vector()), |&(aimed, direction, normal)| {
        let Some(surface) = surface(&aimed) else { return Ok(()) };
        let bent = Surface { shading_normal: normal.as_vec3(), ..surface };
        let (expected, found) = (part(&surface, direction), part(&bent, direction));
        if expected == found {
            Ok(())
        } else {
            Err(wrong(&bent, direction, &format!("{expected:?}, as without it"), found))
        }
    })
}

/// 1e3 to 1e6 times as large, where the numbers are far apart.
pub fn a_large_scene_is_left(part: &Part, trial: &Trial) -> Verdict {
    trial.search((drawn(), steep(), magnitude(1e3, 1e6)), |&(aimed, direction, size)| {
        is_on_its_side(part, &scaled(&aimed, size), direction)
    })
}

/// 1e-6 to 1e-3 times as large: a ray starts no farther off than twice the error.
pub fn a_small_scene_is_not_jumped_over(part: &Part, trial: &Trial) -> Verdict {
    trial.search((drawn(), steep(), magnitude(1e-6, 1e-3)), |&(aimed, direction, size)| {
        let aimed = scaled(&aimed, size);
        let Some(surface) = surface(&aimed) else { return Ok(()) };
        is_near(&surface, direction, part(&surface, direction))
    })
}

/// Triangles of all sizes and shapes, and directions down to a rounding from the surface.
pub fn a_triangle_is_not_met_again(part: &Part, trial: &Trial) -> Verdict {
    // The weights of so thin a triangle cancel; `t` must not be made of them.
    let corners = [Vec3::ZERO, Vec3::new(0.0, 0.0, 2700633.8), Vec3::new(3.003649, 0.0, 4782476.5)];
    let ray = Ray::new(Vec3::new(0.2760935, -1909636.4, -137227.38), Vec3::new(0.0, 1909636.4, 1909636.4));
    let known = (Aimed { shape: Triangle { corners }, ray }, Vec3::new(-0.33343172, 0.3504778, 0.8752077));
    let left = |aimed: &Aimed<Triangle>, heading: &dyn Fn(&Surface) -> Vec3| {
        let (point, normal) = triangle::point_and_normal(&aimed.shape);
        is_left(part, &aimed.shape, &aimed.ray, heading, |p| normal.dot(&p.minus(&point)))
    };
    trial.search(Just(known), |(aimed, direction)| left(aimed, &|_| *direction))?;
    trial.times(16).search((triangles(), headings()), |(aimed, heading)| left(aimed, &|surface| heading.from(surface)))
}

/// Planes.
pub fn a_plane_is_not_met_again(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search((planes(), headings()), |(aimed, heading)| {
        let Some(shape) = aimed.shape.plane() else { return Ok(()) };
        let (point, normal) = plane::point_and_normal(&aimed.shape);
        is_left(part, &shape, &aimed.ray, |surface| heading.from(surface), |p| normal.dot(&p.minus(&point)))
    })
}

/// Outwards; inwards the other side is met: `t = -2 (f.d) / (d.d)`, to the precision of the start. Where the chord is longer than the sphere is
/// uncertain.
pub fn a_sphere_is_not_met_again_outwards_and_on_its_far_side_inwards(part: &Part, trial: &Trial) -> Verdict {
    // Each coordinate of the start rounded away from the surface would be a step of 1/32 sideways here: out of the sphere.
    let shape = Sphere { center: Vec3::new(0.0, 0.0, 326323.97), radius: 1.0 };
    let ray = Ray::new(shape.center, Vec3::new(0.99998367, 0.0, 0.005715572));
    let direction = Vec3::new(3.266308e-5, 0.0, -0.0057154787);
    trial.search(Just((Aimed { shape, ray }, direction)), |(aimed, direction)| {
        sphere_is_left(part, aimed, |_| *direction)
    })?;
    trial.times(16).search((spheres(), headings()), |(aimed, heading)| {
        sphere_is_left(part, aimed, |surface| heading.from(surface))
    })
}

/// Stretched and sheared as well.
pub fn an_ellipsoid_is_not_met_again_outwards_and_on_its_far_side_inwards(part: &Part, trial: &Trial) -> Verdict {
    // The centre is half a step of `f32` off the nearest number: rounding moves the point so far along the surface, which bends away
    // under it by 0.0037^2 / 2, a hundred times the point's own error along the normal.
    let shape = Transform::translation(DVec3::new(100000.0037, 0.0, 0.0));
    let ray = Ray::new(Vec3::new(100000.0, 0.0, 3.0), Vec3::new(0.00185, 0.0, -1.0));
    trial.search(Just(Aimed { shape, ray }), |aimed| ellipsoid_is_left(part, aimed, |_| -Vec3::Z))?;
    trial.times(16).search((ellipsoids(), headings()), |(aimed, heading)| {
        ellipsoid_is_left(part, aimed, |surface| heading.from(surface))
    })
}

/// A gap of 1e-5 of the scale, from plane to plane: the next one is met, and nothing before it; lights in the gap are seen, and those
/// behind it are not.
pub fn from_plane_to_plane_there_is_no_acne_and_no_leak(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(planes_apart(), |apart| {
        let (Some(first), Some(second)) = (apart.first.plane(), apart.second.plane()) else { return Ok(()) };
        crosses_the_gap(part, [&first, &second], apart.scale, &apart.ray, apart.leaving)
    })
}

/// The same between triangles.
pub fn from_triangle_to_triangle_there_is_no_acne_and_no_leak(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(triangles_apart(), |apart| {
        crosses_the_gap(part, [&apart.first, &apart.second], apart.scale, &apart.ray, apart.leaving)
    })
}

/// The same between spheres, outwards and inwards.
pub fn from_sphere_to_sphere_there_is_no_acne_and_no_leak(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(spheres_apart(), |apart| {
        crosses_the_gap(part, [&apart.first, &apart.second], apart.scale, &apart.ray, apart.leaving)
    })
}

/// The same between ellipsoids.
pub fn from_ellipsoid_to_ellipsoid_there_is_no_acne_and_no_leak(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(ellipsoids_apart(), |apart| {
        let [first, second] = [apart.first, apart.second].map(|map| Ellipsoid::new(map).expect("of full rank"));
        crosses_the_gap(part, [&first, &second], apart.scale, &apart.ray, apart.leaving)
    })
}

/// From outside a cube nothing of it is met again, however near to an edge.
pub fn a_cube_is_not_met_again_from_outside_near_its_edges(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(cube_edges(), |case| {
        let cube = Cube::new(&case.place);
        let Some((_, surface)) = cube.nearest(&case.ray) else { return Ok(()) };
        let direction = away(case.leaving, surface.geometric_normal);
        let outward = leave(part, &surface, direction);
        if slope(&surface, direction) <= cube.flatness() {
            return Ok(());
        }
        match cube.nearest(&outward) {
            Some((again, _)) => Err(acne(&surface, &outward, f64::from(again.t))),
            None => Ok(()),
        }
    })
}

/// From inside a cube the next face is met, however near to an edge; its middle is seen from everywhere, what is outside from nowhere.
pub fn no_ray_leaves_a_cube_from_inside_near_its_edges(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(cube_edges(), |case| {
        let cube = Cube::new(&case.place);
        let Some((hit, surface)) = cube.nearest(&case.ray) else { return Ok(()) };
        let direction = -away(case.leaving, surface.geometric_normal);
        // At the very edge half an ulp decides which side of the other face the point is on.
        let is_clear = cube.distance_from_other_faces(&surface, hit) > 4.0 * surface.error.as_dvec3().length();
        if !is_clear || slope(&surface, direction) >= -cube.flatness() {
            return Ok(());
        }
        let inward = leave(part, &surface, direction);
        let Some((next, _)) = cube.nearest(&inward) else { return Err(leak(&surface, &inward)) };
        if next.primitive / 2 == hit.primitive / 2 {
            return Err(acne(&surface, &inward, f64::from(next.t)));
        }
        let to_middle = leave_towards(part, &surface, case.place.translation.as_vec3());
        if cube.blocks(&to_middle) {
            return Err(acne(&surface, &to_middle, 0.0));
        }
        let to_outside = leave_towards(part, &surface, inward.at(2.0 * f64::from(next.t)).as_vec3());
        if cube.blocks(&to_outside) { Ok(()) } else { Err(leak(&surface, &to_outside)) }
    })
}

crate::kit! { $crate
    /// Names the laws of a new ray's origin as tests of a [`crate::RayOrigin`]: `geometry::ray_origin_conformance!(my_origin);`.
    ray_origin_conformance, Part, ray_origin;
    a_ray_starts_at_its_surface: "nothing is returned yet: the surface's point, moved along its normal by a little";
    a_ray_starts_on_the_side_that_it_goes_to: "the point is not moved at all, or always to the front: what is refracted goes to the back";
    the_directions_length_does_not_matter: "the point is moved by a share of the direction, which has any length";
    the_shading_normal_does_not_matter: "the point is moved along the shading normal, which may point into the surface";
    a_large_scene_is_left: "the distance is a constant, less there than a step from one f32 to the next";
    a_small_scene_is_not_jumped_over: "the distance is a constant, and there as large as the scene";
    a_triangle_is_not_met_again: "the distance is not the error's share along the normal: |n|.error";
    a_plane_is_not_met_again: "the distance does not grow with the coordinates of the plane's own point";
    a_sphere_is_not_met_again_outwards_and_on_its_far_side_inwards: "each coordinate is rounded away from the surface, which moves the start sideways out of a small sphere";
    an_ellipsoid_is_not_met_again_outwards_and_on_its_far_side_inwards: "the error of a curved surface is more than the rounding of its point, since it bends away";
    from_plane_to_plane_there_is_no_acne_and_no_leak: "a shadow ray is offset by more than the error, or at its far end";
    from_triangle_to_triangle_there_is_no_acne_and_no_leak: "a shadow ray is offset by more than the error, or at its far end";
    from_sphere_to_sphere_there_is_no_acne_and_no_leak: "a shadow ray is offset by more than the error, or at its far end";
    from_ellipsoid_to_ellipsoid_there_is_no_acne_and_no_leak: "a shadow ray is offset by more than the error, or at its far end";
    a_cube_is_not_met_again_from_outside_near_its_edges: "the start is moved along the direction, into the next face";
    no_ray_leaves_a_cube_from_inside_near_its_edges: "the start is moved so far that it is out of the next face";
}

fn leave(part: &Part, surface: &Surface, direction: Vec3) -> Ray {
    Ray { origin: part(surface, direction.as_dvec3()), direction }
}

fn leave_towards(part: &Part, surface: &Surface, target: Vec3) -> Ray {
    let origin = part(surface, target.as_dvec3() - surface.position.as_dvec3());
    Ray { origin, direction: target - origin }
}

fn drawn() -> impl Strategy<Value = Aimed<Triangle>> {
    drawn_triangles(1.0..10.0, 1.0).prop_map(|drawn| drawn.inside())
}

/// Unit vectors; what is too flat is left out later.
fn steep() -> impl Strategy<Value = DVec3> {
    unit_vector()
}

fn surface(aimed: &Aimed<Triangle>) -> Option<Surface> {
    let hit = aimed.shape.intersect(&aimed.ray, Interval::FORWARD)?;
    Some(aimed.shape.surface(&aimed.ray, &hit))
}

fn scaled(Aimed { shape, ray }: &Aimed<Triangle>, size: f64) -> Aimed<Triangle> {
    let scaled = |v: Vec3| (v.as_dvec3() * size).as_vec3();
    Aimed { shape: Triangle { corners: shape.corners.map(scaled) }, ray: Ray::new(scaled(ray.origin), ray.direction) }
}

/// The start is on the side of the exact plane that the direction goes to, unless that is within a tenth of the plane.
fn is_on_its_side(part: &Part, aimed: &Aimed<Triangle>, direction: DVec3) -> Verdict {
    let Some(surface) = surface(aimed) else { return Ok(()) };
    let cosine = surface.geometric_normal.as_dvec3().dot(direction.normalize());
    if cosine.abs() < 0.1 {
        return Ok(());
    }
    let (point, normal) = triangle::point_and_normal(&aimed.shape);
    is_beside(&surface, direction, cosine, part(&surface, direction), |p| normal.dot(&p.minus(&point)))
}

fn is_beside(
    surface: &Surface,
    direction: DVec3,
    cosine: f64,
    origin: Vec3,
    side: impl Fn(&Vector) -> Exact,
) -> Verdict {
    let exact_side = if origin.is_finite() { side(&origin.into()) } else { Exact::ZERO };
    if if cosine > 0.0 { exact_side > Exact::ZERO } else { exact_side < Exact::ZERO } {
        return Ok(());
    }
    let which = if cosine > 0.0 { "in front of" } else { "behind" };
    Err(wrong(surface, direction, &format!("a point {which} the surface"), origin))
}

fn is_near(surface: &Surface, direction: DVec3, origin: Vec3) -> Verdict {
    let moved = (origin.as_dvec3() - surface.position.as_dvec3()).length();
    let most = 2.0 * surface.error.as_dvec3().length() + 1e-30;
    if moved <= most {
        return Ok(());
    }
    Err(wrong(surface, direction, &format!("no farther off than {most:e}"), origin))
}

fn wrong(surface: &Surface, direction: DVec3, expected: &str, origin: Vec3) -> Box<Counterexample> {
    let position = surface.position.as_dvec3();
    let ray = Ray::new(surface.position, direction.as_vec3());
    let normal = surface.geometric_normal.as_dvec3();
    let reach = 2.0 * (origin.as_dvec3() - position).length().max(surface.error.as_dvec3().length());
    let along = direction.reject_from(normal).normalize_or(normal.any_orthonormal_vector()) * reach;
    let figure = Figure::through(&ray, position + normal)
        .line(position - along, position + along, Ink::Shape)
        .line(position, position + normal * reach, Ink::Shape)
        .point(origin.as_dvec3(), Ink::Found, "start");
    let figure = figure.point(position, Ink::Expected, "point");
    Counterexample::new(format!("of {surface:?}, to {direction:?}: {expected}"), format!("{origin:?}")).drawn(figure)
}

fn acne(surface: &Surface, ray: &Ray, t: f64) -> Box<Counterexample> {
    let direction = ray.direction.as_dvec3();
    wrong(surface, direction, &format!("not to meet it again (acne), as at t = {t}"), ray.origin)
}

fn leak(surface: &Surface, ray: &Ray) -> Box<Counterexample> {
    wrong(surface, ray.direction.as_dvec3(), "to meet the other side (a leak)", ray.origin)
}

/// Where to leave to: any direction, or one so many roundings off the tangent plane.
#[derive(Clone, Copy, Debug)]
struct Heading {
    direction: Vec3,
    roundings: Option<f64>,
}

fn headings() -> impl Strategy<Value = Heading> {
    let length = prop_oneof![Just(1.0), Just(1e-3), Just(1e3)];
    let directions = (unit_vector(), length).prop_map(|(unit, length)| (unit * length).as_vec3());
    let roundings = prop_oneof![3 => Just(None), 1 => (-8.0..8.0).prop_map(Some)];
    (directions, roundings).prop_map(|(direction, roundings)| Heading { direction, roundings })
}

impl Heading {
    fn from(self, surface: &Surface) -> Vec3 {
        let Some(roundings) = self.roundings else { return self.direction };
        let (direction, normal) = (self.direction.as_dvec3(), surface.geometric_normal.as_dvec3());
        let along = direction - normal * normal.dot(direction);
        (along + normal * (roundings * SINGLE * along.length())).as_vec3()
    }
}

/// The cosine to the normal, if the direction is clearly on one side. A unit normal's three coordinates are each rounded by half
/// of `u` at most, together by 0.87 u: nearer to the tangent plane than that, the surface does not know its sides.
fn cosine(surface: &Surface, direction: Vec3) -> Option<f64> {
    Some(slope(surface, direction)).filter(|cosine| cosine.abs() > SINGLE)
}

fn slope(surface: &Surface, direction: Vec3) -> f64 {
    surface.geometric_normal.as_dvec3().dot(direction.as_dvec3()) / direction.as_dvec3().length()
}

/// Less than any radius of curvature of an ellipsoid: the shortest axis squared over the longest.
fn sharpest_bend(linear: DMat3) -> f64 {
    let size = |m: DMat3| DVec3::new(m.x_axis.length(), m.y_axis.length(), m.z_axis.length()).length();
    1.0 / (size(linear.inverse()).powi(2) * size(linear))
}

/// A ray that leaves starts on the side it goes to, and no farther off than the error and a rounding make necessary.
fn starts_on_its_side(surface: &Surface, ray: &Ray, cosine: f64, side: impl Fn(&Vector) -> Exact) -> Verdict {
    let direction = ray.direction.as_dvec3();
    is_beside(surface, direction, cosine, ray.origin, side)?;
    is_near(surface, direction, ray.origin)
}

/// Of a flat surface.
fn is_left(
    part: &Part,
    shape: &dyn Primitive,
    ray: &Ray,
    heading: impl Fn(&Surface) -> Vec3,
    side: impl Fn(&Vector) -> Exact,
) -> Verdict {
    let Some(hit) = shape.intersect(ray, Interval::FORWARD) else { return Ok(()) };
    let surface = shape.surface(ray, &hit);
    let direction = heading(&surface);
    let Some(cosine) = cosine(&surface, direction) else { return Ok(()) };
    let leaving = leave(part, &surface, direction);
    starts_on_its_side(&surface, &leaving, cosine, side)?;
    match shape.intersect(&leaving, Interval::FORWARD) {
        Some(again) => Err(acne(&surface, &leaving, f64::from(again.t))),
        None => Ok(()),
    }
}

fn sphere_is_left(part: &Part, aimed: &Aimed<Sphere>, heading: impl Fn(&Surface) -> Vec3) -> Verdict {
    let shape = aimed.shape;
    let Some(hit) = shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
    let surface = shape.surface(&aimed.ray, &hit);
    let side = |p: &Vector| {
        let from_center = p.minus(&shape.center.into());
        from_center.dot(&from_center) - exact(shape.radius) * exact(shape.radius)
    };
    let radius = f64::from(shape.radius);
    let error = surface.error.as_dvec3().length();
    let direction = heading(&surface);
    let Some(cosine) = cosine(&surface, direction) else { return Ok(()) };
    let leaving = leave(part, &surface, direction);
    let again = shape.intersect(&leaving, Interval::FORWARD);
    // Else the grid of `f32` is as coarse there as the sphere is small: no number may lie inside.
    let has_inside = radius > 2.0 * error;
    curved_is_left(&surface, &leaving, cosine, again.map(|again| again.t), has_inside, side)?;
    if cosine < 0.0 && cosine.powi(2) * radius > 64.0 * error {
        let chord = -2.0 * cosine * radius;
        let t = again.map(|again| f64::from(again.t) * leaving.direction.as_dvec3().length());
        if !t.is_some_and(|t| (t - chord).abs() < 16.0 * error / cosine.abs()) {
            let expected = format!("to meet the far side after {chord}, not {t:?}");
            return Err(wrong(&surface, direction.as_dvec3(), &expected, leaving.origin));
        }
    }
    Ok(())
}

fn ellipsoid_is_left(part: &Part, aimed: &Aimed<Transform>, heading: impl Fn(&Surface) -> Vec3) -> Verdict {
    let shape = Ellipsoid::new(aimed.shape).expect("maps of full rank");
    let Some(hit) = shape.intersect(&aimed.ray, Interval::FORWARD) else { return Ok(()) };
    let surface = shape.surface(&aimed.ray, &hit);
    let direction = heading(&surface);
    let Some(cosine) = cosine(&surface, direction) else { return Ok(()) };
    let leaving = leave(part, &surface, direction);
    let again = shape.intersect(&leaving, Interval::FORWARD).map(|again| again.t);
    // Else its tip is as small as the grid of `f32` there: no number may lie just inside.
    let has_inside = surface.error.as_dvec3().length() < sharpest_bend(aimed.shape.linear);
    curved_is_left(&surface, &leaving, cosine, again, has_inside, |p| ellipsoid::outside(&aimed.shape, p))
}

fn curved_is_left(
    surface: &Surface,
    leaving: &Ray,
    cosine: f64,
    again: Option<f32>,
    has_inside: bool,
    side: impl Fn(&Vector) -> Exact,
) -> Verdict {
    if cosine < 0.0 && !has_inside {
        return Ok(());
    }
    starts_on_its_side(surface, leaving, cosine, side)?;
    match again {
        Some(t) if cosine > 0.0 => Err(acne(surface, leaving, f64::from(t))),
        None if cosine < 0.0 => Err(leak(surface, leaving)),
        _ => Ok(()),
    }
}

/// The ray that leaves the first surface meets the second after at least the gap, and before anything else of the first; the
/// shadow segments to lights before and behind the second are free and blocked.
fn crosses_the_gap(part: &Part, [first, second]: [&dyn Primitive; 2], scale: f32, ray: &Ray, leaving: Vec3) -> Verdict {
    let hit = first.intersect(ray, Interval::FORWARD).expect("the ray is aimed at the first surface");
    let surface = first.surface(ray, &hit);
    let left = leave(part, &surface, leaving);
    let Some(next) = second.intersect(&left, Interval::FORWARD) else { return Err(leak(&surface, &left)) };
    let length = left.direction.as_dvec3().length();
    // Nine tenths: the surfaces' coordinates, the hit point and the start are each rounded, 2 to 4 of the gap's 80 roundings.
    let least = 0.9 * GAP * f64::from(scale);
    if f64::from(next.t) * length < least {
        let expected = format!("to have {least:e} to go to the next surface, not {:e}", f64::from(next.t) * length);
        return Err(wrong(&surface, leaving.as_dvec3(), &expected, left.origin));
    }
    // What is left inwards has its other side behind the second's near one.
    if let Some(again) = first.intersect(&left, Interval::FORWARD).filter(|again| again.t <= next.t) {
        return Err(acne(&surface, &left, f64::from(again.t)));
    }
    for (share, is_blocked) in [(0.5, false), (1.5, true)] {
        let light = left.at(share * f64::from(next.t)).as_vec3();
        let segment = leave_towards(part, &surface, light);
        if let Some(again) = first.intersect(&segment, Interval::SEGMENT) {
            return Err(acne(&surface, &segment, f64::from(again.t)));
        }
        if second.intersect(&segment, Interval::SEGMENT).is_some() != is_blocked {
            let light = if is_blocked {
                "a light behind the next surface to be hidden"
            } else {
                "a light before it to be seen"
            };
            return Err(wrong(&surface, segment.direction.as_dvec3(), light, segment.origin));
        }
    }
    Ok(())
}

/// The direction or its opposite, on the normal's side.
fn away(direction: Vec3, normal: Vec3) -> Vec3 {
    if direction.dot(normal) < 0.0 { -direction } else { direction }
}
