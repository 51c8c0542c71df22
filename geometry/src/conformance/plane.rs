//! A ray and an infinite plane.
//!
//! The idea: a plane is the points `p` with `n.(p - a) = 0`. Put the ray's points in, and `t` is a quotient.
//!
//! ```text
//!    o  \  d                    n.(a - o)
//!        \        n         t = ---------        n.d = 0: the ray is parallel
//!   -----X--a-----|----            n.d
//! ```
//!
//! **The contract** is [`crate::Primitive::intersect`]'s: met from both sides, strictly inside the interval; `u` and `v` stay 0. What is
//! asked is the plane's [`crate::Plane::point`] and [`crate::Plane::normal`], a unit vector in `f64`.
//!
//! **The laws** stand below from the easiest on. The hard cases: rays almost parallel to the plane, which meet it near the horizon; a
//! point of the plane 1e6 from where it is met; directions of length 1e-3, for which `n.d` is small all the same.
//! What they are held against is the quotient in rational numbers.
//!
//! **Literature.** Haines, in Glassner (ed.): An Introduction to Ray Tracing, 1989, chapter 2. Ericson: Real-Time Collision
//! Detection, 2005, section 5.3.1 on the test and chapter 11 on its robustness. Higham: Accuracy and Stability of Numerical
//! Algorithms, 2nd ed. 2002, section 3.1, on inner products.
//!
//! **Exercises.** 1. Pass the kit up to `what_is_no_number_is_not_met`; what does division by zero do to you? 2. Pass it all. 3. Show
//! what part of a floor's picture an epsilon of 1e-6 loses, with `compare`. 4. Beat the reference: when may it stay in `f32`?
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`a_plane_straight_ahead_is_met`] |
//! | the numerator's sign | [`a_plane_straight_ahead_is_met`] |
//! | the plane goes through the origin of space | [`a_plane_straight_ahead_is_met`] |
//! | culled from behind | [`a_plane_is_met_from_behind`] |
//! | the absolute value of t | [`a_plane_behind_the_ray_is_not_met`] |
//! | t is the distance | [`t_counts_multiples_of_the_direction`] |
//! | a ray in the plane is met at once | [`a_parallel_ray_misses_it`] |
//! | the interval is not checked | [`a_hit_outside_the_interval_does_not_count`] |
//! | texture coordinates in u and v | [`nothing_but_t_is_told`] |
//! | a comparison that NaN passes | [`what_is_no_number_is_not_met`] |
//! | an epsilon for parallel rays | [`a_plane_is_met_near_the_horizon`] |
//! | all in f32 | [`t_is_exact_to_half_an_ulp`] |

use super::claim::{Truth, broken, wild_claim};
use super::exact::{DOUBLE, Exact, ULPS, Vector, approximate, exact, is_within, truths};
use super::{Aimed, Figure, PlaneGiven, Trial, Verdict, drawn_planes, planes, wild_intervals, wild_rays, wild_vectors};
use crate::{Intersect, Intersection, Interval, Plane, Ray};
use glam::DVec3;

/// The part: a plain function, the field `plane` of [`crate::Kernels`].
pub type Part = Intersect<Plane>;

/// A plane in front of the ray, seen from its front, is met to three digits where a drawing on paper shows it.
pub fn a_plane_straight_ahead_is_met(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_planes(0.3..1.0, 1.0..10.0, 1.0), |aimed| is_met(part, aimed, Interval::FORWARD))
}

/// Both sides are met.
pub fn a_plane_is_met_from_behind(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_planes(-1.0..-0.3, 1.0..10.0, 1.0), |aimed| is_met(part, aimed, Interval::FORWARD))
}

/// What lies behind the origin is not met.
pub fn a_plane_behind_the_ray_is_not_met(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_planes(0.3..1.0, -10.0..-1.0, 1.0), |aimed| is_met(part, aimed, Interval::FORWARD))
}

/// The direction need not be a unit vector: if it is four times as long, `t` is a quarter as much.
pub fn t_counts_multiples_of_the_direction(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_planes(0.3..1.0, 1.0..10.0, 4.0), |aimed| is_met(part, aimed, Interval::FORWARD))
}

