use std::collections::HashMap;

use super::{Bytes, MeshFileError, broken, broken_line, number, push};
use crate::scene_file::{Mesh, Triple};

/// Three corners for each triangle; those at one place become one point. The normals in the file are not read: the corners say the
/// same.
pub(super) fn read(bytes: &[u8], most: usize) -> Result<Mesh, MeshFileError> {
    let mut mesh = Joined::default();
    match binary(bytes) {
        Some(triangles) => {
            for triangle in triangles {
                let mut rest = Bytes(triangle);
                let (Some(_normal), Some(corners)) = (rest.take::<12>(), rest.floats::<9>()) else {
                    return broken("a coordinate is not finite");
                };
                mesh.add(corners.as_chunks().0, most)?;
            }
        }
        None => text(bytes, &mut mesh, most)?,
    }
    Ok(mesh.mesh)
}

/// The triangles of a binary file, 50 bytes each, if that is its length. Many of these begin with `solid` as texts do.
fn binary(bytes: &[u8]) -> Option<std::slice::ChunksExact<'_, u8>> {
    let (count, triangles) = bytes.get(80..)?.split_first_chunk()?;
    let length = usize::try_from(u32::from_le_bytes(*count)).ok()?.checked_mul(50)?;
    (length == triangles.len()).then(|| triangles.chunks_exact(50))
}

/// `facet normal ... vertex x y z ...`: only the vertices matter.
fn text(bytes: &[u8], mesh: &mut Joined, most: usize) -> Result<(), MeshFileError> {
    let Some(text) = str::from_utf8(bytes).ok().filter(|text| text.trim_start().starts_with("solid")) else {
        return broken("it is neither a text that begins with `solid` nor as long as its count of triangles says");
    };
    let mut corners: Vec<Triple> = Vec::new();
    for (line, words) in (1..).zip(text.lines().map(str::split_ascii_whitespace)) {
        let mut words = words;
        match words.next() {
            Some("vertex") => {
                let mut coordinate = || number(words.next(), line);
                corners.push([coordinate()?, coordinate()?, coordinate()?]);
            }
            Some("endloop") if corners.len() < 3 => return broken_line(line, "a facet has fewer than 3 vertices"),
            Some("endloop") => {
                mesh.add(&corners, most)?;
                corners.clear();
            }
            _ => {}
        }
    }
    if corners.is_empty() { Ok(()) } else { broken("it ends within a facet") }
}

/// A mesh whose corners at one place are one point.
#[derive(Default)]
struct Joined {
    mesh: Mesh,
    numbers: HashMap<[u32; 3], u32>,
}

impl Joined {
    /// Adds a polygon, as a fan around its first corner.
    fn add(&mut self, corners: &[Triple], most: usize) -> Result<(), MeshFileError> {
        let mut numbers = Vec::with_capacity(corners.len());
        for corner in corners {
            // Bits, so that every coordinate has a key; the two zeros are one place.
            let key = corner.map(|coordinate| (coordinate + 0.0).to_bits());
            let points = &mut self.mesh.points.value;
            let next = points.len() as u32;
            let number = *self.numbers.entry(key).or_insert(next);
            if number == next {
                push(points, *corner, most)?;
            }
            numbers.push(number);
        }
        if let [first, rest @ ..] = numbers.as_slice() {
            for pair in rest.windows(2) {
                push(&mut self.mesh.triangles.value, [*first, pair[0], pair[1]], most)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "solid x
 facet normal 0 0 1
  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1e0 0\n  endloop\n endfacet
 facet normal 0 0 1
  outer loop\n   vertex 1 0 0\n   vertex 1 1 0\n   vertex 0 1 -0\n  endloop\n endfacet
endsolid x\n";

    fn as_binary(text: &str) -> Vec<u8> {
        let mesh = read(text.as_bytes(), 99).unwrap();
        let mut bytes = b"solid, but binary".to_vec();
        bytes.resize(80, b' ');
        bytes.extend((mesh.triangles.len() as u32).to_le_bytes());
        for corners in mesh.triangles.iter() {
            let corners = corners.map(|corner| mesh.points[corner as usize]);
            bytes.extend(
                [[0.0; 3], corners[0], corners[1], corners[2]].as_flattened().iter().flat_map(|n| n.to_le_bytes()),
            );
            bytes.extend([0, 0]);
        }
        bytes
    }

    #[test]
    fn corners_at_one_place_are_one_point() {
        let mesh = read(TEXT.as_bytes(), 99).unwrap();
        assert_eq!((mesh.points.len(), &mesh.triangles[..]), (4, &[[0, 1, 2], [1, 3, 2]][..]));
    }

    #[test]
    fn both_forms_hold_the_same_mesh_whatever_the_header_says() {
        assert_eq!(read(&as_binary(TEXT), 99), read(TEXT.as_bytes(), 99));
    }

    #[test]
    fn what_is_cut_off_or_too_large_is_refused() {
        let binary = as_binary(TEXT);
        assert!(read(&binary[..binary.len() - 1], 99).is_err());
        assert!(read(&TEXT.as_bytes()[..80], 99).is_err());
        assert_eq!(read(TEXT.as_bytes(), 3), Err(MeshFileError::OverLimit(3)));
        assert!(read(b"", 9).is_err());
    }
}
