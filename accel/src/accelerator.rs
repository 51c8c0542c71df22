use geometry::{Hit, Interval, Ray};

/// Answers rays about a set of primitives.
pub trait Accelerator: Send + Sync {
    /// The nearest hit strictly within the interval; of hits at one distance the lowest primitive's.
    fn closest(&self, ray: &Ray, within: Interval) -> Option<Hit>;

    /// Whether there is any hit strictly within the interval. May stop at the first one found.
    fn any(&self, ray: &Ray, within: Interval) -> bool;

    /// The nearest hit of each ray, anywhere in front of it; `hits` is as long as `rays`.
    ///
    /// Rays that lie near each other should stand near each other: of a picture, tiles of 4 x 4 pixels, not rows.
    fn closest_many(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        for (ray, hit) in rays.iter().zip(hits) {
            *hit = self.closest(ray, Interval::FORWARD);
        }
    }

    /// Whether each ray has any hit strictly within the interval; `found` is as long as `rays`.
    fn any_many(&self, rays: &[Ray], within: Interval, found: &mut [bool]) {
        for (ray, found) in rays.iter().zip(found) {
            *found = self.any(ray, within);
        }
    }

    /// How much [`Self::closest`] looks at to answer a ray. An accelerator that does not count has nothing to tell.
    fn visits(&self, _ray: &Ray, _within: Interval) -> Visits {
        Visits::default()
    }

    /// What was built. An accelerator that builds nothing has nothing to tell.
    fn statistics(&self) -> Statistics {
        Statistics::default()
    }
}

/// What a ray looks at on its way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Visits {
    /// Nodes that lead to others.
    pub nodes: u64,
    /// Primitives that were tested, each as often as it was.
    pub primitives: u64,
}

/// What an accelerator was built of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Nodes that lead to others.
    pub branches: usize,
    /// Those that do not, and hold something.
    pub leaves: usize,
    /// Nodes that lead to others, from the root to the deepest leaf.
    pub depth: usize,
    /// Entries in the leaves: more than primitives, where one stands in several cells.
    pub references: usize,
    /// The most entries in one leaf.
    pub largest_leaf: usize,
    /// What a ray is expected to cost that passes all that it might meet, in tests of one primitive: by the surface area heuristic, for
    /// rays that meet the box around all primitives.
    pub cost: f32,
    /// Memory beside the primitives themselves.
    pub bytes: usize,
}
