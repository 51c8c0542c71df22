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

use geometry::{Hit, Interval, Primitives, Ray, TriangleProbe};

use super::{
    Tree,
    boxes::{BoxLanes, NEGLIGIBLE, SLACK},
    decide::{Aimed, Decide, Nearest},
    layout::{Link, Node},
    simd::{Isa, Lanes, Stack, splat},
    traverse::{Pending, any_of, distance, nearest_of, pending},
    triangles::TriangleRay,
};
use crate::ordinary::FARTHEST;

/// The rays of a packet.
pub(super) const RAYS: usize = 16;

/// So many rays and no more are tested each against all eight boxes of a node, not all against each.
const FEW: u32 = 4;

/// One number of each ray, in two vectors.
type Row = [[f32; 8]; 2];

/// The rays of a packet, ready for boxes.
struct Packet {
    near: [Row; 3],
    far: [Row; 3],
    inverse: [Row; 3],
    sides: [usize; 3],
    /// Of all rays, for each axis, the moved origin from which the near planes come first, and that from which the far ones come last.
    first: [f32; 3],
    last: [f32; 3],
    /// The least and the greatest reciprocal.
    inverses: [[f32; 3]; 2],
    min: f32,
}

/// What a packet meets in a node: for each box, which rays do, and where the first of them may enter it.
struct Met {
    rays: [u32; 8],
    distances: [f32; 8],
}

impl Packet {
    /// `None` if the rays go different ways, or are not ordinary. As [`BoxRay`](super::boxes::BoxRay), eight rays in a step.
    #[inline(always)]
    fn new<I: Isa>(isa: I, rays: &[Ray; RAYS], min: f32, magnitude: f32) -> Option<Self> {
        // Looked at first: of rays that go all ways, the second or third differs.
        let octant = |ray: &Ray| ray.direction.is_negative_bitmask();
        if rays.iter().any(|ray| octant(ray) != octant(&rays[0])) {
            return None;
        }
        let empty = [[[0.0; 8]; 2]; 3];
        let (mut origins, mut directions) = (empty, empty);
        for (number, ray) in rays.iter().enumerate() {
            let (half, lane) = (number / 8, number % 8);
            for axis in 0..3 {
                origins[axis][half][lane] = ray.origin.to_array()[axis];
                directions[axis][half][lane] = ray.direction.to_array()[axis];
            }
        }
        let mut packet = Self {
            near: empty,
            far: empty,
            inverse: empty,
            sides: [0; 3],
            first: [0.0; 3],
            last: [0.0; 3],
            inverses: [[0.0; 3]; 2],
            min,
        };
        let zero = I::F32::splat(isa, 0.0);
        let one = I::F32::splat(isa, 1.0);
        let farthest = I::F32::splat(isa, FARTHEST);
        let nearest = I::F32::splat(isa, 1.0 / FARTHEST);
        let magnitudes = I::F32::splat(isa, magnitude);
        let (mut near_origins, mut far_origins) = (empty, empty);
        let (mut ordinary, mut down) = (0xFF, [0; 3]);
        for half in 0..2 {
            let x = I::F32::load(isa, &directions[0][half]).abs();
            let y = I::F32::load(isa, &directions[1][half]).abs();
            let z = I::F32::load(isa, &directions[2][half]).abs();
            let largest = x.max(y).max(z);
            ordinary &= x.lt(farthest) & y.lt(farthest) & z.lt(farthest) & nearest.lt(largest);
            let floor = (largest * I::F32::splat(isa, NEGLIGIBLE)).max(I::F32::splat(isa, f32::MIN_POSITIVE));
            for axis in 0..3 {
                let origin = I::F32::load(isa, &origins[axis][half]);
                let direction = I::F32::load(isa, &directions[axis][half]);
                ordinary &= origin.abs().lt(farthest);
                let direction = direction.abs().max(floor).with_sign_of(direction);
                let inverse = one / direction;
                let slack = I::F32::splat(isa, SLACK) * (origin.abs() + magnitudes);
                let forward = slack.with_sign_of(direction);
                let (near, far) = (origin + forward, origin - forward);
                near.store(&mut near_origins[axis][half]);
                far.store(&mut far_origins[axis][half]);
                (near * inverse).store(&mut packet.near[axis][half]);
                (far * inverse).store(&mut packet.far[axis][half]);
                inverse.store(&mut packet.inverse[axis][half]);
                down[axis] |= direction.lt(zero) << (8 * half);
            }
        }
        if ordinary != 0xFF {
            return None;
        }
        for axis in 0..3 {
            let (least_inverse, greatest_inverse) = range(isa, &packet.inverse[axis]);
            packet.inverses[0][axis] = least_inverse;
            packet.inverses[1][axis] = greatest_inverse;
            let (near, far) = (range(isa, &near_origins[axis]), range(isa, &far_origins[axis]));
            packet.sides[axis] = usize::from(down[axis] != 0);
            // Seen from a lower origin the planes of a ray upwards come later; downwards they come sooner.
            (packet.first[axis], packet.last[axis]) = if down[axis] == 0 { (near.1, far.0) } else { (near.0, far.1) };
        }
        Some(packet)
    }