/// Above it or in it, a parallel ray has no one place where it meets it. Of planes along the axes, where `n.d` is exactly 0.
pub fn a_parallel_ray_misses_it(part: &Part, trial: &Trial) -> Verdict {
    use proptest::prelude::*;
    let whole = || [-4..=4_i32, -4..=4, -4..=4].prop_map(|v| glam::Vec3::from(v.map(|x| x as f32)));
    trial.search((whole(), whole(), whole(), 0..3_usize), |&(point, origin, mut direction, axis)| {
        let mut normal = glam::Vec3::ZERO;
        normal[axis] = 1.0;
        direction[axis] = 0.0;
        direction[(axis + 1) % 3] += 10.0;
        let aimed = Aimed { shape: PlaneGiven::ByNormal { point, normal }, ray: Ray::new(origin, direction) };
        is_met(part, &aimed, Interval::FORWARD)
    })
}

/// A hit counts strictly inside the interval.
pub fn a_hit_outside_the_interval_does_not_count(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_planes(0.3..1.0, 1.0..10.0, 1.0), |aimed| {
        let Some(plane) = aimed.shape.plane() else { return Ok(()) };
        let Some(met) = part(&plane, &aimed.ray, Interval::FORWARD) else { return Ok(()) };
        let after = |min: f32| Interval { min, max: f32::INFINITY };
        for within in
            [Interval::FORWARD.up_to(0.9 * met.t), Interval::FORWARD.up_to(met.t), after(1.1 * met.t), after(met.t)]
        {
            let none = Truth { t: None, tolerance: 0.0 };
            none.judge(&aimed.ray, part(&plane, &aimed.ray, within), || scene(aimed))?;
        }
        Ok(())
    })
}

/// `u` and `v` of an intersection are a triangle's.
pub fn nothing_but_t_is_told(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_planes(0.3..1.0, 1.0..10.0, 1.0), |aimed| {
        let found = aimed.shape.plane().and_then(|plane| part(&plane, &aimed.ray, Interval::FORWARD));
        let expected = found.map(|met| Intersection::at(met.t));
        if found == expected { Ok(()) } else { Err(broken(&aimed.ray, ("u = 0 and v = 0", None), found, scene(aimed))) }
    })
}

/// NaN in a ray or an interval is no hit; infinities and zeros make no panic.
pub fn what_is_no_number_is_not_met(part: &Part, trial: &Trial) -> Verdict {
    let points = [wild_vectors(), wild_vectors(), wild_vectors()];
    trial.times(32).search((points, wild_rays(), wild_intervals()), |&([a, b, c], ray, within)| {
        for plane in [Plane::from_normal(a, b), Plane::from_points(a, b, c)].into_iter().flatten() {
            wild_claim(part(&plane, &ray, within), a.is_nan(), &ray, within)?;
        }
        Ok(())
    })
}

/// Seen at 1e-7 to 1e-3 of a right angle, and by directions of length 1e-3.
pub fn a_plane_is_met_near_the_horizon(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_planes(1e-7..1e-3, 1.0..10.0, 1.0), |aimed| is_roughly_met(part, aimed))?;
    trial.search(drawn_planes(1e-4..1e-3, 1.0..10.0, 1e-3), |aimed| is_roughly_met(part, aimed))
}

/// `f64` adds a few roundings of the offset to the plane's point. They show only where both the point is far beside the hit
/// and the ray nearly parallel: half an ulp of the inputs would move `t` 2^28 times as far.
pub fn t_is_exact_to_half_an_ulp(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(planes(), |aimed| {
        let Aimed { shape, ray } = aimed;
        let (point, normal) = point_and_normal(shape);
        let (Some(plane), Some((t, scale))) = (shape.plane(), exact_t(&point, &normal, ray)) else { return Ok(()) };
        let error = 4.0 * DOUBLE * scale;
        let found = part(&plane, ray, Interval::FORWARD);
        let is_right = match found {
            Some(hit) => is_within(&t, &truths(hit.t, ULPS, error)),
            None => t <= exact(error),
        };
        if is_right {
            return Ok(());
        }
        let t = approximate(&t);
        Err(broken(ray, (&format!("t = {t}, to half a unit in the last place"), Some(t)), found, scene(aimed)))
    })
}

