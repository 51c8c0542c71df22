use scene_format::scene_file::BucketOrder;

use crate::{Crop, sampler::scramble};

/// A bucket's place in the grid of buckets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// From the left, from 0.
    pub column: u32,
    /// From the top, from 0.
    pub row: u32,
}

/// The order in which buckets are rendered, from a name for it and the number of columns and rows; each bucket exactly once.
pub type BucketOrdering = fn(BucketOrder, u32, u32) -> Vec<Tile>;

/// All buckets of a grid, in an order.
///
/// ```text
///   row      column    diagonal  spiral    hilbert
///   0 1 2    0 5 6     0 1 3     6 7 8     0 1 14 15
///   5 4 3    1 4 7     2 4 6     5 0 1     3 2 13 12
///   6 7 8    2 3 8     5 7 8     4 3 2     4 7  8 11
///                                          5 6  9 10
/// ```
pub fn bucket_order(order: BucketOrder, columns: u32, rows: u32) -> Vec<Tile> {
    match order {
        BucketOrder::Hilbert => hilbert(columns, rows),
        BucketOrder::Spiral => spiral(columns, rows),
        BucketOrder::Row => serpentine(rows, columns).map(|(row, column)| Tile { column, row }).collect(),
        BucketOrder::Column => serpentine(columns, rows).map(|(column, row)| Tile { column, row }).collect(),
        BucketOrder::Diagonal => {
            let mut tiles = all(columns, rows);
            tiles.sort_by_key(|tile| (tile.column + tile.row, tile.row));
            tiles
        }
        BucketOrder::Random => {
            let mut tiles = all(columns, rows);
            tiles.sort_by_key(|tile| (scramble(scramble(tile.column) ^ tile.row), tile.column, tile.row));
            tiles
        }
    }
}

fn all(columns: u32, rows: u32) -> Vec<Tile> {
    (0..rows).flat_map(|row| (0..columns).map(move |column| Tile { column, row })).collect()
}

/// Line by line, every second one backwards.
fn serpentine(lines: u32, length: u32) -> impl Iterator<Item = (u32, u32)> {
    (0..lines)
        .flat_map(move |line| (0..length).map(move |step| (line, if line % 2 == 0 { step } else { length - 1 - step })))
}

/// From the middle in growing squares; what lies outside the grid is passed over.
fn spiral(columns: u32, rows: u32) -> Vec<Tile> {
    let count = columns as usize * rows as usize;
    let mut tiles = Vec::with_capacity(count);
    let (mut x, mut y) = (i64::from(columns - columns.min(1)) / 2, i64::from(rows - rows.min(1)) / 2);
    let directions = [(1, 0), (0, 1), (-1, 0), (0, -1)];
    for (turn, (dx, dy)) in directions.into_iter().cycle().enumerate() {
        for _ in 0..turn / 2 + 1 {
            if tiles.len() == count {
                return tiles;
            }
            if (0..i64::from(columns)).contains(&x) && (0..i64::from(rows)).contains(&y) {
                tiles.push(Tile { column: x as u32, row: y as u32 });
            }
            (x, y) = (x + dx, y + dy);
        }
    }
    tiles
}

/// Along Hilbert's curve on the smallest square of a power of two that holds the grid; what lies outside is passed over.
fn hilbert(columns: u32, rows: u32) -> Vec<Tile> {
    let edge = columns.max(rows).next_power_of_two();
    (0..u64::from(edge) * u64::from(edge))
        .map(|distance| hilbert_point(edge, distance))
        .filter(|tile| tile.column < columns && tile.row < rows)
        .collect()
}

/// The point at a distance along the curve: square by square, each turned to begin where the last one ends.
/// (Warren: Hacker's Delight, 2nd ed. 2012, section 16-2.)
fn hilbert_point(edge: u32, mut distance: u64) -> Tile {
    let (mut x, mut y) = (0, 0);
    let mut size = 1;
    while size < edge {
        let right = ((distance / 2) & 1) as u32;
        let down = (distance as u32 ^ right) & 1;
        if down == 0 {
            if right == 1 {
                (x, y) = (size - 1 - x, size - 1 - y);
            }
            (x, y) = (y, x);
        }
        (x, y) = (x + size * right, y + size * down);
        distance /= 4;
        size *= 2;
    }
    Tile { column: x, row: y }
}

/// The pixels of a bucket: a part of the window, in the whole picture's pixels.
pub(crate) fn bucket_pixels(window: Crop, size: u32, tile: Tile) -> Crop {
    let (x, y) = (tile.column * size, tile.row * size);
    Crop { x: window.x + x, y: window.y + y, width: size.min(window.width - x), height: size.min(window.height - y) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The number of each bucket, row by row.
    fn numbers(order: BucketOrder, columns: u32, rows: u32) -> Vec<usize> {
        let tiles = bucket_order(order, columns, rows);
        all(columns, rows).iter().map(|tile| tiles.iter().position(|other| other == tile).unwrap()).collect()
    }

    #[test]
    fn orders_run_as_drawn() {
        assert_eq!(numbers(BucketOrder::Row, 3, 3), [0, 1, 2, 5, 4, 3, 6, 7, 8]);
        assert_eq!(numbers(BucketOrder::Column, 3, 3), [0, 5, 6, 1, 4, 7, 2, 3, 8]);
        assert_eq!(numbers(BucketOrder::Diagonal, 3, 3), [0, 1, 3, 2, 4, 6, 5, 7, 8]);
        assert_eq!(numbers(BucketOrder::Spiral, 3, 3), [6, 7, 8, 5, 0, 1, 4, 3, 2]);
        assert_eq!(numbers(BucketOrder::Hilbert, 4, 4), [0, 1, 14, 15, 3, 2, 13, 12, 4, 7, 8, 11, 5, 6, 9, 10]);
    }
}
