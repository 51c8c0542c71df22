//! Whether each ray of a packet meets anything.

use geometry::{Interval, Primitives, Ray};

use super::{ALL, Packet, RAYS};
use crate::wide::{
    Tree,
    decide::{Asked, Decide},
    layout::{Block, Link, SLOTS},
    simd::{Isa, Line, Room, Stack, bits},
    traverse::{any_of, is_any_met},
};

/// A bit for each ray that meets anything; `None` if the rays go different ways.
#[inline(always)]
pub(in crate::wide) fn any<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    rays: &[Ray; RAYS],
    within: Interval,
) -> Option<u32> {
    let packet = Packet::new(isa, rays, within, tree.magnitude)?;
    let limits = Line([within.max; RAYS]);
    let mut room = Room::<(Link, u32)>::new();
    let mut stack = Stack::within(&mut room);
    let (mut link, mut active) = (tree.root, ALL);
    let ask = |numbers: &[u32], active: u32| packet.ask(primitives, numbers, rays, active);
    let mut found = if tree.beside.is_empty() { 0 } else { ask(&tree.beside, ALL) };
    active &= !found;
    loop {
        if link.is_node() {
            let node = &tree.nodes[link.bits() as usize];
            let (_, boxes) = packet.meet_together(node, within.max);
            for slot in bits(boxes) {
                let slot = slot & (SLOTS - 1);
                let rays = packet.meet_box(node, slot, &limits) & active;
                if rays != 0 {
                    tree.prefetch(node.links[slot]);
                    stack.push((node.links[slot], rays));
                }
            }
        } else {
            let (blocks, asked) = tree.leaf(link);
            for block in blocks {
                let met = packet.any::<D>(&tree.blocks, block, rays, active);
                found |= met;
                active &= !met;
            }
            if !asked.is_empty() {
                found |= ask(asked, active);
            }
        }
        loop {
            let Some((next, rays)) = stack.pop() else { return Some(found) };
            active = rays & !found;
            if active != 0 {
                link = next;
                break;
            }
        }
    }
}

impl<I: Isa> Packet<I> {
    /// A bit for each active ray that meets any of the primitives that are asked one by one.
    #[inline(always)]
    fn ask(&self, primitives: &Primitives, numbers: &[u32], rays: &[Ray; RAYS], mut active: u32) -> u32 {
        let mut found = 0;
        for &number in numbers {
            let sphere = self.meet_sphere(primitives, number, active);
            let asked =
                bits(sphere.unknown).filter(|&ray| any_of(primitives, &[number], &rays[ray & (RAYS - 1)], self.within));
            found |= asked.fold(sphere.met, |met, ray| met | 1 << ray);
            active &= !found;
            if active == 0 {
                break;
            }
        }
        found
    }

    /// A bit for each active ray that meets any triangle of a block.
    #[inline(always)]
    fn any<D: Decide>(&self, blocks: &[Block], block: usize, rays: &[Ray; RAYS], mut active: u32) -> u32 {
        let asked = |ray: usize| Asked { blocks, ray: &rays[ray & (RAYS - 1)], within: &self.within };
        let triangles = self.meet_block(&blocks[block]);
        let mut found = 0;
        if active.count_ones() <= triangles.count_ones() {
            for ray in bits(active) {
                let is_met = self.aimed(ray & (RAYS - 1), asked(ray)).is_met::<D>(block);
                found |= u32::from(is_met) << ray;
            }
            return found;
        }
        let limits = Line([self.within.max; RAYS]);
        for lane in bits(triangles) {
            let Some(met) = self.meet_triangle::<D>(&blocks[block], lane, &limits) else { continue };
            found |= met.certain & active;
            for ray in bits(met.possible & active & !met.certain) {
                found |= u32::from(is_any_met::<D>(asked(ray), block, 1 << lane)) << ray;
            }
            active &= !found;
            if active == 0 {
                break;
            }
        }
        found
    }
}
