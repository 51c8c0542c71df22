//! One ray through the tree.

use std::ops::Range;

use geometry::{Hit, Interval, Primitives, Ray, TriangleProbe};

use super::{
    Tree,
    boxes::{BoxRays, near_sides, reach},
    decide::{Asked, Decide, NO_HIT, Nearest, Place},
    layout::{Block, Link, Linked, Mixed, Node, SLOTS},
    simd::{Isa, Lanes, Line, Room, Stack, bits, prefetch},
    triangles::{Met, TriangleRays},
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

/// A ray made ready for nodes.
struct Bound<I: Isa> {
    isa: I,
    sides: [usize; 3],
    boxes: BoxRays<I::F32x16>,
}

impl<I: Isa> Bound<I> {
    #[inline(always)]
    fn new(isa: I, ray: &Ray, min: f32, reach: f32) -> Self {
        let boxes = BoxRays::new(isa, ray.origin.to_array(), ray.direction.to_array(), min, reach);
        let boxes = boxes.map(
            #[inline(always)]
            |&number| I::F32x16::splat(isa, number),
        );
        Self { isa, sides: near_sides(ray), boxes }
    }

    /// Where the ray enters each box of a node, and a bit for each that it enters before the limit.
    #[inline(always)]
    fn enter(&self, node: &Node, limit: f32) -> (I::F32x16, u32) {
        let limit = I::F32x16::splat(self.isa, limit);
        self.boxes.meet(
            #[inline(always)]
            |axis| node.planes_of_all(self.isa, self.sides, axis),
            limit,
        )
    }

    /// The nearest of the links of a node that the ray meets before the limit, if any; the others wait on the stack, the farthest lowest.
    #[inline(always)]
    fn visit(&self, node: &Node, limit: f32, stack: &mut Stack<Pending>) -> Option<Link> {
        let (enters, met) = self.enter(node, limit);
        if met == 0 {
            return None;
        }
        let Line(distances) = &Line::of::<I>(&enters);
        // Of one or of two: which it is cannot be foreseen, so both go the same way.
        let (first, last) = (met.trailing_zeros() as usize & (SLOTS - 1), met.ilog2() as usize & (SLOTS - 1));
        if met == 1 << first | 1 << last {
            let (one, other) =
                (pending(distances[first], node.links[first]), pending(distances[last], node.links[last]));
            let is_swapped = distances[last].to_bits() < distances[first].to_bits();
            stack.push(if is_swapped { one } else { other });
            let near = if is_swapped { node.links[last] } else { node.links[first] };
            stack.shorten(usize::from(first == last));
            return Some(near);
        }
        Some(self.visit_many(node, met, distances, stack))
    }

    #[inline(always)]
    fn visit_many(&self, node: &Node, mut met: u32, distances: &[f32; SLOTS], stack: &mut Stack<Pending>) -> Link {
        let first = met.trailing_zeros() as usize;
        met &= met - 1;
        let entry = |slot: usize| pending(distances[slot & (SLOTS - 1)], node.links[slot & (SLOTS - 1)]);
        let mut best = entry(first);
        let start = stack.len();
        while met != 0 {
            let next = entry(met.trailing_zeros() as usize);
            met &= met - 1;
            let (near, far) = if next < best { (next, best) } else { (best, next) };
            best = near;
            stack.push(far);
            if stack.len() > start + 1 {
                sink(stack.since(start), |&entry| entry);
            }
        }
        Link::from_bits(best as u32)
    }
}

/// A ray made ready for triangles.
pub(super) struct Aimed<'a, I: Isa> {
    pub(super) isa: I,
    /// Which axis the probe has made which.
    pub(super) axes: [usize; 3],
    pub(super) triangles: TriangleRays<I::F32x8>,
    pub(super) asked: Asked<'a>,
}

