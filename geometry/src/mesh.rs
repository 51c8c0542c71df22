use glam::{Vec2, Vec3};

/// Triangles that share points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The points.
    pub positions: Vec<Vec3>,
    /// Three indices into the points for each triangle, counter-clockwise seen from the front.
    pub triangles: Vec<[u32; 3]>,
    /// Normals to shade with, of any length; a zero one falls back to the triangle's own.
    pub normals: Corners<Vec3>,
    /// Texture coordinates; without them the two edges from a triangle's first corner are the basis.
    pub uvs: Corners<Vec2>,
}

/// Values at the corners of a mesh's triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Corners<T> {
    /// None are given.
    #[default]
    None,
    /// The same at every corner.
    Everywhere(T),
    /// One for each point.
    PerPoint(Vec<T>),
    /// Three for each triangle.
    PerTriangle(Vec<[T; 3]>),
}

impl<T: Copy> Corners<T> {
    pub(crate) fn of(&self, face: usize, corners: [u32; 3]) -> Option<[T; 3]> {
        match self {
            Self::None => None,
            Self::Everywhere(value) => Some([*value; 3]),
            Self::PerPoint(values) => Some(corners.map(|corner| values[corner as usize])),
            Self::PerTriangle(values) => Some(values[face]),
        }
    }
}

impl<T> Corners<T> {
    /// How many values are missing.
    pub(crate) fn missing(&self, positions: &[Vec3], triangles: &[[u32; 3]]) -> usize {
        match self {
            Self::None | Self::Everywhere(_) => 0,
            Self::PerPoint(values) => positions.len().saturating_sub(values.len()),
            Self::PerTriangle(values) => triangles.len().saturating_sub(values.len()),
        }
    }

    fn bytes(&self) -> usize {
        match self {
            Self::None | Self::Everywhere(_) => 0,
            Self::PerPoint(values) => size_of_val(&values[..]),
            Self::PerTriangle(values) => size_of_val(&values[..]),
        }
    }
}

/// What a mesh keeps beside its triangles' corners.
#[derive(Clone, Debug)]
pub(crate) struct MeshCorners {
    pub(crate) first_triangle: u32,
    /// Empty when no value is given for each point.
    pub(crate) point_indices: Vec<[u32; 3]>,
    pub(crate) normals: Corners<Vec3>,
    pub(crate) uvs: Corners<Vec2>,
}

impl MeshCorners {
    pub(crate) fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&self.point_indices[..]) + self.normals.bytes() + self.uvs.bytes()
    }
}
