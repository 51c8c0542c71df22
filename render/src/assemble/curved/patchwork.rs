use geometry::{Corners, Mesh};
use glam::{DVec3, Vec2};

/// What a surface is at a place of its two coordinates.
pub(super) struct At {
    pub(super) point: DVec3,
    pub(super) normal: DVec3,
    pub(super) uv: Vec2,
}

/// Squares of triangles, patch by patch.
#[derive(Default)]
pub(super) struct Patchwork {
    mesh: Mesh,
    normals: Vec<glam::Vec3>,
    uvs: Vec<Vec2>,
    is_flat: bool,
}

impl Patchwork {
    /// Adds a patch of so many squares along u and v, which both run from 0 to 1. Its front is where u turns to v against the clock.
    pub(super) fn add(&mut self, [across, along]: [u32; 2], surface: impl Fn(f64, f64) -> At) {
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

    /// Leaves out the normals: every triangle is flat.
    pub(super) fn flatten(&mut self) {
        self.is_flat = true;
    }

    pub(super) fn finish(self) -> Mesh {
        let normals = if self.is_flat { Corners::None } else { Corners::PerPoint(self.normals) };
        Mesh { normals, uvs: Corners::PerPoint(self.uvs), ..self.mesh }
    }
}
