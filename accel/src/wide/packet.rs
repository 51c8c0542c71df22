//! Sixteen rays that go much the same way, through the tree together.
//!
//! Rays of neighbouring pixels visit nearly the same nodes. Together, they load each node once, and most of its boxes are seen to be
//! missed, or not, by all of them at once: by the interval of all their origins and reciprocals (Boulos, Wald, Shirley: Geometric
//! and Arithmetic Culling Methods for Entire Ray Packets, 2006). What is left is tested ray by ray, sixteen in a step; where few
//! rays are left, each against the eight boxes. In leaves each ray meets the blocks alone, as it does in [`super::traverse`]; what
//! is won there is that sixteen rays wait for nothing of each other.
//!
//! ```text
//!   interval of the rays:  [1 0 1 1 0 0 0 1]  boxes that some ray may meet
//!   the rays, box 0:       0111 1111 1111 0011, box 2: 0000 0000 0011 1111 ...    pushed with these masks
//! ```

use geometry::{Hit, Interval, Primitives, Ray, TriangleLanes, intersect_lanes};

use super::{
    Tree,
    boxes::{BoxRays, SLACK},
    decide::{Asked, Decide, NO_HIT, Nearest, Place},
    layout::{Block, Link, Node},
    simd::{Isa, Lanes, Room, Stack},
    traverse::{Aimed, Pending, any_of, distance, is_any_met, nearest_with, pending},
    triangles::{Met, PROJECTED, TriangleRays},
};
use crate::ordinary::FARTHEST;

/// The rays of a packet.
pub(super) const RAYS: usize = 16;

/// One number of each ray.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
struct Row([f32; RAYS]);

impl Row {
    #[inline(always)]
    fn of<I: Isa>(lanes: &I::F32x16) -> Self {
        let mut row = Self([0.0; RAYS]);
        lanes.store(&mut row.0);
        row
    }

    #[inline(always)]
    fn lanes<I: Isa>(&self, isa: I) -> I::F32x16 {
        I::F32x16::load(isa, &self.0)
    }
}

#[inline(always)]
fn lanes_of<I: Isa>(isa: I, rows: &[Row; 3]) -> [I::F32x16; 3] {
    [rows[0].lanes(isa), rows[1].lanes(isa), rows[2].lanes(isa)]
}

/// The least and the greatest of the lanes.
#[inline(always)]
fn range<I: Isa>(lanes: I::F32x16) -> [f32; 2] {
    [lanes.least(), lanes.greatest()]
}

/// All rays of a packet.
const ALL: u32 = (1 << RAYS) - 1;

/// The rays of a packet, ready for boxes and triangles.
struct Packet<I> {
    isa: I,
    within: Interval,
    /// Of all rays, on each axis which planes come first.
    sides: [usize; 3],
    boxes: BoxRays<Row>,
    /// Of all rays, which axis has become which.
    axes: [usize; 3],
    triangles: TriangleRays<Row>,
    /// Axes turned.
    directions: [Row; 3],
    beam: Beam,
}

/// Between what all rays of a packet lie.
struct Beam {
    /// For each axis, the moved origin from which the near planes come first, and that from which the far ones come last.
    first: [f32; 3],
    last: [f32; 3],
    /// The least and the greatest reciprocal.
    inverses: [[f32; 2]; 3],
    /// Axes turned: the least and the greatest origin, and the shear.
    origins: [[f32; 2]; 3],
    shears: [[f32; 2]; 2],
    /// How far any ray may be off what it sees of a triangle.
    slack: f32,
}

