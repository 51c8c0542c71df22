//! Inputs for property tests: rays aimed at primitives, with the cases that break naive kernels made common.
//!
//! A kernel that is right on these is right on scenes; which law to hold it to is the test's own business. The families are
//! multiplied rather than listed: a far origin, a grazing ray, a large offset and a direction of odd length meet in one case.
//!
//! A failing case prints as a literal. To paste it, write `use glam::{DMat3, dvec3 as DVec3, vec3 as Vec3};`.

mod figure;
mod law;
mod picture;
mod secondary;

use glam::{DMat3, DVec3, Vec3};
use proptest::prelude::*;

pub use figure::{Figure, Ink};
pub use law::{Broken, Counterexample, Law, Trial, Verdict, same};
pub use secondary::{Apart, CubeEdge, GAP, cube_edges, ellipsoids_apart, planes_apart, spheres_apart, triangles_apart};

use crate::{Aabb, Mesh, Plane, Ray, Sphere, Transform, Triangle};

/// A shape, and a ray that meets it or narrowly does not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aimed<S> {
    /// The shape.
    pub shape: S,
    /// The ray. Its direction has any length.
    pub ray: Ray,
}

/// How a plane is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneGiven {
    /// See [`Plane::from_normal`].
    ByNormal {
        /// A point of the plane.
        point: Vec3,
        /// Of any length.
        normal: Vec3,
    },
    /// See [`Plane::from_points`].
    ByPoints {
        /// The texture's origin.
        point: Vec3,
        /// The end of its first edge.
        along_u: Vec3,
        /// The end of its second edge.
        along_v: Vec3,
    },
}

impl PlaneGiven {
    /// The plane, if there is one.
    pub fn plane(&self) -> Option<Plane> {
        match *self {
            Self::ByNormal { point, normal } => Plane::from_normal(point, normal),
            Self::ByPoints { point, along_u, along_v } => Plane::from_points(point, along_u, along_v),
        }
    }
}

/// A closed mesh and rays that start inside it.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosed {
    /// Star-shaped around the rays' origin.
    pub mesh: Mesh,
    /// Rays to every point, to the middle of every edge, and to the middle of every triangle, as exactly as `f32` allows.
    pub rays: Vec<Ray>,
}

/// How many cases a law is tried on: a multiple of proptest's own number. `PROPTEST_CASES` sets one number for all laws.
///
/// Failures are not kept in a file: each becomes a literal test.
pub fn times(factor: u32) -> ProptestConfig {
    let default = ProptestConfig::default();
    let cases = factor * default.cases;
    ProptestConfig { cases, max_global_rejects: 16 * cases, failure_persistence: None, ..default }
}

/// Spheres of radius 1e-6 to 1e6, up to 1e6 radii from the origin of space; rays from the centre, from just inside, on or just
/// outside the surface and from up to 1e6 radii away; through the sphere, past it, and grazing it to 1e-7.
pub fn spheres() -> impl Strategy<Value = Aimed<Sphere>> {
    let place = (magnitude(1e-6, 1e6), prop_oneof![Just(0.0), magnitude(1.0, 1e6)], unit_vector());
    (place, unit_sphere_line(), magnitude(1e-3, 1e3)).prop_map(
        |((radius, offset, side), (origin, direction), length)| {
            let center = side * offset * radius;
            Aimed {
                shape: Sphere { center: center.as_vec3(), radius: radius as f32 },
                ray: Ray::new((center + origin * radius).as_vec3(), (direction * length).as_vec3()),
            }
        },
    )
}

/// The rays of [`spheres`] at a unit sphere, under maps that turn, shear, mirror and stretch it (axes 1 : 1e3) and move it.
pub fn ellipsoids() -> impl Strategy<Value = Aimed<Transform>> {
    let axes = [magnitude(1.0, 1e3), magnitude(1.0, 1e3), magnitude(1.0, 1e3)];
    let map = (frame(), axes, -1.0..1.0, frame(), any::<bool>(), magnitude(1e-3, 1e3));
    let map = map.prop_map(|(turn, [x, y, z], shear, last_turn, mirror, size)| {
        let mirror = if mirror { -1.0 } else { 1.0 };
        let shear = DMat3::from_cols(DVec3::X, DVec3::new(shear, 1.0, 0.0), DVec3::Z);
        last_turn * shear * DMat3::from_diagonal(DVec3::new(x, y, z * mirror)) * turn * size
    });
    let translation = (prop_oneof![Just(0.0), magnitude(1.0, 1e6)], unit_vector()).prop_map(|(far, side)| side * far);
    (map, translation, unit_sphere_line()).prop_map(|(linear, translation, (origin, direction))| {
        let shape = Transform { linear, translation };
        Aimed { shape, ray: Ray::new(shape.point(origin).as_vec3(), shape.direction(direction).as_vec3()) }
    })
}

