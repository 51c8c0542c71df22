//! A ray and a box along the axes: the test that accelerators are made of.
//!
//! The idea: a box is three slabs. A ray is in each slab on an interval of `t`, and in the box where the three overlap.
//!
//! ```text
//!       |      |  /                x slab:      [====]
//!   ----+------+-X-----            y slab:   [=====]
//!       |      |/                  box:         [==]        none left: missed
//!       |      /
//!   ----+-----X+-------
//!       |    / |
//! ```
//!
//! **The contract** of [`crate::Clip`]: the part of the interval on which the ray is in the box, `None` if it is nowhere. It **may return too
//! much, never too little**: what is behind a box that was lost is lost. How much too much is a question of speed; the laws allow
//! 8 roundings of the coordinates.
//!
//! **The laws** stand below from the easiest on. The hard cases: boxes without thickness; rays in a face or along an edge, where
//! `0 * infinity` is NaN; origins inside; components of -0 and 1e-45; boxes of 1e-44 and 1e6 sizes off.
//! What they are held against is the three slabs in rational numbers.
//!
//! **Literature.** Kay, Kajiya: Ray Tracing Complex Scenes, SIGGRAPH 1986. Williams, Barrus, Morley, Shirley: An Efficient and Robust
//! Ray-Box Intersection Algorithm, Journal of Graphics Tools, 2005. Ize: Robust BVH Ray Traversal, JCGT, 2013, on how much to widen.
//! Majercik, Crassin, Shirley, McGuire: A Ray-Box Intersection Algorithm and Efficient Dynamic Voxel Rendering, JCGT, 2018.
//!
//! **Exercises.** 1. Pass the kit up to `a_box_is_not_lost_by_a_ray_along_the_axes`. 2. Pass `a_box_that_the_exact_ray_meets_is_never_missed`:
//! by how much must an interval be widened, and why? 3. Pass it all: never too little *and* hardly too much. 4. Beat the reference:
//! sixteen boxes in one step (`accel`'s `wide/boxes.rs`).
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`a_box_straight_ahead_is_passed_where_it_is`] |
//! | near and far are not put in order | [`a_box_straight_ahead_is_passed_where_it_is`] |
//! | one axis is forgotten | [`a_box_straight_ahead_is_passed_where_it_is`] |
//! | the intervals are united, not cut | [`a_box_straight_ahead_is_passed_where_it_is`] |
//! | a miss is returned as an empty part | [`a_ray_beside_the_box_misses_it`] |
//! | the box behind the origin counts | [`a_box_behind_the_ray_is_missed`] |
//! | an origin inside counts as a miss | [`from_inside_the_box_is_passed_from_the_start`] |
//! | the interval's end is not looked at | [`a_box_outside_the_interval_is_missed`] |
//! | flat boxes are lost | [`a_flat_box_is_not_lost`] |
//! | a direction of 0 along an axis is a miss | [`a_box_is_not_lost_by_a_ray_along_the_axes`] |
//! | a comparison that NaN fails | [`a_box_is_not_lost_by_a_ray_along_the_axes`] |
//! | a clamp that panics | [`what_is_no_number_makes_no_panic`] |
//! | the slabs as written down, without slack | [`a_box_that_the_exact_ray_meets_is_never_missed`] |
//! | a slack of a hundred-thousandth | [`a_box_that_the_exact_ray_clearly_passes_is_missed`] |

use glam::Vec3;
use proptest::prelude::*;

use super::exact::{Exact, SINGLE, Vector, approximate, exact};
use super::{
    Aimed, Counterexample, Figure, Ink, Trial, Verdict, boxes, drawn_boxes, wild_intervals, wild_rays, wild_vectors,
};
use crate::{Aabb, Clip, Interval, Ray};

/// The part: a plain function, the field `aabb` of [`crate::Kernels`].
pub type Part = Clip;

/// A box in front of the ray is passed where a drawing on paper shows it, to three digits.
pub fn a_box_straight_ahead_is_passed_where_it_is(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_boxes(1.5..10.0, 0.0..0.9), |aimed| is_passed(part, aimed, Interval::FORWARD))
}

/// A ray that clearly goes by is no hit.
pub fn a_ray_beside_the_box_misses_it(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_boxes(1.5..10.0, 1.1..3.0), |aimed| {
        let cut = clip(aimed, Interval::FORWARD, 1e-2);
        if cut.is_none() { is(part, aimed, Interval::FORWARD, None) } else { Ok(()) }
    })
}

