//! Rays that go all ways, in turn.
//!
//! A ray waits: for a node from a far cache, for the compare that tells which box comes next. Other rays can be traced meanwhile. So a
//! few rays are on their way at a time, each takes one step in its turn, and asks for the memory of its next one.

use std::array::from_fn;

use geometry::{Hit, Interval, Primitives, Ray, TriangleProbe};

use super::{
    Tree,
    decide::Decide,
    layout::Link,
    simd::{Isa, Stack},
    traverse::{Pending, Walk},
};

/// Rays on their way at a time.
pub(super) const RAYS: usize = 4;

/// The nearest hit of each of a few ordinary rays, anywhere in front of it.
#[inline(always)]
pub(super) fn closest<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    rays: &[Ray; RAYS],
    hits: &mut [Option<Hit>],
) {
    let within = Interval::FORWARD;
    let probes = rays.each_ref().map(TriangleProbe::new);
    // Written out: a closure would not be compiled with the instruction set.
    let mut walks: [Walk<I>; RAYS] = [
        Walk::new(isa, tree, primitives, &rays[0], &probes[0], within),
        Walk::new(isa, tree, primitives, &rays[1], &probes[1], within),
        Walk::new(isa, tree, primitives, &rays[2], &probes[2], within),
        Walk::new(isa, tree, primitives, &rays[3], &probes[3], within),
    ];
    let mut stacks: [Stack<Pending>; RAYS] = from_fn(|_| Stack::new());
    let mut links: [Option<Link>; RAYS] = [Some(tree.root); RAYS];
    let mut on_their_way = RAYS;
    while on_their_way > 0 {
        for ray in 0..RAYS {
            if let Some(link) = links[ray] {
                links[ray] = walks[ray].step::<D>(link, &mut stacks[ray]);
                match links[ray] {
                    Some(next) => tree.fetch(isa, next),
                    None => on_their_way -= 1,
                }
            }
        }
    }
    for (ray, hit) in hits.iter_mut().enumerate() {
        *hit = D::finish(within, &probes[ray], &walks[ray].nearest);
    }
}
