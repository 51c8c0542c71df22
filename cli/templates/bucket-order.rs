//! In which order are the tiles of a picture rendered?

use render::Tile;
use scene_format::scene_file::BucketOrder;

/// Each tile of a grid exactly once, in an order.
///
/// A stub: none of them.
pub fn order(_order: BucketOrder, _columns: u32, _rows: u32) -> Vec<Tile> {
    Vec::new()
}