/// Planes whose point is up to 1e6 away from the hit and from the origin of space; rays from 1e-3 to 1e6 away, some parallel to
/// 1e-6, from both sides and pointing both ways.
pub fn planes() -> impl Strategy<Value = Aimed<PlaneGiven>> {
    let place = (prop_oneof![Just(0.0), magnitude(1e-3, 1e6)], unit_vector());
    let away = prop_oneof![Just(0.0), magnitude(1e-3, 1e6)];
    let edges = (any::<bool>(), magnitude(1e-3, 1e3), magnitude(1e-3, 1e3), 0.1..3.0);
    let line = (magnitude(1e-3, 1e6), slope(), magnitude(1e-3, 1e3), 0.0..6.3);
    (frame(), place, away, edges, line).prop_map(|(frame, (far, side), away, edges, line)| {
        let point = side * far;
        let (by_points, along_u, along_v, angle) = edges;
        let shape = if by_points {
            PlaneGiven::ByPoints {
                point: point.as_vec3(),
                along_u: (point + frame.x_axis * along_u).as_vec3(),
                along_v: (point + in_plane(frame, angle) * along_v).as_vec3(),
            }
        } else {
            PlaneGiven::ByNormal { point: point.as_vec3(), normal: (frame.z_axis * along_u).as_vec3() }
        };
        let (distance, slope, length, heading) = line;
        let direction = (in_plane(frame, heading) + frame.z_axis * slope).normalize();
        let hit = point + frame.y_axis * away;
        Aimed { shape, ray: Ray::new((hit - direction * distance).as_vec3(), (direction * length).as_vec3()) }
    })
}

/// Triangles of size 1e-6 to 1e7, aspect 1 to 1e6, up to 1e6 sizes from the origin of space; rays from 1e-3 to 1e6 sizes away,
/// some edge-on to 1e-6, aimed at the inside, at what lies around, and as exactly as `f32` allows at edges and corners.
pub fn triangles() -> impl Strategy<Value = Aimed<Triangle>> {
    let place = (magnitude(1e-6, 1e7), prop_oneof![Just(0.0), magnitude(1.0, 1e6)], unit_vector());
    let shape = (prop_oneof![Just(1.0), magnitude(1.0, 1e6)], -1.0..2.0_f64);
    let line = (magnitude(1e-3, 1e6), slope(), magnitude(1e-3, 1e3), 0.0..6.3);
    (frame(), place, shape, barycentric(), line).prop_map(|(frame, place, (aspect, lean), [wa, wb, wc], line)| {
        let (size, far, side) = place;
        let a = side * far * size;
        let b = a + frame.x_axis * size;
        let c = a + frame.x_axis * (lean * size) + frame.y_axis * (size / aspect);
        let corners = [a.as_vec3(), b.as_vec3(), c.as_vec3()];
        let [a, b, c] = corners.map(|corner| corner.as_dvec3());
        let target = (a * wa + b * wb + c * wc).as_vec3();
        let (distance, slope, length, heading) = line;
        let direction = (in_plane(frame, heading) + frame.z_axis * slope).normalize();
        let origin = (target.as_dvec3() - direction * distance * size).as_vec3();
        // A power of two keeps an exact aim exact.
        let length = libm::exp2(libm::rint(libm::log2(length))) as f32;
        Aimed { shape: Triangle { corners }, ray: Ray::new(origin, (target - origin) * length) }
    })
}

