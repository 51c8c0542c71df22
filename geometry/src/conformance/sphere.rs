//! A ray and a sphere.
//!
//! The idea: put the ray's points into the sphere's equation, `|o + t d - c|^2 = r^2`, and a quadratic for `t` is left, whose two roots
//! are the two sides.
//!
//! ```text
//!        d ->   near     far
//!   o------------X--------X-----      f = o - c,   a = d.d,   b = 2 f.d,   c = f.f - r^2
//!              /     |     \
//!             |      c      |         t = (-b -+ sqrt(b^2 - 4 a c)) / 2 a
//! ```
//!
//! **The contract** is [`crate::Primitive::intersect`]'s: the lesser of the two `t` that lies strictly inside the interval, in multiples of
//! the direction, whatever its length; `u` and `v` stay 0. A kernel decides nothing else: point and normal follow from `t`.
//!
//! **The laws** stand below from the easiest on. The hard cases: an origin 1e6 radii off (`b^2` and `4 a c` agree in all digits of
//! `f32`), an origin on the surface (one root is nearly 0), tangents (the square root doubles the digits that are lost), NaN.
//! What they are held against is the quadratic in rational numbers, which round nowhere.
//!
//! **Literature.** Haines, Günther, Akenine-Möller: Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019,
//! chapter 7. Press et al.: Numerical Recipes, 3rd ed. 2007, section 5.6, on the quadratic. Higham: Accuracy and Stability of
//! Numerical Algorithms, 2nd ed. 2002, section 1.8. Our own: [`crate::Sphere`]'s source.
//!
//! **Exercises.** 1. Pass the kit up to `what_is_no_number_is_not_met` in `f32`. 2. Pass `a_small_sphere_far_off_keeps_its_digits`, still in
//! `f32`. 3. Pass it all; which steps must be `f64`? 4. Beat the reference: fewer instructions, and no law broken.
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`a_sphere_straight_ahead_is_met`] |
//! | only the far side is looked at | [`a_sphere_straight_ahead_is_met`] |
//! | the direction is taken for a unit vector | [`t_counts_multiples_of_the_direction`] |
//! | the root of the discriminant's absolute value | [`a_ray_beside_the_sphere_misses_it`] |
//! | the absolute value of t | [`a_sphere_behind_the_ray_is_not_met`] |
//! | only the near side is looked at | [`from_inside_the_far_side_is_met`] |
//! | the interval is not checked | [`a_hit_outside_the_interval_does_not_count`] |
//! | the interval's ends count as inside | [`a_hit_outside_the_interval_does_not_count`] |
//! | the far side only for a negative near one | [`the_far_side_is_met_where_the_near_one_does_not_count`] |
//! | texture coordinates in u and v | [`nothing_but_t_is_told`] |
//! | the interval is checked so that NaN passes | [`what_is_no_number_is_not_met`] |
//! | the school's formula in f32 | [`a_small_sphere_far_off_keeps_its_digits`] |
//! | the school's formula in f64 | [`t_is_the_nearest_root_ahead_to_half_an_ulp`] |
//! | an epsilon at the interval's lower end | [`t_is_the_nearest_root_ahead_to_half_an_ulp`] |

use std::ops::Range;

use super::claim::{Truth, broken, wild_claim};
use super::exact::{Quadratic, SINGLE, ULPS, Vector, approximate, exact, truths};
use super::{
    Aimed, Figure, Trial, Verdict, drawn_spheres, spheres, wild_intervals, wild_numbers, wild_rays, wild_vectors,
};
use crate::{Intersect, Intersection, Interval, Ray, Sphere};

/// The part: a plain function, the field `sphere` of [`crate::Kernels`].
pub type Part = Intersect<Sphere>;

const UNIT: Range<f64> = 1.0..1.000_001;

