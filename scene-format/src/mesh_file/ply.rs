use super::{MeshFileError, broken, polygon, push};
use crate::scene_file::{Mesh, PerVertex, Triple};

/// How the values stand in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// The type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

/// One value of an element, or a list of them.
struct Property {
    name: String,
    /// Of a list: the type of its count.
    counted_by: Option<Scalar>,
    scalar: Scalar,
}

/// `element NAME COUNT` and its properties.
struct Element {
    name: String,
    count: u64,
    properties: Vec<Property>,
}

/// Stanford's PLY, as text or binary: of `vertex` the place, normal and texture coordinates, of `face` the list of corners, cut into
/// triangles. Everything else is passed over.
pub(super) fn read(bytes: &[u8], most: usize) -> Result<Mesh, MeshFileError> {
    let (encoding, elements, body) = header(bytes)?;
    let mut values = Values { encoding, rest: body };
    let mut mesh = Mesh::default();
    let (mut normals, mut uvs): (Vec<Triple>, Vec<[f32; 2]>) = (Vec::new(), Vec::new());
    let mut corners = Vec::new();
    for element in &elements {
        if element.properties.is_empty() {
            // Such elements take no bytes: their count must not take time.
            continue;
        }
        let vertex = (element.name == "vertex").then(|| VertexPlaces::of(&element.properties));
        let mut row = Vec::with_capacity(element.properties.len());
        for _ in 0..element.count {
            row.clear();
            for property in &element.properties {
                match property.counted_by {
                    None => row.push(values.next(property.scalar)?),
                    Some(count) => {
                        let is_face = element.name == "face" && property.name.starts_with("vertex_ind");
                        values.list(count, property.scalar, most, &mut corners)?;
                        if is_face {
                            add_face(&mut mesh, &corners, most)?;
                        }
                        row.push(0.0);
                    }
                }
            }
            let Some(places) = &vertex else { continue };
            push(&mut mesh.points.value, triple(&row, Some(places.point))?, most)?;
            if places.normal.is_some() {
                normals.push(triple(&row, places.normal)?);
            }
            if let Some([u, v]) = places.uv {
                uvs.push([float(&row, u)?, float(&row, v)?]);
            }
        }
    }
    let points = mesh.points.len();
    if points > 0 && normals.len() == points {
        mesh.normals.value = PerVertex::Vertex(normals);
    }
    if points > 0 && uvs.len() == points {
        mesh.uvs.value = PerVertex::Vertex(uvs);
    }
    Ok(mesh)
}

/// Where in a vertex its values stand.
struct VertexPlaces {
    /// Missing coordinates lie outside every row, which is told when one is read.
    point: [usize; 3],
    normal: Option<[usize; 3]>,
    uv: Option<[usize; 2]>,
}

impl VertexPlaces {
    fn of(properties: &[Property]) -> Self {
        let place = |name: &str| properties.iter().position(|property| property.name == name);
        let point = ["x", "y", "z"].map(|name| place(name).unwrap_or(usize::MAX));
        let normal = match ["nx", "ny", "nz"].map(place) {
            [Some(x), Some(y), Some(z)] => Some([x, y, z]),
            _ => None,
        };
        let uv =
            [["u", "v"], ["s", "t"], ["texture_u", "texture_v"]].into_iter().find_map(|names| match names.map(place) {
                [Some(u), Some(v)] => Some([u, v]),
                _ => None,
            });
        Self { point, normal, uv }
    }
}

fn float(row: &[f64], place: usize) -> Result<f32, MeshFileError> {
    match row.get(place).map(|value| *value as f32) {
        Some(value) if value.is_finite() => Ok(value),
        Some(_) => broken("a vertex has a value that is not finite"),
        None => broken("its vertices have no x, y and z"),
    }
}

fn triple(row: &[f64], places: Option<[usize; 3]>) -> Result<Triple, MeshFileError> {
    let [x, y, z] = places.unwrap_or([usize::MAX; 3]);
    Ok([float(row, x)?, float(row, y)?, float(row, z)?])
}

