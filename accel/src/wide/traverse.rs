//! One ray through the tree.

use geometry::{Hit, Interval, Primitives, Ray, TriangleProbe};

use super::{
    Tree,
    boxes::BoxLanes,
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
pub(super) fn closest<I: Isa>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    ray: &Ray,
    within: Interval,
) -> Option<Hit> {
    let mut walk = Walk::new(isa, tree, primitives, ray, within);
    let mut link = tree.root;
    loop {
        if link.is_node() {
            if let Some(nearest) = walk.node(link) {
                link = nearest;
                continue;
            }
        } else {
            walk.leaf(link);
        }
        match walk.pop() {
            Some(next) => link = next,
            None => return walk.nearest,
        }
    }
}

/// A ray on its way to its nearest hit.
struct Walk<'a, I: Isa> {
    isa: I,
    tree: &'a Tree,
    primitives: &'a Primitives,
    ray: &'a Ray,
    within: Interval,
    probe: TriangleProbe,
    boxes: BoxLanes<I>,
    triangles: TriangleLanes<I>,
    nearest: Option<Hit>,
    /// Where the nearest hit is, or the interval ends; in three forms.
    limit: f32,
    box_limit: I::F32,
    depth_limit: I::F32,
    stack: Stack<Pending>,
}

impl<'a, I: Isa> Walk<'a, I> {
    #[inline(always)]
    fn new(isa: I, tree: &'a Tree, primitives: &'a Primitives, ray: &'a Ray, within: Interval) -> Self {
        let probe = TriangleProbe::new(ray);
        let triangles = TriangleLanes::new(isa, ray, &probe, within.min, tree.magnitude);
        let mut walk = Self {
            isa,
            tree,
            primitives,
            ray,
            within,
            boxes: BoxLanes::new(isa, ray, within.min, tree.magnitude),
            nearest: None,
            limit: within.max,
            box_limit: I::F32::splat(isa, within.max),
            depth_limit: triangles.limit(isa, within.max),
            probe,
            triangles,
            stack: Stack::new(),
        };
        if !tree.beside.is_empty() {
            walk.ask(&tree.beside);
        }
        walk
    }

    /// Visits a node: the nearest of the links that the ray meets, if any; the others wait on the stack, the farthest lowest.
    #[inline(always)]
    fn node(&mut self, link: Link) -> Option<Link> {
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
        let start = self.stack.len();
        while met != 0 {
            let next = entry(met.trailing_zeros() as usize);
            met &= met - 1;
            let (near, far) = if next < best { (next, best) } else { (best, next) };
            best = near;
            self.stack.push(far);
            if self.stack.len() > start + 1 {
                sink(self.stack.since(start));
            }
        }
        Some(Link::from_bits(best as u32))
    }

    /// Takes from the stack what the ray enters before its nearest hit.
    #[inline(always)]
    fn pop(&mut self) -> Option<Link> {
        loop {
            let next = self.stack.pop()?;
            // A hit at just this distance may still have a lower number.
            if distance(next) <= self.limit {
                return Some(Link::from_bits(next as u32));
            }
        }
    }

    #[inline(always)]
    fn leaf(&mut self, link: Link) {
        let tree = self.tree;
        match link.linked() {
            Linked::Node(_) => {}
            Linked::Blocks { first, count } => {
                for block in &tree.blocks[first as usize..(first + count) as usize] {
                    self.block(block);
                }
            }
            Linked::Mixed(index) => {
                let (blocks, asked) = tree.mixed(index);
                for block in blocks {
                    self.block(block);
                }
                self.ask(asked);
            }
        }
    }

    #[inline(always)]
    fn block(&mut self, block: &Block) {
        let mut candidates = self.triangles.candidates(self.isa, block, self.depth_limit);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            if let Some(met) = self.probe.intersect(self.triangles.corners(block, lane), self.within) {
                let hit = met.on(block.primitives[lane & 7]);
                if self.nearest.is_none_or(|nearest| hit.is_before(nearest)) {
                    self.found(hit);
                }
            }
        }
    }

    #[inline(always)]
    fn found(&mut self, hit: Hit) {
        self.nearest = Some(hit);
        self.limit = hit.t;
        self.box_limit = I::F32::splat(self.isa, hit.t);
        self.depth_limit = self.triangles.limit(self.isa, hit.t);
    }

    /// Asks primitives one by one.
    #[inline(always)]
    fn ask(&mut self, numbers: &[u32]) {
        if let Some(hit) = closest_of(self.primitives, numbers.iter().copied(), self.ray, self.within, self.nearest) {
            self.found(hit);
        }
    }
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
pub(super) fn any<I: Isa>(isa: I, tree: &Tree, primitives: &Primitives, ray: &Ray, within: Interval) -> bool {
    let search = Search { isa, tree, primitives, ray, within, probe: TriangleProbe::new(ray) };
    search.run()
}

/// A ray that looks for anything in its way.
struct Search<'a, I: Isa> {
    isa: I,
    tree: &'a Tree,
    primitives: &'a Primitives,
    ray: &'a Ray,
    within: Interval,
    probe: TriangleProbe,
}

impl<I: Isa> Search<'_, I> {
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
            match link.linked() {
                Linked::Node(_) => {}
                Linked::Blocks { first, count } => {
                    for block in &self.tree.blocks[first as usize..(first + count) as usize] {
                        if self.block(&triangles, block, depth_limit) {
                            return true;
                        }
                    }
                }
                Linked::Mixed(index) => {
                    let (blocks, asked) = self.tree.mixed(index);
                    for block in blocks {
                        if self.block(&triangles, block, depth_limit) {
                            return true;
                        }
                    }
                    if self.ask(asked) {
                        return true;
                    }
                }
            }
            match stack.pop() {
                Some(next) => link = next,
                None => return false,
            }
        }
    }

    #[inline(always)]
    fn block(&self, triangles: &TriangleLanes<I>, block: &Block, depth_limit: I::F32) -> bool {
        let mut candidates = triangles.candidates(self.isa, block, depth_limit);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            if self.probe.intersect(triangles.corners(block, lane), self.within).is_some() {
                return true;
            }
        }
        false
    }

    fn ask(&self, numbers: &[u32]) -> bool {
        numbers.iter().any(|&number| self.primitives.intersect(number, self.ray, self.within).is_some())
    }
}

impl Tree {
    /// The blocks of a mixed leaf, and what is asked one by one.
    fn mixed(&self, index: u32) -> (&[Block], &[u32]) {
        let Mixed { first_block, blocks, first_asked, asked } = self.mixed[index as usize];
        let range = |first: u32, count: u32| first as usize..(first + count) as usize;
        (&self.blocks[range(first_block, blocks)], &self.asked[range(first_asked, asked)])
    }
}
