use std::fmt::{self, Debug};

use geometry::conformance::{Figure, Ink};
use geometry::{Ellipsoid, Hit, Interval, Mesh, Primitive, Primitives, Ray, Sphere, Transform};
use glam::{DVec3, Vec3};
use proptest::prelude::*;

/// A primitive, as a literal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thing {
    /// Centre and radius.
    Sphere(Vec3, f32),
    /// Centre, the three half axes, and by how many degrees it is turned about (1, 2, 3).
    Ellipsoid(Vec3, Vec3, f32),
    /// The corners.
    Triangle([Vec3; 3]),
}

/// Things, and rays that are asked about them.
#[derive(Clone, PartialEq)]
pub struct Asked {
    /// In the order of their numbers.
    pub things: Vec<Thing>,
    /// Each with the interval that is of interest.
    pub rays: Vec<(Ray, Interval)>,
}

impl Debug for Asked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Asked {{ things: vec!{:?}, rays: vec!{:?} }}", self.things, self.rays)
    }
}

impl Asked {
    /// The things as primitives.
    pub fn primitives(&self) -> Primitives {
        let mut primitives = Primitives::default();
        for thing in &self.things {
            thing.add_to(&mut primitives);
        }
        primitives
    }

    /// The same things, and one ray.
    #[must_use]
    pub fn alone(&self, ray: Ray, within: Interval) -> Self {
        Self { things: self.things.clone(), rays: vec![(ray, within)] }
    }

    /// A drawing: the things, a ray, and the hits.
    pub fn drawn(&self, ray: &Ray, expected: Option<Hit>, found: Option<Hit>) -> Figure {
        let middle = expected.or(found).map_or(DVec3::ZERO, |hit| ray.at(f64::from(hit.t)));
        let towards = self.things.get(expected.or(found).map_or(0, |hit| hit.primitive as usize));
        let figure = Figure::through(ray, towards.map_or(middle, |thing| thing.middle()));
        let figure = self.things.iter().fold(figure, |figure, thing| thing.draw(figure));
        let t = |hit: Option<Hit>| hit.map(|hit| hit.t);
        figure.hit(ray, t(expected), Ink::Expected).hit(ray, t(found), Ink::Found)
    }
}

impl Thing {
    fn add_to(&self, primitives: &mut Primitives) {
        match *self {
            Self::Sphere(center, radius) => primitives.add_sphere(Sphere { center, radius }),
            Self::Ellipsoid(center, axes, degrees) => {
                primitives.add_ellipsoid(ellipsoid(center, axes, degrees));
            }
            Self::Triangle(corners) => {
                let positions = corners.to_vec();
                primitives.add_mesh(Mesh { positions, triangles: vec![[0, 1, 2]], ..Mesh::default() });
            }
        }
    }

    /// Its centre.
    pub fn middle(&self) -> DVec3 {
        match *self {
            Self::Sphere(center, _) | Self::Ellipsoid(center, ..) => center.as_dvec3(),
            Self::Triangle([a, b, c]) => (a.as_dvec3() + b.as_dvec3() + c.as_dvec3()) / 3.0,
        }
    }

    fn draw(&self, figure: Figure) -> Figure {
        match *self {
            Self::Sphere(center, radius) => figure.sphere(center.as_dvec3(), f64::from(radius)),
            Self::Ellipsoid(center, axes, degrees) => figure.cuboid(&ellipsoid(center, axes, degrees).bounds()),
            Self::Triangle(corners) => figure.outline(&corners.map(|corner| corner.as_dvec3())),
        }
    }
}

fn ellipsoid(center: Vec3, axes: Vec3, degrees: f32) -> Ellipsoid {
    let place = Transform::scale(axes.as_dvec3())
        .then(&Transform::rotation(DVec3::new(1.0, 2.0, 3.0), f64::from(degrees)))
        .then(&Transform::translation(center.as_dvec3()));
    Ellipsoid::new(place).expect("axes other than 0")
}

/// Coordinates that meet: half of them on a grid, so that faces, edges and cell borders coincide.
fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![(-4..=4).prop_map(|n| n as f32), -4.0_f32..4.0]
}

/// Points up to 4 from the origin along each axis, half of their coordinates whole.
pub fn points() -> impl Strategy<Value = Vec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(Vec3::from)
}

/// Spheres, ellipsoids and triangles of sizes 0.01 to 8 among these points: small triangles, flat boxes and twins among them.
pub fn things() -> impl Strategy<Value = Thing> {
    let small = prop_oneof![Just(1.0_f32), 0.01_f32..1.0];
    prop_oneof![
        (points(), small).prop_map(|(center, radius)| Thing::Sphere(center, radius)),
        (points(), [0.1_f32..2.0, 0.1_f32..2.0, 0.1_f32..2.0], 0.0_f32..360.0)
            .prop_map(|(center, axes, degrees)| Thing::Ellipsoid(center, axes.into(), degrees)),
        [points(), points(), points()].prop_map(Thing::Triangle),
        (points(), 0.01_f32..1.0).prop_map(|(p, size)| Thing::Triangle([p, p + size * Vec3::X, p + size * Vec3::Y])),
    ]
}
