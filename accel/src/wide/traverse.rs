//! One ray through the tree.

use geometry::{Hit, Interval, Primitives, Ray, TriangleProbe};

use super::{
    Tree,
    boxes::{BoxLanes, BoxRay},
    decide::{Aimed, Decide, Nearest},
    layout::{Block, Link, Linked, Mixed},
    simd::{Isa, Lanes, Stack},
    triangles::TriangleRay,
};
use crate::none::closest_of;

/// A node or leaf still to visit, and where the ray enters its box: the distance in the upper half, so that the entries of a node can be
/// ordered as whole numbers. (Distances below 0 come in the wrong order; the order only saves time.)
pub(super) type Pending = u64;

#[inline(always)]
pub(super) fn pending(distance: f32, link: Link) -> Pending {
    u64::from(distance.to_bits()) << 32 | u64::from(link.bits())
}

#[inline(always)]
pub(super) fn distance(pending: Pending) -> f32 {
    f32::from_bits((pending >> 32) as u32)
}

/// A ray's nearest hit.
#[inline(always)]
pub(super) fn closest<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    ray: &Ray,
    within: Interval,
) -> Option<Hit> {
    let probe = TriangleProbe::new(ray);
    let mut walk = Walk::new(isa, tree, primitives, ray, &probe, within);
    let mut stack = Stack::new();
    let mut link = tree.root;
    while let Some(next) = walk.step::<D>(link, &mut stack) {
        link = next;
    }
    D::finish(within, &probe, &walk.nearest)
}

/// A ray on its way to its nearest hit.
pub(super) struct Walk<'a, I: Isa> {
    tree: &'a Tree,
    primitives: &'a Primitives,
    ray: &'a Ray,
    boxes: BoxLanes<I>,
    aimed: Aimed<'a, I>,
    pub(super) nearest: Nearest<'a>,
}

impl<'a, I: Isa> Walk<'a, I> {
    #[inline(always)]
    pub(super) fn new(
        isa: I,
        tree: &'a Tree,
        primitives: &'a Primitives,
        ray: &'a Ray,
        probe: &'a TriangleProbe,
        within: Interval,
    ) -> Self {
        let mut walk = Self {
            tree,
            primitives,
            ray,
            boxes: BoxRay::new(ray, tree.magnitude).lanes(isa, within.min),
            aimed: Aimed {
                isa,
                within,
                probe,
                triangles: TriangleRay::new(ray, probe, within.min, tree.magnitude).lanes(isa),
            },
            nearest: Nearest::none(within),
        };
        if !tree.beside.is_empty() {
            walk.ask(&tree.beside);
        }
        walk
    }

    /// Visits a node or a leaf; returns what to visit next, if anything.
    #[inline(always)]
    pub(super) fn step<D: Decide>(&mut self, link: Link, stack: &mut Stack<Pending>) -> Option<Link> {
        if link.is_node() {
            if let Some(nearest) = self.node(link, stack) {
                return Some(nearest);
            }
        } else {
            self.leaf::<D>(link);
        }
        self.pop(stack)
    }

    /// Visits a node: the nearest of the links that the ray meets, if any; the others wait on the stack, the farthest lowest.
    #[inline(always)]
    fn node(&mut self, link: Link, stack: &mut Stack<Pending>) -> Option<Link> {
        let node = &self.tree.nodes[link.bits() as usize];
        let (enters, mut met) = self.boxes.meet(self.aimed.isa, node, self.nearest.limit);
        if met == 0 {
            return None;
        }
        let first = met.trailing_zeros() as usize;
        met &= met - 1;
        if met == 0 {
            return Some(node.links[first & 7]);
        }
        let mut distances = [0.0; 8];
        enters.store(&mut distances);
        let entry = |slot: usize| pending(distances[slot & 7], node.links[slot & 7]);
        let mut best = entry(first);
        let start = stack.len();
        while met != 0 {
            let next = entry(met.trailing_zeros() as usize);
            met &= met - 1;
            let (near, far) = if next < best { (next, best) } else { (best, next) };
            best = near;
            stack.push(far);
            if stack.len() > start + 1 {
                sink(stack.since(start));
            }
        }
        Some(Link::from_bits(best as u32))
    }

