use crate::scene_file::{Mesh, PerVertex};

/// Gives each point of a mesh a normal: the mean of those of its triangles, weighted by their areas, as Sunflow does. Points of no
/// triangle that has an area get 0 0 0.
pub fn smooth_normals(mesh: &mut Mesh) {
    let mut sums = vec![[0.0f64; 3]; mesh.points.len()];
    for triangle in mesh.triangles.iter() {
        let corner = |at: u32| mesh.points.get(at as usize).map(|point| point.map(f64::from));
        let [Some(a), Some(b), Some(c)] = triangle.map(corner) else { continue };
        let edge = |to: [f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
        let (u, v) = (edge(b), edge(c));
        // Twice the triangle's area long.
        let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        for &corner in triangle {
            if let Some(sum) = sums.get_mut(corner as usize) {
                sum.iter_mut().zip(normal).for_each(|(sum, part)| *sum += part);
            }
        }
    }
    mesh.normals.value = PerVertex::Vertex(sums.into_iter().map(unit).collect());
}

fn unit(vector: [f64; 3]) -> [f32; 3] {
    // The largest component first: so squares neither overflow nor vanish.
    let largest = vector.iter().fold(0.0f64, |largest, part| largest.max(part.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return [0.0; 3];
    }
    let scaled = vector.map(|part| part / largest);
    let length = scaled.iter().map(|part| part * part).sum::<f64>().sqrt();
    scaled.map(|part| (part / length) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn larger_triangles_count_for_more() {
        // Around the origin: one of area 2 facing z, one of area 1/2 facing x. The mean is (1, 0, 4), over its length sqrt(17).
        let points = vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mut mesh = Mesh { points: points.into(), triangles: vec![[0, 1, 2], [0, 3, 4]].into(), ..Mesh::default() };
        smooth_normals(&mut mesh);
        let PerVertex::Vertex(normals) = &*mesh.normals else { panic!("none") };
        let expected = [1.0, 0.0, 4.0].map(|part| part / 17.0f32.sqrt());
        assert!(normals[0].iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-6));
        assert_eq!((normals[1], normals[4]), ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]));
    }
}