impl<'a, I: Isa> Aimed<'a, I> {
    #[inline(always)]
    fn new(isa: I, asked: Asked<'a>, reach: f32) -> Self {
        let (ray, probe) = (asked.ray, TriangleProbe::new(asked.ray));
        let (origin, direction) = (probe.turned(ray.origin).to_array(), probe.turned(ray.direction).to_array());
        let triangles = TriangleRays::new(isa, origin, direction, reach).map(
            #[inline(always)]
            |&number| I::F32x8::splat(isa, number),
        );
        Self { isa, axes: probe.axes(), triangles, asked }
    }

    /// What it meets of a block.
    #[inline(always)]
    fn meet<D: Decide>(&self, block: &Block, limit: f32) -> Option<Met<I::F32x8>> {
        D::meet(
            self.isa,
            &self.triangles,
            #[inline(always)]
            |corner, axis| block.of_all(self.isa, corner, self.axes[axis]),
            *self.asked.within,
            I::F32x8::splat(self.isa, limit),
        )
    }

    /// The nearest hit, so far and with a block's triangles.
    #[inline(always)]
    pub(super) fn nearest<D: Decide>(&self, block: usize, known: &mut Hit, mut nearest: Nearest) -> Nearest {
        let Some(met) = self.meet::<D>(&self.asked.blocks[block], nearest.high) else { return nearest };
        let (mut low, mut high) = ([0.0; 8], [0.0; 8]);
        met.low.store(&mut low);
        met.high.store(&mut high);
        for lane in bits(met.possible) {
            let lane = lane & 7;
            let place = Place::new(block, lane);
            nearest = if met.certain >> lane & 1 == 1 {
                nearest.or_certain::<D>(self.asked, known, place, [low[lane], high[lane]])
            } else {
                nearest.or_possible::<D>(self.asked, known, place, low[lane])
            };
        }
        nearest
    }

    /// Whether it meets any of a block's triangles.
    #[inline(always)]
    pub(super) fn is_met<D: Decide>(&self, block: usize) -> bool {
        let Some(met) = self.meet::<D>(&self.asked.blocks[block], self.asked.within.max) else { return false };
        met.certain != 0 || is_any_met::<D>(self.asked, block, met.possible)
    }
}

/// Whether any of a block's triangles that may be met is. A call of its own, for it is rare.
#[cold]
#[inline(never)]
pub(super) fn is_any_met<D: Decide>(asked: Asked, block: usize, possible: u32) -> bool {
    bits(possible).any(|lane| D::hit(asked, Place::new(block, lane), asked.within.min).is_some())
}

/// A ray's nearest hit.
#[inline(always)]
pub(super) fn closest<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    ray: &Ray,
    within: &Interval,
) -> Option<Hit> {
    search::<I, D>(isa, tree, primitives, ray, within, |_| ())
}

/// A ray's nearest hit; `visit` is shown each node and leaf on the way.
#[inline(always)]
pub(super) fn search<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    ray: &Ray,
    within: &Interval,
    mut visit: impl FnMut(Link),
) -> Option<Hit> {
    let asked = Asked { blocks: &tree.blocks, ray, within };
    let reach = reach(isa, ray.origin.to_array(), tree.magnitude);
    let (bound, aimed) = (Bound::new(isa, ray, within.min, reach), Aimed::new(isa, asked, reach));
    let (mut nearest, mut known) = (Nearest::none(*within), NO_HIT);
    if !tree.beside.is_empty() {
        nearest = nearest_with::<D>(primitives, &tree.beside, asked, &mut known, nearest);
    }
    let mut room = Room::new();
    let mut stack = Stack::within(&mut room);
    // Looked up once: the compiler cannot know that nothing changes it.
    let (nodes, mut link) = (&tree.nodes[..], tree.root);
    loop {
        visit(link);
        if link.is_node() {
            if let Some(first) = bound.visit(&nodes[link.bits() as usize], nearest.high, &mut stack) {
                link = first;
                continue;
            }
        } else {
            let (blocks, numbers) = tree.leaf(link);
            for block in blocks {
                nearest = aimed.nearest::<D>(block, &mut known, nearest);
            }
            if !numbers.is_empty() {
                nearest = nearest_with::<D>(primitives, numbers, asked, &mut known, nearest);
            }
        }
        link = loop {
            let Some(next) = stack.pop() else { return nearest.finish::<D>(asked, known) };
            // A hit at just this distance may still have a lower number.
            if distance(next) <= nearest.high {
                break Link::from_bits(next as u32);
            }
        };
    }
}

