//! Which octree: of whole primitives, or with thin triangles in pieces.

use geometry::{Aabb, Primitives};
use rayon::prelude::*;

use super::{
    cells::{Cell, Content, grow},
    morton::{Grid, in_morton_order},
    pieces::{Piece, cost_of_thin_triangles, pieces},
    step::Step,
};

/// Of what a tree costs the share that thin triangles must waste before they are cut, and that a tree of pieces must save.
const WORTH_CUTTING: f32 = 0.1;

/// The cheapest octree: of whole primitives, or with thin triangles in pieces.
pub(super) fn cheapest(primitives: &Primitives, inside: &[u32], grid: Grid, step: Step) -> Grown {
    let whole = Grown::of(inside, &Whole(primitives), grid);
    if step < Step::ThinInPieces || primitives.kernels().triangle.is_some() {
        return whole;
    }
    let worthwhile = WORTH_CUTTING * whole.cost();
    if cost_of_thin_triangles(primitives, inside) < worthwhile {
        return whole;
    }
    let pieces = pieces(primitives, inside, grid);
    let Ok(count) = u32::try_from(pieces.len()) else { return whole };
    let references: Vec<u32> = (0..count).collect();
    let cut = Grown::of(&references, &InPieces(primitives, pieces), grid);
    if cut.cost() < whole.cost() - worthwhile { cut } else { whole }
}

/// An octree, not yet laid out.
pub(super) struct Grown {
    /// The primitives of its cells.
    pub(super) row: Vec<u32>,
    pub(super) root: Cell,
}

impl Grown {
    fn of(references: &[u32], content: &impl Content, grid: Grid) -> Self {
        let coded = in_morton_order(references, |reference| content.bounds(reference), grid);
        let root = grow(&coded, 0, content);
        Self {
            row: coded.par_iter().with_min_len(4096).map(|coded| content.primitive(coded.reference)).collect(),
            root,
        }
    }

    fn cost(&self) -> f32 {
        self.root.costs[0]
    }
}

/// Primitives as they are.
struct Whole<'a>(&'a Primitives);

impl Content for Whole<'_> {
    fn bounds(&self, reference: u32) -> Aabb {
        self.0.bounds(reference)
    }

    fn primitive(&self, reference: u32) -> u32 {
        reference
    }

    fn is_in_block(&self, reference: u32) -> bool {
        is_in_block(self.0, reference)
    }
}

/// Primitives of which some are cut in pieces.
struct InPieces<'a>(&'a Primitives, Vec<Piece>);

impl Content for InPieces<'_> {
    fn bounds(&self, reference: u32) -> Aabb {
        self.1[reference as usize].bounds
    }

    fn primitive(&self, reference: u32) -> u32 {
        self.1[reference as usize].primitive
    }

    fn is_in_block(&self, reference: u32) -> bool {
        is_in_block(self.0, self.primitive(reference))
    }
}

/// Whether a primitive is a triangle that stands in blocks.
pub(super) fn is_in_block(primitives: &Primitives, number: u32) -> bool {
    // A kernel of someone else's may accept what the blocks' filter would leave out.
    primitives.kernels().triangle.is_none() && primitives.triangle(number).is_some()
}
