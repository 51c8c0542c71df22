//! Curved surfaces as triangles, each with the normals and texture coordinates of the surface, as Sunflow has them.

use geometry::{Corners, Mesh};
use glam::{DVec3, Vec2};
use scene_format::scene_file::{BezierMesh, Subdivision, Triple};

use super::placement::dvec3;

/// So many squares go once around a circle: its outline is off by at most 1 - cos(pi / 128), 0.03 % of its radius.
const AROUND: u32 = 128;

/// What a surface is at a place of its two coordinates.
struct At {
    point: DVec3,
    normal: DVec3,
    uv: Vec2,
}

/// Radius 1 around the z axis from -1 to 1, open at both ends.
pub(super) fn cylinder() -> Mesh {
    let mut mesh = Patchwork::default();
    mesh.add([AROUND, 1], |u, v| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * u);
        let normal = DVec3::new(cos, sin, 0.0);
        At { point: normal + DVec3::Z * (2.0 * v - 1.0), normal, uv: Vec2::new(u as f32, v as f32) }
    });
    mesh.finish()
}

/// A tube of a radius along a circle around the z axis.
pub(super) fn torus([tube, circle]: [f32; 2]) -> Mesh {
    let mut mesh = Patchwork::default();
    mesh.add([AROUND, AROUND / 2], |u, v| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * u);
        let (height, outwards) = libm::sincos(std::f64::consts::TAU * v);
        let out = DVec3::new(cos, sin, 0.0);
        let normal = out * outwards + DVec3::Z * height;
        // By the height alone: a texture lies on the inside as on the outside.
        let uv = Vec2::new(u as f32, (libm::asin(height.clamp(-1.0, 1.0)) / std::f64::consts::PI + 0.5) as f32);
        At { point: out * f64::from(circle) + normal * f64::from(tube), normal, uv }
    });
    mesh.finish()
}

/// How many triangles the patches of a surface make, if that can be counted.
pub(super) fn triangles_of(patches: usize, subdivision: &Subdivision) -> Option<usize> {
    let squares = edges(subdivision) as usize;
    squares.checked_mul(squares)?.checked_mul(2)?.checked_mul(patches)
}

/// How many patches a mesh has.
pub(super) fn patches_of(mesh: &BezierMesh) -> usize {
    let [along_u, along_v] = patch_counts(mesh);
    along_u * along_v
}

