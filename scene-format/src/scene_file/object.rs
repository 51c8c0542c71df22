use super::{Transform, Triple, Unknown, Unrendered};
use crate::span::Spanned;

/// `object { ... }`
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// `shader NAME` or `shaders N NAME ...`; the first is used unless a mesh has face shaders. Empty after `noinstance`.
    pub shaders: Vec<Spanned<String>>,
    /// `modifier NAME` or `modifiers N NAME ...`
    pub modifiers: Vec<Spanned<String>>,
    /// `transform <matrix>`
    pub transform: Option<Spanned<Transform>>,
    /// `noinstance`: only a geometry for instances to use, not itself in the picture.
    pub noinstance: Option<Spanned<()>>,
    /// `accel NAME`: not heeded, since one accelerator holds the whole scene.
    pub accelerator: Option<Spanned<String>>,
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
        point: Spanned<Triple>,
        /// How it is turned.
        orientation: PlaneOrientation,
    },
    /// `box`: the cube from -0.5 to 0.5 on each axis.
    Box,
    /// `generic-mesh`, `mesh` or `flat-mesh`.
    Mesh(Mesh),
    /// `file-mesh`: a mesh from another file.
    FileMesh {
        /// `filename FILE`
        file: Spanned<String>,
        /// `smooth_normals BOOL`: normals that let it look round, unless the file has its own; `false` unless given.
        smooth: Option<Spanned<bool>>,
    },
    /// `bezier-mesh`
    Bezier(BezierMesh),
    /// `cylinder`: radius 1 around the z axis, from z = -1 to 1, open at both ends.
    Cylinder,
    /// `torus`: around the z axis.
    Torus {
        /// `r <inner> <outer>`: first the radius of the ring's tube, then that of the circle in its middle, both greater than 0.
        radii: Spanned<[f32; 2]>,
    },
    /// `sphereflake`: a sphere with nine of a third of its size on it, each with nine ...
    Sphereflake {
        /// `level N`: how often; 2 unless given.
        level: Option<Spanned<u32>>,
        /// `axis <vector>`: where the flake's top points, not 0; 0 0 1 unless given.
        axis: Option<Spanned<Triple>>,
        /// `radius R`: of the sphere in the middle; 1 unless given.
        radius: Option<Spanned<f32>>,
    },
    /// `teapot`: Newell's, its height along z.
    Teapot(Subdivision),
    /// `gumbo`: Catmull's elephant.
    Gumbo(Subdivision),
    /// `particles`: spheres of one size.
    Particles {
        /// Their centres.
        centers: ParticleSource,
        /// `num N`: takes the first so many only.
        count: Option<Spanned<u32>>,
        /// `radius R`, greater than 0.
        radius: Spanned<f32>,
    },
    /// Another type of Sunflow's: not rendered.
    Unrendered(Unrendered),
    /// A type that nobody knows.
    Unknown(Unknown),
}

/// How finely a curved surface is cut into triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Subdivision {
    /// `subdivs N`: so many squares along each edge of a patch, at least 1; 8 unless given.
    pub count: Option<Spanned<u32>>,
    /// `smooth BOOL`: with the curved surface's normals; `true` unless given.
    pub smooth: Option<Spanned<bool>>,
}

/// Patches of Bezier surfaces that share their edges' points.
#[derive(Clone, Debug, PartialEq)]
pub struct BezierMesh {
    /// `n NU NV`: how many points there are along u and v: one more than a multiple of 3 where the mesh is open, a multiple of 3
    /// where it is closed.
    pub size: Spanned<[u32; 2]>,
    /// `wrap BOOL BOOL`: whether it is closed along u and v; `false false` unless given.
    pub wrap: Option<Spanned<[bool; 2]>>,
    /// `points`: NU times NV of them, u running fastest.
    pub points: Spanned<Vec<Triple>>,
    /// How finely it is cut.
    pub subdivision: Subdivision,
}

/// Where particles come from.
#[derive(Clone, Debug, PartialEq)]
pub enum ParticleSource {
    /// `points N x y z ...`
    Points(Spanned<Vec<Triple>>),
    /// `filename FILE [ little_endian ]`: 32-bit floats, three for each.
    File {
        /// The file's name as written.
        name: Spanned<String>,
        /// `little_endian`: their lowest byte comes first; else their highest.
        little_endian: Option<Spanned<()>>,
    },
}

/// The two ways to write a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SphereForm {
    /// Radius 1 around the origin, placed by the transform.
    Unit,
    /// `c <point> r <float>`: radius greater than 0.
    CenterRadius {
        /// The centre.
        center: Spanned<Triple>,
        /// The radius.
        radius: Spanned<f32>,
    },
}

/// How a plane is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneOrientation {
    /// `n <vector>`: its normal, of any length but 0.
    Normal(Spanned<Triple>),
    /// `p <point> p <point>`: two more points; the edges from the first point to them span the texture.
    Points([Spanned<Triple>; 2]),
}

/// A mesh of triangles. Every index is below the number of points: the reader sees to it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The form in which it was written.
    pub form: MeshForm,
    /// The points.
    pub points: Spanned<Vec<Triple>>,
    /// Three indices into the points for each triangle, counter-clockwise seen from the front.
    pub triangles: Spanned<Vec<[u32; 3]>>,
    /// Normals, of any length.
    pub normals: Spanned<PerVertex<3>>,
    /// Texture coordinates.
    pub uvs: Spanned<PerVertex<2>>,
    /// `face_shaders`: for each triangle, an index into the object's shaders.
    pub face_shaders: Option<Spanned<Vec<u32>>>,
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
