//! Scenes, and rays that are asked about them.

use geometry::conformance::{Enclosed, closed_meshes, triangles, wild_rays};
use geometry::{Interval, Ray};
use glam::Vec3;
use proptest::prelude::*;
use proptest::sample::Index;

use super::aims::{nearly_along_axes, weights};
use super::{Asked, Thing, aims, intervals, points, things};

/// One thing, and rays from outside at its middle.
pub(super) fn alone() -> impl Strategy<Value = Asked> {
    let at = || [-4.0_f32..4.0, -4.0..4.0, -4.0..4.0].prop_map(Vec3::from);
    let sphere = (at(), 0.5_f32..1.0).prop_map(|(center, radius)| Thing::Sphere(center, radius));
    let thing = prop_oneof![sphere, [at(), at(), at()].prop_map(Thing::Triangle)];
    (thing, outside()).prop_map(|(thing, from)| {
        let origin = thing.middle().as_vec3() + from;
        ahead(vec![thing], [Ray::new(origin, thing.middle().as_vec3() - origin)])
    })
}

/// Nothing, and things that a ray leaves behind it.
pub(super) fn nothing_ahead() -> impl Strategy<Value = Asked> {
    (prop::collection::vec(things(), 0..20), outside()).prop_map(|(things, from)| ahead(things, [Ray::new(from, from)]))
}

/// Up to 150 small spheres that stand side by side, seen along the rays: through each runs a ray that meets no other one.
pub(super) fn each_of_many() -> impl Strategy<Value = Asked> {
    let depths = prop::collection::vec(-4.0_f32..4.0, 2..150);
    (depths, [0.2_f32..0.5, 0.2_f32..0.5], -0.22_f32..0.22).prop_map(|(depths, [x, y], off)| {
        let direction = Vec3::new(x, y, 1.0).normalize();
        let columns = (depths.len() as f32).sqrt().ceil() as usize;
        let middle = |(number, &depth): (usize, &f32)| {
            Vec3::new((number % columns) as f32, (number / columns) as f32, 0.0) + depth * direction
        };
        let middles: Vec<Vec3> = depths.iter().enumerate().map(middle).collect();
        let things = middles.iter().map(|&middle| Thing::Sphere(middle, 0.25)).collect();
        // Past the middle, through cells that the sphere touches alone.
        let start = off * direction.any_orthonormal_vector() - 20.0 * direction;
        ahead(things, middles.into_iter().map(|middle| Ray::new(middle + start, direction)))
    })
}

/// Spheres in a row along a ray, in any order; some beside it.
pub(super) fn in_a_row() -> impl Strategy<Value = Asked> {
    let along = prop::collection::vec((-4.0_f32..4.0, prop_oneof![2 => Just(0.0_f32), 1 => 0.5_f32..3.0]), 2..40);
    (along, oblique(), points()).prop_map(|(places, direction, middle)| {
        let beside = direction.any_orthonormal_vector();
        let sphere = |&(along, off): &(f32, f32)| Thing::Sphere(middle + along * direction + off * beside, 0.2);
        ahead(places.iter().map(sphere).collect(), [Ray::new(middle - 9.0 * direction, direction)])
    })
}

/// Triangles as large as the scene among small spheres: they stand in many cells, and most of these meet them elsewhere.
pub(super) fn large_among_small() -> impl Strategy<Value = Asked> {
    let large = prop::collection::vec([points(), points(), points()], 1..5);
    let small = prop::collection::vec((points(), 0.05_f32..0.4), 10..60);
    (large, small, prop::collection::vec((outside(), points()), 8)).prop_map(|(large, small, rays)| {
        let large = large.into_iter().map(Thing::Triangle);
        let things = large.chain(small.into_iter().map(|(center, radius)| Thing::Sphere(center, radius))).collect();
        ahead(things, rays.into_iter().map(|(from, to)| Ray::new(from, to - from)))
    })
}

