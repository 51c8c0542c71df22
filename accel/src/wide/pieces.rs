//! Long thin triangles, cut at the planes of the octree.
//!
//! The box of a thin triangle that lies across the axes is nearly empty, and every ray through it asks the triangle in vain. Cut where the
//! planes between cells pass, the pieces have small boxes, in cells of their own. Only the boxes are cut: a piece is the triangle
//! itself, asked wherever one of its pieces is met, always with the same answer.
//!
//! ```text
//!   +---------+             +----|----+       The pieces' boxes cover the triangle, so the one with the
//!   |       / |             |    | +-/+       point where a ray meets it is met by the ray as well.
//!   |     /   |             |    | |/ |
//!   |   /     |   ------->  |----+-+--+       Planes high in the octree count most: a box that lies across
//!   | /       |             | +-/|    |       one of them keeps the cells on both sides from being told apart.
//!   +/--------+             +-|/-|----+
//! ```
//!
//! Which triangles are cut, and how often, is that of Karras and Aila (Fast Parallel Construction of High-Quality Bounding Volume
//! Hierarchies, 2013, section 4.3). Whether it pays is seen only afterwards, from what both trees cost.

use geometry::{Aabb, Primitives, Triangle};
use glam::Vec3;
use rayon::prelude::*;

use super::{collapse::triangle_cost, morton::Grid};

/// A primitive, or a part of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Piece {
    pub(super) primitive: u32,
    /// Around the part.
    pub(super) bounds: Aabb,
}

/// So many times as many pieces as primitives, at most.
const MOST_PIECES: usize = 3;

/// A triangle whose box has so many times its own surface is not thin: among triangles of good shape the mean is 2 to 3.
const ORDINARY: f32 = 4.0;

/// What the boxes of thin triangles cost too much: no cut can save more than that.
pub(super) fn cost_of_thin_triangles(primitives: &Primitives, numbers: &[u32]) -> f32 {
    let waste = |&number: &u32| primitives.triangle(number).map_or(0.0, |triangle| Thinness::of(triangle).waste);
    // Added up in parts of fixed size, so that the sum's rounding does not depend on the threads.
    let parts: Vec<f32> = numbers.par_chunks(4096).map(|part| part.iter().map(waste).sum()).collect();
    triangle_cost(parts.into_iter().sum())
}

/// The numbered primitives, the thin triangles among them in pieces.
pub(super) fn pieces(primitives: &Primitives, numbers: &[u32], grid: Grid) -> Vec<Piece> {
    let thinness = |&number: &u32| primitives.triangle(number).map_or(Thinness::NONE, Thinness::of);
    let thinnesses: Vec<Thinness> = numbers.par_iter().with_min_len(4096).map(thinness).collect();
    let scale = scale(&thinnesses, (MOST_PIECES - 1) * numbers.len());
    let cut = |(&primitive, thinness): (&u32, &Thinness)| {
        let whole = Piece { primitive, bounds: primitives.bounds(primitive) };
        let mut pieces = Vec::new();
        match primitives.triangle(primitive) {
            Some(triangle) => Cutter { triangle, grid }.cut(whole, thinness.cuts(scale), &mut pieces),
            None => pieces.push(whole),
        }
        pieces
    };
    numbers.par_iter().zip(&thinnesses).with_min_len(4096).flat_map_iter(cut).collect()
}

/// How much a triangle wants to be cut.
#[derive(Clone, Copy)]
struct Thinness {
    /// Half the surface that its box has more than an ordinary triangle's.
    waste: f32,
    /// How many such triangles as it would be had to share the box to be ordinary.
    pieces: f32,
}

impl Thinness {
    const NONE: Self = Self { waste: 0.0, pieces: 1.0 };

    fn of(triangle: &Triangle) -> Self {
        let [a, b, c] = triangle.corners;
        let (normal, around) = ((b - a).cross(c - a), Aabb::around(triangle.corners).half_surface());
        // What it shows along each axis, from both sides: half of its surface, counted as a box's is.
        let ordinary = ORDINARY * 0.5 * (normal.x.abs() + normal.y.abs() + normal.z.abs());
        if around > ordinary { Self { waste: around - ordinary, pieces: around / ordinary } } else { Self::NONE }
    }