/// Triangles whose corners lie exactly in a row, or on each other, up to 1e6 sizes from the origin of space; rays straight at them.
///
/// The corners are whole numbers below 2^24, which no rounding moves, or differ along one axis alone.
pub fn flat_triangles() -> impl Strategy<Value = Aimed<Triangle>> {
    let whole = |most: i32| [-most..=most, -most..=most, -most..=most].prop_map(|v| Vec3::from(v.map(|x| x as f32)));
    let order = prop::sample::select(vec![[0, 1, 2], [1, 0, 2], [0, 2, 1], [0, 0, 1], [0, 0, 0]]);
    let start = prop_oneof![whole(1000), whole(1_000_000)];
    let row = (start, prop_oneof![whole(1), whole(1000)], order)
        .prop_map(|(start, step, order)| order.map(|steps| start + steps as f32 * step));
    let place = (unit_vector(), magnitude(1e-3, 1e7)).prop_map(|(side, far)| side * far);
    let along = || (magnitude(1e-3, 1e6), any::<bool>()).prop_map(|(along, back)| if back { -along } else { along });
    let along_axis = (place, 0..3_usize, [along(), along(), along()]).prop_map(|(place, axis, places)| {
        places.map(|along| {
            let mut corner = place.as_vec3();
            corner[axis] = along as f32;
            corner
        })
    });
    let aim = (barycentric(), magnitude(1e-3, 1e6), unit_vector());
    (prop_oneof![row, along_axis], aim).prop_map(|(corners, ([wa, wb, wc], far, side))| {
        let [a, b, c] = corners.map(|corner| corner.as_dvec3());
        let target = (a * wa + b * wb + c * wc).as_vec3();
        let origin = (target.as_dvec3() + side * far).as_vec3();
        Aimed { shape: Triangle { corners }, ray: Ray::new(origin, target - origin) }
    })
}

/// Boxes, flat ones included and down to 1e-44 in size; origins in the planes of faces, on edges and corners, inside, and up to 1e6 sizes away;
/// directions at faces, edges and corners and along them, with components 0, -0 and denormal.
pub fn boxes() -> impl Strategy<Value = Aimed<Aabb>> {
    prop_oneof![4 => boxes_at_any_side(), 1 => boxes_along_an_edge()]
}

fn box_shapes() -> impl Strategy<Value = Aabb> {
    let extent = || prop_oneof![1 => Just(0.0), 3 => magnitude(1e-3, 1.0)];
    let size = prop_oneof![7 => magnitude(1e-3, 1e6), 1 => magnitude(1e-44, 1e-30)];
    let place = (size, prop_oneof![Just(0.0), magnitude(1.0, 1e6)], unit_vector());
    (place, [extent(), extent(), extent()]).prop_map(|((size, far, side), extent)| {
        let min = (side * far * size).as_vec3();
        Aabb { min, max: (min.as_dvec3() + DVec3::from(extent) * size).as_vec3() }
    })
}

/// Rays that run exactly in an edge's line, from before the box, from within the edge, or from behind.
fn boxes_along_an_edge() -> impl Strategy<Value = Aimed<Aabb>> {
    let start = prop_oneof![Just(0.0), Just(1.0), 0.0..1.0, -1.0..2.0, magnitude(1.0, 1e6).prop_map(|far| -far)];
    let sign = || prop_oneof![Just(1.0_f32), Just(-1.0)];
    (box_shapes(), 0..3_usize, any::<[bool; 2]>(), start, [sign(), sign(), sign()], magnitude(1e-3, 1e3)).prop_map(
        |(shape, axis, upper, start, signs, length)| {
            let mut origin = shape.min;
            for (other, upper) in [(axis + 1) % 3, (axis + 2) % 3].into_iter().zip(upper) {
                origin[other] = if upper { shape.max[other] } else { shape.min[other] };
            }
            let (low, high) = (f64::from(shape.min[axis]), f64::from(shape.max[axis]));
            origin[axis] = (low + start * (high - low)) as f32;
            let mut direction = Vec3::ZERO;
            direction[axis] = length as f32;
            Aimed { shape, ray: Ray::new(origin, direction * Vec3::from(signs)) }
        },
    )
}