    /// What the active rays meet in a node before their limits.
    #[inline(always)]
    fn meet<I: Isa>(&self, isa: I, node: &Node, active: u32, limits: &Row) -> Met {
        if active.count_ones() <= FEW {
            return self.meet_each(isa, node, active, limits);
        }
        let (enters, mut boxes) = self.meet_together(isa, node, limits);
        let mut met = Met { rays: [0; 8], distances: [0.0; 8] };
        enters.store(&mut met.distances);
        while boxes != 0 {
            let slot = boxes.trailing_zeros() as usize & 7;
            boxes &= boxes - 1;
            let low = self.meet_box(isa, node, slot, 0, limits);
            let high = self.meet_box(isa, node, slot, 1, limits);
            met.rays[slot] = (low | high << 8) & active;
        }
        met
    }

    /// Where the first ray of all may enter each box, and a bit for each box that some ray may meet. The bounds on the rays are rounded as each
    /// ray's own crossings are, and rounding keeps order: no box is lost that a ray would meet.
    #[inline(always)]
    fn meet_together<I: Isa>(&self, isa: I, node: &Node, limits: &Row) -> (I::F32, u32) {
        let farthest = limits.as_flattened().iter().fold(f32::NEG_INFINITY, |a, &b| if a > b { a } else { b });
        let mut enters = I::F32::splat(isa, self.min);
        let mut leaves = I::F32::splat(isa, farthest);
        for axis in 0..3 {
            let side = self.sides[axis] & 1;
            let least = I::F32::splat(isa, self.inverses[0][axis]);
            let greatest = I::F32::splat(isa, self.inverses[1][axis]);
            let near = I::F32::load(isa, &node.planes[axis][side]) - I::F32::splat(isa, self.first[axis]);
            let far = I::F32::load(isa, &node.planes[axis][side ^ 1]) - I::F32::splat(isa, self.last[axis]);
            enters = enters.max((near * least).min(near * greatest));
            leaves = leaves.min((far * least).max(far * greatest));
        }
        (enters, enters.le(leaves))
    }

    /// A bit for each of eight rays that meets a box.
    #[inline(always)]
    fn meet_box<I: Isa>(&self, isa: I, node: &Node, slot: usize, half: usize, limits: &Row) -> u32 {
        let mut enters = I::F32::splat(isa, self.min);
        let mut leaves = I::F32::load(isa, &limits[half]);
        for axis in 0..3 {
            let side = self.sides[axis] & 1;
            let near = I::F32::splat(isa, node.planes[axis][side][slot]);
            let far = I::F32::splat(isa, node.planes[axis][side ^ 1][slot]);
            let inverse = I::F32::load(isa, &self.inverse[axis][half]);
            enters = enters.max(near.times_less(inverse, I::F32::load(isa, &self.near[axis][half])));
            leaves = leaves.min(far.times_less(inverse, I::F32::load(isa, &self.far[axis][half])));
        }
        enters.le(leaves)
    }

