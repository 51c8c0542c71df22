//! The nearest hit of each ray of a packet.

use geometry::{Hit, Interval, Primitives, Ray, TriangleLanes, intersect_lanes};

use super::{ALL, Packet, RAYS, components};
use crate::wide::{
    Tree,
    decide::{Asked, Decide, NO_HIT, Nearest, Place},
    layout::{Block, Link, SLOTS},
    simd::{Isa, Lanes, Line, Room, Stack, bits},
    traverse::{Pending, distance, nearest_with, pending, sink},
};

/// The nearest hit of each ray, anywhere in front of it; `false` if the rays go different ways, and nothing was done.
#[inline(always)]
pub(in crate::wide) fn closest<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    rays: &[Ray; RAYS],
    found: &mut [Option<Hit>],
) -> bool {
    let within = Interval::FORWARD;
    let Some(packet) = Packet::new(isa, rays, within, tree.magnitude) else { return false };
    let mut hits = Hits::none(&tree.blocks, rays, &within);
    if !tree.beside.is_empty() {
        hits.ask::<I, D>(&packet, primitives, &tree.beside, ALL);
    }
    let mut room = Room::<(Pending, u32)>::new();
    let mut stack = Stack::within(&mut room);
    let (mut link, mut active) = (tree.root, ALL);
    loop {
        if link.is_node() {
            let node = &tree.nodes[link.bits() as usize];
            let (enters, boxes) = packet.meet_together(node, hits.farthest);
            let Line(distances) = &Line::of::<I>(&enters);
            let start = stack.len();
            for slot in bits(boxes) {
                let slot = slot & (SLOTS - 1);
                let rays = packet.meet_box(node, slot, &hits.high) & active;
                if rays != 0 {
                    tree.prefetch(node.links[slot]);
                    stack.push((pending(distances[slot], node.links[slot]), rays));
                    sink(stack.since(start), |entry| entry.0);
                }
            }
        } else {
            let (blocks, asked) = tree.leaf(link);
            for block in blocks {
                hits.block::<I, D>(&packet, block, active);
            }
            if !asked.is_empty() {
                hits.ask::<I, D>(&packet, primitives, asked, active);
            }
            hits.farthest = hits.high.lanes(isa).greatest();
        }
        loop {
            let Some((next, rays)) = stack.pop() else {
                hits.finish::<I, D>(&packet, found);
                return true;
            };
            let enters = I::F32x16::splat(isa, distance(next));
            active = rays & enters.le(hits.high.lanes(isa));
            if active != 0 {
                link = Link::from_bits(next as u32);
                break;
            }
        }
    }
}

/// The nearest hits of a packet's rays so far: a [`Nearest`] of each, in rows.
struct Hits<'a> {
    blocks: &'a [Block],
    rays: &'a [Ray; RAYS],
    within: &'a Interval,
    low: Line,
    high: Line,
    /// The bits of each ray's [`Place`].
    places: Line,
    known: [Hit; RAYS],
    /// The greatest of `high`.
    farthest: f32,
}

impl<'a> Hits<'a> {
    #[inline(always)]
    fn none(blocks: &'a [Block], rays: &'a [Ray; RAYS], within: &'a Interval) -> Self {
        let ends = Line([within.max; RAYS]);
        let places = Line([f32::from_bits(Place::NOWHERE.bits()); RAYS]);
        Self { blocks, rays, within, low: ends, high: ends, places, known: [NO_HIT; RAYS], farthest: within.max }
    }