impl<I: Isa> Packet<I> {
    /// `None` if the rays go different ways, or are not ordinary.
    #[inline(always)]
    fn new(isa: I, rays: &[Ray; RAYS], within: Interval, magnitude: f32) -> Option<Self> {
        // Looked at first: of rays that go all ways, one of these differs.
        let octant = |ray: &Ray| ray.direction.is_negative_bitmask();
        if rays[1..4].iter().any(|ray| octant(ray) != octant(&rays[0])) {
            return None;
        }
        let mut rows = [[Row([0.0; RAYS]); 3]; 2];
        for (number, ray) in rays.iter().enumerate() {
            for (rows, vector) in rows.iter_mut().zip([ray.origin, ray.direction]) {
                for (row, component) in rows.iter_mut().zip(vector.to_array()) {
                    row.0[number] = component;
                }
            }
        }
        let (zero, farthest) = (I::F32x16::splat(isa, 0.0), I::F32x16::splat(isa, FARTHEST));
        let [origins, directions] = [lanes_of(isa, &rows[0]), lanes_of(isa, &rows[1])];
        let [x, y, z] = [directions[0].abs(), directions[1].abs(), directions[2].abs()];
        let largest = x.max(y).max(z);
        let mut far = I::F32x16::splat(isa, 1.0 / FARTHEST).lt(largest) ^ ALL;
        for axis in 0..3 {
            far |= (origins[axis].abs().lt(farthest) & directions[axis].abs().lt(farthest)) ^ ALL;
        }
        if far != 0 {
            return None;
        }
        // As the probe does it.
        let (x_is_largest, y_is_larger) = (y.le(x) & z.le(x), z.le(y));
        let axes = match (x_is_largest, y_is_larger) {
            (ALL, _) => [1, 2, 0],
            (0, ALL) => [2, 0, 1],
            (0, 0) => [0, 1, 2],
            _ => return None,
        };
        let boxes = BoxRays::new(isa, origins, directions, within.min, magnitude);
        let mut sides = [0; 3];
        for (side, inverse) in sides.iter_mut().zip(&boxes.inverse) {
            *side = match inverse.lt(zero) {
                0 => 0,
                ALL => 1,
                _ => return None,
            };
        }
        let triangles = TriangleRays::new(
            isa,
            [origins[axes[0]], origins[axes[1]], origins[axes[2]]],
            [directions[axes[0]], directions[axes[1]], directions[axes[2]]],
            magnitude,
        );
        let origins = [range::<I>(origins[0]), range::<I>(origins[1]), range::<I>(origins[2])];
        let mut beam = Beam {
            first: [0.0; 3],
            last: [0.0; 3],
            inverses: [range::<I>(boxes.inverse[0]), range::<I>(boxes.inverse[1]), range::<I>(boxes.inverse[2])],
            origins: [origins[axes[0]], origins[axes[1]], origins[axes[2]]],
            shears: [range::<I>(triangles.shear[0]), range::<I>(triangles.shear[1])],
            slack: 0.0,
        };
        let mut reach = magnitude;
        for axis in 0..3 {
            let [least, greatest] = origins[axis];
            reach = reach.max(magnitude + least.abs().max(greatest.abs()));
            let slack = SLACK * (least.abs().max(greatest.abs()) + magnitude);
            // Seen from a lower origin the planes of a ray upwards come later; downwards they come sooner.
            (beam.first[axis], beam.last[axis]) =
                if sides[axis] == 0 { (greatest + slack, least - slack) } else { (least - slack, greatest + slack) };
        }
        beam.slack = PROJECTED * reach;
        Some(Self {
            isa,
            within,
            sides,
            boxes: boxes.map(Row::of::<I>),
            axes,
            triangles: triangles.map(Row::of::<I>),
            directions: [rows[1][axes[0]], rows[1][axes[1]], rows[1][axes[2]]],
            beam,
        })
    }

    #[inline(always)]
    fn number(&self, value: f32) -> I::F32x8 {
        I::F32x8::splat(self.isa, value)
    }

    /// Where the first ray of all may enter each box, and a bit for each box that some ray may meet. The bounds on the rays are rounded as each
    /// ray's own crossings are, and rounding keeps order: no box is lost that a ray would meet.
    #[inline(always)]
    fn meet_together(&self, node: &Node, farthest: f32) -> (I::F32x8, u32) {
        let mut enters = self.number(self.within.min);
        let mut leaves = self.number(farthest);
        for axis in 0..3 {
            let [near, far] = node.planes_of_all(self.isa, self.sides, axis);
            let [least, greatest] = self.beam.inverses[axis];
            let (least, greatest) = (self.number(least), self.number(greatest));
            let near = near - self.number(self.beam.first[axis]);
            let far = far - self.number(self.beam.last[axis]);
            enters = enters.max((near * least).min(near * greatest));
            leaves = leaves.min((far * least).max(far * greatest));
        }
        (enters, enters.le(leaves))
    }

    /// A bit for each ray that meets a box before its limit.
    #[inline(always)]
    fn meet_box(&self, node: &Node, slot: usize, limits: &Row) -> u32 {
        let isa = self.isa;
        let rays = self.boxes.map(
            #[inline(always)]
            |row| row.lanes(isa),
        );
        let met = rays.meet::<I>(
            #[inline(always)]
            |axis| {
                let (planes, side) = (&node.planes[axis], self.sides[axis] & 1);
                [I::F32x16::splat(isa, planes[side][slot]), I::F32x16::splat(isa, planes[side ^ 1][slot])]
            },
            limits.lanes(isa),
        );
        met.1
    }

