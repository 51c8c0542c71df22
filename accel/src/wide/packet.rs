//! Sixteen rays that go much the same way, through the tree together.
//!
//! Rays of neighbouring pixels visit nearly the same nodes. Together, they load each node once, and most of its boxes are seen to be
//! missed, or not, by all of them at once: by the interval of all their origins and reciprocals (Boulos, Wald, Shirley: Geometric
//! and Arithmetic Culling Methods for Entire Ray Packets, 2006). Those that are left are tested sixteen rays in a step.
//!
//! ```text
//!   interval of the rays:  [1 0 1 1 0 0 0 1]  boxes that some ray may meet
//!   the rays, box 0:       0111 1111 1111 0011, box 2: 0000 0000 0011 1111 ...    pushed with these masks
//! ```
//!
//! In a leaf it is the same: of a block's triangles those are left that not all rays see on one side. Each is tested sixteen rays in a
//! step; or, where fewer rays than triangles are left, each ray against all eight as in [`super::traverse`]. The nearest hits, one of
//! each ray, are computed in `f64` at the end, all in the same steps ([`geometry::intersect_lanes`]). Of what is asked one by one, spheres are
//! asked by all rays in the same steps, too ([`geometry::meet_sphere_lanes`]).

mod any;
mod closest;
mod spheres;

use geometry::{Interval, Ray};

use super::{
    boxes::{BoxRays, SLACK, reach},
    decide::{Asked, Decide},
    layout::{Block, Node},
    simd::{Isa, Lanes, Line},
    traverse::Aimed,
    triangles::{Met, PROJECTED, TriangleRays},
};
use crate::ordinary::FARTHEST;

pub(super) use any::any;
pub(super) use closest::closest;

/// The rays of a packet.
pub(super) const RAYS: usize = 16;

/// For x, y, z: each ray's.
#[inline(always)]
fn components<I: Isa>(isa: I, of: impl Fn(usize, usize) -> f32) -> [I::F32x16; 3] {
    [
        I::F32x16::of_each(
            isa,
            #[inline(always)]
            |ray| of(ray, 0),
        ),
        I::F32x16::of_each(
            isa,
            #[inline(always)]
            |ray| of(ray, 1),
        ),
        I::F32x16::of_each(
            isa,
            #[inline(always)]
            |ray| of(ray, 2),
        ),
    ]
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
    boxes: BoxRays<Line>,
    /// Of all rays, which axis has become which.
    axes: [usize; 3],
    triangles: TriangleRays<Line>,
    /// Axes turned.
    directions: [Line; 3],
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
        let origins = components(
            isa,
            #[inline(always)]
            |ray, axis| rays[ray].origin[axis],
        );
        let directions = components(
            isa,
            #[inline(always)]
            |ray, axis| rays[ray].direction[axis],
        );
        let (zero, farthest) = (I::F32x16::splat(isa, 0.0), I::F32x16::splat(isa, FARTHEST));
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
        let reach_of_each = reach(isa, origins, magnitude);
        let boxes = BoxRays::new(isa, origins, directions, within.min, reach_of_each);
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
            reach_of_each,
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
            boxes: boxes.map(Line::of::<I>),
            axes,
            triangles: triangles.map(Line::of::<I>),
            directions: [
                Line::of::<I>(&directions[axes[0]]),
                Line::of::<I>(&directions[axes[1]]),
                Line::of::<I>(&directions[axes[2]]),
            ],
            beam,
        })
    }

    /// A number for all boxes of a node.
    #[inline(always)]
    fn of_boxes(&self, value: f32) -> I::F32x16 {
        I::F32x16::splat(self.isa, value)
    }

    /// A number for all triangles of a block.
    #[inline(always)]
    fn number(&self, value: f32) -> I::F32x8 {
        I::F32x8::splat(self.isa, value)
    }

    /// Where the first ray of all may enter each box, and a bit for each box that some ray may meet. Rounding keeps order, and this rounds less
    /// often than [`BoxRays`] allows each ray for: no box that holds a hit is lost.
    #[inline(always)]
    fn meet_together(&self, node: &Node, farthest: f32) -> (I::F32x16, u32) {
        let mut enters = self.of_boxes(self.within.min);
        let mut leaves = self.of_boxes(farthest);
        for axis in 0..3 {
            let [near, far] = node.planes_of_all(self.isa, self.sides, axis);
            let [least, greatest] = self.beam.inverses[axis];
            let (least, greatest) = (self.of_boxes(least), self.of_boxes(greatest));
            let near = near - self.of_boxes(self.beam.first[axis]);
            let far = far - self.of_boxes(self.beam.last[axis]);
            enters = enters.max((near * least).min(near * greatest));
            leaves = leaves.min((far * least).max(far * greatest));
        }
        (enters, enters.le(leaves))
    }

    /// A bit for each ray that meets a box before its limit.
    #[inline(always)]
    fn meet_box(&self, node: &Node, slot: usize, limits: &Line) -> u32 {
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
    fn meet_triangle<D: Decide>(&self, block: &Block, lane: usize, limits: &Line) -> Option<Met<I::F32x16>> {
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
