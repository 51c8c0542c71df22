use geometry::{Hit, Interval, Primitives, Ray};

use crate::Accelerator;

/// No acceleration: every primitive is asked. The definition of the right answer.
pub fn none(primitives: Primitives) -> Box<dyn Accelerator> {
    Box::new(EveryPrimitive { primitives })
}

struct EveryPrimitive {
    primitives: Primitives,
}

impl Accelerator for EveryPrimitive {
    fn closest(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        closest_of(&self.primitives, 0..self.primitives.len(), ray, within, None)
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        (0..self.primitives.len()).any(|number| self.primitives.intersect(number, ray, within).is_some())
    }
}

/// The nearest of `nearest` and the hits of the numbered primitives, by the order of [`Hit::is_before`].
pub(crate) fn closest_of(
    primitives: &Primitives,
    numbers: impl IntoIterator<Item = u32>,
    ray: &Ray,
    within: Interval,
    mut nearest: Option<Hit>,
) -> Option<Hit> {
    for number in numbers {
        if let Some(hit) = primitives.intersect(number, ray, within)
            && nearest.is_none_or(|nearest| hit.is_before(nearest))
        {
            nearest = Some(hit);
        }
    }
    nearest
}
