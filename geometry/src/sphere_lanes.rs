use glam::{DVec3, Vec3};

use crate::{
    Interval, Sphere,
    sphere::{is_exact, is_left_behind},
};

/// Where each of many rays meets a sphere, as [`crate::Primitive::intersect`] has it in each bit.
#[derive(Clone, Debug)]
pub struct SphereMet<const N: usize> {
    /// As in [`crate::Intersection`]; NaN where the sphere is missed.
    pub t: [f32; N],
    /// Not 0 where the sphere has to be asked, because the ray starts near the surface.
    pub is_in_doubt: [u32; N],
}

/// Intersects many rays with a sphere, all in the same steps: a loop that the compiler makes vectors of. Of their origins and directions each
/// ray's x, y and z. `within` begins at 0 or later.
#[inline(always)]
pub fn meet_sphere_lanes<const N: usize>(
    sphere: &Sphere,
    origins: [&[f32; N]; 3],
    directions: [&[f32; N]; 3],
    within: Interval,
) -> SphereMet<N> {
    let at = |rows: [&[f32; N]; 3], lane: usize| Vec3::new(rows[0][lane], rows[1][lane], rows[2][lane]).as_dvec3();
    let (center, radius) = (sphere.center.as_dvec3(), f64::from(sphere.radius));
    let squared = radius * radius;
    let mut met = SphereMet { t: [f32::NAN; N], is_in_doubt: [0; N] };
    for lane in 0..N {
        let (from_center, direction): (DVec3, DVec3) = (at(origins, lane) - center, at(directions, lane));
        // The steps of `line_meets_sphere`.
        let a = direction.dot(direction);
        let half_b = from_center.dot(direction);
        let middle = -(half_b / a);
        let nearest = from_center + direction * middle;
        let depth = squared - nearest.dot(nearest);
        let distance = from_center.dot(from_center);
        let power = distance - squared;
        let far = middle + (depth / a).sqrt().copysign(middle);
        let other = if far == 0.0 { 0.0 } else { power / a / far };
        // In front, where the interval lies, the root of lesser magnitude comes first.
        let (first, second) = (other as f32, far as f32);
        let is_within = |t: f32| (t > within.min) & (t < within.max);
        let t = if is_within(first) { first } else { second };
        // Comparisons that a NaN fails.
        let is_met = (depth >= 0.0) & is_within(t);
        met.t[lane] = if is_met { t } else { f32::NAN };
        met.is_in_doubt[lane] =
            u32::from((depth >= 0.0) & !is_exact(power, squared) & !is_left_behind(half_b, distance, squared));
    }
    met
}
