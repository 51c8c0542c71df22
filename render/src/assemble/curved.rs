//! Curved surfaces as triangles, each with the normals and texture coordinates of the surface, as Sunflow has them.

mod bezier;
mod flake;
mod gumbo;
mod patchwork;
mod teapot;

use glam::{DVec3, Vec2};

pub(super) use bezier::{bezier, patches_of, triangles_of};
pub(super) use flake::{DEEPEST_FLAKE, sphereflake, spheres_of};
use geometry::Mesh;
pub(super) use gumbo::{GUMBO_PATCHES, gumbo};
use patchwork::{At, Patchwork};
pub(super) use teapot::{TEAPOT_PATCHES, teapot};

/// So many squares go once around a circle: its outline is off by at most 1 - cos(pi / 128), 0.03 % of its radius.
const AROUND: u32 = 128;

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

#[cfg(test)]
mod tests {
    use geometry::Corners;

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
}
