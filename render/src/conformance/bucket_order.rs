//! The kit of an order of buckets.
//!
//! **The idea.** A picture is rendered in squares, so that threads can share it out. Which square comes when has no influence on the picture,
//! but on who looks on (the middle first) and on caches (neighbours in time are neighbours in the picture).
//!
//! ```text
//!   row      column    diagonal  spiral    hilbert
//!   0 1 2    0 5 6     0 1 3     6 7 8     0 1 14 15
//!   5 4 3    1 4 7     2 4 6     5 0 1     3 2 13 12
//!   6 7 8    2 3 8     5 7 8     4 3 2     4 7  8 11
//!                                          5 6  9 10
//! ```
//!
//! **The contract.** A [`BucketOrdering`] makes [`Tile`]s of a name and the number of columns and rows. Whatever the name: each tile of the
//! grid, once. What a name asks for beyond that is little: see the last laws.
//!
//! **Hard cases.** Grids of one row or column, of no size that is a power of two, and of nothing.
//!
//! **Literature.** Warren: Hacker's Delight, 2nd ed. 2012, chapter 16 (Hilbert's curve). Skilling: Programming the Hilbert Curve, 2004.
//!
//! **Exercises.** Pass the kit with rows alone up to the last laws. Put the buckets that took longest in a first rough picture first, and
//! measure the last thread's idle time. Find an order for which the octree's cache misses are fewest.
//!
//! | mistake | law that names it |
//! |---|---|
//! | nothing is returned | [`every_bucket_comes`] |
//! | a bucket lost: the last column | [`every_bucket_comes`] |
//! | columns and rows exchanged | [`every_bucket_comes`] |
//! | a bucket twice | [`no_bucket_comes_twice`] |
//! | buckets outside the grid | [`no_bucket_lies_outside_the_grid`] |
//! | a panic in an empty grid | [`an_empty_grid_has_no_buckets`] |
//! | another order at each call | [`an_order_is_the_same_whenever_it_is_asked`] |
//! | all orders are rows | [`columns_come_one_after_the_other`] |

use std::collections::BTreeSet;

use geometry::conformance::{Counterexample, Figure, Ink, Trial, Verdict, same};
use glam::DVec3;
use proptest::prelude::*;
use scene_format::scene_file::BucketOrder;

use crate::{BucketOrdering, Tile};

/// An order and a grid.
pub fn grids() -> impl Strategy<Value = (BucketOrder, u32, u32)> {
    let size = prop_oneof![3 => (1..20_u32, 1..20_u32), 1 => (Just(1_u32), 1..40_u32), 1 => (1..40_u32, Just(1_u32))];
    let all = prop::sample::select(BucketOrder::ALL.to_vec());
    (all, size).prop_map(|(order, (columns, rows))| (order, columns, rows))
}

fn grids_in(order: BucketOrder) -> impl Strategy<Value = (BucketOrder, u32, u32)> {
    grids().prop_map(move |(_, columns, rows)| (order, columns, rows))
}

/// The way from bucket to bucket.
fn drawn(tiles: &[Tile]) -> Figure {
    let place = |tile: &Tile| DVec3::new(f64::from(tile.column) + 0.5, -f64::from(tile.row) - 0.5, 0.0);
    let steps = tiles.windows(2).map(|pair| (place(&pair[0]), place(&pair[1])));
    steps.fold(Figure::flat(), |figure, (from, to)| figure.line(from, to, Ink::Found))
}

fn broken(tiles: &[Tile], expected: impl Into<String>, found: impl Into<String>) -> Verdict {
    Err(Counterexample::new(expected, found).drawn(drawn(tiles)))
}

/// None is lost.
pub fn every_bucket_comes(ordering: &BucketOrdering, trial: &Trial) -> Verdict {
    trial.search(grids(), |&(order, columns, rows)| {
        let tiles = ordering(order, columns, rows);
        let grid = (0..rows).flat_map(|row| (0..columns).map(move |column| Tile { column, row }));
        match grid.into_iter().find(|tile| !tiles.contains(tile)) {
            None => Ok(()),
            Some(lost) => broken(&tiles, format!("{lost:?} among the buckets"), format!("{tiles:?}")),
        }
    })
}

/// A second time it would be rendered in vain.
pub fn no_bucket_comes_twice(ordering: &BucketOrdering, trial: &Trial) -> Verdict {
    trial.search(grids(), |&(order, columns, rows)| {
        let tiles = ordering(order, columns, rows);
        let mut seen = BTreeSet::new();
        match tiles.iter().find(|tile| !seen.insert((tile.column, tile.row))) {
            None => Ok(()),
            Some(twice) => broken(&tiles, format!("{twice:?} once"), "it comes again"),
        }
    })
}

/// There are no pixels there.
pub fn no_bucket_lies_outside_the_grid(ordering: &BucketOrdering, trial: &Trial) -> Verdict {
    trial.search(grids(), |&(order, columns, rows)| {
        let tiles = ordering(order, columns, rows);
        match tiles.iter().find(|tile| tile.column >= columns || tile.row >= rows) {
            None => Ok(()),
            Some(outside) => {
                broken(&tiles, format!("columns below {columns}, rows below {rows}"), format!("{outside:?}"))
            }
        }
    })
}