fn boxes_at_any_side() -> impl Strategy<Value = Aimed<Aabb>> {
    let place = || prop_oneof![Just(0.0), Just(1.0), 0.0..1.0, -1.0..2.0];
    let far = || prop_oneof![3 => Just(0.0), 1 => magnitude(1.0, 1e6), 1 => magnitude(1.0, 1e6).prop_map(|far| -far)];
    let origin = [(place(), far()), (place(), far()), (place(), far())];
    let step = || {
        let sign = prop_oneof![Just(1.0_f32), Just(-1.0)];
        let tiny = prop_oneof![Just(0.0), Just(1e-45_f32), Just(1e-40), Just(f32::MIN_POSITIVE), Just(1e-30)];
        prop_oneof![3 => Just(None), 1 => (sign, tiny).prop_map(|(sign, tiny)| Some(sign * tiny))]
    };
    let target = [(place(), step()), (place(), step()), (place(), step())];
    (box_shapes(), origin, target, magnitude(1e-3, 1e3)).prop_map(|(shape, origin, target, length)| {
        let coordinate = |axis: usize, place: f64| match place {
            0.0 => shape.min[axis],
            1.0 => shape.max[axis],
            _ => (f64::from(shape.min[axis]) * (1.0 - place) + f64::from(shape.max[axis]) * place) as f32,
        };
        let size = f64::from(shape.extent().max_element());
        let start = |axis: usize| match origin[axis] {
            (place, 0.0) => coordinate(axis, place),
            (place, far) => (f64::from(coordinate(axis, place)) + far * size) as f32,
        };
        let towards = |axis: usize| match target[axis] {
            (_, Some(step)) => step,
            (place, None) => (coordinate(axis, place) - start(axis)) * length as f32,
        };
        let origin = Vec3::new(start(0), start(1), start(2));
        Aimed { shape, ray: Ray::new(origin, Vec3::new(towards(0), towards(1), towards(2))) }
    })
}

/// Octahedra split up to three times and crumpled (radii 1 : 10), stretched (1 : 1e3), of size 1e-3 to 1e6, up to 1e3 sizes from
/// the origin of space.
pub fn closed_meshes() -> impl Strategy<Value = Enclosed> {
    let stretch = [magnitude(1e-3, 1.0), magnitude(1e-3, 1.0), magnitude(1e-3, 1.0)];
    let place = (magnitude(1e-3, 1e6), prop_oneof![Just(0.0), magnitude(1.0, 1e3)], unit_vector());
    (0..4_usize, prop::collection::vec(magnitude(0.1, 1.0), 32), stretch, frame(), place).prop_map(
        |(splits, radii, stretch, turn, (size, far, side))| {
            let (directions, triangles) = split_octahedron(splits);
            let inside = (side * far * size).as_vec3();
            let linear = turn * DMat3::from_diagonal(DVec3::from(stretch)) * size;
            let place = |(direction, radius): (&DVec3, &f64)| {
                (inside.as_dvec3() + linear * (direction.normalize() * *radius)).as_vec3()
            };
            let positions: Vec<Vec3> = directions.iter().zip(radii.iter().cycle()).map(place).collect();
            let middles = triangles.iter().flat_map(|corners| {
                let [a, b, c] = corners.map(|corner| positions[corner as usize]);
                [0.5 * a + 0.5 * b, 0.5 * b + 0.5 * c, 0.5 * c + 0.5 * a, (a + b + c) / 3.0]
            });
            let rays =
                positions.iter().copied().chain(middles).map(|target| Ray::new(inside, target - inside)).collect();
            Enclosed { mesh: Mesh { positions, triangles, ..Mesh::default() }, rays }
        },
    )
}

/// Vectors with components that are NaN, infinite, huge, zero, denormal; one in two is ordinary.
pub fn wild_vectors() -> impl Strategy<Value = Vec3> {
    [wild_numbers(), wild_numbers(), wild_numbers()].prop_map(Vec3::from)
}

/// Numbers that are NaN, infinite, huge, zero, denormal; three in four are ordinary.
pub fn wild_numbers() -> impl Strategy<Value = f32> {
    let wild = prop::sample::select(vec![
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        f32::MIN,
        0.0,
        -0.0,
        1e-45,
        f32::MIN_POSITIVE,
    ]);
    prop_oneof![3 => -2.0_f32..2.0, 1 => wild]
}

/// Unit vectors: everywhere, and along the axes.
pub fn unit_vector() -> impl Strategy<Value = DVec3> {
    frame().prop_map(|frame| frame.z_axis)
}

/// Numbers whose logarithm is spread evenly.
pub fn magnitude(from: f64, to: f64) -> impl Strategy<Value = f64> + Clone {
    (libm::log(from)..libm::log(to)).prop_map(libm::exp)
}

/// How far a direction rises from a plane: often little.
fn slope() -> impl Strategy<Value = f64> {
    let rise = || prop_oneof![magnitude(1e-6, 1.0), magnitude(1.0, 1e6)];
    prop_oneof![rise(), rise().prop_map(|slope| -slope)]
}