/// A box behind the origin is no hit.
pub fn a_box_behind_the_ray_is_missed(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_boxes(-10.0..-2.0, 0.0..0.9), |aimed| is(part, aimed, Interval::FORWARD, None))
}

/// From inside, the part begins where the interval does.
pub fn from_inside_the_box_is_passed_from_the_start(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_boxes(-0.4..0.4, 0.0..0.5), |aimed| is_passed(part, aimed, Interval::FORWARD))
}

/// An interval that ends before the box or begins behind it does not meet it, and one within is all that is left.
pub fn a_box_outside_the_interval_is_missed(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_boxes(1.5..10.0, 0.0..0.9), |aimed| {
        let Some([near, far]) = clip(aimed, Interval::FORWARD, 0.0) else { return Ok(()) };
        is(part, aimed, Interval::FORWARD.up_to((0.9 * near) as f32), None)?;
        is(part, aimed, Interval { min: (1.1 * far) as f32, max: f32::INFINITY }, None)?;
        let [from, to] = [0.75 * near + 0.25 * far, 0.25 * near + 0.75 * far].map(|t| t as f32);
        is_passed(part, aimed, Interval { min: from, max: to })
    })
}

/// A box without thickness along one axis, such as a wall's, and a ray through its middle.
pub fn a_flat_box_is_not_lost(part: &Part, trial: &Trial) -> Verdict {
    let flat = (drawn_boxes(1.5..10.0, 0.0..0.9), 0..3_usize).prop_map(|(Aimed { mut shape, ray }, axis)| {
        shape.max[axis] = shape.min[axis];
        Aimed { shape, ray: Ray::new(ray.origin, shape.center() - ray.origin) }
    });
    trial.search(flat, |aimed| is_met(part, aimed))
}

/// Directions with one or two components of 0, of either sign, inside and in the faces: `0 * infinity` is NaN. On whole numbers, where
/// nothing is rounded.
pub fn a_box_is_not_lost_by_a_ray_along_the_axes(part: &Part, trial: &Trial) -> Verdict {
    let whole = |from: i32, to: i32| [from..=to, from..=to, from..=to].prop_map(|v| Vec3::from(v.map(|x| x as f32)));
    let step = || prop::sample::select(vec![1.0_f32, 2.0, -1.0, -2.0]);
    let zero = || prop::sample::select(vec![0.0_f32, -0.0]);
    let cases = (whole(-3, 3), whole(1, 4), whole(0, 4), 1..7_u32, [step(), step(), step()], [zero(), zero(), zero()])
        .prop_map(|(min, extent, inside, zeros, steps, zero)| {
            let component = |axis: usize| if zeros >> axis & 1 == 1 { zero[axis] } else { steps[axis] };
            let direction = Vec3::from([0, 1, 2].map(component));
            // From so far off that it meets the inside or a face.
            let target = min + inside.min(extent);
            Aimed { shape: Aabb { min, max: min + extent }, ray: Ray::new(target - 8.0 * direction, direction) }
        });
    trial.search(cases, |aimed| is_met(part, aimed))
}

/// Anything may be returned, but nothing panics.
pub fn what_is_no_number_makes_no_panic(part: &Part, trial: &Trial) -> Verdict {
    trial.times(32).search(
        (wild_vectors(), wild_vectors(), wild_rays(), wild_intervals()),
        |&(min, max, ray, within)| {
            let _ = part(&Aabb { min, max }, &ray, within);
            Ok(())
        },
    )
}

/// However flat, small, far, or seen along an edge; and its part of the ray is not cut short.
pub fn a_box_that_the_exact_ray_meets_is_never_missed(part: &Part, trial: &Trial) -> Verdict {
    // Four roundings of so small a box are less than the least number there is.
    let denormal = Aabb { min: Vec3::ZERO, max: Vec3::new(3.66e-42, 0.0, 0.0) };
    // The reciprocal of a component below 2^-126 may overflow; what replaces the component must not turn the ray.
    let flat = Aabb { min: Vec3::ZERO, max: Vec3::new(1.0, 0.0, 1.0) };
    let edge = Aabb { min: Vec3::ZERO, max: Vec3::Y };
    let known = [
        (denormal, Ray::new(Vec3::ZERO, Vec3::X)),
        (flat, Ray::new(Vec3::X, Vec3::new(-0.0, 0.0, 1e-45))),
        (edge, Ray::new(Vec3::new(0.0, -13537.286, 0.0), Vec3::new(0.0, 1e-30, 0.0))),
    ];
    trial.times(32).search(boxes(), |aimed| is_not_lost(part, aimed))?;
    let known = prop::sample::select(known.to_vec()).prop_map(|(shape, ray)| Aimed { shape, ray });
    trial.search(known, |aimed| is_not_lost(part, aimed))
}