/// Nor does it end the program.
pub fn an_empty_grid_has_no_buckets(ordering: &BucketOrdering, trial: &Trial) -> Verdict {
    let empty = prop_oneof![Just((0_u32, 0_u32)), (Just(0_u32), 1..9_u32), (1..9_u32, Just(0_u32))];
    trial.search((grids(), empty), |&((order, ..), (columns, rows))| same(&Vec::new(), &ordering(order, columns, rows)))
}

/// It is a function: two runs are compared bucket by bucket.
pub fn an_order_is_the_same_whenever_it_is_asked(ordering: &BucketOrdering, trial: &Trial) -> Verdict {
    trial.search(grids(), |&(order, columns, rows)| {
        same(&ordering(order, columns, rows), &ordering(order, columns, rows))
    })
}

/// The tiles' numbers along something never fall.
fn rises(tiles: &[Tile], what: &str, number: impl Fn(&Tile) -> u32) -> Verdict {
    let falls = tiles.windows(2).find(|pair| number(&pair[1]) < number(&pair[0]));
    falls
        .map_or(Ok(()), |pair| broken(tiles, format!("{what} by {what}"), format!("{:?} after {:?}", pair[1], pair[0])))
}

/// `row`: all of a row before the next.
pub fn rows_come_one_after_the_other(ordering: &BucketOrdering, trial: &Trial) -> Verdict {
    trial.search(grids_in(BucketOrder::Row), |&(order, columns, rows)| {
        rises(&ordering(order, columns, rows), "row", |tile| tile.row)
    })
}

/// `column`: all of a column before the next.
pub fn columns_come_one_after_the_other(ordering: &BucketOrdering, trial: &Trial) -> Verdict {
    trial.search(grids_in(BucketOrder::Column), |&(order, columns, rows)| {
        rises(&ordering(order, columns, rows), "column", |tile| tile.column)
    })
}

/// `diagonal`: all of a diagonal, from the top left, before the next.
pub fn diagonals_come_one_after_the_other(ordering: &BucketOrdering, trial: &Trial) -> Verdict {
    trial.search(grids_in(BucketOrder::Diagonal), |&(order, columns, rows)| {
        rises(&ordering(order, columns, rows), "diagonal", |tile| tile.column + tile.row)
    })
}

/// `spiral`: from the first bucket, which is in the middle, in growing squares.
pub fn a_spiral_grows_from_the_middle(ordering: &BucketOrdering, trial: &Trial) -> Verdict {
    trial.search(grids_in(BucketOrder::Spiral), |&(order, columns, rows)| {
        let tiles = ordering(order, columns, rows);
        let Some(&first) = tiles.first() else { return broken(&tiles, "a first bucket", "none") };
        let off = |at: u32, count: u32| (2 * at + 1).abs_diff(count);
        if off(first.column, columns) > 1 || off(first.row, rows) > 1 {
            return broken(&tiles, "a first bucket in the middle", format!("{first:?}"));
        }
        rises(&tiles, "ring", |tile| tile.column.abs_diff(first.column).max(tile.row.abs_diff(first.row)))
    })
}

/// `hilbert`: in a square of a power of two, each bucket touches the one before.
pub fn neighbours_along_hilberts_curve_touch(ordering: &BucketOrdering, trial: &Trial) -> Verdict {
    trial.search(0..6_u32, |&halvings| {
        let tiles = ordering(BucketOrder::Hilbert, 1 << halvings, 1 << halvings);
        let touch = |pair: &&[Tile]| pair[0].column.abs_diff(pair[1].column) + pair[0].row.abs_diff(pair[1].row) == 1;
        match tiles.windows(2).find(|pair| !touch(pair)) {
            None => Ok(()),
            Some(pair) => broken(&tiles, format!("a bucket beside {:?}", pair[0]), format!("{:?}", pair[1])),
        }
    })
}

geometry::kit! { $crate
    /// Names the laws of an order of buckets as tests: of a [`BucketOrdering`](crate::BucketOrdering).
    bucket_order_conformance, BucketOrdering, bucket_order;
    every_bucket_comes: "nothing is returned yet: begin with two loops, over rows and columns; or a loop ends one too early";
    no_bucket_comes_twice: "a corner belongs to two sides of a spiral, or a loop ends one too late";
    no_bucket_lies_outside_the_grid: "the square around the grid is not cut down to it";
    an_empty_grid_has_no_buckets: "a number below 0 in unsigned arithmetic, or a loop that ends only with the last bucket";
    an_order_is_the_same_whenever_it_is_asked: "chance with a state: shuffle by a hash of the tile instead";
    rows_come_one_after_the_other: "the order's name is not looked at, or rows and columns are exchanged";
    columns_come_one_after_the_other: "the order's name is not looked at, or rows and columns are exchanged";
    diagonals_come_one_after_the_other: "a diagonal's number is column plus row";
    a_spiral_grows_from_the_middle: "the middle is a corner of the grid, or a side is as long as the one before the last";
    neighbours_along_hilberts_curve_touch: "a quarter of the curve is not turned: first and last quarter are mirrored at the diagonals";
}