/// The nearest hit, so far and with primitives that are asked one by one.
#[inline(always)]
pub(super) fn nearest_with<D: Decide>(
    primitives: &Primitives,
    numbers: &[u32],
    asked: Asked,
    known: &mut Hit,
    nearest: Nearest,
) -> Nearest {
    match nearest_of(primitives, numbers, asked, nearest.known(*known)) {
        Some(hit) => nearest.or_hit::<D>(asked, known, hit),
        None => nearest,
    }
}

/// A call of its own, so that what is asked one by one does not take the registers of the rest.
#[cold]
#[inline(never)]
fn nearest_of(primitives: &Primitives, numbers: &[u32], asked: Asked, nearest: Option<Hit>) -> Option<Hit> {
    closest_of(primitives, numbers.iter().copied(), asked.ray, *asked.within, nearest)
}

/// Moves the last entry down to its place: the nearest last.
#[inline(always)]
pub(super) fn sink<T>(entries: &mut [T], pending: impl Fn(&T) -> Pending) {
    let mut place = entries.len() - 1;
    while place > 0 && pending(&entries[place - 1]) < pending(&entries[place]) {
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
    within: &Interval,
) -> bool {
    if !tree.beside.is_empty() && any_of(primitives, &tree.beside, ray, *within) {
        return true;
    }
    let asked = Asked { blocks: &tree.blocks, ray, within };
    let reach = reach(isa, ray.origin.to_array(), tree.magnitude);
    let (bound, aimed) = (Bound::new(isa, ray, within.min, reach), Aimed::new(isa, asked, reach));
    let mut room = Room::<Link>::new();
    let mut stack = Stack::within(&mut room);
    let mut link = tree.root;
    loop {
        while link.is_node() {
            let node = &tree.nodes[link.bits() as usize];
            let (_, mut met) = bound.enter(node, within.max);
            if met == 0 {
                break;
            }
            link = node.links[met.trailing_zeros() as usize & (SLOTS - 1)];
            met &= met - 1;
            while met != 0 {
                stack.push(node.links[met.trailing_zeros() as usize & (SLOTS - 1)]);
                met &= met - 1;
            }
        }
        if !link.is_node() {
            let (blocks, asked) = tree.leaf(link);
            for block in blocks {
                if aimed.is_met::<D>(block) {
                    return true;
                }
            }
            if !asked.is_empty() && any_of(primitives, asked, ray, *within) {
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
#[cold]
#[inline(never)]
pub(super) fn any_of(primitives: &Primitives, numbers: &[u32], ray: &Ray, within: Interval) -> bool {
    numbers.iter().any(|&number| primitives.intersect(number, ray, within).is_some())
}

impl Tree {
    /// Asks for the memory of a node, or of a leaf's first block.
    #[inline(always)]
    pub(super) fn prefetch(&self, link: Link) {
        match link.linked() {
            Linked::Node(index) => prefetch(&self.nodes[index as usize]),
            Linked::Blocks { first, .. } => prefetch(&self.blocks[first as usize]),
            Linked::Mixed(_) => {}
        }
    }

    /// The numbers of a leaf's blocks, and what is asked one by one.
    #[inline(always)]
    pub(super) fn leaf(&self, link: Link) -> (Range<usize>, &[u32]) {
        match link.linked() {
            Linked::Node(_) => (0..0, &[]),
            Linked::Blocks { first, count } => (first as usize..(first + count) as usize, &[]),
            Linked::Mixed(index) => {
                let Mixed { first_block, blocks, first_asked, asked } = self.mixed[index as usize];
                let range = |first: u32, count: u32| first as usize..(first + count) as usize;
                (range(first_block, blocks), &self.asked[range(first_asked, asked)])
            }
        }
    }
}