/// What is met lies within twice the slack: 8 u of the coordinates.
pub fn a_box_that_the_exact_ray_clearly_passes_is_missed(part: &Part, trial: &Trial) -> Verdict {
    trial.times(32).search(boxes(), |aimed| {
        let Aimed { shape, ray } = aimed;
        // Shorter directions may meet every box.
        if ray.direction.abs().max_element() < f32::exp2(-64.0) {
            return Ok(());
        }
        let (low, high) = grown(*shape, ray, 8.0 * SINGLE);
        let found = part(shape, ray, Interval::FORWARD);
        if found.is_some() && exact_clip(&low, &high, ray).is_none() {
            return Err(wrong(aimed, "None, by more than 8 roundings of the coordinates", found));
        }
        Ok(())
    })
}

/// A part of the ray that ends before what was returned, or starts after it, does not meet the box.
pub fn what_lies_outside_the_interval_is_cut_off(part: &Part, trial: &Trial) -> Verdict {
    trial.times(32).search(boxes(), |aimed| {
        let Aimed { shape, ray } = aimed;
        let Some(passed) = part(shape, ray, Interval::FORWARD) else { return Ok(()) };
        if passed.min <= 0.0 || passed.max == f32::INFINITY {
            return Ok(());
        }
        is(part, aimed, Interval::FORWARD.up_to(passed.min.next_down()), None)?;
        is(part, aimed, Interval { min: passed.max.next_up(), max: f32::INFINITY }, None)
    })
}

crate::kit! { $crate
    /// Names the laws of a ray and a box as tests of a [`crate::Clip`]: `geometry::aabb_conformance!(my_box);`.
    aabb_conformance, Part, aabb;
    a_box_straight_ahead_is_passed_where_it_is: "nothing is returned yet: for each axis (b - o) / d of both planes, the lesser is near, the greater far; the box is where the three intervals overlap";
    a_ray_beside_the_box_misses_it: "the greatest near is not compared with the least far, or not over all three axes";
    a_box_behind_the_ray_is_missed: "the near is not cut to the interval's beginning";
    from_inside_the_box_is_passed_from_the_start: "a near before the interval counts as a miss";
    a_box_outside_the_interval_is_missed: "the far is not cut to the interval's end, or the interval is not cut at all";
    a_flat_box_is_not_lost: "near = far counts as a miss: `>=` where `>` is due";
    a_box_is_not_lost_by_a_ray_along_the_axes: "0 times infinity is NaN, and a comparison with it loses the box; or a component of 0 counts as a miss";
    what_is_no_number_makes_no_panic: "clamp panics if its bounds are NaN or in the wrong order";
    a_box_that_the_exact_ray_meets_is_never_missed: "nothing makes up for the rounding of near and far; see geometry::BoxProbe";
    a_box_that_the_exact_ray_clearly_passes_is_missed: "the slack is a fixed number or a large share of t, not a few roundings of the coordinates";
    what_lies_outside_the_interval_is_cut_off: "what is returned is wider than what is compared with the interval";
}

/// Where the exact ray is in the box, grown by a share of its coordinates, and in the interval.
fn clip(Aimed { shape, ray }: &Aimed<Aabb>, within: Interval, share: f64) -> Option<[f64; 2]> {
    let (low, high) = grown(*shape, ray, share);
    let (near, far) = exact_clip(&low, &high, ray)?;
    let near = approximate(&near).max(f64::from(within.min));
    let far = far.map_or(f64::INFINITY, |far| approximate(&far)).min(f64::from(within.max));
    (near <= far).then_some([near, far])
}

/// The answer is a part of the ray, to three digits: that on which it is in the box.
fn is_passed(part: &Part, aimed: &Aimed<Aabb>, within: Interval) -> Verdict {
    is(part, aimed, within, clip(aimed, within, 0.0))
}