pub(super) fn bezier(mesh: &BezierMesh) -> Mesh {
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

/// How many patches lie along u and v: neighbours share a row of points.
fn patch_counts(mesh: &BezierMesh) -> [usize; 2] {
    let wrap = mesh.wrap.map_or([false; 2], |wrap| wrap.value);
    let count = |points: u32, wraps: bool| if wraps { points / 3 } else { points.saturating_sub(1) / 3 } as usize;
    [count(mesh.size[0], wrap[0]), count(mesh.size[1], wrap[1])]
}

/// How many patches the teapot has.
pub(super) const TEAPOT_PATCHES: usize = 4 * PROFILES.len() + 2 * RIBBONS.len();

/// Curves of four points, radius and height, that are turned around the z axis: the lower and upper body, the rim, its inside, the
/// lid and its knob. (Newell's teapot of 1975, forty times its size, as it stands in Sunflow.)
const PROFILES: [[[f64; 2]; 4]; 6] = [
    [[80.0, 30.0], [80.0, 12.0], [60.0, 3.0], [60.0, 0.0]],
    [[60.0, 90.0], [70.0, 69.0], [80.0, 48.0], [80.0, 30.0]],
    [[56.0, 90.0], [53.5, 95.25], [57.5, 95.25], [60.0, 90.0]],
    [[50.0, 90.0], [52.0, 90.0], [54.0, 90.0], [56.0, 90.0]],
    [[8.0, 102.0], [16.0, 96.0], [52.0, 96.0], [52.0, 90.0]],
    [[0.0, 120.0], [32.0, 120.0], [0.0, 108.0], [8.0, 102.0]],
];

/// Bent tubes, the handle's two halves and the spout's: four rings, of each the inner place (x, z), the outer one, and half its
/// width.
const RIBBONS: [[[f64; 5]; 4]; 4] = [
    [
        [-64.0, 75.0, -60.0, 84.0, 12.0],
        [-92.0, 75.0, -100.0, 84.0, 12.0],
        [-108.0, 75.0, -120.0, 84.0, 12.0],
        [-108.0, 66.0, -120.0, 66.0, 12.0],
    ],
    [
        [-108.0, 66.0, -120.0, 66.0, 12.0],
        [-108.0, 57.0, -120.0, 48.0, 12.0],
        [-100.0, 39.0, -106.0, 31.5, 12.0],
        [-80.0, 30.0, -76.0, 18.0, 12.0],
    ],
    [
        [68.0, 51.0, 68.0, 18.0, 26.4],
        [104.0, 51.0, 124.0, 27.0, 26.4],
        [92.0, 78.0, 96.0, 75.0, 10.0],
        [108.0, 90.0, 132.0, 90.0, 10.0],
    ],
    [
        [108.0, 90.0, 132.0, 90.0, 10.0],
        [112.0, 93.0, 141.0, 93.75, 10.0],
        [116.0, 93.0, 138.0, 94.5, 6.0],
        [112.0, 90.0, 128.0, 90.0, 6.0],
    ],
];

pub(super) fn teapot(subdivision: &Subdivision) -> Mesh {
    /// How far the inner points of a curve lie from its ends, for a quarter of a circle; Newell's choice (0.5523 is nearer).
    const QUARTER: f64 = 0.56;
    let mut patches = Patchwork::default();
    for profile in PROFILES {
        for quarter in 0..4 {
            let turned = |x: f64, y: f64| match quarter {
                0 => [-x, -y],
                1 => [y, -x],
                2 => [x, y],
                _ => [-y, x],
            };
            let circle = [[1.0, 0.0], [1.0, QUARTER], [QUARTER, 1.0], [0.0, 1.0]].map(|[x, y]| turned(x, y));
            let row = |[radius, height]: [f64; 2]| circle.map(|[x, y]| DVec3::new(radius * x, radius * y, height));
            patches.add_patch(&profile.map(row), subdivision);
        }
    }
    for ribbon in RIBBONS {
        let side = |[x, z, other_x, other_z, width]: [f64; 5]| {
            [[x, 0.0, z], [x, width, z], [other_x, width, other_z], [other_x, 0.0, other_z]].map(DVec3::from)
        };
        patches.add_patch(&ribbon.map(side), subdivision);
        let mirrored = |ring| {
            let [a, b, c, d] = side(ring).map(|point| point * DVec3::new(1.0, -1.0, 1.0));
            [d, c, b, a]
        };
        patches.add_patch(&ribbon.map(mirrored), subdivision);
    }
    patches.finish()
}

fn edges(subdivision: &Subdivision) -> u32 {
    subdivision.count.map_or(8, |count| count.value.max(1))
}

/// Squares of triangles, patch by patch.
#[derive(Default)]
struct Patchwork {
    mesh: Mesh,
    normals: Vec<glam::Vec3>,
    uvs: Vec<Vec2>,
    flat: bool,
}

impl Patchwork {
    /// Adds a patch of so many squares along u and v, which both run from 0 to 1. Its front is where u turns to v against the clock.
    fn add(&mut self, [across, along]: [u32; 2], surface: impl Fn(f64, f64) -> At) {
        let first = self.mesh.positions.len() as u32;
        for (i, j) in (0..=across).flat_map(|i| (0..=along).map(move |j| (i, j))) {
            let at = surface(f64::from(i) / f64::from(across), f64::from(j) / f64::from(along));
            self.mesh.positions.push(at.point.as_vec3());
            self.normals.push(at.normal.as_vec3());
            self.uvs.push(at.uv);
        }
        for (i, j) in (0..across).flat_map(|i| (0..along).map(move |j| (i, j))) {
            let corner = first + i * (along + 1) + j;
            let [further, above, both] = [corner + along + 1, corner + 1, corner + along + 2];
            // The ends of a surface may come together in a point: no triangle is kept that has two corners there.
            let place = |number: u32| self.mesh.positions.get(number as usize).copied();
            for triangle in [[corner, further, above], [further, both, above]] {
                let [a, b, c] = triangle.map(place);
                if a != b && b != c && c != a {
                    self.mesh.triangles.push(triangle);
                }
            }
        }
    }

    /// Adds a bicubic patch: rows along v, in each four points along u. (Farin: Curves and Surfaces for CAGD, section 14.)
    fn add_patch(&mut self, controls: &[[DVec3; 4]; 4], subdivision: &Subdivision) {
        self.flat |= subdivision.smooth.is_some_and(|smooth| !smooth.value);
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

    fn finish(self) -> Mesh {
        let normals = if self.flat { Corners::None } else { Corners::PerPoint(self.normals) };
        Mesh { normals, uvs: Corners::PerPoint(self.uvs), ..self.mesh }
    }
}

fn bernstein(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t]
}

fn bernstein_slope(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t]
}