    /// A bit for each triangle of a block that some ray may meet: not for those whose corners all rays see on one side. A ray's own `x'` and `y'`
    /// are within these bounds, for rounding keeps order; and where all three are above 8u R, which [`TriangleRays`] allows for
    /// their error, so are the exact ones.
    #[inline(always)]
    fn meet_block(&self, block: &Block) -> u32 {
        let beam = &self.beam;
        let slack = self.number(beam.slack);
        let mut met = 0xFF;
        for axis in 0..2 {
            let mut lowest = self.number(f32::INFINITY);
            let mut highest = self.number(f32::NEG_INFINITY);
            let [least, greatest] = [self.number(beam.shears[axis][0]), self.number(beam.shears[axis][1])];
            for corner in 0..3 {
                let place = block.of_all(self.isa, corner, self.axes[axis]);
                let z = block.of_all(self.isa, corner, self.axes[2]);
                let (z_low, z_high) = (z - self.number(beam.origins[2][1]), z - self.number(beam.origins[2][0]));
                let (a, b, c, d) = (z_low * least, z_low * greatest, z_high * least, z_high * greatest);
                let low = place - self.number(beam.origins[axis][1]) - a.max(b).max(c.max(d));
                let high = place - self.number(beam.origins[axis][0]) - a.min(b).min(c.min(d));
                (lowest, highest) = (low.min(lowest), high.max(highest));
            }
            met &= lowest.le(slack) & (self.number(0.0) - slack).le(highest);
        }
        met
    }
}

impl<I: Isa> Packet<I> {
    /// One of the rays, ready for the triangles of a block.
    #[inline(always)]
    fn aimed<'a>(&self, ray: usize, asked: Asked<'a>) -> Aimed<'a, I> {
        let triangles = self.triangles.map(
            #[inline(always)]
            |row| self.number(row.0[ray]),
        );
        Aimed { isa: self.isa, axes: self.axes, triangles, asked }
    }

    /// Which rays meet one triangle of a block.
    #[inline(always)]
    fn meet_triangle<D: Decide>(&self, block: &Block, lane: usize, limits: &Row) -> Option<Met<I::F32x16>> {
        let isa = self.isa;
        let rays = self.triangles.map(
            #[inline(always)]
            |row| row.lanes(isa),
        );
        D::meet(
            isa,
            &rays,
            #[inline(always)]
            |corner, axis| I::F32x16::splat(isa, block.corners[corner][self.axes[axis]][lane & 7]),
            self.within,
            limits.lanes(isa),
        )
    }
}

/// The bits of a number that are set, from the lowest.
#[inline(always)]
fn bits(mut set: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lowest = (set != 0).then_some(set.trailing_zeros() as usize);
        set &= set.wrapping_sub(1);
        lowest
    })
}

/// The nearest hits of a packet's rays so far: a [`Nearest`] of each, in rows.
struct Hits<'a> {
    blocks: &'a [Block],
    rays: &'a [Ray; RAYS],
    within: &'a Interval,
    low: Row,
    high: Row,
    /// The bits of each ray's [`Place`].
    places: Row,
    known: [Hit; RAYS],
    /// The greatest of `high`.
    farthest: f32,
}

impl<'a> Hits<'a> {
    #[inline(always)]
    fn none(blocks: &'a [Block], rays: &'a [Ray; RAYS], within: &'a Interval) -> Self {
        let ends = Row([within.max; RAYS]);
        let places = Row([f32::from_bits(Place::NOWHERE.bits()); RAYS]);
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
                let ray = ray & 15;
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
        self.low = Row::of::<I>(&low.or_where(nearer, met.low));
        self.high = Row::of::<I>(&high.or_where(nearer, met.high));
        let place_lanes = I::F32x16::splat(isa, f32::from_bits(place.bits()));
        self.places = Row::of::<I>(&self.places.lanes(isa).or_where(nearer, place_lanes));
        let farther = certain & high.lt(met.low);
        let close = met.possible & active & !nearer & !farther;
        if close == 0 {
            return;
        }
        let low = Row::of::<I>(&met.low);
        for ray in bits(close) {
            let ray = ray & 15;
            let (asked, nearest) = (self.asked(ray), self.nearest(ray));
            let nearest = nearest.or_possible::<D>(asked, &mut self.known[ray], place, low.0[ray]);
            self.set(ray, nearest);
        }
    }

    #[inline(always)]
    fn ask<D: Decide>(&mut self, primitives: &Primitives, numbers: &[u32], active: u32) {
        for ray in bits(active) {
            let ray = ray & 15;
            let (asked, nearest) = (self.asked(ray), self.nearest(ray));
            let nearest = nearest_with::<D>(primitives, numbers, asked, &mut self.known[ray], nearest);
            self.set(ray, nearest);
        }
    }