fn is(part: &Part, aimed: &Aimed<Aabb>, within: Interval, expected: Option<[f64; 2]>) -> Verdict {
    let found = part(&aimed.shape, &aimed.ray, within);
    let near = |a: f64, b: f32| (a - f64::from(b)).abs() <= 1e-3 * a.abs().max(1e-2);
    match (expected, found) {
        (None, None) => Ok(()),
        (Some([from, to]), Some(part)) if near(from, part.min) && near(to, part.max) => Ok(()),
        (Some([from, to]), _) => {
            Err(wrong(aimed, &format!("in {within:?} the box is passed from t = {from} to {to}, to 1e-3 of it"), found))
        }
        (None, _) => Err(wrong(aimed, &format!("None in {within:?}"), found)),
    }
}

/// A box that the exact ray meets is met.
fn is_met(part: &Part, aimed: &Aimed<Aabb>) -> Verdict {
    let Aimed { shape, ray } = aimed;
    let Some((near, _)) = exact_clip(&shape.min.into(), &shape.max.into(), ray) else { return Ok(()) };
    match part(shape, ray, Interval::FORWARD) {
        None => Err(wrong(aimed, &format!("met at about t = {}", approximate(&near)), None)),
        Some(_) => Ok(()),
    }
}

/// Nothing of the part in which the exact ray is in the box is cut off.
fn is_not_lost(part: &Part, aimed: &Aimed<Aabb>) -> Verdict {
    let Aimed { shape, ray } = aimed;
    // A direction of 0 is no ray; a t that f32 cannot hold is no hit of any primitive.
    let exact_part = exact_clip(&shape.min.into(), &shape.max.into(), ray);
    let Some((near, far)) = exact_part.filter(|(near, _)| ray.direction != Vec3::ZERO && *near <= exact(f32::MAX))
    else {
        return Ok(());
    };
    let found = part(shape, ray, Interval::FORWARD);
    let holds = |part: Interval| {
        let ends = far.as_ref().is_none_or(|far| part.max == f32::INFINITY || *far <= exact(part.max));
        !part.min.is_nan() && !part.max.is_nan() && exact(part.min.clamp(0.0, f32::MAX)) <= near && ends
    };
    if found.is_some_and(holds) {
        return Ok(());
    }
    let (near, far) = (approximate(&near), far.map_or(f64::INFINITY, |far| approximate(&far)));
    Err(wrong(aimed, &format!("all from t = {near:e} to {far:e}"), found))
}

fn wrong(Aimed { shape, ray }: &Aimed<Aabb>, expected: &str, found: Option<Interval>) -> Box<Counterexample> {
    let figure = Figure::through(ray, shape.center().as_dvec3()).cuboid(shape);
    let figure = found
        .into_iter()
        .flat_map(|part| [part.min, part.max])
        .fold(figure, |figure, t| figure.hit(ray, Some(t), Ink::Found));
    Counterexample::new(expected, format!("{found:?}")).drawn(figure)
}

/// From where to where the exact ray is in a box, from its origin on; the end is `None` where there is none.
pub fn exact_clip(low: &Vector, high: &Vector, ray: &Ray) -> Option<(Exact, Option<Exact>)> {
    let (mut near, mut far) = (Exact::ZERO, None);
    let origin = Vector::from(ray.origin);
    let direction = Vector::from(ray.direction);
    for axis in 0..3 {
        let to_low = &low.0[axis] - &origin.0[axis];
        let to_high = &high.0[axis] - &origin.0[axis];
        let step = &direction.0[axis];
        if *step == Exact::ZERO {
            if to_low > Exact::ZERO || to_high < Exact::ZERO {
                return None;
            }
            continue;
        }
        let (a, b) = (to_low / step, to_high / step);
        let (enter, leave) = if a < b { (a, b) } else { (b, a) };
        near = near.max(enter);
        far = Some(far.map_or(leave.clone(), |far: Exact| far.min(leave)));
    }
    if far.as_ref().is_some_and(|far| *far < near) { None } else { Some((near, far)) }
}

/// The box with each face moved outwards by some share of the coordinates, and by what underflows: of them, and of `t`.
fn grown(bounds: Aabb, ray: &Ray, share: f64) -> (Vector, Vector) {
    if share == 0.0 {
        return (bounds.min.into(), bounds.max.into());
    }
    let underflow = 3.0 * f64::from(f32::MIN_POSITIVE) * (1.0 + f64::from(ray.direction.abs().max_element()));
    let by = (ray.origin.abs().as_dvec3() + f64::from(bounds.magnitude())) * share + underflow;
    (Vector::from(bounds.min).minus(&by.into()), Vector::from(bounds.max).plus(&by.into()))
}
