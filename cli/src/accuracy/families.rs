//! The families of cases: everyday ones, and those that are hard for one reason each.

use geometry::{Aabb, Ellipsoid, Sphere, Triangle};

use super::aimed::{Aimed, AtBox, AtPlane, AtSphere, AtTriangle, GivenPlane, OnFace};
use super::random::Random;

/// Cases of one kind.
pub(crate) struct Family<Shape> {
    pub(crate) name: String,
    pub(crate) make: Make<Shape>,
}

type Make<Shape> = Box<dyn Fn(&mut Random) -> Aimed<Shape>>;

fn family<Shape>(name: impl Into<String>, make: impl Fn(&mut Random) -> Aimed<Shape> + 'static) -> Family<Shape> {
    Family { name: name.into(), make: Box::new(make) }
}

const EVERYDAY: &str = "everyday";

pub(crate) fn spheres() -> Vec<Family<Sphere>> {
    let usual = AtSphere::default();
    let far = |ratio: f64| AtSphere { distance: [ratio, ratio], ..usual };
    [
        (EVERYDAY, usual),
        ("D/r = 100", far(1e2)),
        ("D/r = 10⁴", far(1e4)),
        ("D/r = 10⁶", far(1e6)),
        ("grazing, to 10⁻⁵ of r", AtSphere { passing: [1.0 - 1e-5, 1.0 + 1e-5], ..usual }),
        ("radius 10⁻⁶", AtSphere { radius: [1e-6, 1e-6], ..usual }),
        ("radius 10⁶", AtSphere { radius: [1e6, 1e6], ..usual }),
        ("ray from just outside", AtSphere { distance: [1.0 + 1e-6, 1.0 + 1e-4], passing: [0.0, 1.0], ..usual }),
        ("ray from just inside", AtSphere { distance: [1.0 - 1e-4, 1.0 - 1e-6], passing: [0.0, 1.0], ..usual }),
        ("direction 10⁻³ to 10³ long", AtSphere { length: [1e-3, 1e3], ..usual }),
        ("10⁵ r from the origin", AtSphere { offset: [1e5, 1e5], ..usual }),
    ]
    .map(|(name, at)| family(name, move |random| at.sphere(random)))
    .into()
}

pub(crate) fn ellipsoids() -> Vec<Family<Ellipsoid>> {
    let usual = AtSphere { stretch: [1.0, 3.0], ..AtSphere::default() };
    [
        (EVERYDAY, usual),
        ("stretched 1 : 1000", AtSphere { stretch: [1e3, 1e3], ..usual }),
        ("D/r = 10⁴", AtSphere { distance: [1e4, 1e4], ..usual }),
        ("grazing, to 10⁻⁵ of r", AtSphere { passing: [1.0 - 1e-5, 1.0 + 1e-5], ..usual }),
        ("direction 10⁻³ to 10³ long", AtSphere { length: [1e-3, 1e3], ..usual }),
        ("10⁵ r from the origin", AtSphere { offset: [1e5, 1e5], ..usual }),
    ]
    .map(|(name, at)| family(name, move |random| at.ellipsoid(random)))
    .into()
}

pub(crate) fn triangles() -> Vec<Family<Triangle>> {
    let usual = AtTriangle::default();
    [
        (EVERYDAY, usual),
        ("aspect 1000", AtTriangle { aspect: [1e3, 1e3], ..usual }),
        ("aspect 10⁶", AtTriangle { aspect: [1e6, 1e6], ..usual }),
        ("edge-on, to 10⁻⁶", AtTriangle { slope: [1e-6, 1e-4], ..usual }),
        ("size 10⁻⁶", AtTriangle { size: [1e-6, 1e-6], ..usual }),
        ("size 10⁷", AtTriangle { size: [1e7, 1e7], ..usual }),
        ("1000 sizes from the origin", AtTriangle { offset: [1e3, 1e3], ..usual }),
        ("10⁶ sizes from the origin", AtTriangle { offset: [1e6, 1e6], ..usual }),
        ("seen from 10⁵ sizes", AtTriangle { distance: [1e5, 1e5], ..usual }),
        ("direction 10⁻³ to 10³ long", AtTriangle { length: [1e-3, 1e3], ..usual }),
    ]
    .map(|(name, at)| family(name, move |random| at.triangle(random)))
    .into()
}

