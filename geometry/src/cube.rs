use glam::{Vec2, Vec3};

use crate::{Corners, Mesh};

/// The cube of side 1 around the origin: twelve triangles, two a face.
///
/// Each face shows the whole texture, upright and unmirrored seen from outside. Upright means: towards +z on the four sides, as
/// a room's walls stand; on the top and the bottom towards +y and -y.
///
/// ```text
///   3-----2      u to the right, v upwards; a face is (0, 1, 2) and (0, 2, 3)
///   |   / |
///   | /   |
///   0-----1
/// ```
pub fn unit_cube() -> Mesh {
    /// For each face: its outward normal, and what is right in its picture. Up is normal x right.
    const FACES: [(Vec3, Vec3); 6] = [
        (Vec3::X, Vec3::Y),
        (Vec3::NEG_X, Vec3::NEG_Y),
        (Vec3::Y, Vec3::NEG_X),
        (Vec3::NEG_Y, Vec3::X),
        (Vec3::Z, Vec3::X),
        (Vec3::NEG_Z, Vec3::X),
    ];
    let mut mesh = Mesh::default();
    let mut uvs = Vec::new();
    for (normal, right) in FACES {
        let up = normal.cross(right);
        let first = mesh.positions.len() as u32;
        for (across, along) in [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)] {
            mesh.positions.push(0.5 * normal + across * right + along * up);
            uvs.push(Vec2::new(across + 0.5, along + 0.5));
        }
        mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    mesh.uvs = Corners::PerPoint(uvs);
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interval, Primitives, Ray};

    #[test]
    fn every_face_shows_the_whole_texture_upright_and_unmirrored_from_outside() {
        let mut cube = Primitives::default();
        cube.add_mesh(unit_cube());
        // Seen from outside, looking along -normal with `up` upwards, right is up x normal.
        for (normal, up) in [
            (Vec3::X, Vec3::Z),
            (-Vec3::X, Vec3::Z),
            (Vec3::Y, Vec3::Z),
            (-Vec3::Y, Vec3::Z),
            (Vec3::Z, Vec3::Y),
            (-Vec3::Z, -Vec3::Y),
        ] {
            let right = up.cross(normal);
            for (across, along) in [(-0.4, -0.4), (0.4, -0.4), (0.4, 0.3), (-0.4, 0.3)] {
                let ray = Ray::new(2.0 * normal + across * right + along * up, -normal);
                let hit = (0..12).find_map(|face| cube.intersect(face, &ray, Interval::FORWARD.up_to(2.0))).unwrap();
                let uv = cube.uv(&ray, &hit);
                assert!((uv - Vec2::new(across + 0.5, along + 0.5)).length() < 1e-6, "face {normal}: {uv}");
                assert_eq!(cube.surface(&ray, &hit).geometric_normal, normal, "outward");
            }
        }
    }
}