/// A sphere in front of the ray is met, to three digits, where a drawing on paper shows it.
pub fn a_sphere_straight_ahead_is_met(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_spheres(2.0..10.0, 0.0..0.9, UNIT), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// The direction need not be a unit vector: if it is twice as long, `t` is half as much.
pub fn t_counts_multiples_of_the_direction(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_spheres(2.0..10.0, 0.0..0.9, 0.25..4.0), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// A ray that goes by is no hit: the discriminant is negative.
pub fn a_ray_beside_the_sphere_misses_it(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_spheres(2.0..10.0, 1.1..3.0, UNIT), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// What lies behind the origin is not met: `t` is negative there.
pub fn a_sphere_behind_the_ray_is_not_met(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_spheres(-10.0..-2.0, 0.0..0.9, UNIT), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// From inside the far side is met: the near one is behind.
pub fn from_inside_the_far_side_is_met(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_spheres(-0.4..0.4, 0.0..0.8, UNIT), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// A hit counts strictly inside the interval: a light's shadow ray must not find what lies beyond the light.
pub fn a_hit_outside_the_interval_does_not_count(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_spheres(2.0..10.0, 0.0..0.9, UNIT), |aimed| {
        let Some(first) = part(&aimed.shape, &aimed.ray, Interval::FORWARD) else { return Ok(()) };
        // Shortly before it, and right at it: an interval's ends lie outside.
        is_met(part, aimed, Interval::FORWARD.up_to(0.9 * first.t), DRAWN)?;
        let ends_there = part(&aimed.shape, &aimed.ray, Interval::FORWARD.up_to(first.t));
        Truth { t: None, tolerance: 0.0 }.judge(&aimed.ray, ends_there, || scene(aimed))
    })
}

/// Where the near side lies before the interval, the far one is asked.
pub fn the_far_side_is_met_where_the_near_one_does_not_count(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_spheres(2.0..10.0, 0.0..0.9, UNIT), |aimed| {
        let [near, far] = equation(&aimed.shape, &aimed.ray).roots().expect("the ray is aimed at the sphere");
        is_met(part, aimed, Interval { min: (0.5 * (near + far)) as f32, max: f32::INFINITY }, DRAWN)
    })
}

/// `u` and `v` of an intersection are a triangle's.
pub fn nothing_but_t_is_told(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_spheres(2.0..10.0, 0.0..0.9, UNIT), |aimed| {
        let found = part(&aimed.shape, &aimed.ray, Interval::FORWARD);
        let expected = found.map(|met| Intersection::at(met.t));
        if found == expected { Ok(()) } else { Err(broken(&aimed.ray, ("u = 0 and v = 0", None), found, scene(aimed))) }
    })
}

/// NaN anywhere is no hit; infinities and zeros make no panic.
pub fn what_is_no_number_is_not_met(part: &Part, trial: &Trial) -> Verdict {
    let cases = (wild_vectors(), wild_numbers(), wild_rays(), wild_intervals());
    trial.times(32).search(cases, |&(center, radius, ray, within)| {
        wild_claim(part(&Sphere { center, radius }, &ray, within), center.is_nan() || radius.is_nan(), &ray, within)
    })
}

/// Small and far off, the terms of the school's formula are much larger than their difference. Six digits are left of `t` if
/// the discriminant is made otherwise, in `f32` as well.
pub fn a_small_sphere_far_off_keeps_its_digits(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_spheres(1e3..1e4, 0.0..0.9, UNIT), |aimed| is_met(part, aimed, Interval::FORWARD, 1e-6))
}

/// Where half an ulp of the inputs could not make hit and miss of each other: within 4 u of tangency, the square root doubles the
/// digits that are lost.
pub fn t_is_the_nearest_root_ahead_to_half_an_ulp(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(spheres(), |aimed| {
        let (clearance, scale) = clearance(&aimed.shape, &aimed.ray);
        if clearance.abs() <= 8.0 * SINGLE * scale {
            return Ok(());
        }
        is_root_to(part, aimed, 0.0)
    })
}

/// More nearly tangential, `t` is as exact as `f64` sees: a rounding of the depth, divided by the depth's root.
pub fn t_is_as_exact_as_f64_sees_near_a_tangent(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(spheres(), |aimed| {
        let (clearance, scale) = clearance(&aimed.shape, &aimed.ray);
        let error = f64::exp2(-49.0) * scale;
        if clearance >= -error {
            return Ok(());
        }
        is_root_to(part, aimed, error / (-clearance).sqrt() / aimed.ray.direction.as_dvec3().length())
    })
}

/// The inputs are taken as exact; `f64` sees 2^29 times finer than they are.
pub fn hit_and_miss_are_right_unless_the_line_touches_as_closely_as_f64_sees(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(spheres(), |aimed| {
        let (clearance, scale) = clearance(&aimed.shape, &aimed.ray);
        if clearance.abs() <= f64::exp2(-49.0) * scale {
            return Ok(());
        }
        let found = part(&aimed.shape, &aimed.ray, Interval::FORWARD);
        match (equation(&aimed.shape, &aimed.ray).first_ahead(), found) {
            (Some(_), None) => Err(broken(&aimed.ray, ("a hit", None), found, scene(aimed))),
            (None, Some(_)) => Err(broken(&aimed.ray, ("None", None), found, scene(aimed))),
            _ => Ok(()),
        }
    })
}

/// Whichever root it is, the one after it is found from there on, if it rounds to another `t`.
pub fn the_far_side_is_met_beyond_the_near_one(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(spheres(), |aimed| {
        let Aimed { shape, ray } = aimed;
        let (clearance, scale) = clearance(shape, ray);
        let equation = equation(shape, ray);
        if clearance >= -8.0 * SINGLE * scale || equation.first_ahead() != Some(0) {
            return Ok(());
        }
        let Some(near) = part(shape, ray, Interval::FORWARD) else { return Ok(()) };
        let beyond = part(shape, ray, Interval { min: near.t, max: f32::INFINITY });
        // Both sides may round to one `t`.
        let claim = beyond.unwrap_or(near);
        if equation.root_is_within(1, &truths(claim.t, ULPS, 0.0)) {
            return Ok(());
        }
        Err(broken(ray, (&format!("the far side, beyond t = {}", near.t), None), beyond, scene(aimed)))
    })
}

crate::kit! { $crate
    /// Names the laws of a ray and a sphere as tests of an [`crate::Intersect`]: `geometry::sphere_conformance!(my_sphere);`.
    sphere_conformance, Part, sphere;
    a_sphere_straight_ahead_is_met: "nothing is returned yet: solve |o + t d - c| = r for t and return the lesser one, in multiples of d";
    t_counts_multiples_of_the_direction: "the direction is taken for a unit vector: a = 1, where a is d.d; or it is normalised, and t is a distance";
    a_ray_beside_the_sphere_misses_it: "a negative discriminant is not taken for a miss";
    a_sphere_behind_the_ray_is_not_met: "a negative t is returned, or its absolute value";
    from_inside_the_far_side_is_met: "only the lesser of the two t is looked at, which is behind an origin inside";
    a_hit_outside_the_interval_does_not_count: "the interval is not asked whether it contains t, or its ends count as inside";
    the_far_side_is_met_where_the_near_one_does_not_count: "the far side is tried only if the near one is behind the origin, not if it is outside the interval";
    nothing_but_t_is_told: "texture coordinates are put into the barycentric weights u and v";
    what_is_no_number_is_not_met: "a comparison is written so that NaN passes it, such as `!(t <= min)`";
    a_small_sphere_far_off_keeps_its_digits: "the discriminant b^2 - 4 a c is computed in f32, in which both terms are much larger than their difference";
    t_is_the_nearest_root_ahead_to_half_an_ulp: "a step that cancels is taken in f32, or -b + sqrt(..) where both are nearly equal";
    t_is_as_exact_as_f64_sees_near_a_tangent: "the discriminant is made of b^2 and 4 a c, which cancel where the ray grazes the sphere, instead of the line's point nearest the centre";
    hit_and_miss_are_right_unless_the_line_touches_as_closely_as_f64_sees: "the discriminant is compared with an epsilon, or cancels";
    the_far_side_is_met_beyond_the_near_one: "an epsilon is added to the interval's lower end";
}

/// `|o + t d - c|^2 - r^2`.
pub fn equation(sphere: &Sphere, ray: &Ray) -> Quadratic {
    let from_center = Vector::from(ray.origin).minus(&sphere.center.into());
    let direction = Vector::from(ray.direction);
    Quadratic {
        a: direction.dot(&direction),
        half_b: from_center.dot(&direction),
        c: from_center.dot(&from_center) - exact(sphere.radius) * exact(sphere.radius),
    }
}

/// The line's distance from the centre, squared, less the radius squared; and the scale of its errors.
pub fn clearance(sphere: &Sphere, ray: &Ray) -> (f64, f64) {
    let equation = equation(sphere, ray);
    let radius = f64::from(sphere.radius);
    let distance = (ray.origin.as_dvec3() - sphere.center.as_dvec3()).length();
    (-approximate(&equation.discriminant()) / approximate(&equation.a), radius * (distance + radius))
}

/// What laws about easy cases ask of `t`: three digits.
const DRAWN: f64 = 1e-3;

/// The nearest root in the interval is met.
fn is_met(part: &Part, aimed: &Aimed<Sphere>, within: Interval, tolerance: f64) -> Verdict {
    let roots = equation(&aimed.shape, &aimed.ray).roots();
    let t = roots.and_then(|roots| roots.into_iter().find(|&t| within.contains(t as f32)));
    Truth { t, tolerance }.judge(&aimed.ray, part(&aimed.shape, &aimed.ray, within), || scene(aimed))
}

/// If both are there, the hit is the first root ahead, to half an ulp and an error.
fn is_root_to(part: &Part, aimed: &Aimed<Sphere>, error: f64) -> Verdict {
    let equation = equation(&aimed.shape, &aimed.ray);
    let found = part(&aimed.shape, &aimed.ray, Interval::FORWARD);
    let (Some(met), Some(root)) = (found, equation.first_ahead()) else { return Ok(()) };
    if equation.root_is_within(root, &truths(met.t, ULPS, error)) {
        return Ok(());
    }
    let truth = equation.roots().map(|roots| roots[root]);
    let expected = format!("t = {}, to half a unit in the last place", truth.unwrap_or(f64::NAN));
    Err(broken(&aimed.ray, (&expected, truth), found, scene(aimed)))
}

fn scene(Aimed { shape, ray }: &Aimed<Sphere>) -> Figure {
    let center = shape.center.as_dvec3();
    Figure::through(ray, center).sphere(center, f64::from(shape.radius))
}
