use geometry::{Aabb, Ray};

use super::Truth;
use crate::accuracy::exact::Exact;

/// A ray against a closed box, and where it enters it: 0 if it starts inside. Never unclear: a box is asked so that nothing in it
/// is lost, and may be met too often, but never too seldom.
pub(crate) fn aabb(shape: &Aabb, ray: &Ray) -> Truth {
    let mut enters = Exact::from(0.0);
    let mut leaves: Option<Exact> = None;
    for axis in 0..3 {
        let (origin, direction) = (ray.origin[axis], ray.direction[axis]);
        let (low, high) = (shape.min[axis], shape.max[axis]);
        if direction == 0.0 {
            if !(low..=high).contains(&origin) {
                return Truth::Miss;
            }
            continue;
        }
        let crossing = |plane: f32| (Exact::from(plane) - Exact::from(origin)) / Exact::from(direction);
        let (one, other) = (crossing(low), crossing(high));
        enters = enters.max(one.min(other));
        let out = one.max(other);
        leaves = Some(leaves.map_or(out, |leaves| leaves.min(out)));
    }
    // The interval is open at 0: a box that is only left there holds nothing ahead.
    let met = leaves.is_none_or(|leaves| leaves.is_positive() && !(leaves - enters).is_negative());
    if met { Truth::Hit(enters) } else { Truth::Miss }
}
