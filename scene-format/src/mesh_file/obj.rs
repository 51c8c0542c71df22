use super::{MeshFileError, broken, broken_line, number, polygon, push};
use crate::scene_file::{Mesh, PerVertex, Triple};

/// What an OBJ file lists: everything is counted from 1, or backwards from the end.
#[derive(Default)]
struct Lists {
    points: Vec<Triple>,
    uvs: Vec<[f32; 2]>,
    normals: Vec<Triple>,
}

/// A corner of a face, its numbers counted from 0.
#[derive(Clone, Copy)]
struct Corner {
    point: u32,
    uv: Option<[f32; 2]>,
    normal: Option<Triple>,
}

/// Wavefront's OBJ: `v`, `vt`, `vn` and `f`; groups, materials and curves are passed over. A line that ends with `\` goes on in the
/// next one. Texture coordinates and normals count only where every corner has them.
pub(super) fn read(bytes: &[u8], most: usize) -> Result<Mesh, MeshFileError> {
    let text = match crate::decode(bytes) {
        Ok(text) => text,
        Err(error) => return broken(error.to_string()),
    };
    let mut lists = Lists::default();
    let mut triangles: Vec<[Corner; 3]> = Vec::new();
    let (mut corners, mut places): (Vec<Corner>, Vec<Triple>) = (Vec::new(), Vec::new());
    let mut lines = (1..).zip(text.lines());
    let mut whole = String::new();
    while let Some((line, beginning)) = lines.next() {
        whole.clear();
        whole.push_str(beginning);
        // Not a comment, which may end with the name of a folder.
        while whole.ends_with('\\') && !whole.starts_with('#') {
            whole.pop();
            whole.push_str(lines.next().map_or("", |(_, more)| more));
        }
        let mut words = whole.split_ascii_whitespace();
        let keyword = words.next();
        let mut coordinate = || number(words.next(), line);
        match keyword {
            Some("v") => push(&mut lists.points, [coordinate()?, coordinate()?, coordinate()?], most)?,
            Some("vn") => push(&mut lists.normals, [coordinate()?, coordinate()?, coordinate()?], most)?,
            // One coordinate alone is a place in a band of colours.
            Some("vt") => {
                let u = coordinate()?;
                let v = words.next().map_or(Ok(0.0), |word| number(Some(word), line))?;
                push(&mut lists.uvs, [u, v], most)?;
            }
            Some("f") => {
                corners.clear();
                for word in words.take_while(|word| !word.starts_with('#')) {
                    corners.push(lists.corner(word, line)?);
                }
                if corners.len() < 3 {
                    return broken_line(line, "a face has fewer than 3 corners");
                }
                places.clear();
                places.extend(corners.iter().filter_map(|corner| lists.points.get(corner.point as usize)));
                polygon::triangles(&places, |places| push(&mut triangles, places.map(|place| corners[place]), most))?;
            }
            _ => {}
        }
    }
    Ok(mesh(lists.points, &triangles))
}

impl Lists {
    /// `point`, `point/uv`, `point//normal` or `point/uv/normal`.
    fn corner(&self, word: &str, line: usize) -> Result<Corner, MeshFileError> {
        let mut numbers = word.split('/').map(|number| (!number.is_empty()).then_some(number));
        let Some(point) = numbers.next().flatten() else {
            return broken_line(line, format!("`{word}` is no corner: it begins with the number of a point"));
        };
        let point = place(point, self.points.len(), "v", line)?;
        let uv = numbers.next().flatten().map(|number| place(number, self.uvs.len(), "vt", line)).transpose()?;
        let normal =
            numbers.next().flatten().map(|number| place(number, self.normals.len(), "vn", line)).transpose()?;
        Ok(Corner {
            point: point as u32,
            uv: uv.and_then(|at| self.uvs.get(at).copied()),
            normal: normal.and_then(|at| self.normals.get(at).copied()),
        })
    }
}