/// Tiles of a floor or a wall: each one's box is flat, and so is the one around all.
pub(super) fn flat() -> impl Strategy<Value = Asked> {
    let tiles = (0_usize..3, coordinate(), 2_i32..8);
    (tiles, prop::collection::vec((outside(), any::<Index>(), weights()), 8)).prop_map(
        |((axis, height, side), rays)| {
            let at = |x: i32, y: i32| {
                let mut corner = [0.0; 3];
                (corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3]) = (height, x as f32, y as f32);
                Vec3::from(corner)
            };
            let tile = |(x, y)| {
                [[at(x, y), at(x + 1, y), at(x + 1, y + 1)], [at(x, y), at(x + 1, y + 1), at(x, y + 1)]]
                    .map(Thing::Triangle)
            };
            let places = (0..side).flat_map(|x| (0..side).map(move |y| (x, y)));
            let things: Vec<Thing> = places.flat_map(tile).collect();
            let rays = rays
                .into_iter()
                .map(|(from, triangle, weights)| super::Aim::At { from, triangle, weights, length: 1.0 }.ray(&things));
            let rays: Vec<Ray> = rays.collect();
            ahead(things, rays)
        },
    )
}

/// Things at whole coordinates, and rays along the axes and the planes between cells.
pub(super) fn along_axes() -> impl Strategy<Value = Asked> {
    let rays = prop::collection::vec((points(), nearly_along_axes()), 16);
    (prop::collection::vec(things(), 1..40), rays).prop_map(|(things, rays)| {
        ahead(things, rays.into_iter().map(|(origin, direction)| Ray::new(origin, direction)))
    })
}

/// Rays that start among the things.
pub(super) fn from_inside() -> impl Strategy<Value = Asked> {
    (prop::collection::vec(small_spheres(), 10..80), prop::collection::vec((points(), oblique()), 16)).prop_map(
        |(things, rays)| ahead(things, rays.into_iter().map(|(origin, direction)| Ray::new(0.5 * origin, direction))),
    )
}

/// Rays with intervals that begin or end among the things.
pub(super) fn with_intervals() -> impl Strategy<Value = Asked> {
    let rays = prop::collection::vec((outside(), points(), 0.0_f32..1.5, 0.0_f32..1.0), 16);
    (prop::collection::vec(small_spheres(), 10..80), rays).prop_map(|(things, rays)| {
        let ray = |(from, to, min, length)| (Ray::new(from, to - from), Interval { min, max: min + length });
        Asked { things, rays: rays.into_iter().map(ray).collect() }
    })
}

/// Things of which each stands there more than once, in any order.
pub(super) fn twins() -> impl Strategy<Value = Asked> {
    let places = prop::collection::vec(any::<Index>(), 2..60);
    (prop::collection::vec(things(), 1..8), places, prop::collection::vec((outside(), any::<Index>()), 8)).prop_map(
        |(kinds, places, rays)| {
            let things: Vec<Thing> = places.iter().map(|place| kinds[place.index(kinds.len())]).collect();
            let ray =
                |(from, at): &(Vec3, Index)| Ray::new(*from, things[at.index(things.len())].middle().as_vec3() - *from);
            let rays: Vec<Ray> = rays.iter().map(ray).collect();
            ahead(things, rays)
        },
    )
}

/// Up to 500 times the same thing, and another.
pub(super) fn all_the_same() -> impl Strategy<Value = Asked> {
    (things(), 100_usize..500, things(), outside()).prop_map(|(thing, count, other, from)| {
        let mut same = vec![thing; count];
        same.push(other);
        ahead(same, [thing, other].map(|thing| Ray::new(from, thing.middle().as_vec3() - from)))
    })
}

/// Things and rays that are no numbers.
pub(super) fn wild() -> impl Strategy<Value = Asked> {
    (prop::collection::vec(things(), 0..40), prop::collection::vec(wild_rays(), 16))
        .prop_map(|(things, rays)| ahead(things, rays))
}

/// Everything: all kinds of things, of rays, of intervals.
pub(super) fn everything() -> impl Strategy<Value = Asked> {
    let rays = prop::collection::vec((aims(), intervals()), 40);
    (prop::collection::vec(things(), 0..60), rays).prop_map(|(things, rays)| {
        let rays = rays.iter().map(|(aim, within)| (aim.ray(&things), *within)).collect();
        Asked { things, rays }
    })
}