    /// Ray by ray, against all boxes.
    #[inline(always)]
    fn meet_each<I: Isa>(&self, isa: I, node: &Node, mut active: u32, limits: &Row) -> Met {
        let mut met = Met { rays: [0; 8], distances: [f32::INFINITY; 8] };
        let mut nearest = I::F32::splat(isa, f32::INFINITY);
        while active != 0 {
            let ray = active.trailing_zeros() as usize & 15;
            active &= active - 1;
            let (half, lane) = (ray / 8, ray % 8);
            let boxes = BoxLanes::<I> {
                near: splat(isa, at(&self.near, half, lane)),
                far: splat(isa, at(&self.far, half, lane)),
                inverse: splat(isa, at(&self.inverse, half, lane)),
                sides: self.sides,
                min: I::F32::splat(isa, self.min),
            };
            let (enters, mut boxes) = boxes.meet(isa, node, limits[half][lane]);
            nearest = nearest.min(enters);
            while boxes != 0 {
                met.rays[boxes.trailing_zeros() as usize & 7] |= 1 << ray;
                boxes &= boxes - 1;
            }
        }
        nearest.store(&mut met.distances);
        met
    }
}

/// The least and the greatest of sixteen numbers.
#[inline(always)]
fn range<I: Isa>(isa: I, row: &Row) -> (f32, f32) {
    let (low, high) = (I::F32::load(isa, &row[0]), I::F32::load(isa, &row[1]));
    let (mut least, mut greatest) = ([0.0; 8], [0.0; 8]);
    low.min(high).store(&mut least);
    low.max(high).store(&mut greatest);
    let least = least.into_iter().fold(f32::INFINITY, |a, b| if a < b { a } else { b });
    let greatest = greatest.into_iter().fold(f32::NEG_INFINITY, |a, b| if a > b { a } else { b });
    (least, greatest)
}

/// A ray of a packet, made ready for triangles when it first comes to a leaf.
type Ready = Option<(TriangleProbe, TriangleRay)>;

#[inline(always)]
fn ready<'a>(ready: &'a mut Ready, ray: &Ray, min: f32, magnitude: f32) -> &'a (TriangleProbe, TriangleRay) {
    if ready.is_none() {
        let probe = TriangleProbe::new(ray);
        let triangles = TriangleRay::new(ray, &probe, min, magnitude);
        *ready = Some((probe, triangles));
    }
    ready.as_ref().expect("just made")
}

#[inline(always)]
fn at(rows: &[Row; 3], half: usize, lane: usize) -> [f32; 3] {
    [rows[0][half][lane], rows[1][half][lane], rows[2][half][lane]]
}

