//! The octree, made for a processor that does many things at once.
//!
//! The plain octree spends its time on one box, one plane, one primitive after the other, each waiting for the last. Here the cells are the same:
//! a cube around all primitives, halved and halved again. But each primitive stands in one cell only, the one of its centre, and what a
//! ray is tested against is the tight box of what a cell holds. That frees the tree to show its cells in any grouping, and the
//! grouping that costs a ray least is found. Long thin triangles may stand in pieces, each in its own cell, if that costs less.
//!
//! ```text
//!   primitives --> codes, sorted --> cells --> cheapest cuts --> nodes of 16 boxes      --> ray: 16 boxes in a step
//!    pieces.rs       morton.rs      cells.rs   collapse.rs       blocks of eight triangles       eight triangles in a step
//!                                  cheapest.rs  slot.rs          layout.rs, rows.rs, build.rs   boxes.rs, triangles.rs, traverse.rs
//! ```
//!
//! `f32` is precise enough to leave out most of what is missed, and to be certain of most of what is met: `boxes.rs` and `triangles.rs` argue how
//! far their steps may be off, and pass on what they cannot tell; `decide.rs` then asks `geometry`, and once more for where the nearest
//! is met. `packet.rs` traces many rays at once. `simd.rs` is the only place that knows the processor.
//!
//! A box test or a triangle test of someone else's ([`geometry::Kernels`]): triangles are then asked one by one, and boxes are still tested here.

mod boxes;
mod build;
mod cells;
mod cheapest;
mod collapse;
mod decide;
mod layout;
mod morton;
mod packet;
mod pieces;
mod rows;
mod simd;
mod slot;
mod step;
mod traverse;
mod triangles;
mod visits;

use std::hint::cold_path;
use std::marker::PhantomData;
use std::sync::LazyLock;

use geometry::{Hit, Interval, Primitives, Ray};

use crate::{
    Accelerator, Statistics, Visits,
    none::{any_of_all, closest_of_all, visits_of_all},
    ordinary::is_ordinary,
};
use decide::{Decide, Exact, Watertight};
use layout::{Block, Link, Mixed, Node, SLOTS};
use simd::{Isa, Portable};
pub use step::Step;

/// Levels of wide nodes, at most: below the 21 levels of the Morton codes 11 of rows cut in eight (8^11 > 2^32), and in each cell a
/// node for a whole, a half and a pair.
const MOST_LEVELS: usize = 3 * (21 + 11);

/// What a ray can have to visit, at most: of each level the slots that it is not in.
const MOST_PENDING: usize = (SLOTS - 1) * MOST_LEVELS + 1;

/// Builds the wide octree; its hits are those of [`crate::none`], bit for bit.
pub fn wide(primitives: Primitives) -> Box<dyn Accelerator> {
    best(primitives, Hits::Exact, Step::ThinInPieces)
}

/// Builds the wide octree, with hits decided in `f32`: see [`Hits::Watertight`].
pub fn wide_watertight(primitives: Primitives) -> Box<dyn Accelerator> {
    best(primitives, Hits::Watertight, Step::ThinInPieces)
}

/// How the wide octree decides whether a ray meets a triangle of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hits {
    /// In `f64`, by [`geometry::TriangleProbe`]: as every other accelerator does.
    Exact,
    /// In `f32`, by edge functions that leave no gap between triangles that share an edge. Faster; `t`, `u` and `v` of the nearest are
    /// computed in `f64`. A ray aimed at an edge may meet the other one of the triangles there.
    Watertight,
}

/// The instructions that the wide octree can be traversed with. All give the same hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// x86-64 with AVX-512 (F, VL, DQ).
    Avx512,
    /// x86-64 with AVX2 and FMA.
    Avx2,
    /// Any processor.
    Portable,
}

impl Instructions {
    /// From the fastest to the slowest.
    pub const ALL: [Self; 3] = [Self::Avx512, Self::Avx2, Self::Portable];
}