/// Bundles as a camera's or a light's: 37 rays that lie near each other, one in twenty going the other way.
pub(super) fn bundles() -> impl Strategy<Value = Asked> {
    let jitter = prop::collection::vec(([-1.0_f32..1.0, -1.0_f32..1.0, -1.0_f32..1.0], 0..20_u32), 37);
    let spread = prop_oneof![Just(0.0_f32), Just(0.5)];
    (prop::collection::vec(things(), 0..60), points(), points(), spread, any::<bool>(), jitter).prop_map(
        |(things, origin, target, spread, all_one_way, jitter)| {
            let bundled = |([x, y, z], wild): ([f32; 3], u32)| {
                let jitter = Vec3::new(x, y, z);
                // Factors, so that signs and zeros stay as they are.
                let direction = (target - origin) * (Vec3::ONE + 0.3 * jitter);
                let back = wild == 0 && !all_one_way;
                Ray::new(origin + spread * jitter, if back { -direction } else { direction })
            };
            ahead(things, jitter.into_iter().map(bundled))
        },
    )
}

/// Triangles of any size and shape, up to 1e6 times as far from the origin as they are large, beside each other.
pub(super) fn slivers_giants_and_dust() -> impl Strategy<Value = Asked> {
    prop::collection::vec(triangles(), 1..40).prop_map(|aimed| {
        let things = aimed.iter().map(|aimed| Thing::Triangle(aimed.shape.corners)).collect();
        ahead(things, aimed.iter().map(|aimed| aimed.ray))
    })
}

/// Rays from inside closed meshes, each aimed at a corner, an edge or a triangle.
pub(super) fn inside_closed_meshes() -> impl Strategy<Value = Asked> {
    closed_meshes().prop_map(|Enclosed { mesh, rays }| {
        let triangle = |corners: &[u32; 3]| Thing::Triangle(corners.map(|corner| mesh.positions[corner as usize]));
        ahead(mesh.triangles.iter().map(triangle).collect(), rays)
    })
}

/// Crossing wires of long thin triangles: their boxes are much larger than they are.
pub(super) fn wires() -> impl Strategy<Value = Asked> {
    let wire = (0.8_f32..1.2, 0.001_f32..0.02, points());
    (wire, prop::collection::vec(aims(), 60)).prop_map(|((slope, width, wave), aims)| {
        let wire = |number: u32| {
            let (row, piece) = (number / 4, (number / 2 % 2) as f32);
            let side = if number.is_multiple_of(2) { slope } else { -slope };
            let at = |along: f32| {
                let x = 0.06 * row as f32 - 4.0 + side * along;
                Vec3::new(x, 0.01 * (wave.x * x + wave.y * along), along + 0.01 * wave.z)
            };
            Thing::Triangle([at(4.0 * piece - 4.0), at(4.0 * piece), at(4.0 * piece) + width * Vec3::X])
        };
        let things: Vec<_> = (0..512).map(wire).collect();
        let rays: Vec<Ray> = aims.iter().map(|aim| aim.ray(&things)).collect();
        ahead(things, rays)
    })
}

fn small_spheres() -> impl Strategy<Value = Thing> {
    (points(), 0.05_f32..0.5).prop_map(|(center, radius)| Thing::Sphere(center, radius))
}

/// Points around all things, 20 away, off the axes.
fn outside() -> impl Strategy<Value = Vec3> {
    oblique().prop_map(|direction| 20.0 * direction)
}

/// Unit vectors none of whose components is small: rays along the axes are a law of their own.
fn oblique() -> impl Strategy<Value = Vec3> {
    let component = || (0.2_f32..1.0, any::<bool>()).prop_map(|(size, back)| if back { -size } else { size });
    [component(), component(), component()].prop_map(|direction| Vec3::from(direction).normalize())
}

fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![Just(0.0_f32), Just(1.0), -4.0_f32..4.0]
}

fn ahead(things: Vec<Thing>, rays: impl IntoIterator<Item = Ray>) -> Asked {
    Asked { things, rays: rays.into_iter().map(|ray| (ray, Interval::FORWARD)).collect() }
}