    /// How often it is cut. Of a diagonal cut into n equal pieces the boxes have 1/n of the surface, and more pieces than make each
    /// of them ordinary win nothing. So much surface is left least, with a given number of cuts in all, when each triangle's n is
    /// as the square root of its waste.
    fn cuts(self, scale: f32) -> usize {
        (self.waste.sqrt() * scale).min(self.pieces - 1.0) as usize
    }
}

/// The greatest scale, nearly, with which no more cuts are made than `most`.
fn scale(thinnesses: &[Thinness], most: usize) -> f32 {
    let all = || thinnesses.par_iter().with_min_len(4096);
    let total = |scale: f32| all().map(|thinness| thinness.cuts(scale)).sum::<usize>();
    let greatest = all().map(|thinness| thinness.waste.sqrt()).reduce(|| 0.0, f32::max);
    if greatest == 0.0 {
        return 0.0;
    }
    // With the upper one, the thinnest alone would be cut more often than that.
    let (mut lower, mut upper) = (0.0, (most + 1) as f32 / greatest);
    for _ in 0..24 {
        let middle = 0.5 * (lower + upper);
        if total(middle) <= most { lower = middle } else { upper = middle }
    }
    lower
}

/// A plane between cells.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plane {
    axis: usize,
    /// The first cell behind it.
    cell: u32,
}

/// Of the planes in the middle half of the cells between two the one that halves the greatest cell; on the axis where they are most,
/// or on one where they are at least half as many: the triangles of a diagonal wire are then all cut on the same.
fn best_plane([lowest, highest]: [[u32; 3]; 2]) -> Option<Plane> {
    let lengths: [u32; 3] = std::array::from_fn(|axis| highest[axis] - lowest[axis]);
    let longest = lengths.into_iter().max()?;
    let mut best = None;
    for axis in (0..3).filter(|&axis| lengths[axis] >= longest / 2) {
        let quarter = lengths[axis] / 4;
        let (lowest, highest) = (lowest[axis] + quarter, highest[axis] - quarter);
        // The highest bit that differs is that of the greatest cell.
        let Some(bit) = (lowest ^ highest).checked_ilog2() else { continue };
        if best.is_none_or(|(found, _)| bit > found) {
            best = Some((bit, Plane { axis, cell: highest >> bit << bit }));
        }
    }
    best.map(|(_, plane)| plane)
}

struct Cutter<'a> {
    triangle: &'a Triangle,
    grid: Grid,
}