/// Builds the wide octree up to a step; its hits are those of [`crate::none`], bit for bit, as well.
pub fn wide_up_to(primitives: Primitives, step: Step) -> Box<dyn Accelerator> {
    best(primitives, Hits::Exact, step)
}

fn best(primitives: Primitives, hits: Hits, step: Step) -> Box<dyn Accelerator> {
    Traversal::best().over(primitives, hits, step)
}

/// Runs code compiled for the widest vectors that this processor has: for loops over many numbers that the compiler makes vectors of. Its results
/// are those that it has otherwise, bit for bit.
///
/// The closure, and all that it calls, must be `#[inline(always)]` to be compiled so.
///
/// ```
/// let numbers = std::hint::black_box([1.0 + f32::EPSILON; 16]);
/// let squares = accel::vectorize(
///     #[inline(always)]
///     || numbers.map(|number| number * number - (1.0 + 2.0 * f32::EPSILON)),
/// );
/// // The product is rounded before the difference: in one step, as the processor could, it would be 1.4e-14.
/// assert_eq!(squares, [0.0; 16]);
/// ```
#[inline]
pub fn vectorize<R>(code: impl FnOnce() -> R) -> R {
    static BEST: LazyLock<Traversal> = LazyLock::new(Traversal::best);
    match *BEST {
        #[cfg(target_arch = "x86_64")]
        Traversal::Avx512(isa) => isa.vectorize(code),
        #[cfg(target_arch = "x86_64")]
        Traversal::Avx2(isa) => isa.vectorize(code),
        Traversal::Portable(isa) => isa.vectorize(code),
    }
}

/// Builds the wide octree to be traversed with the instructions named; `None` if this processor does not have them.
pub fn wide_with(primitives: Primitives, hits: Hits, instructions: Instructions) -> Option<Box<dyn Accelerator>> {
    Traversal::of(instructions).map(|traversal| traversal.over(primitives, hits, Step::ThinInPieces))
}

/// Instructions that this processor has.
enum Traversal {
    #[cfg(target_arch = "x86_64")]
    Avx512(simd::Avx512),
    #[cfg(target_arch = "x86_64")]
    Avx2(simd::Avx2),
    Portable(Portable),
}

impl Traversal {
    fn best() -> Self {
        Instructions::ALL.into_iter().filter_map(Self::of).next().unwrap_or(Self::Portable(Portable))
    }

    fn of(instructions: Instructions) -> Option<Self> {
        match instructions {
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => simd::Avx512::detect().map(Self::Avx512),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => simd::Avx2::detect().map(Self::Avx2),
            #[cfg(not(target_arch = "x86_64"))]
            Instructions::Avx512 | Instructions::Avx2 => None,
            Instructions::Portable => Some(Self::Portable(Portable)),
        }
    }

    fn over(self, primitives: Primitives, hits: Hits, step: Step) -> Box<dyn Accelerator> {
        let tree = build::build(&primitives, step);
        match self {
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(isa) => Wide::boxed(isa, primitives, tree, hits),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(isa) => Wide::boxed(isa, primitives, tree, hits),
            Self::Portable(isa) => Wide::boxed(isa, primitives, tree, hits),
        }
    }
}

struct Tree {
    root: Link,
    nodes: Vec<Node>,
    blocks: Vec<Block>,
    /// The first is empty, and what [`Link::NOTHING`] names.
    mixed: Vec<Mixed>,
    /// The primitives of mixed leaves that are asked one by one.
    asked: Vec<u32>,
    /// Primitives that are not in the tree.
    beside: Vec<u32>,
    /// The greatest coordinate.
    magnitude: f32,
    /// Levels of nodes.
    depth: usize,
    leaves: usize,
    largest_leaf: usize,
    /// Primitives in leaves, those in several counted in each.
    references: usize,
    /// What a ray that meets the root's box costs, in tests of a primitive.
    cost: f32,
}

