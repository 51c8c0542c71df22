use super::{Other, Transform, Triple};
use crate::span::Spanned;

/// `object { ... }`
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// `shader NAME` or `shaders N NAME ...`; the first is used unless a mesh has face shaders. Empty after `noinstance`.
    pub shaders: Vec<Spanned<String>>,
    /// `modifier NAME` or `modifiers N NAME ...`
    pub modifiers: Vec<Spanned<String>>,
    /// `transform <matrix>`; of a moving object the first.
    pub transform: Option<Spanned<Transform>>,
    /// `noinstance`: only a geometry for instances to use, not itself in the picture.
    pub noinstance: bool,
    /// `name NAME`
    pub name: Option<Spanned<String>>,
    /// What it is, with the place of its type.
    pub shape: Spanned<Shape>,
}

/// `instance { ... }`: a geometry once more, at another place.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// `name NAME`
    pub name: Option<Spanned<String>>,
    /// `geometry NAME`: the name of the object whose geometry it shows, without that object's transform and shader.
    pub geometry: Spanned<String>,
    /// `transform <matrix>`
    pub transform: Option<Spanned<Transform>>,
    /// As in an [`Object`].
    pub shaders: Vec<Spanned<String>>,
    /// As in an [`Object`].
    pub modifiers: Vec<Spanned<String>>,
}

/// What an object is.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// `sphere`
    Sphere(SphereForm),
    /// `plane`: infinite.
    Plane {
        /// `p`: a point on it.
        point: Triple,
        /// How it is turned.
        orientation: PlaneOrientation,
    },
    /// `box`: the cube from -0.5 to 0.5 on each axis.
    Box,
    /// `generic-mesh`, `mesh` or `flat-mesh`.
    Mesh(Mesh),
    /// Any other type: not rendered.
    Other(Other),
}

/// The two ways to write a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SphereForm {
    /// Radius 1 around the origin, placed by the transform.
    Unit,
    /// `c <point> r <float>`: radius greater than 0.
    CenterRadius {
        /// The centre.
        center: Triple,
        /// The radius.
        radius: f32,
    },
}

/// How a plane is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneOrientation {
    /// `n <vector>`: its normal, of any length but 0.
    Normal(Triple),
    /// `p <point> p <point>`: two more points; the edges from the first point to them span the texture.
    Points([Triple; 2]),
}

/// A mesh of triangles. Every index is below the number of points: the reader sees to it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The form in which it was written.
    pub form: MeshForm,
    /// The points.
    pub points: Vec<Triple>,
    /// Three indices into the points for each triangle, counter-clockwise seen from the front.
    pub triangles: Vec<[u32; 3]>,
    /// Normals, of any length.
    pub normals: PerVertex<3>,
    /// Texture coordinates.
    pub uvs: PerVertex<2>,
    /// `face_shaders`: for each triangle, an index into the object's shaders.
    pub face_shaders: Option<Vec<u32>>,
}

/// The three ways to write a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeshForm {
    /// `generic-mesh`
    #[default]
    Generic,
    /// `mesh`: points with normals and texture coordinates on one line.
    Lines,
    /// `flat-mesh`: the same lines; their normals are read, kept and not used.
    FlatLines,
}

/// Values at the corners of a mesh's triangles, `N` numbers each.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum PerVertex<const N: usize> {
    /// `none`, or nothing written.
    #[default]
    None,
    /// `vertex`: one value for each point.
    Vertex(Vec<[f32; N]>),
    /// `facevarying`: three values for each triangle.
    FaceVarying(Vec<[[f32; N]; 3]>),
}