    #[inline(always)]
    fn asked(&self, ray: usize) -> Asked<'a> {
        Asked { blocks: self.blocks, ray: &self.rays[ray], within: self.within }
    }

    #[inline(always)]
    fn nearest(&self, ray: usize) -> Nearest {
        let place = Place::from_bits(self.places.0[ray].to_bits());
        Nearest { place, low: self.low.0[ray], high: self.high.0[ray] }
    }

    #[inline(always)]
    fn set(&mut self, ray: usize, nearest: Nearest) {
        self.places.0[ray] = f32::from_bits(nearest.place.bits());
        (self.low.0[ray], self.high.0[ray]) = (nearest.low, nearest.high);
    }

    /// Takes the nearest hits of the active rays with a block's triangles: ray by ray, or triangle by triangle, whichever are fewer.
    #[inline(always)]
    fn block<I: Isa, D: Decide>(&mut self, packet: &Packet<I>, block: usize, active: u32) {
        let triangles = packet.meet_block(&self.blocks[block]);
        if active.count_ones() <= triangles.count_ones() {
            for ray in bits(active) {
                let ray = ray & (RAYS - 1);
                let (aimed, nearest) = (packet.aimed(ray, self.asked(ray)), self.nearest(ray));
                let nearest = aimed.nearest::<D>(block, &mut self.known[ray], nearest);
                self.set(ray, nearest);
            }
        } else {
            for lane in bits(triangles) {
                self.triangle::<I, D>(packet, block, lane, active);
            }
        }
    }

    #[inline(always)]
    fn triangle<I: Isa, D: Decide>(&mut self, packet: &Packet<I>, block: usize, lane: usize, active: u32) {
        let isa = packet.isa;
        let Some(met) = packet.meet_triangle::<D>(&self.blocks[block], lane, &self.high) else { return };
        let place = Place::new(block, lane);
        let (low, high) = (self.low.lanes(isa), self.high.lanes(isa));
        let certain = met.certain & active;
        let nearer = certain & met.high.lt(low);
        self.low = Line::of::<I>(&low.or_where(nearer, met.low));
        self.high = Line::of::<I>(&high.or_where(nearer, met.high));
        let place_lanes = I::F32x16::splat(isa, f32::from_bits(place.bits()));
        self.places = Line::of::<I>(&self.places.lanes(isa).or_where(nearer, place_lanes));
        let farther = certain & high.lt(met.low);
        let close = met.possible & active & !nearer & !farther;
        if close == 0 {
            return;
        }
        let low = Line::of::<I>(&met.low);
        for ray in bits(close) {
            let ray = ray & (RAYS - 1);
            let (asked, nearest) = (self.asked(ray), self.nearest(ray));
            let nearest = nearest.or_possible::<D>(asked, &mut self.known[ray], place, low.0[ray]);
            self.set(ray, nearest);
        }
    }

    #[inline(always)]
    fn ask<I: Isa, D: Decide>(&mut self, packet: &Packet<I>, primitives: &Primitives, numbers: &[u32], active: u32) {
        for &number in numbers {
            let sphere = packet.meet_sphere(primitives, number, active);
            for ray in bits(sphere.met) {
                let ray = ray & (RAYS - 1);
                let (asked, nearest) = (self.asked(ray), self.nearest(ray));
                let hit = Hit { t: sphere.t[ray], u: 0.0, v: 0.0, primitive: number };
                let nearest = nearest.or_hit::<D>(asked, &mut self.known[ray], hit);
                self.set(ray, nearest);
            }
            for ray in bits(sphere.unknown) {
                let ray = ray & (RAYS - 1);
                let (asked, nearest) = (self.asked(ray), self.nearest(ray));
                let nearest = nearest_with::<D>(primitives, &[number], asked, &mut self.known[ray], nearest);
                self.set(ray, nearest);
            }
        }
    }

    /// One of the corners of each ray's triangle: for x, y, z, axes turned.
    #[inline(always)]
    fn corners<I: Isa>(&self, packet: &Packet<I>, places: &[Place; RAYS], corner: usize) -> [[f32; RAYS]; 3] {
        let [x, y, z] = components(
            packet.isa,
            #[inline(always)]
            |ray, axis| places[ray].coordinate(self.blocks, corner, packet.axes[axis]),
        );
        [Line::of::<I>(&x).0, Line::of::<I>(&y).0, Line::of::<I>(&z).0]
    }

    /// The nearest hits, at the end. All triangles are looked at closely in the same steps.
    #[inline(always)]
    fn finish<I: Isa, D: Decide>(&self, packet: &Packet<I>, found: &mut [Option<Hit>]) {
        let is_triangle = |ray: usize| self.nearest(ray).place.is_triangle();
        if !(0..RAYS).any(is_triangle) {
            for (ray, hit) in found.iter_mut().enumerate() {
                *hit = self.nearest(ray & (RAYS - 1)).known(self.known[ray & (RAYS - 1)]);
            }
            return;
        }
        // Rays without a triangle have any: what comes of it is not looked at.
        let mut places = [Place::new(0, 0); RAYS];
        for (ray, place) in places.iter_mut().enumerate() {
            if is_triangle(ray) {
                *place = self.nearest(ray).place;
            }
        }
        let lanes = TriangleLanes {
            origin: [packet.triangles.origin[0].0, packet.triangles.origin[1].0, packet.triangles.origin[2].0],
            direction: [packet.directions[0].0, packet.directions[1].0, packet.directions[2].0],
            corners: [
                self.corners(packet, &places, 0),
                self.corners(packet, &places, 1),
                self.corners(packet, &places, 2),
            ],
        };
        let met = intersect_lanes(&lanes);
        for (ray, hit) in found.iter_mut().enumerate() {
            let ray = ray & (RAYS - 1);
            let nearest = self.nearest(ray);
            let is_met = nearest.place.is_triangle() && met.is_in_doubt[ray] == 0 && self.within.contains(met.t[ray]);
            *hit = if is_met {
                Some(Hit { t: met.t[ray], u: met.u[ray], v: met.v[ray], primitive: places[ray].primitive(self.blocks) })
            } else {
                nearest.finish::<D>(self.asked(ray), self.known[ray])
            };
        }
    }
}
