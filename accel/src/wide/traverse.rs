//! One ray through the tree.

use std::marker::PhantomData;

use geometry::{Hit, Interval, Primitives, Ray, TriangleProbe};

use super::{
    Tree,
    boxes::BoxLanes,
    decide::Decide,
    layout::{Block, Link, Linked, Mixed},
    simd::{Isa, Lanes, Stack},
    triangles::TriangleLanes,
};
use crate::none::closest_of;

/// A node or leaf still to visit, and where the ray enters its box: the distance in the upper half, so that the entries of a node can be
/// ordered as whole numbers. (Distances below 0 come in the wrong order; the order only saves time.)
type Pending = u64;

#[inline(always)]
fn pending(distance: f32, link: Link) -> Pending {
    u64::from(distance.to_bits()) << 32 | u64::from(link.bits())
}

#[inline(always)]
fn distance(pending: Pending) -> f32 {
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
    let mut walk = Walk::<I, D>::new(isa, tree, primitives, ray, &probe, within);
    let mut stack = Stack::new();
    let mut link = tree.root;
    loop {
        if link.is_node() {
            if let Some(nearest) = walk.node(link, &mut stack) {
                link = nearest;
                continue;
            }
        } else {
            walk.leaf(link);
        }
        match walk.pop(&mut stack) {
            Some(next) => link = next,
            None => return D::finish(&walk),
        }
    }
}

/// A ray on its way to its nearest hit.
pub(super) struct Walk<'a, I: Isa, D> {
    pub(super) isa: I,
    tree: &'a Tree,
    primitives: &'a Primitives,
    ray: &'a Ray,
    pub(super) within: Interval,
    pub(super) probe: &'a TriangleProbe,
    boxes: BoxLanes<I>,
    pub(super) triangles: TriangleLanes<I>,
    pub(super) nearest: Option<Hit>,
    /// Where it stands, if in a block: for who has still to look closer.
    pub(super) place: Option<(&'a Block, usize)>,
    /// Where the nearest hit is, or the interval ends; in three forms.
    limit: f32,
    pub(super) box_limit: I::F32,
    pub(super) depth_limit: I::F32,
    decide: PhantomData<D>,
}

impl<'a, I: Isa, D: Decide> Walk<'a, I, D> {
    #[inline(always)]
    fn new(
        isa: I,
        tree: &'a Tree,
        primitives: &'a Primitives,
        ray: &'a Ray,
        probe: &'a TriangleProbe,
        within: Interval,
    ) -> Self {
        let triangles = TriangleLanes::new(isa, ray, probe, within.min, tree.magnitude);
        let mut walk = Self {
            isa,
            tree,
            primitives,
            ray,
            within,
            boxes: BoxLanes::new(isa, ray, within.min, tree.magnitude),
            nearest: None,
            place: None,
            decide: PhantomData,
            limit: within.max,
            box_limit: I::F32::splat(isa, within.max),
            depth_limit: triangles.limit(isa, within.max),
            probe,
            triangles,
        };
        if !tree.beside.is_empty() {
            walk.ask(&tree.beside);
        }
        walk
    }

    /// Visits a node: the nearest of the links that the ray meets, if any; the others wait on the stack, the farthest lowest.
    #[inline(always)]
    fn node(&mut self, link: Link, stack: &mut Stack<Pending>) -> Option<Link> {
        let node = &self.tree.nodes[link.bits() as usize];
        let (enters, mut met) = self.boxes.meet(self.isa, node, self.box_limit);
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
            if distance(next) <= self.limit {
                return Some(Link::from_bits(next as u32));
            }
        }
    }

    #[inline(always)]
    fn leaf(&mut self, link: Link) {
        let (blocks, asked) = self.tree.leaf(link);
        for block in blocks {
            D::block(self, block);
        }
        if !asked.is_empty() {
            self.ask(asked);
        }
    }

    /// A hit, if it comes before the nearest so far.
    #[inline(always)]
    pub(super) fn found(&mut self, hit: Hit, place: Option<(&'a Block, usize)>) {
        if self.nearest.is_some_and(|nearest| !hit.is_before(nearest)) {
            return;
        }
        self.nearest = Some(hit);
        self.place = place;
        self.limit = hit.t;
        self.box_limit = I::F32::splat(self.isa, hit.t);
        self.depth_limit = self.triangles.limit(self.isa, hit.t);
    }

    /// Asks primitives one by one.
    #[inline(always)]
    fn ask(&mut self, numbers: &[u32]) {
        if let Some(hit) = nearest_of(self.primitives, numbers, self.ray, self.within, self.nearest) {
            self.found(hit, None);
        }
    }
}

/// A call of its own, so that what is asked one by one does not take the registers of the rest.
#[inline(never)]
fn nearest_of(
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
fn sink(entries: &mut [Pending]) {
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
    let search =
        Search::<I, D> { decide: PhantomData, isa, tree, primitives, ray, within, probe: TriangleProbe::new(ray) };
    search.run()
}

/// A ray that looks for anything in its way.
pub(super) struct Search<'a, I: Isa, D> {
    pub(super) isa: I,
    tree: &'a Tree,
    primitives: &'a Primitives,
    ray: &'a Ray,
    pub(super) within: Interval,
    pub(super) probe: TriangleProbe,
    decide: PhantomData<D>,
}

impl<I: Isa, D: Decide> Search<'_, I, D> {
    #[inline(always)]
    fn run(&self) -> bool {
        if !self.tree.beside.is_empty() && self.ask(&self.tree.beside) {
            return true;
        }
        let boxes = BoxLanes::new(self.isa, self.ray, self.within.min, self.tree.magnitude);
        let triangles = TriangleLanes::new(self.isa, self.ray, &self.probe, self.within.min, self.tree.magnitude);
        let box_limit = I::F32::splat(self.isa, self.within.max);
        let depth_limit = triangles.limit(self.isa, self.within.max);
        let mut stack = Stack::<Link>::new();
        let mut link = self.tree.root;
        loop {
            while link.is_node() {
                let node = &self.tree.nodes[link.bits() as usize];
                let (_, mut met) = boxes.meet(self.isa, node, box_limit);
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
                let (blocks, asked) = self.tree.leaf(link);
                for block in blocks {
                    if D::is_met(self, &triangles, block, box_limit, depth_limit) {
                        return true;
                    }
                }
                if !asked.is_empty() && self.ask(asked) {
                    return true;
                }
            }
            match stack.pop() {
                Some(next) => link = next,
                None => return false,
            }
        }
    }

    #[inline(never)]
    fn ask(&self, numbers: &[u32]) -> bool {
        numbers.iter().any(|&number| self.primitives.intersect(number, self.ray, self.within).is_some())
    }
}

impl Tree {
    /// The blocks of a leaf, and what is asked one by one.
    #[inline(always)]
    fn leaf(&self, link: Link) -> (&[Block], &[u32]) {
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
