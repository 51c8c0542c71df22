use geometry::{Hit, Interval, Primitives, Ray};

use crate::{Accelerator, Statistics, Visits};

/// No acceleration: every primitive is asked. The definition of the right answer.
pub fn none(primitives: Primitives) -> Box<dyn Accelerator> {
    Box::new(EveryPrimitive { primitives })
}

struct EveryPrimitive {
    primitives: Primitives,
}

impl Accelerator for EveryPrimitive {
    fn closest(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        closest_of_all(&self.primitives, ray, within)
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        any_of_all(&self.primitives, ray, within)
    }

    fn visits(&self, _ray: &Ray, _within: Interval) -> Visits {
        visits_of_all(&self.primitives)
    }

    /// One leaf, in which all stand.
    fn statistics(&self) -> Statistics {
        let count = self.primitives.len() as usize;
        Statistics { leaves: 1, references: count, largest_leaf: count, cost: count as f32, ..Statistics::default() }
    }
}

/// The nearest hit of all primitives.
pub(crate) fn closest_of_all(primitives: &Primitives, ray: &Ray, within: Interval) -> Option<Hit> {
    closest_of(primitives, 0..primitives.len(), ray, within, None)
}

/// Whether any primitive is hit.
pub(crate) fn any_of_all(primitives: &Primitives, ray: &Ray, within: Interval) -> bool {
    (0..primitives.len()).any(|number| primitives.intersect(number, ray, within).is_some())
}

/// What is looked at when every primitive is asked.
pub(crate) fn visits_of_all(primitives: &Primitives) -> Visits {
    Visits { nodes: 0, primitives: u64::from(primitives.len()) }
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