    /// Takes from the stack what the ray enters before its nearest hit.
    #[inline(always)]
    fn pop(&mut self, stack: &mut Stack<Pending>) -> Option<Link> {
        loop {
            let next = stack.pop()?;
            // A hit at just this distance may still have a lower number.
            if distance(next) <= self.nearest.limit {
                return Some(Link::from_bits(next as u32));
            }
        }
    }

    #[inline(always)]
    fn leaf<D: Decide>(&mut self, link: Link) {
        let (blocks, asked) = self.tree.leaf(link);
        for block in blocks {
            D::block(&self.aimed, block, &mut self.nearest);
        }
        if !asked.is_empty() {
            self.ask(asked);
        }
    }

    /// Asks primitives one by one.
    #[inline(always)]
    fn ask(&mut self, numbers: &[u32]) {
        let nearest = nearest_of(self.primitives, numbers, self.ray, self.aimed.within, self.nearest.hit);
        if let Some(hit) = nearest {
            self.nearest.take(hit, None);
        }
    }
}

/// A call of its own, so that what is asked one by one does not take the registers of the rest.
#[inline(never)]
pub(super) fn nearest_of(
    primitives: &Primitives,
    numbers: &[u32],
    ray: &Ray,
    within: Interval,
    nearest: Option<Hit>,
) -> Option<Hit> {
    closest_of(primitives, numbers.iter().copied(), ray, within, nearest)
}

/// Moves the last entry down to its place: the nearest last.
#[inline(always)]
pub(super) fn sink(entries: &mut [Pending]) {
    let mut place = entries.len() - 1;
    while place > 0 && entries[place - 1] < entries[place] {
        entries.swap(place - 1, place);
        place -= 1;
    }
}

/// Whether a ray meets anything.
#[inline(always)]
pub(super) fn any<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    ray: &Ray,
    within: Interval,
) -> bool {
    if !tree.beside.is_empty() && any_of(primitives, &tree.beside, ray, within) {
        return true;
    }
    let probe = &TriangleProbe::new(ray);
    let boxes = BoxRay::new(ray, tree.magnitude).lanes(isa, within.min);
    let triangles = TriangleRay::new(ray, probe, within.min, tree.magnitude).lanes(isa);
    let aimed = Aimed { isa, within, probe, triangles };
    let mut stack = Stack::<Link>::new();
    let mut link = tree.root;
    loop {
        while link.is_node() {
            let node = &tree.nodes[link.bits() as usize];
            let (_, mut met) = boxes.meet(isa, node, within.max);
            if met == 0 {
                break;
            }
            link = node.links[met.trailing_zeros() as usize & 7];
            met &= met - 1;
            while met != 0 {
                stack.push(node.links[met.trailing_zeros() as usize & 7]);
                met &= met - 1;
            }
        }
        if !link.is_node() {
            let (blocks, asked) = tree.leaf(link);
            for block in blocks {
                if D::is_met(&aimed, block) {
                    return true;
                }
            }
            if !asked.is_empty() && any_of(primitives, asked, ray, within) {
                return true;
            }
        }
        match stack.pop() {
            Some(next) => link = next,
            None => return false,
        }
    }
}

/// A call of its own, as [`nearest_of`].
#[inline(never)]
pub(super) fn any_of(primitives: &Primitives, numbers: &[u32], ray: &Ray, within: Interval) -> bool {
    numbers.iter().any(|&number| primitives.intersect(number, ray, within).is_some())
}

impl Tree {
    /// The blocks of a leaf, and what is asked one by one.
    #[inline(always)]
    pub(super) fn leaf(&self, link: Link) -> (&[Block], &[u32]) {
        match link.linked() {
            Linked::Node(_) => (&[], &[]),
            Linked::Blocks { first, count } => (&self.blocks[first as usize..(first + count) as usize], &[]),
            Linked::Mixed(index) => {
                let Mixed { first_block, blocks, first_asked, asked } = self.mixed[index as usize];
                let range = |first: u32, count: u32| first as usize..(first + count) as usize;
                (&self.blocks[range(first_block, blocks)], &self.asked[range(first_asked, asked)])
            }
        }
    }
}