impl Cutter<'_> {
    /// Cuts a piece so many times.
    fn cut(&self, piece: Piece, cuts: usize, pieces: &mut Vec<Piece>) {
        let cells = [piece.bounds.min, piece.bounds.max].map(|point| self.grid.cell(point));
        self.cut_within(piece, cells, cuts, pieces);
    }

    /// Cuts a piece that lies between two cells. No deeper than there are planes on three axes: each cut
    /// leaves a quarter of them behind.
    fn cut_within(&self, piece: Piece, cells: [[u32; 3]; 2], cuts: usize, pieces: &mut Vec<Piece>) {
        let Some(plane) = best_plane(cells).filter(|_| cuts > 0) else {
            pieces.push(piece);
            return;
        };
        let Plane { axis, cell, .. } = plane;
        let parts = self.parts(piece.bounds, axis, self.grid.plane(axis, cell));
        let (mut below, mut above) = (cells, cells);
        below[1][axis] = cell - 1;
        above[0][axis] = cell;
        let lengths = parts.map(|bounds| bounds.map_or(0.0, |bounds| bounds.extent().max_element()));
        // The other cuts are shared out by the parts' lengths; where one is empty, none was made here.
        let (rest, share) = match parts {
            [Some(_), Some(_)] => (cuts - 1, lengths[0] / (lengths[0] + lengths[1])),
            [lower, _] => (cuts, f32::from(lower.is_some())),
        };
        let lower_cuts = ((rest as f32 * share + 0.5) as usize).min(rest);
        for (bounds, cells, cuts) in [(parts[0], below, lower_cuts), (parts[1], above, rest - lower_cuts)] {
            if let Some(bounds) = bounds {
                self.cut_within(Piece { bounds, ..piece }, self.tightened(cells, bounds), cuts, pieces);
            }
        }
    }

    /// The cells that a box lies between, of those between two.
    fn tightened(&self, [lowest, highest]: [[u32; 3]; 2], bounds: Aabb) -> [[u32; 3]; 2] {
        let (first, last) = (self.grid.cell(bounds.min), self.grid.cell(bounds.max));
        let lowest = std::array::from_fn(|axis| first[axis].clamp(lowest[axis], highest[axis]));
        [lowest, std::array::from_fn(|axis| last[axis].clamp(lowest[axis], highest[axis]))]
    }

    /// The boxes of what lies below a plane and above it, of the triangle's part in a box.
    ///
    /// No point of the triangle is lost: where an edge crosses the plane is computed in `f64`, off by no more than some 2^-50 of the
    /// greatest coordinate, which the slack of the box test has to spare (`boxes.rs`), and rounded to `f32` outwards.
    fn parts(&self, bounds: Aabb, axis: usize, plane: f32) -> [Option<Aabb>; 2] {
        let (mut below, mut above) = (Aabb::EMPTY, Aabb::EMPTY);
        let [a, b, c] = self.triangle.corners;
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let corner = Aabb { min: from, max: from };
            if from[axis] <= plane {
                below = below.union(corner);
            }
            if from[axis] >= plane {
                above = above.union(corner);
            }
            if (from[axis] < plane) != (to[axis] < plane) {
                let crossing = crossing(from, to, axis, plane);
                (below, above) = (below.union(crossing), above.union(crossing));
            }
        }
        below.max[axis] = below.max[axis].min(plane);
        above.min[axis] = above.min[axis].max(plane);
        [below, above].map(|part| {
            let part = Aabb { min: part.min.max(bounds.min), max: part.max.min(bounds.max) };
            part.min.cmple(part.max).all().then_some(part)
        })
    }
}

