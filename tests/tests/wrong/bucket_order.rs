use std::sync::atomic::{AtomicUsize, Ordering};

use render::conformance::bucket_order as kit;
use render::{BucketOrdering, Tile, bucket_order};
use scene_format::scene_file::BucketOrder;

use crate::Kit;

#[test]
fn every_mistake_in_an_order_of_buckets_is_named() {
    static CALLS: AtomicUsize = AtomicUsize::new(0);
    let comes = "every_bucket_comes";
    Kit { page: "render/src/conformance/bucket_order.rs", laws: kit::LAWS }.catches([
        ("nothing is returned", (|_, _, _| Vec::new()) as BucketOrdering, comes),
        (
            "a bucket lost: the last column",
            |order, columns, rows| bucket_order(order, columns.saturating_sub(1), rows),
            comes,
        ),
        ("columns and rows exchanged", |order, columns, rows| bucket_order(order, rows, columns), comes),
        (
            "a bucket twice",
            |order, columns, rows| {
                let mut tiles = bucket_order(order, columns, rows);
                tiles.extend(tiles.first().copied());
                tiles
            },
            "no_bucket_comes_twice",
        ),
        (
            "buckets outside the grid",
            |_, columns, rows| {
                let edge = columns.max(rows).next_power_of_two();
                bucket_order(BucketOrder::Hilbert, edge, edge)
            },
            "no_bucket_lies_outside_the_grid",
        ),
        (
            "a panic in an empty grid",
            |order, columns, rows| {
                assert!(columns > 0 && rows > 0, "attempt to subtract with overflow");
                bucket_order(order, columns, rows)
            },
            "an_empty_grid_has_no_buckets",
        ),
        (
            "another order at each call",
            |order, columns, rows| {
                let mut tiles = bucket_order(order, columns, rows);
                let turn = CALLS.fetch_add(1, Ordering::Relaxed) % tiles.len().max(1);
                tiles.rotate_left(turn);
                tiles
            },
            "an_order_is_the_same_whenever_it_is_asked",
        ),
        (
            "all orders are rows",
            |_, columns, rows| (0..rows).flat_map(|row| (0..columns).map(move |column| Tile { column, row })).collect(),
            "columns_come_one_after_the_other",
        ),
    ]);
}