    /// The nearest hits, at the end. All triangles are looked at closely in the same steps.
    #[inline(always)]
    fn finish<I: Isa, D: Decide>(&self, packet: &Packet<I>, found: &mut [Option<Hit>]) {
        let row = [0.0; RAYS];
        let mut lanes = TriangleLanes {
            origin: [packet.triangles.origin[0].0, packet.triangles.origin[1].0, packet.triangles.origin[2].0],
            direction: [packet.directions[0].0, packet.directions[1].0, packet.directions[2].0],
            corners: [[row; 3]; 3],
        };
        let mut primitives = [0; RAYS];
        for ray in 0..RAYS {
            let place = self.nearest(ray).place;
            if place.is_triangle() {
                primitives[ray] = place.primitive(self.blocks);
                for (rows, corner) in lanes.corners.iter_mut().zip(place.corners(self.blocks, packet.axes)) {
                    (rows[0][ray], rows[1][ray], rows[2][ray]) = (corner.x, corner.y, corner.z);
                }
            }
        }
        let met = intersect_lanes(&lanes);
        for (ray, hit) in found.iter_mut().enumerate() {
            let ray = ray & 15;
            let nearest = self.nearest(ray);
            let is_met = nearest.place.is_triangle() && met.is_in_doubt[ray] == 0 && self.within.contains(met.t[ray]);
            *hit = if is_met {
                Some(Hit { t: met.t[ray], u: met.u[ray], v: met.v[ray], primitive: primitives[ray] })
            } else {
                nearest.finish::<D>(self.asked(ray), self.known[ray])
            };
        }
    }
}

/// The nearest hit of each ray, anywhere in front of it; `false` if the rays go different ways, and nothing was done.
#[inline(always)]
pub(super) fn closest<I: Isa, D: Decide>(
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
        hits.ask::<D>(primitives, &tree.beside, ALL);
    }
    let mut room = Room::<(Pending, u32)>::new();
    let mut stack = Stack::within(&mut room);
    let (mut link, mut active) = (tree.root, ALL);
    loop {
        if link.is_node() {
            let node = &tree.nodes[link.bits() as usize];
            let (enters, boxes) = packet.meet_together(node, hits.farthest);
            let mut distances = [0.0; 8];
            enters.store(&mut distances);
            let start = stack.len();
            for slot in bits(boxes) {
                let slot = slot & 7;
                let rays = packet.meet_box(node, slot, &hits.high) & active;
                if rays != 0 {
                    stack.push((pending(distances[slot], node.links[slot]), rays));
                    sink(stack.since(start));
                }
            }
        } else {
            let (blocks, asked) = tree.leaf(link);
            for block in blocks {
                hits.block::<I, D>(&packet, block, active);
            }
            if !asked.is_empty() {
                hits.ask::<D>(primitives, asked, active);
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

/// Moves the last entry down to its place: the nearest last.
#[inline(always)]
fn sink(entries: &mut [(Pending, u32)]) {
    let mut place = entries.len() - 1;
    while place > 0 && entries[place - 1].0 < entries[place].0 {
        entries.swap(place - 1, place);
        place -= 1;
    }
}

/// A bit for each ray that meets anything; `None` if the rays go different ways.
#[inline(always)]
pub(super) fn any<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    rays: &[Ray; RAYS],
    within: Interval,
) -> Option<u32> {
    let packet = Packet::new(isa, rays, within, tree.magnitude)?;
    let limits = Row([within.max; RAYS]);
    let mut room = Room::<(Link, u32)>::new();
    let mut stack = Stack::within(&mut room);
    let (mut link, mut active) = (tree.root, ALL);
    let ask = |numbers: &[u32], active: u32| {
        bits(active)
            .filter(|&ray| any_of(primitives, numbers, &rays[ray & 15], within))
            .fold(0, |met, ray| met | 1 << ray)
    };
    let mut found = if tree.beside.is_empty() { 0 } else { ask(&tree.beside, ALL) };
    active &= !found;
    loop {
        if link.is_node() {
            let node = &tree.nodes[link.bits() as usize];
            let (_, boxes) = packet.meet_together(node, within.max);
            for slot in bits(boxes) {
                let slot = slot & 7;
                let rays = packet.meet_box(node, slot, &limits) & active;
                if rays != 0 {
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
    /// A bit for each active ray that meets any triangle of a block.
    #[inline(always)]
    fn any<D: Decide>(&self, blocks: &[Block], block: usize, rays: &[Ray; RAYS], mut active: u32) -> u32 {
        let asked = |ray: usize| Asked { blocks, ray: &rays[ray & 15], within: &self.within };
        let triangles = self.meet_block(&blocks[block]);
        let mut found = 0;
        if active.count_ones() <= triangles.count_ones() {
            for ray in bits(active) {
                let is_met = self.aimed(ray & 15, asked(ray)).is_met::<D>(block);
                found |= u32::from(is_met) << ray;
            }
            return found;
        }
        let limits = Row([self.within.max; RAYS]);
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