/// A box around the point where an edge crosses a plane.
fn crossing(from: Vec3, to: Vec3, axis: usize, plane: f32) -> Aabb {
    let (start, way) = (from.as_dvec3(), to.as_dvec3() - from.as_dvec3());
    let point = start + way * ((f64::from(plane) - start[axis]) / way[axis]);
    let nearest = point.as_vec3().to_array();
    Aabb { min: nearest.map(f32::next_down).into(), max: nearest.map(f32::next_up).into() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::Mesh;
    use glam::DVec3;

    /// Numbers from -1 to 1 (Steele, Lea, Flood: SplitMix, 2014).
    fn random(state: &mut u64) -> f32 {
        *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (*state ^ *state >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ z >> 31) >> 39) as f32 / (1 << 24) as f32 - 1.0
    }

    fn triangle(state: &mut u64, thickness: f32) -> Triangle {
        let mut point = || Vec3::new(random(state), random(state), random(state));
        let (a, b, off) = (point(), point(), point());
        Triangle { corners: [a, b, 0.5 * (a + b) + thickness * off] }
    }

    fn in_pieces(triangle: &Triangle, cuts: usize) -> Vec<Piece> {
        let grid = Grid::around(Aabb { min: Vec3::splat(-1.5), max: Vec3::splat(1.75) });
        let mut pieces = Vec::new();
        let whole = Piece { primitive: 0, bounds: Aabb::around(triangle.corners) };
        Cutter { triangle, grid }.cut(whole, cuts, &mut pieces);
        pieces
    }

    /// The points of the triangle's edges on a plane along the axes.
    fn on_edges(triangle: &Triangle, axis: usize, plane: f32) -> Vec<DVec3> {
        let [a, b, c] = triangle.corners.map(|corner| corner.as_dvec3());
        let share = |(from, to): (DVec3, DVec3)| (f64::from(plane) - from[axis]) / (to[axis] - from[axis]);
        let edges = [(a, b), (b, c), (c, a)].into_iter();
        edges.filter(|&edge| (0.0..=1.0).contains(&share(edge))).map(|edge| edge.0.lerp(edge.1, share(edge))).collect()
    }

    /// Where the pieces end is where points could be lost: on each such plane the ends of the triangle's part, and its middle.
    #[test]
    fn every_point_of_a_triangle_is_in_a_piece() {
        let mut state = 1;
        for thickness in [0.3, 0.01, 1e-5] {
            for number in 0..300 {
                let triangle = triangle(&mut state, thickness);
                let pieces = in_pieces(&triangle, 1 + number % 40);
                for axis in 0..3 {
                    for plane in pieces.iter().flat_map(|piece| [piece.bounds.min[axis], piece.bounds.max[axis]]) {
                        let ends = on_edges(&triangle, axis, plane);
                        let middle = ends.iter().sum::<DVec3>() / ends.len().max(1) as f64;
                        for point in ends.iter().copied().chain((!ends.is_empty()).then_some(middle)) {
                            // The f64 steps here and there: below 2^-48 of the coordinates.
                            let slack = DVec3::splat(1.0 / (1_u64 << 48) as f64);
                            let is_in = |piece: &Piece| {
                                let Aabb { min, max } = piece.bounds;
                                (min.as_dvec3() - slack).cmple(point).all() && point.cmple(max.as_dvec3() + slack).all()
                            };
                            assert!(pieces.iter().any(is_in), "{point} of {triangle:?} is lost among {pieces:?}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn a_diagonal_cut_in_pieces_has_so_much_smaller_boxes() {
        let diagonal = Triangle { corners: [Vec3::ZERO, Vec3::new(1.0, 1.0, 0.0), Vec3::new(0.5, 0.5, 1e-4)] };
        let surface = |cuts| {
            let pieces = in_pieces(&diagonal, cuts);
            assert_eq!(pieces.len(), cuts + 1);
            pieces.iter().map(|piece| piece.bounds.half_surface()).sum::<f32>()
        };
        // n equal pieces have n (1/n)^2 of the surface; planes in the middle half make them equal within a factor of 3.
        let whole = surface(0);
        for cuts in [1, 3, 15] {
            let pieces = (cuts + 1) as f32;
            assert!(surface(cuts) >= 0.99 * whole / pieces, "{cuts}");
            assert!(surface(cuts) < 1.6 * whole / pieces, "{cuts}: {} of {whole}", surface(cuts));
        }
    }

    fn primitives(thickness: f32, count: usize) -> Primitives {
        let mut state = 7;
        let triangles: Vec<_> = (0..count).map(|_| triangle(&mut state, thickness)).collect();
        let mut primitives = Primitives::default();
        primitives.add_mesh(Mesh {
            positions: triangles.iter().flat_map(|triangle| triangle.corners).collect(),
            triangles: (0..count as u32).map(|number| [3 * number, 3 * number + 1, 3 * number + 2]).collect(),
            ..Mesh::default()
        });
        primitives
    }

    #[test]
    fn thin_triangles_are_cut_as_often_as_is_allowed_and_thick_ones_are_not() {
        let count = 1000;
        let numbers: Vec<u32> = (0..count as u32).collect();
        let grid = Grid::around(Aabb { min: Vec3::splat(-1.0), max: Vec3::ONE });
        let thin = pieces(&primitives(1e-3, count), &numbers, grid).len();
        // The scale is found to a 2^-24th; all it leaves is what rounding down to whole cuts does.
        assert!((MOST_PIECES * count - 10..=MOST_PIECES * count).contains(&thin), "{thin}");
        let equilateral = Triangle { corners: [Vec3::X, Vec3::Y, Vec3::Z] };
        // A box of 1 x 1 x 1 around a triangle that shows 1/2 along each axis: half surfaces of 3 and 3/2.
        assert_eq!(Thinness::of(&equilateral).cuts(1e9), 0);
        assert_eq!(Thinness::of(&equilateral).waste, 0.0);
    }
}
