use glam::{DMat3, Vec3};
use proptest::prelude::*;

use crate::{Interval, Ray, Transform};

/// Vectors with components that are NaN, infinite, huge, zero, denormal; one in two is ordinary.
pub fn wild_vectors() -> impl Strategy<Value = Vec3> {
    [wild_numbers(), wild_numbers(), wild_numbers()].prop_map(Vec3::from)
}

/// Numbers that are NaN, infinite, huge, zero, denormal; three in four are ordinary.
pub fn wild_numbers() -> impl Strategy<Value = f32> {
    let wild = prop::sample::select(vec![
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        f32::MIN,
        0.0,
        -0.0,
        1e-45,
        f32::MIN_POSITIVE,
    ]);
    prop_oneof![3 => -2.0_f32..2.0, 1 => wild]
}

/// Rays of such vectors.
pub fn wild_rays() -> impl Strategy<Value = Ray> {
    (wild_vectors(), wild_vectors()).prop_map(|(origin, direction)| Ray::new(origin, direction))
}

/// Everything ahead, or an interval between such numbers.
pub fn wild_intervals() -> impl Strategy<Value = Interval> {
    let wild = (wild_numbers(), wild_numbers()).prop_map(|(min, max)| Interval { min, max });
    prop_oneof![Just(Interval::FORWARD), wild]
}

/// Maps of such vectors.
pub fn wild_maps() -> impl Strategy<Value = Transform> {
    [wild_vectors(), wild_vectors(), wild_vectors(), wild_vectors()].prop_map(|vectors| {
        let [x, y, z, translation] = vectors.map(Vec3::as_dvec3);
        Transform { linear: DMat3::from_cols(x, y, z), translation }
    })
}