/// The nearest hit of each ray, anywhere in front of it; `false` if the rays go different ways, and nothing was done.
#[inline(always)]
pub(super) fn closest<I: Isa, D: Decide>(
    isa: I,
    tree: &Tree,
    primitives: &Primitives,
    rays: &[Ray; RAYS],
    hits: &mut [Option<Hit>],
) -> bool {
    let within = Interval::FORWARD;
    let Some(packet) = Packet::new(isa, rays, within.min, tree.magnitude) else { return false };
    let mut readies = [const { Ready::None }; RAYS];
    let mut nearest = [Nearest::none(within); RAYS];
    let mut limits: Row = [[within.max; 8]; 2];
    let mut stack = Stack::<(Pending, u32)>::new();
    let (mut link, mut active) = (tree.root, (1 << RAYS) - 1);
    let ask = |nearest: &mut Nearest, ray: usize, numbers: &[u32]| {
        if let Some(hit) = nearest_of(primitives, numbers, &rays[ray], within, nearest.hit) {
            nearest.take(hit, None);
        }
    };
    if !tree.beside.is_empty() {
        for ray in 0..RAYS {
            ask(&mut nearest[ray], ray, &tree.beside);
            limits[ray / 8][ray % 8] = nearest[ray].limit;
        }
    }
    loop {
        if link.is_node() {
            let node = &tree.nodes[link.bits() as usize];
            let met = packet.meet(isa, node, active, &limits);
            push(&mut stack, node, &met);
        } else {
            let (blocks, asked) = tree.leaf(link);
            let mut waiting = active;
            while waiting != 0 {
                let ray = waiting.trailing_zeros() as usize & 15;
                waiting &= waiting - 1;
                let (probe, triangles) = ready(&mut readies[ray], &rays[ray], within.min, tree.magnitude);
                let aimed = Aimed { isa, within, probe, triangles: triangles.lanes(isa) };
                for block in blocks {
                    D::block(&aimed, block, &mut nearest[ray]);
                }
                if !asked.is_empty() {
                    ask(&mut nearest[ray], ray, asked);
                }
                limits[ray / 8][ray % 8] = nearest[ray].limit;
            }
        }
        loop {
            let Some((next, rays)) = stack.pop() else {
                for (ray, hit) in hits.iter_mut().enumerate() {
                    *hit = readies[ray]
                        .as_ref()
                        .map_or(nearest[ray].hit, |(probe, _)| D::finish(within, probe, &nearest[ray]));
                }
                return true;
            };
            let enters = I::F32::splat(isa, distance(next));
            let low = enters.le(I::F32::load(isa, &limits[0]));
            let high = enters.le(I::F32::load(isa, &limits[1]));
            active = rays & (low | high << 8);
            if active != 0 {
                link = Link::from_bits(next as u32);
                break;
            }
        }
    }
}

/// Pushes what was met, the nearest last.
#[inline(always)]
fn push(stack: &mut Stack<(Pending, u32)>, node: &Node, met: &Met) {
    let start = stack.len();
    for slot in 0..8 {
        if met.rays[slot] == 0 {
            continue;
        }
        stack.push((pending(met.distances[slot], node.links[slot]), met.rays[slot]));
        let entries = stack.since(start);
        let mut place = entries.len() - 1;
        while place > 0 && entries[place - 1].0 < entries[place].0 {
            entries.swap(place - 1, place);
            place -= 1;
        }
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
    let packet = Packet::new(isa, rays, within.min, tree.magnitude)?;
    let mut readies = [const { Ready::None }; RAYS];
    let limits: Row = [[within.max; 8]; 2];
    let mut stack = Stack::<(Link, u32)>::new();
    let (mut link, mut active) = (tree.root, (1 << RAYS) - 1);
    let ask = |ray: usize, numbers: &[u32]| any_of(primitives, numbers, &rays[ray], within);
    let mut found = 0;
    if !tree.beside.is_empty() {
        for ray in 0..RAYS {
            found |= u32::from(ask(ray, &tree.beside)) << ray;
        }
        active &= !found;
    }
    loop {
        if link.is_node() {
            let node = &tree.nodes[link.bits() as usize];
            let met = packet.meet(isa, node, active, &limits);
            for slot in 0..8 {
                if met.rays[slot] != 0 {
                    stack.push((node.links[slot], met.rays[slot]));
                }
            }
        } else {
            let (blocks, asked) = tree.leaf(link);
            while active != 0 {
                let ray = active.trailing_zeros() as usize & 15;
                active &= active - 1;
                let (probe, triangles) = ready(&mut readies[ray], &rays[ray], within.min, tree.magnitude);
                let aimed = Aimed { isa, within, probe, triangles: triangles.lanes(isa) };
                let mut is_met = false;
                for block in blocks {
                    is_met = is_met || D::is_met(&aimed, block);
                }
                is_met = is_met || (!asked.is_empty() && ask(ray, asked));
                found |= u32::from(is_met) << ray;
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