/// The spheres of a flake, centre and radius each: the first, and nine of a third of its size around it, six below and three above
/// as seen from where it grew. (Haines: A Proposal for Standard Graphics Environments, 1987; the angles are Sunflow's.)
pub(super) fn sphereflake(level: u32, axis: Triple, radius: f32) -> Vec<(DVec3, f64)> {
    fn grow(spheres: &mut Vec<(DVec3, f64)>, level: u32, center: DVec3, radius: f64, up: DVec3) {
        spheres.push((center, radius));
        let Some(below) = level.checked_sub(1) else { return };
        let [x, y, z] = up.to_array();
        // The axis that `up` leans to least has no part in the first of the two others.
        let across = if x * x < y * y && x * x < z * z {
            DVec3::new(0.0, z, -y)
        } else if y * y < z * z {
            DVec3::new(z, 0.0, -x)
        } else {
            DVec3::new(y, -x, 0.0)
        };
        let second = up.cross(across.normalize_or_zero());
        let first = up.cross(second);
        let step = std::f64::consts::PI / 3.0;
        let lower = (0..6).map(|number| (-0.3, f64::from(number) * step));
        let upper = (0..3).map(|number| (0.6, f64::from(6 * 3 - 1 + 6 * number) * step / 3.0));
        for (height, angle) in lower.chain(upper) {
            let (sin, cos) = libm::sincos(angle);
            let out = (up * height + first * sin + second * cos).normalize_or_zero();
            grow(spheres, below, center + out * (radius * 4.0 / 3.0), radius / 3.0, out);
        }
    }
    let mut spheres = Vec::new();
    grow(&mut spheres, level, DVec3::ZERO, f64::from(radius).abs(), dvec3(axis).normalize_or_zero());
    spheres
}

/// How often a flake is grown at most: to 597,871 spheres.
pub(super) const DEEPEST_FLAKE: u32 = 6;

/// How many spheres a flake has, if that can be counted: 1 + 9 + 81 ...
pub(super) fn spheres_of(level: u32) -> Option<usize> {
    Some((9usize.checked_pow(level.checked_add(1)?)? - 1) / 8)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the area, and six times the volume that the triangles enclose, as seen from outside.
    fn area_and_volume(mesh: &Mesh) -> (f64, f64) {
        mesh.triangles.iter().fold((0.0, 0.0), |(area, volume), corners| {
            let [a, b, c] = corners.map(|corner| mesh.positions[corner as usize].as_dvec3());
            let normal = (b - a).cross(c - a);
            (area + normal.length(), volume + a.dot(b.cross(c)))
        })
    }

    #[test]
    fn a_cylinder_has_its_area_and_looks_outwards() {
        // 2 pi times 2.
        let (area, _) = area_and_volume(&cylinder());
        assert!((area / 2.0 / (2.0 * std::f64::consts::TAU) - 1.0).abs() < 1e-3, "{area}");
        for mesh in [cylinder(), torus([0.5, 2.0])] {
            let Corners::PerPoint(normals) = &mesh.normals else { panic!("flat") };
            for corners in &mesh.triangles {
                let [a, b, c] = corners.map(|corner| mesh.positions[corner as usize]);
                assert!((b - a).cross(c - a).dot(normals[corners[0] as usize]) > 0.0);
            }
        }
    }

    #[test]
    fn a_torus_has_its_volume() {
        // 2 pi^2 R r^2 = 2 pi^2 2 0.25.
        let (_, volume) = area_and_volume(&torus([0.5, 2.0]));
        assert!((volume / 6.0 / std::f64::consts::PI.powi(2) - 1.0).abs() < 5e-3, "{volume}");
    }

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
        assert_eq!(area_and_volume(&made).0, 18.0);
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

    #[test]
    fn the_teapot_is_as_large_as_newell_s() {
        let made = teapot(&Subdivision::default());
        let (mut min, mut max) = (glam::Vec3::INFINITY, glam::Vec3::NEG_INFINITY);
        for position in &made.positions {
            (min, max) = (min.min(*position), max.max(*position));
        }
        // The handle's and spout's curves stay within their points at -120 and 141; the lid's knob reaches 120.
        assert!((-121.0..-110.0).contains(&min.x) && (130.0..141.0).contains(&max.x), "{min} {max}");
        assert_eq!((min.z, max.z), (0.0, 120.0));
        assert!((max.y - 80.0).abs() < 0.2 && (min.y + 80.0).abs() < 0.2, "{min} {max}");
        assert!(triangles_of(TEAPOT_PATCHES, &Subdivision::default()) == Some(32 * 128));
    }

    #[test]
    fn each_sphere_of_a_flake_touches_the_one_it_grows_from() {
        let spheres = sphereflake(2, [0.0, 0.0, 2.0], 3.0);
        assert_eq!(Some(spheres.len()), spheres_of(2));
        assert_eq!(spheres[0], (DVec3::ZERO, 3.0));
        for (center, radius) in spheres.iter().filter(|(_, radius)| *radius == 1.0) {
            assert!((center.length() - 4.0).abs() < 1e-12 && *radius == 1.0);
        }
        assert_eq!(spheres.iter().filter(|(_, radius)| *radius == 1.0).count(), 9);
        // Three above, six below.
        assert_eq!(spheres.iter().filter(|(center, radius)| *radius == 1.0 && center.z > 0.0).count(), 3);
        assert_eq!(spheres_of(40), None);
    }
}
