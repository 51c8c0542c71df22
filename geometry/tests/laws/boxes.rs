use geometry::{
    Aabb, BoxProbe, Interval, Ray,
    conformance::{Aimed, boxes, times},
};
use glam::Vec3;
use proptest::prelude::*;

use crate::exact::{Exact, SINGLE, Vector, exact};

/// From where to where the exact ray is in a box, from its origin on; the end is `None` where there is none.
fn exact_clip(low: &Vector, high: &Vector, ray: &Ray) -> Option<(Exact, Option<Exact>)> {
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
    let underflow = 3.0 * f64::from(f32::MIN_POSITIVE) * (1.0 + f64::from(ray.direction.abs().max_element()));
    let by = (ray.origin.abs().as_dvec3() + f64::from(bounds.magnitude())) * share + underflow;
    (Vector::from(bounds.min).minus(&by.into()), Vector::from(bounds.max).plus(&by.into()))
}

fn is_not_missed(Aimed { shape, ray }: &Aimed<Aabb>) -> Result<(), TestCaseError> {
    let Some((near, far)) = exact_clip(&shape.min.into(), &shape.max.into(), ray) else { return Ok(()) };
    // A t that f32 cannot hold is no hit of any primitive.
    if near > exact(f32::MAX) {
        return Ok(());
    }
    let clipped = BoxProbe::new(ray, shape.magnitude()).clip(*shape, Interval::FORWARD);
    let Some(clipped) = clipped else { return Err(TestCaseError::fail("missed")) };
    prop_assert!(exact(clipped.min.clamp(0.0, f32::MAX)) <= near, "{:?}", clipped);
    if let Some(far) = far
        && clipped.max < f32::INFINITY
    {
        prop_assert!(far <= exact(clipped.max), "{:?}", clipped);
    }
    Ok(())
}

proptest! {
    #![proptest_config(times(32))]

    #[test]
    fn a_box_that_the_exact_ray_meets_is_never_missed(aimed in boxes()) {
        prop_assume!(aimed.ray.direction != Vec3::ZERO);
        is_not_missed(&aimed)?;
    }

    /// What is met lies within twice the slack: 8 u of the coordinates.
    #[test]
    fn a_box_that_the_exact_ray_clearly_passes_is_missed(aimed in boxes()) {
        let Aimed { shape, ray } = aimed;
        // Shorter directions meet every box.
        prop_assume!(ray.direction.abs().max_element() >= f32::exp2(-64.0));
        let (low, high) = grown(shape, &ray, 8.0 * SINGLE);
        let clipped = BoxProbe::new(&ray, shape.magnitude()).clip(shape, Interval::FORWARD);
        prop_assert!(clipped.is_none() || exact_clip(&low, &high, &ray).is_some(), "{:?}", clipped);
    }

    /// A part of the ray that ends before the box, or starts after it.
    #[test]
    fn what_lies_outside_the_interval_is_cut_off(aimed in boxes()) {
        let Aimed { shape, ray } = aimed;
        let probe = BoxProbe::new(&ray, shape.magnitude());
        let Some(clipped) = probe.clip(shape, Interval::FORWARD) else { return Ok(()) };
        prop_assume!(0.0 < clipped.min && clipped.max < f32::INFINITY);
        prop_assert!(probe.clip(shape, Interval::FORWARD.up_to(clipped.min.next_down())).is_none());
        let behind = Interval { min: clipped.max.next_up(), max: f32::INFINITY };
        prop_assert!(probe.clip(shape, behind).is_none());
    }
}

/// Four roundings of so small a box are less than the least number there is.
#[test]
fn denormal_boxes_are_not_missed() {
    let shape = Aabb { min: Vec3::ZERO, max: Vec3::new(3.66e-42, 0.0, 0.0) };
    is_not_missed(&Aimed { shape, ray: Ray::new(Vec3::ZERO, Vec3::X) }).unwrap();
}

/// The reciprocal of a component below 2^-126 may overflow; what replaces the component must not turn the ray.
#[test]
fn denormal_directions_miss_no_box() {
    let flat = Aabb { min: Vec3::ZERO, max: Vec3::new(1.0, 0.0, 1.0) };
    let ray = Ray::new(Vec3::X, Vec3::new(-0.0, 0.0, 1e-45));
    is_not_missed(&Aimed { shape: flat, ray }).unwrap();
    let edge = Aabb { min: Vec3::ZERO, max: Vec3::Y };
    let ray = Ray::new(Vec3::new(0.0, -13537.286, 0.0), Vec3::new(0.0, 1e-30, 0.0));
    is_not_missed(&Aimed { shape: edge, ray }).unwrap();
}