pub(crate) fn planes() -> Vec<Family<GivenPlane>> {
    let usual = AtPlane::default();
    [
        (EVERYDAY, usual),
        ("near-parallel, to 10⁻⁷", AtPlane { slope: [1e-7, 1e-5], distance: [10.0, 1e4], ..usual }),
        ("seen from 10⁶", AtPlane { distance: [1e6, 1e6], ..usual }),
        ("point 10⁶ from the origin", AtPlane { offset: [1e6, 1e6], ..usual }),
        ("met 10⁶ from its point", AtPlane { away: [1e6, 1e6], ..usual }),
        ("direction 10⁻³ to 10³ long", AtPlane { length: [1e-3, 1e3], ..usual }),
    ]
    .map(|(name, at)| family(name, move |random| at.plane(random)))
    .into()
}

pub(crate) fn boxes() -> Vec<Family<Aabb>> {
    let usual = AtBox::default();
    const ZEROS: &[f32] = &[0.0, -0.0];
    const DENORMALS: &[f32] = &[1e-40, -1e-40, 1e-45, -1e-45];
    [
        (EVERYDAY, usual),
        ("flat", AtBox { flat: 4, ..usual }),
        ("components 0 and -0", AtBox { set: ZEROS, ..usual }),
        ("along a face or an edge", AtBox { set: ZEROS, on_face: OnFace::WhereSet, ..usual }),
        ("flat, along a face", AtBox { flat: 4, set: ZEROS, on_face: OnFace::WhereSet, ..usual }),
        ("denormal components", AtBox { set: DENORMALS, on_face: OnFace::WhereSet, ..usual }),
        ("seen from 10⁶", AtBox { distance: [1e6, 1e6], ..usual }),
    ]
    .map(|(name, at)| family(name, move |random| at.aabb(random)))
    .into()
}

/// One family for each of some values, from easy to hard.
pub(crate) struct Sweep<Shape> {
    /// What is varied, as a heading.
    pub(crate) title: &'static str,
    /// The axis.
    pub(crate) label: &'static str,
    pub(crate) points: Vec<(f64, Family<Shape>)>,
}

fn sweep<Shape, At: 'static>(
    title: &'static str,
    label: &'static str,
    decades: std::ops::RangeInclusive<i32>,
    make: fn(&At, &mut Random) -> Aimed<Shape>,
    at: impl Fn(f64) -> At,
) -> Sweep<Shape>
where
    Shape: 'static,
{
    // Two for each decade.
    let halves = 2 * decades.start()..=2 * decades.end();
    let points = halves.map(|half| {
        let value = libm::exp10(0.5 * f64::from(half));
        let at = at(value);
        (value, family(format!("{title} {value:e}"), move |random| make(&at, random)))
    });
    Sweep { title, label, points: points.collect() }
}

pub(crate) fn sphere_sweeps() -> Vec<Sweep<Sphere>> {
    let usual = AtSphere::default();
    vec![
        sweep("Sphere: distance", "distance over radius, D/r", 0..=6, AtSphere::sphere, move |ratio| AtSphere {
            distance: [1.5 * ratio, 1.5 * ratio],
            ..usual
        }),
        sweep(
            "Sphere: place",
            "centre's distance from the scene's origin, in radii",
            0..=6,
            AtSphere::sphere,
            move |far| AtSphere { offset: [far, far], ..usual },
        ),
    ]
}

pub(crate) fn ellipsoid_sweeps() -> Vec<Sweep<Ellipsoid>> {
    let usual = AtSphere { stretch: [1.0, 3.0], ..AtSphere::default() };
    vec![sweep(
        "Ellipsoid: place",
        "centre's distance from the scene's origin, in radii",
        0..=6,
        AtSphere::ellipsoid,
        move |far| AtSphere { offset: [far, far], ..usual },
    )]
}

pub(crate) fn triangle_sweeps() -> Vec<Sweep<Triangle>> {
    let usual = AtTriangle::default();
    vec![
        sweep("Triangle: shape", "aspect, longest edge over height", 0..=6, AtTriangle::triangle, move |aspect| {
            AtTriangle { aspect: [aspect, aspect], ..usual }
        }),
        sweep(
            "Triangle: place",
            "distance from the scene's origin, in sizes",
            0..=6,
            AtTriangle::triangle,
            move |far| AtTriangle { offset: [far, far], ..usual },
        ),
        sweep("Triangle: size", "longest edge, in the scene's units", -6..=6, AtTriangle::triangle, move |size| {
            AtTriangle { size: [size, size], ..usual }
        }),
    ]
}

pub(crate) fn plane_sweeps() -> Vec<Sweep<GivenPlane>> {
    let usual = AtPlane::default();
    vec![sweep("Plane: slope", "tangent of the angle between ray and plane", -7..=0, AtPlane::plane, move |slope| {
        AtPlane { slope: [slope, slope], ..usual }
    })]
}
