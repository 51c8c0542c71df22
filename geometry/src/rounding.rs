//! The rounding unit, and bounds that must not be narrower than the truth.

use glam::{DVec3, Vec3};

/// Half the distance from 1 to the next `f32`: the largest relative error of one rounding to `f32`.
pub(crate) const UNIT_ROUNDOFF: f32 = f32::EPSILON / 2.0;

/// The largest `f32` vector that is nowhere greater than the `f64` one.
pub(crate) fn round_down(v: DVec3) -> Vec3 {
    let nearest = v.as_vec3();
    let down = |nearest: f32, exact: f64| if f64::from(nearest) > exact { nearest.next_down() } else { nearest };
    Vec3::new(down(nearest.x, v.x), down(nearest.y, v.y), down(nearest.z, v.z))
}

/// The smallest `f32` vector that is nowhere less than the `f64` one.
pub(crate) fn round_up(v: DVec3) -> Vec3 {
    -round_down(-v)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rounding_unit_is_the_most_that_is_rounded_away_from_1() {
        assert_eq!(1.0 + UNIT_ROUNDOFF, 1.0);
        assert_eq!(1.0 + UNIT_ROUNDOFF.next_up(), 1.0 + f32::EPSILON);
    }

    #[test]
    fn rounding_outwards_keeps_the_exact_value_between() {
        let third = DVec3::splat(1.0 / 3.0);
        assert!(round_down(third).as_dvec3().cmplt(third).all());
        assert!(round_up(third).as_dvec3().cmpgt(third).all());
        assert_eq!(round_up(third).x, round_down(third).x.next_up());
    }

    #[test]
    fn rounding_outwards_leaves_exact_values_alone() {
        let v = DVec3::new(0.5, -2.0, 0.0);
        assert_eq!(round_down(v), v.as_vec3());
        assert_eq!(round_up(v), v.as_vec3());
    }
}