/// A place in a list of so many, from a number that counts from 1, or from -1 backwards.
fn place(word: &str, count: usize, list: &str, line: usize) -> Result<usize, MeshFileError> {
    let place = match word.parse::<i64>() {
        Ok(number @ 1..) => usize::try_from(number - 1).ok(),
        Ok(number @ ..=-1) => usize::try_from(number.unsigned_abs()).ok().and_then(|back| count.checked_sub(back)),
        _ => None,
    };
    match place.filter(|place| *place < count) {
        Some(place) => Ok(place),
        None => {
            broken_line(line, format!("`{word}` is not the number of a `{list}`: there are {count} before this line"))
        }
    }
}

fn mesh(points: Vec<Triple>, triangles: &[[Corner; 3]]) -> Mesh {
    fn all<const N: usize>(
        triangles: &[[Corner; 3]],
        value: impl Fn(&Corner) -> Option<[f32; N]>,
    ) -> Option<Vec<[[f32; N]; 3]>> {
        triangles.iter().map(|[a, b, c]| Some([value(a)?, value(b)?, value(c)?])).collect()
    }
    let values = |found: Option<_>| found.filter(|_| !triangles.is_empty());
    let uvs = values(all(triangles, |corner| corner.uv)).map_or(PerVertex::None, PerVertex::FaceVarying);
    let normals = all(triangles, |corner| corner.normal).filter(|_| !triangles.is_empty());
    Mesh {
        points: points.into(),
        triangles: triangles.iter().map(|corners| corners.map(|corner| corner.point)).collect::<Vec<_>>().into(),
        normals: normals.map_or(PerVertex::None, PerVertex::FaceVarying).into(),
        uvs: uvs.into(),
        ..Mesh::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = "o x\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";

    fn of(faces: &str) -> Result<Mesh, MeshFileError> {
        read(format!("{SQUARE}{faces}").as_bytes(), 9)
    }

    #[test]
    fn a_polygon_is_cut_into_triangles() {
        assert_eq!(*of("f 1 2 3 4 # a square").unwrap().triangles, [[0, 1, 2], [0, 2, 3]]);
        // With a dent at the last corner, which a fan around the first would leave.
        assert_eq!(*of("v .5 .1 0\nf 1 2 3 5").unwrap().triangles, [[4, 0, 1], [1, 2, 4]]);
    }

    #[test]
    fn a_line_may_go_on_in_the_next_one() {
        assert_eq!(of("f 1 \\\n2 3 \\\r\n 4"), of("f 1 2 3 4"));
        assert_eq!(of("f 1 2 3 \\"), of("f 1 2 3"));
        // Comments do not; and lines are counted as they stand in the file.
        assert!(matches!(of("# \\\nf 1 2 \\\n3\nf 1 2 9"), Err(MeshFileError::BrokenLine { line: 14, .. })));
    }

    #[test]
    fn numbers_below_zero_count_backwards() {
        assert_eq!(of("f -4/-4/-1 -3/-3/-1 -2/-2/-1"), of("f 1/1/1 2/2/1 3/3/1"));
    }

    #[test]
    fn values_at_corners_are_read_where_all_have_them() {
        let mesh = of("f 1/1/1 2/2/1 3/3/1").unwrap();
        assert_eq!(*mesh.uvs, PerVertex::FaceVarying(vec![[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]]));
        assert_eq!(*mesh.normals, PerVertex::FaceVarying(vec![[[0.0, 0.0, 1.0]; 3]]));
        let mesh = of("f 1//1 2//1 3//1\nf 1 3 4").unwrap();
        assert_eq!((mesh.uvs.value, mesh.normals.value), (PerVertex::None, PerVertex::None));
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        for (face, line) in
            [("f 1 2", 11), ("f 1 2 5", 11), ("f 0 1 2", 11), ("f 1 2 x", 11), ("\nf 1/9 2 3", 12), ("v 1 NaN 2", 11)]
        {
            assert!(matches!(of(face), Err(MeshFileError::BrokenLine { line: found, .. }) if found == line), "{face}");
        }
        assert_eq!(read(SQUARE.as_bytes(), 3), Err(MeshFileError::OverLimit(3)));
    }
}
