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
    let cost = whole.root.cost;
    if cost_of_thin_triangles(primitives, inside) < WORTH_CUTTING * cost {
        return whole;
    }
    // Not both at a time: it is seldom that this one is wanted after all, and then it is grown again.
    drop(whole);
    in_pieces(primitives, inside, grid)
        .filter(|cut| cut.root.cost < (1.0 - WORTH_CUTTING) * cost)
        .unwrap_or_else(|| Grown::of(inside, &Whole(primitives), grid))
}

/// The octree with thin triangles in pieces; `None` if they are too many to be numbered.
fn in_pieces(primitives: &Primitives, inside: &[u32], grid: Grid) -> Option<Grown> {
    let pieces = pieces(primitives, inside, grid);
    let references: Vec<u32> = (0..u32::try_from(pieces.len()).ok()?).collect();
    Some(Grown::of(&references, &InPieces(primitives, pieces), grid))
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
