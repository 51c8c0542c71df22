//! How much of the tree a ray looks at.

use geometry::{Interval, Primitives, Ray, TriangleProbe};

use super::{
    Tree,
    decide::Decide,
    simd::{Isa, Stack},
    traverse::Walk,
};
use crate::Visits;

/// What a ray visits on its way to its nearest hit: the steps of [`super::traverse::closest`], each counted.
pub(super) fn visits<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    ray: &Ray,
    within: Interval,
) -> Visits {
    let probe = TriangleProbe::new(ray);
    let mut walk = Walk::new(isa, tree, primitives, ray, &probe, within);
    let mut visits = Visits { nodes: 0, primitives: tree.beside.len() as u64 };
    let mut stack = Stack::new();
    let mut next = Some(tree.root);
    while let Some(link) = next {
        if link.is_node() {
            visits.nodes += 1;
        } else {
            let (blocks, asked) = tree.leaf(link);
            let taken = blocks.iter().flat_map(|block| block.primitives).filter(|&number| number != u32::MAX);
            visits.primitives += (taken.count() + asked.len()) as u64;
        }
        next = walk.step::<D>(link, &mut stack);
    }
    visits
}
