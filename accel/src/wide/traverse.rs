//! One ray through the tree.

use geometry::{Hit, Interval, Ray, TriangleProbe};

use super::{
    Tree,
    boxes::BoxLanes,
    layout::{Block, Link, Linked, Mixed},
    simd::{Isa, Lanes, Stack},
    triangles::TriangleLanes,
};
use crate::none::closest_of;
use geometry::Primitives;

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
pub(super) fn closest<I: Isa>(isa: I, tree: &Tree, primitives: &Primitives, ray: &Ray, within: Interval) -> Option<Hit> {
    let probe = TriangleProbe::new(ray);
    let boxes = BoxLanes::new(isa, ray, within.min, tree.magnitude);
    let triangles = TriangleLanes::new(isa, ray, &probe, within.min, tree.magnitude);
    let mut nearest = closest_of(primitives, tree.beside.iter().copied(), ray, within, None);
    let mut limit = nearest.map_or(within.max, |hit| hit.t);
    let mut limits = I::F32::splat(isa, limit);
    let mut depths = triangles.limit(isa, limit);
    let mut stack = Stack::<Pending>::new();
    let mut link = tree.root;
    loop {
        while link.is_node() {
            let node = &tree.nodes[link.bits() as usize];
            let (enters, mut met) = boxes.meet(isa, node, limits);
            if met == 0 {
                break;
            }
            let first = met.trailing_zeros() as usize;
            met &= met - 1;
            if met == 0 {
                link = node.links[first & 7];
                continue;
            }
            let mut distances = [0.0; 8];
            enters.store(&mut distances);
            let entry = |slot: usize| pending(distances[slot & 7], node.links[slot & 7]);
            let mut best = entry(first);
            let second = entry(met.trailing_zeros() as usize);
            met &= met - 1;
            if met == 0 {
                let (near, far) = if best < second { (best, second) } else { (second, best) };
                stack.push(far);
                link = Link::from_bits(near as u32);
                continue;
            }
            let start = stack.len();
            let far = if second < best { std::mem::replace(&mut best, second) } else { second };
            stack.push(far);
            while met != 0 {
                let next = entry(met.trailing_zeros() as usize);
                met &= met - 1;
                let next = if next < best { std::mem::replace(&mut best, next) } else { next };
                stack.push(next);
                sink(stack.since(start));
            }
            link = Link::from_bits(best as u32);
        }
        if !link.is_node() {
            let mut visit = |block: &Block| {
                let mut candidates = triangles.candidates(isa, block, depths);
                while candidates != 0 {
                    let lane = candidates.trailing_zeros() as usize;
                    candidates &= candidates - 1;
                    if let Some(met) = probe.intersect(triangles.corners(block, lane), within) {
                        let hit = met.on(block.primitives[lane & 7]);
                        if nearest.is_none_or(|nearest| hit.is_before(nearest)) {
                            nearest = Some(hit);
                            limit = hit.t;
                            limits = I::F32::splat(isa, limit);
                            depths = triangles.limit(isa, limit);
                        }
                    }
                }
            };
            match link.linked() {
                Linked::Node(_) => {}
                Linked::Blocks { first, count } => {
                    for block in &tree.blocks[first as usize..(first + count) as usize] {
                        visit(block);
                    }
                }
                Linked::Mixed(index) => {
                    let (blocks, asked) = tree.mixed(index);
                    blocks.iter().for_each(&mut visit);
                    nearest = closest_of(primitives, asked.iter().copied(), ray, within, nearest);
                    limit = nearest.map_or(within.max, |hit| hit.t);
                    limits = I::F32::splat(isa, limit);
                    depths = triangles.limit(isa, limit);
                }
            }
        }
        loop {
            let Some(next) = stack.pop() else { return nearest };
            // A hit at just this distance may still have a lower number.
            if distance(next) <= limit {
                link = Link::from_bits(next as u32);
                break;
            }
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
    let ask = |numbers: &[u32]| numbers.iter().any(|&number| primitives.intersect(number, ray, within).is_some());
    if ask(&tree.beside) {
        return true;
    }
    let probe = TriangleProbe::new(ray);
    let boxes = BoxLanes::new(isa, ray, within.min, tree.magnitude);
    let triangles = TriangleLanes::new(isa, ray, &probe, within.min, tree.magnitude);
    let limits = I::F32::splat(isa, within.max);
    let depths = triangles.limit(isa, within.max);
    let meets = |block: &Block| {
        let mut candidates = triangles.candidates(isa, block, depths);
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            if probe.intersect(triangles.corners(block, lane), within).is_some() {
                return true;
            }
        }
        false
    };
    let mut stack = Stack::<Link>::new();
    let mut link = tree.root;
    loop {
        while link.is_node() {
            let node = &tree.nodes[link.bits() as usize];
            let (_, mut met) = boxes.meet(isa, node, limits);
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
        let found = match link.linked() {
            Linked::Node(_) => false,
            Linked::Blocks { first, count } => {
                tree.blocks[first as usize..(first + count) as usize].iter().any(meets)
            }
            Linked::Mixed(index) => {
                let (blocks, asked) = tree.mixed(index);
                blocks.iter().any(meets) || ask(asked)
            }
        };
        if found {
            return true;
        }
        match stack.pop() {
            Some(next) => link = next,
            None => return false,
        }
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