struct Wide<I, D> {
    isa: I,
    decide: PhantomData<D>,
    primitives: Primitives,
    tree: Tree,
}

impl<I: Isa + Send + Sync + 'static> Wide<I, Exact> {
    fn boxed(isa: I, primitives: Primitives, tree: Tree, hits: Hits) -> Box<dyn Accelerator> {
        match hits {
            Hits::Exact => Box::new(Self { isa, decide: PhantomData, primitives, tree }),
            Hits::Watertight => Box::new(Wide::<I, Watertight> { isa, decide: PhantomData, primitives, tree }),
        }
    }
}

impl<I: Isa + Send + Sync, D: Decide + Send + Sync> Wide<I, D> {
    /// In packets where rays go the same way; others, and what is left over, alone.
    #[inline(always)]
    fn closest_many(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        let Self { isa, tree, primitives, .. } = self;
        for (rays, hits) in rays.chunks(packet::RAYS).zip(hits.chunks_mut(packet::RAYS)) {
            if let Ok(rays) = rays.try_into()
                && packet::closest::<I, D>(*isa, tree, primitives, rays, hits)
            {
                continue;
            }
            for (ray, hit) in rays.iter().zip(hits) {
                *hit = self.closest(ray, Interval::FORWARD);
            }
        }
    }

    #[inline(always)]
    fn any_many(&self, rays: &[Ray], within: Interval, found: &mut [bool]) {
        let Self { isa, tree, primitives, .. } = self;
        for (rays, found) in rays.chunks(packet::RAYS).zip(found.chunks_mut(packet::RAYS)) {
            let together = match rays.try_into() {
                Ok(rays) => packet::any::<I, D>(*isa, tree, primitives, rays, within),
                Err(_) => None,
            };
            for (number, (ray, found)) in rays.iter().zip(found).enumerate() {
                *found = match together {
                    Some(met) => met >> number & 1 == 1,
                    None => self.any(ray, within),
                };
            }
        }
    }
}

impl<I: Isa + Send + Sync, D: Decide + Send + Sync> Accelerator for Wide<I, D> {
    fn closest(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.isa.vectorize(
            #[inline(always)]
            || {
                if is_ordinary(ray) {
                    traverse::closest::<I, D>(self.isa, &self.tree, &self.primitives, ray, &within)
                } else {
                    cold_path();
                    closest_of_all(&self.primitives, ray, within)
                }
            },
        )
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        self.isa.vectorize(
            #[inline(always)]
            || {
                if is_ordinary(ray) {
                    traverse::any::<I, D>(self.isa, &self.tree, &self.primitives, ray, &within)
                } else {
                    cold_path();
                    any_of_all(&self.primitives, ray, within)
                }
            },
        )
    }

    fn closest_many(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        self.isa.vectorize(
            #[inline(always)]
            || self.closest_many(rays, hits),
        );
    }

    fn any_many(&self, rays: &[Ray], within: Interval, found: &mut [bool]) {
        self.isa.vectorize(
            #[inline(always)]
            || self.any_many(rays, within, found),
        );
    }

    fn visits(&self, ray: &Ray, within: Interval) -> Visits {
        if !is_ordinary(ray) {
            return visits_of_all(&self.primitives);
        }
        visits::visits::<I, D>(self.isa, &self.tree, &self.primitives, ray, &within)
    }

    fn statistics(&self) -> Statistics {
        let Tree { nodes, blocks, mixed, asked, beside, depth, leaves, largest_leaf, references, cost, .. } =
            &self.tree;
        Statistics {
            branches: nodes.len(),
            leaves: *leaves,
            depth: *depth,
            references: *references,
            largest_leaf: *largest_leaf,
            cost: *cost,
            bytes: size_of_val(&nodes[..])
                + size_of_val(&blocks[..])
                + size_of_val(&mixed[..])
                + size_of_val(&asked[..])
                + size_of_val(&beside[..]),
        }
    }
}