fn add_face(mesh: &mut Mesh, corners: &[f64], most: usize) -> Result<(), MeshFileError> {
    let corners: Vec<u32> =
        corners.iter().map(|&value| if (0.0..4e9).contains(&value) { value as u32 } else { u32::MAX }).collect();
    // Where the vertices stand behind the faces, nothing is known of their places yet.
    let place = |corner: &u32| mesh.points.get(*corner as usize).copied().unwrap_or_default();
    let places: Vec<Triple> = corners.iter().map(place).collect();
    polygon::triangles(&places, |places| push(&mut mesh.triangles.value, places.map(|place| corners[place]), most))
}

/// The encoding, the elements, and the bytes behind the header.
fn header(bytes: &[u8]) -> Result<(Encoding, Vec<Element>, &[u8]), MeshFileError> {
    /// Headers are short; a file without an end of its header is none.
    const LONGEST: usize = 1 << 16;
    let (mut encoding, mut elements, mut rest) = (None, Vec::<Element>::new(), bytes);
    let mut first = true;
    loop {
        let Some(end) = rest.iter().take(LONGEST).position(|&byte| byte == b'\n') else {
            return broken("its header has no end");
        };
        let (line, behind) = rest.split_at(end + 1);
        rest = behind;
        let Ok(line) = str::from_utf8(line) else { return broken("its header is no text") };
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        if std::mem::take(&mut first) != (words == ["ply"]) {
            return broken("it does not begin with a line `ply`");
        }
        match words.as_slice() {
            ["format", format, _] => {
                encoding = match *format {
                    "ascii" => Some(Encoding::Text),
                    "binary_little_endian" => Some(Encoding::LittleEndian),
                    "binary_big_endian" => Some(Encoding::BigEndian),
                    other => return broken(format!("its format `{other}` is not known")),
                };
            }
            ["element", name, count] => match count.parse() {
                Ok(count) => elements.push(Element { name: (*name).to_owned(), count, properties: Vec::new() }),
                Err(_) => return broken(format!("`{count}` is no count of elements")),
            },
            ["property", "list", count, scalar, name] => add_property(&mut elements, name, Some(count), scalar)?,
            ["property", scalar, name] => add_property(&mut elements, name, None, scalar)?,
            ["end_header"] => break,
            _ => {}
        }
    }
    match encoding {
        Some(encoding) => Ok((encoding, elements, rest)),
        None => broken("its header does not say its format"),
    }
}

fn add_property(
    elements: &mut [Element],
    name: &str,
    counted_by: Option<&str>,
    kind: &str,
) -> Result<(), MeshFileError> {
    let Some(element) = elements.last_mut() else { return broken("a property stands before the first element") };
    let counted_by = counted_by.map(scalar).transpose()?;
    element.properties.push(Property { name: name.to_owned(), counted_by, scalar: scalar(kind)? });
    Ok(())
}

fn scalar(name: &str) -> Result<Scalar, MeshFileError> {
    Ok(match name {
        "char" | "int8" => Scalar::I8,
        "uchar" | "uint8" => Scalar::U8,
        "short" | "int16" => Scalar::I16,
        "ushort" | "uint16" => Scalar::U16,
        "int" | "int32" => Scalar::I32,
        "uint" | "uint32" => Scalar::U32,
        "float" | "float32" => Scalar::F32,
        "double" | "float64" => Scalar::F64,
        other => return broken(format!("the type `{other}` is not known")),
    })
}

/// The values behind the header, one after the other.
struct Values<'b> {
    encoding: Encoding,
    rest: &'b [u8],
}