/// Three perpendicular unit vectors, right-handed; often the axes.
fn frame() -> impl Strategy<Value = DMat3> {
    let turned = (-1.0..1.0, -3.2..3.2, -3.2..3.2).prop_map(|(height, longitude, turn)| {
        let (sin, cos) = libm::sincos(longitude);
        let width = f64::sqrt(1.0 - height * height);
        let z = DVec3::new(cos * width, sin * width, height);
        let (x, y) = z.any_orthonormal_pair();
        let (sin, cos) = libm::sincos(turn);
        let x = x * cos + y * sin;
        DMat3::from_cols(x, z.cross(x), z)
    });
    let axes = (0..3_usize, any::<bool>()).prop_map(|(first, back)| {
        let sign = if back { -1.0 } else { 1.0 };
        let axes = [DVec3::X * sign, DVec3::Y * sign, DVec3::Z];
        DMat3::from_cols(axes[first], axes[(first + 1) % 3], axes[(first + 2) % 3])
    });
    prop_oneof![3 => turned, 1 => axes]
}

/// A direction in the first two vectors' plane.
fn in_plane(frame: DMat3, angle: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(angle);
    frame.x_axis * cos + frame.y_axis * sin
}

/// Weights of three corners that add up to 1: inside, on edges and corners, just off them, and outside.
fn barycentric() -> impl Strategy<Value = [f64; 3]> {
    let inside = (0.0..1.0, 0.0..1.0).prop_map(|(a, b): (f64, f64)| [a * (1.0 - b), b, (1.0 - a) * (1.0 - b)]);
    let edge = (0.0..1.0).prop_map(|a: f64| [a, 1.0 - a, 0.0]);
    let beside = (0.0..1.0, magnitude(1e-9, 1e-1), any::<bool>()).prop_map(|(a, off, out)| {
        let off = if out { -off } else { off };
        [a * (1.0 - off), (1.0 - a) * (1.0 - off), off]
    });
    let around = (-1.0..2.0, -1.0..2.0).prop_map(|(a, b): (f64, f64)| [a, b, 1.0 - a - b]);
    let weights = prop_oneof![3 => inside, 1 => edge, 1 => Just([1.0, 0.0, 0.0]), 1 => beside, 1 => around];
    (weights, 0..3_usize).prop_map(|([a, b, c], turn)| match turn {
        0 => [a, b, c],
        1 => [c, a, b],
        _ => [b, c, a],
    })
}

/// A line as the unit sphere at the origin sees it: origin and unit direction.
fn unit_sphere_line() -> impl Strategy<Value = (DVec3, DVec3)> {
    let near = || magnitude(1e-8, 1e-4);
    let distance = prop_oneof![
        2 => 0.0..1.0,
        3 => magnitude(1.0, 10.0),
        3 => magnitude(1e2, 1e6),
        1 => Just(1.0),
        2 => near().prop_map(|off| 1.0 - off),
        2 => near().prop_map(|off| 1.0 + off),
    ];
    let grazing = || magnitude(1e-7, 1e-2);
    let passing = prop_oneof![
        3 => 0.0..2.0,
        1 => grazing().prop_map(|off| 1.0 - off),
        1 => grazing().prop_map(|off| 1.0 + off),
    ];
    (frame(), distance, passing, prop_oneof![3 => Just(1.0), 1 => Just(-1.0)]).prop_map(
        |(frame, distance, passing, sign): (_, f64, f64, f64)| {
            let passing = if passing > distance { 0.5 * passing * distance } else { passing };
            let along = f64::sqrt(distance * distance - passing * passing);
            (frame.x_axis * passing - frame.z_axis * (sign * along), frame.z_axis)
        },
    )
}

/// An octahedron whose triangles were split in four a number of times: points (not on a sphere), and corners
/// counter-clockwise from outside.
pub fn split_octahedron(splits: usize) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let mut points = vec![DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
    let mut triangles: Vec<[u32; 3]> =
        vec![[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
    for _ in 0..splits {
        let mut middle = |a: u32, b: u32| {
            let point = (points[a as usize] + points[b as usize]) * 0.5;
            let known = points.iter().position(|&other| other == point);
            known.unwrap_or_else(|| {
                points.push(point);
                points.len() - 1
            }) as u32
        };
        let split = |[a, b, c]: [u32; 3]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        triangles = triangles.into_iter().flat_map(split).collect();
    }
    (points, triangles)
}