crate::kit! { $crate
    /// Names the laws of a ray and a plane as tests of an [`crate::Intersect`]: `geometry::plane_conformance!(my_plane);`.
    plane_conformance, Part, plane;
    a_plane_straight_ahead_is_met: "nothing is returned yet: t = n.(a - o) / n.d; or the plane's point is left out";
    a_plane_is_met_from_behind: "a positive n.d is taken for a miss";
    a_plane_behind_the_ray_is_not_met: "t is not compared with the interval, or its absolute value is";
    t_counts_multiples_of_the_direction: "the direction is normalised, and t is a distance";
    a_parallel_ray_misses_it: "a quotient by 0 is not left to the interval, which contains neither infinity nor NaN";
    a_hit_outside_the_interval_does_not_count: "the interval is not asked whether it contains t, or its ends count as inside";
    nothing_but_t_is_told: "texture coordinates are put into the barycentric weights u and v";
    what_is_no_number_is_not_met: "a comparison is written so that NaN passes it, such as `!(t <= min)`";
    a_plane_is_met_near_the_horizon: "n.d is compared with an epsilon, and a small one taken for 0";
    t_is_exact_to_half_an_ulp: "a scalar product is taken in f32, or as n.a - n.o, which cancels";
}

/// What laws about easy cases ask of `t`: three digits.
const DRAWN: f64 = 1e-3;

/// Met where the exact quotient says.
fn is_met(part: &Part, aimed: &Aimed<PlaneGiven>, within: Interval) -> Verdict {
    let Aimed { shape, ray } = aimed;
    let (point, normal) = point_and_normal(shape);
    let Some(plane) = shape.plane() else { return Ok(()) };
    let t = exact_t(&point, &normal, ray).map(|(t, _)| approximate(&t)).filter(|&t| within.contains(t as f32));
    Truth { t, tolerance: DRAWN }.judge(ray, part(&plane, ray, within), || scene(aimed))
}

/// Met ahead if the exact quotient is, unless a rounding of the inputs decides.
fn is_roughly_met(part: &Part, aimed: &Aimed<PlaneGiven>) -> Verdict {
    let Aimed { shape, ray } = aimed;
    let (point, normal) = point_and_normal(shape);
    let (Some(plane), Some((t, scale))) = (shape.plane(), exact_t(&point, &normal, ray)) else { return Ok(()) };
    let t = approximate(&t);
    let found = part(&plane, ray, Interval::FORWARD);
    let rounding = 8.0 * super::exact::SINGLE * scale;
    match found {
        None if t > rounding => Err(broken(ray, (&format!("a hit at about t = {t}"), Some(t)), found, scene(aimed))),
        _ => Ok(()),
    }
}

/// A square of the plane around its point.
fn scene(Aimed { shape, ray }: &Aimed<PlaneGiven>) -> Figure {
    let (point, normal) = point_and_normal(shape);
    let (point, normal) = (point.approximate(), normal.approximate().normalize());
    let (x, y): (DVec3, DVec3) = normal.any_orthonormal_pair();
    let corners = [x + y, x - y, -x - y, y - x].map(|side| point + side * 5.0);
    Figure::through(ray, ray.origin.as_dvec3() + normal).outline(&corners)
}

/// The plane as it was given: a point, and a normal of some length.
pub fn point_and_normal(plane: &PlaneGiven) -> (Vector, Vector) {
    match *plane {
        PlaneGiven::ByNormal { point, normal } => (point.into(), normal.into()),
        PlaneGiven::ByPoints { point, along_u, along_v } => {
            let point = Vector::from(point);
            let normal = Vector::from(along_u).minus(&point).cross(&Vector::from(along_v).minus(&point));
            (point, normal)
        }
    }
}

/// Where a ray meets the plane through a point, and what `f64` makes of it at best: its rounding of the offset, and of the
/// normal relative to the cosine. `None` for parallel rays.
pub fn exact_t(point: &Vector, normal: &Vector, ray: &Ray) -> Option<(Exact, f64)> {
    let offset = point.minus(&ray.origin.into());
    let along = normal.dot(&ray.direction.into());
    if along == Exact::ZERO {
        return None;
    }
    let t = normal.dot(&offset) / along.clone();
    let length = ray.direction.as_dvec3().length();
    let cosine = approximate(&along).abs() / (normal.approximate().length() * length);
    let error = (offset.approximate().length() / length + approximate(&t).abs()) / cosine;
    Some((t, error))
}