impl Values<'_> {
    /// Every type fits into 64-bit floats.
    fn next(&mut self, scalar: Scalar) -> Result<f64, MeshFileError> {
        let value = match (self.encoding, scalar) {
            (Encoding::Text, _) => self.word(),
            (_, Scalar::I8) => self.bytes().map(|bytes| i8::from_le_bytes(bytes).into()),
            (_, Scalar::U8) => self.bytes().map(|bytes| u8::from_le_bytes(bytes).into()),
            (_, Scalar::I16) => self.bytes().map(|bytes| i16::from_le_bytes(bytes).into()),
            (_, Scalar::U16) => self.bytes().map(|bytes| u16::from_le_bytes(bytes).into()),
            (_, Scalar::I32) => self.bytes().map(|bytes| i32::from_le_bytes(bytes).into()),
            (_, Scalar::U32) => self.bytes().map(|bytes| u32::from_le_bytes(bytes).into()),
            (_, Scalar::F32) => self.bytes().map(|bytes| f32::from_le_bytes(bytes).into()),
            (_, Scalar::F64) => self.bytes().map(f64::from_le_bytes),
        };
        match value {
            Some(value) => Ok(value),
            None => broken("it ends before all its elements, or has a word that is no number"),
        }
    }

    fn list(&mut self, count: Scalar, scalar: Scalar, most: usize, values: &mut Vec<f64>) -> Result<(), MeshFileError> {
        values.clear();
        let count = self.next(count)?;
        if !(0.0..=4e9).contains(&count) {
            return broken("a list has no possible length");
        }
        for _ in 0..count as u64 {
            push(values, self.next(scalar)?, most)?;
        }
        Ok(())
    }

    fn word(&mut self) -> Option<f64> {
        let blank = |byte: &u8| byte.is_ascii_whitespace();
        let start = self.rest.iter().position(|byte| !blank(byte))?;
        let word = self.rest.get(start..)?;
        let (word, rest) = word.split_at(word.iter().position(blank).unwrap_or(word.len()));
        self.rest = rest;
        str::from_utf8(word).ok()?.parse().ok()
    }

    /// The bytes of a value, the lowest first.
    fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (bytes, rest) = self.rest.split_first_chunk::<N>()?;
        self.rest = rest;
        let mut bytes = *bytes;
        if self.encoding == Encoding::BigEndian {
            bytes.reverse();
        }
        Some(bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROPERTIES: &str = "comment by hand\nelement vertex 4\nproperty float x\nproperty double y\nproperty float z\n\
        property uchar red\nproperty float u\nproperty float v\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

    /// The same square, as text or with each value's bytes in order.
    fn square(format: &str) -> Vec<u8> {
        let mut bytes = format!("ply\nformat {format} 1.0\n{PROPERTIES}").into_bytes();
        let vertices = [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        if format == "ascii" {
            for [x, y] in vertices {
                bytes.extend(format!("{x} {y} 0 255 {x} {y}\n").into_bytes());
            }
            bytes.extend(b"4 0 1 2 3\n");
            return bytes;
        }
        let mut add = |mut value: Vec<u8>| {
            if format == "binary_big_endian" {
                value.reverse();
            }
            bytes.extend(value);
        };
        for [x, y] in vertices {
            add(x.to_le_bytes().to_vec());
            add(f64::from(y).to_le_bytes().to_vec());
            add(0.0f32.to_le_bytes().to_vec());
            add(vec![255]);
            add(x.to_le_bytes().to_vec());
            add(y.to_le_bytes().to_vec());
        }
        add(vec![4]);
        (0..4i32).for_each(|corner| add(corner.to_le_bytes().to_vec()));
        bytes
    }

    #[test]
    fn all_three_forms_hold_the_same_mesh() {
        let mesh = read(&square("ascii"), 9).unwrap();
        assert_eq!(*mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(mesh.points[2], [1.0, 1.0, 0.0]);
        assert_eq!(*mesh.uvs, PerVertex::Vertex(vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]));
        for format in ["binary_little_endian", "binary_big_endian"] {
            assert_eq!(read(&square(format), 9).as_ref(), Ok(&mesh), "{format}");
        }
    }

    #[test]
    fn what_is_cut_off_is_refused_at_every_length() {
        for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
            let file = square(format);
            for length in 0..file.len() - 2 {
                assert!(read(&file[..length], 9).is_err(), "{format} up to {length}");
            }
        }
    }

    #[test]
    fn counts_take_neither_memory_nor_time_before_their_values_are_there() {
        for header in [
            "ply\nformat ascii 1.0\nelement vertex 18446744073709551615\nend_header\n",
            "ply\nformat binary_little_endian 1.0\nelement face 99999999999\nproperty list uint int vertex_indices\nend_header\n\u{7f}\u{7f}\u{7f}\u{7f}",
        ] {
            drop(read(header.as_bytes(), 9));
        }
        assert_eq!(read(&square("ascii"), 3), Err(MeshFileError::OverLimit(3)));
    }
}
