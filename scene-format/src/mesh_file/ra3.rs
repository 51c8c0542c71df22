use super::{Bytes, MeshFileError, broken};
use crate::scene_file::Mesh;

/// Sunflow's own: two counts, then points and corners, all of 32 bits with the lowest byte first.
pub(super) fn read(bytes: &[u8], most: usize) -> Result<Mesh, MeshFileError> {
    let mut rest = Bytes(bytes);
    let mut count = || rest.take().map(i32::from_le_bytes).and_then(|count| usize::try_from(count).ok());
    let (Some(points), Some(triangles)) = (count(), count()) else {
        return broken("it does not begin with two counts");
    };
    if points.max(triangles) > most {
        return Err(MeshFileError::OverLimit(most));
    }
    // A point and a triangle take 12 bytes each.
    if rest.0.len() != (points + triangles) * 12 {
        return broken(format!("{points} points and {triangles} triangles are announced, which is not its length"));
    }
    let mut mesh = Mesh::default();
    for _ in 0..points {
        let Some(point) = rest.floats() else { return broken("a coordinate is not finite") };
        mesh.points.value.push(point);
    }
    while let (Some(a), Some(b), Some(c)) = (rest.take(), rest.take(), rest.take()) {
        mesh.triangles.value.push([a, b, c].map(u32::from_le_bytes));
    }
    Ok(mesh)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(counts: [i32; 2], points: &[f32], corners: &[i32]) -> Vec<u8> {
        let counts = counts.iter().flat_map(|count| count.to_le_bytes());
        let points = points.iter().flat_map(|number| number.to_le_bytes());
        counts.chain(points).chain(corners.iter().flat_map(|corner| corner.to_le_bytes())).collect()
    }

    #[test]
    fn points_and_corners_are_read() {
        let mesh = read(&file([3, 1], &[0., 0., 0., 1., 0., 0., 0., 2., 0.], &[0, 1, 2]), 9).unwrap();
        assert_eq!(*mesh.points, [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]]);
        assert_eq!(*mesh.triangles, [[0, 1, 2]]);
    }

    #[test]
    fn counts_that_are_not_its_length_are_refused() {
        for counts in [[3, 2], [2, 1], [-1, 4], [i32::MAX, i32::MAX]] {
            assert!(read(&file(counts, &[0.0; 9], &[0; 3]), 9).is_err(), "{counts:?}");
        }
        assert!(read(&[0; 7], 9).is_err());
    }
}
