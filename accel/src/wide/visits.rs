//! How much of the tree a ray looks at.

use geometry::{Interval, Primitives, Ray};

use super::{Tree, decide::Decide, simd::Isa, traverse::search};
use crate::Visits;

/// What a ray visits on its way to its nearest hit.
pub(super) fn visits<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    ray: &Ray,
    within: &Interval,
) -> Visits {
    let mut visits = Visits { nodes: 0, primitives: tree.beside.len() as u64 };
    search::<I, D>(isa, tree, primitives, ray, within, |link| {
        if link.is_node() {
            visits.nodes += 1;
            return;
        }
        let (blocks, asked) = tree.leaf(link);
        let in_lanes = tree.blocks[blocks].iter().flat_map(|block| block.primitives);
        let taken = in_lanes.filter(|&number| number != u32::MAX);
        visits.primitives += (taken.count() + asked.len()) as u64;
    });
    visits
}
