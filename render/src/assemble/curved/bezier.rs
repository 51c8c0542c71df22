use geometry::Mesh;
use glam::{DVec3, Vec2};
use scene_format::scene_file::{BezierMesh, Subdivision};

use super::super::placement::dvec3;
use super::patchwork::{At, Patchwork};

/// A mesh of patches whose neighbours share a row of points.
pub(in super::super) fn bezier(mesh: &BezierMesh) -> Mesh {
    let [along_u, along_v] = patch_counts(mesh);
    let [points_u, points_v] = mesh.size.value.map(|count| count as usize);
    let mut patches = Patchwork::default();
    for (patch_v, patch_u) in (0..along_v).flat_map(|v| (0..along_u).map(move |u| (v, u))) {
        let point = |row: usize, column: usize| {
            let (u, v) = ((3 * patch_u + column) % points_u, (3 * patch_v + row) % points_v);
            mesh.points.get(u + points_u * v).copied().unwrap_or_default()
        };
        let controls = [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| dvec3(point(row, column))));
        patches.add_patch(&controls, &mesh.subdivision);
    }
    patches.finish()
}

/// How many triangles the patches of a surface make, if that can be counted.
pub(in super::super) fn triangles_of(patches: usize, subdivision: &Subdivision) -> Option<usize> {
    let squares = edges(subdivision) as usize;
    squares.checked_mul(squares)?.checked_mul(2)?.checked_mul(patches)
}

/// How many patches a mesh has.
pub(in super::super) fn patches_of(mesh: &BezierMesh) -> usize {
    let [along_u, along_v] = patch_counts(mesh);
    along_u * along_v
}

/// How many patches lie along u and v: neighbours share a row of points.
fn patch_counts(mesh: &BezierMesh) -> [usize; 2] {
    let wrap = mesh.wrap.map_or([false; 2], |wrap| wrap.value);
    let count = |points: u32, wraps: bool| if wraps { points / 3 } else { points.saturating_sub(1) / 3 } as usize;
    [count(mesh.size[0], wrap[0]), count(mesh.size[1], wrap[1])]
}

impl Patchwork {
    /// Adds a bicubic patch: rows along v, in each four points along u. (Farin: Curves and Surfaces for CAGD, section 14.)
    pub(super) fn add_patch(&mut self, controls: &[[DVec3; 4]; 4], subdivision: &Subdivision) {
        if subdivision.smooth.is_some_and(|smooth| !smooth.value) {
            self.flatten();
        }
        let squares = edges(subdivision);
        self.add([squares, squares], |u, v| {
            let (along_u, along_v) = (bernstein(u), bernstein(v));
            let (slope_u, slope_v) = (bernstein_slope(u), bernstein_slope(v));
            let sum = |of_u: [f64; 4], of_v: [f64; 4]| {
                let rows = controls.iter().zip(of_v);
                let row =
                    |points: &[DVec3; 4]| points.iter().zip(of_u).map(|(point, weight)| *point * weight).sum::<DVec3>();
                rows.map(|(points, weight)| row(points) * weight).sum::<DVec3>()
            };
            let normal = sum(slope_u, along_v).cross(sum(along_u, slope_v)).normalize_or_zero();
            At { point: sum(along_u, along_v), normal, uv: Vec2::new(u as f32, v as f32) }
        });
    }
}

/// How many squares lie along each edge of a patch.
fn edges(subdivision: &Subdivision) -> u32 {
    subdivision.count.map_or(8, |count| count.value.max(1))
}

fn bernstein(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t]
}

fn bernstein_slope(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t]
}

#[cfg(test)]
mod tests {
    use geometry::Corners;
    use scene_format::scene_file::Triple;

    use super::*;

    #[test]
    fn a_bezier_patch_passes_through_its_corners_and_is_flat_where_its_points_are() {
        let grid = (0..16).map(|at| [(at % 4) as f32, (at / 4) as f32, 0.0]).collect::<Vec<_>>();
        let mesh = BezierMesh {
            size: [4, 4].into(),
            wrap: None,
            points: grid.into(),
            subdivision: Subdivision { count: Some(2.into()), smooth: None },
        };
        let made = bezier(&mesh);
        assert_eq!((made.positions.len(), made.triangles.len()), (9, 8));
        assert_eq!((made.positions[0], made.positions[8]), (glam::Vec3::ZERO, glam::Vec3::new(3.0, 3.0, 0.0)));
        let Corners::PerPoint(normals) = &made.normals else { panic!("flat") };
        assert!(normals.iter().all(|normal| *normal == glam::Vec3::Z), "{normals:?}");
        let doubled = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|corner| made.positions[corner as usize].as_dvec3());
            (b - a).cross(c - a).z
        };
        assert_eq!(made.triangles.iter().map(doubled).sum::<f64>(), 18.0);
    }

    #[test]
    fn a_closed_bezier_mesh_meets_its_own_beginning() {
        let ring = |at: usize| [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][at % 6];
        let points: Vec<Triple> = (0..24).map(|at| [ring(at)[0], ring(at)[1], (at / 6) as f32]).collect();
        let mesh = BezierMesh {
            size: [6, 4].into(),
            wrap: Some([true, false].into()),
            points: points.into(),
            subdivision: Subdivision { count: Some(1.into()), smooth: Some(false.into()) },
        };
        assert_eq!(patches_of(&mesh), 2);
        let made = bezier(&mesh);
        // The second patch ends where the first begins.
        assert_eq!(made.positions[6..8], made.positions[0..2]);
        assert_eq!(made.normals, Corners::None);
    }
}
