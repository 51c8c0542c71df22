//! Every accelerator finds the hit that asking every primitive finds, bit for bit.

use accel::{Accelerator, none, octree, wide};
use geometry::{BoxProbe, Ellipsoid, Interval, Kernels, Mesh, Primitives, Ray, Sphere, Transform};
use glam::{DVec3, Vec3};
use proptest::prelude::*;

#[derive(Clone, Debug)]
enum Thing {
    Sphere(Vec3, f32),
    Ellipsoid(Vec3, Vec3, f32),
    Triangle([Vec3; 3]),
}

/// Coordinates that meet: half of them on a grid, so that faces, edges and cell borders coincide.
fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![(-4..=4).prop_map(|n| n as f32), -4.0_f32..4.0]
}

fn point() -> impl Strategy<Value = Vec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(Vec3::from)
}

fn thing() -> impl Strategy<Value = Thing> {
    let small = prop_oneof![Just(1.0_f32), 0.01_f32..1.0];
    prop_oneof![
        (point(), small).prop_map(|(center, radius)| Thing::Sphere(center, radius)),
        (point(), [0.1_f32..2.0, 0.1_f32..2.0, 0.1_f32..2.0], 0.0_f32..360.0)
            .prop_map(|(center, axes, degrees)| Thing::Ellipsoid(center, axes.into(), degrees)),
        [point(), point(), point()].prop_map(Thing::Triangle),
        // Small triangles, flat boxes and twins among them.
        (point(), 0.01_f32..1.0).prop_map(|(p, size)| Thing::Triangle([p, p + size * Vec3::X, p + size * Vec3::Y])),
    ]
}

fn primitives(things: &[Thing]) -> Primitives {
    let mut primitives = Primitives::default();
    for thing in things {
        match *thing {
            Thing::Sphere(center, radius) => primitives.add_sphere(Sphere { center, radius }),
            Thing::Ellipsoid(center, axes, degrees) => {
                let place = Transform::scale(axes.as_dvec3())
                    .then(&Transform::rotation(DVec3::new(1.0, 2.0, 3.0), f64::from(degrees)))
                    .then(&Transform::translation(center.as_dvec3()));
                primitives.add_ellipsoid(Ellipsoid::new(place).expect("positive axes"));
            }
            Thing::Triangle(corners) => {
                primitives.add_mesh(Mesh {
                    positions: corners.to_vec(),
                    triangles: vec![[0, 1, 2]],
                    ..Mesh::default()
                });
            }
        }
    }
    primitives
}

/// Rays in general, along axes and faces, and aimed at points of the grid: vertices, edges, centres.
fn ray() -> impl Strategy<Value = Ray> {
    let zeroed = (point(), 0_usize..8).prop_map(|(direction, keep)| {
        Vec3::from(
            [0, 1, 2]
                .map(|axis| if keep >> axis & 1 == 1 { direction[axis] } else { 0.0_f32.copysign(direction[axis]) }),
        )
    });
    let far = prop_oneof![4 => Just(1.0_f32), 1 => Just(1e3_f32), 1 => Just(1e6_f32)];
    prop_oneof![
        (point(), point()).prop_map(|(origin, direction)| Ray::new(origin, direction)),
        (point(), zeroed).prop_map(|(origin, direction)| Ray::new(origin, direction)),
        (point(), point(), far, 1e-3_f32..1e3)
            .prop_map(|(origin, target, far, length)| { Ray::new(origin * far, (target - origin * far) * length) }),
    ]
}

fn interval() -> impl Strategy<Value = Interval> {
    prop_oneof![
        Just(Interval::FORWARD),
        Just(Interval::SEGMENT),
        (-2.0_f32..2.0, 0.0_f32..4.0).prop_map(|(min, length)| Interval { min, max: min + length })
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn the_octree_finds_what_asking_every_primitive_finds(
        things in prop::collection::vec(thing(), 0..60),
        rays in prop::collection::vec((ray(), interval()), 20),
    ) {
        let all = primitives(&things);
        let asked = none(all.clone());
        for build in [octree, wide] as [fn(Primitives) -> Box<dyn Accelerator>; 2] {
        let octree = build(all.clone());
        for &(ray, within) in &rays {
            let expected = asked.closest(&ray, within);
            prop_assert_eq!(octree.closest(&ray, within), expected, "{:?} {:?}", ray, within);
            prop_assert_eq!(octree.any(&ray, within), expected.is_some(), "{:?} {:?}", ray, within);
        }}
    }

    #[test]
    fn the_octree_finds_it_too_with_a_box_test_of_ones_own(
        things in prop::collection::vec(thing(), 8..60),
        rays in prop::collection::vec((ray(), interval()), 20),
    ) {
        let all = primitives(&things);
        let kernels = Kernels {
            aabb: Some(|bounds, ray, within| BoxProbe::new(ray, bounds.magnitude()).clip(*bounds, within)),
            ..Kernels::default()
        };
        let (asked, octree) = (none(all.clone()), octree(all.with_kernels(kernels)));
        for (ray, within) in rays {
            let expected = asked.closest(&ray, within);
            prop_assert_eq!(octree.closest(&ray, within), expected, "{:?} {:?}", ray, within);
            prop_assert_eq!(octree.any(&ray, within), expected.is_some(), "{:?} {:?}", ray, within);
        }
    }

    #[test]
    fn many_rays_at_once_find_what_each_finds_alone(
        things in prop::collection::vec(thing(), 0..20),
        rays in prop::collection::vec(ray(), 10),
    ) {
        let octree = octree(primitives(&things));
        let mut hits = vec![None; rays.len()];
        octree.closest_many(&rays, &mut hits);
        let alone: Vec<_> = rays.iter().map(|ray| octree.closest(ray, Interval::FORWARD)).collect();
        prop_assert_eq!(hits, alone);
    }
}

/// What a box test leaves out is not asked.
#[test]
fn the_octree_asks_the_box_test_that_it_is_given() {
    let all = primitives(&vec![Thing::Sphere(Vec3::ZERO, 1.0); 20]);
    let ray = Ray::new(Vec3::new(0.0, 0.0, 3.0), Vec3::NEG_Z);
    assert!(octree(all.clone()).closest(&ray, Interval::FORWARD).is_some());
    let blind = Kernels { aabb: Some(|_, _, _| None), ..Kernels::default() };
    assert_eq!(octree(all.with_kernels(blind)).closest(&ray, Interval::FORWARD), None);
}

/// Of two equal triangles the first is hit, wherever the tree has put them.
#[test]
fn the_lowest_primitive_wins_a_tie() {
    let twin = Thing::Triangle([Vec3::ZERO, Vec3::X, Vec3::Y]);
    let other = Thing::Sphere(Vec3::splat(3.0), 0.5);
    let mut things = vec![other.clone(), twin.clone(), twin];
    things.extend(std::iter::repeat_n(other, 40));
    let ray = Ray::new(Vec3::new(0.25, 0.25, 1.0), Vec3::NEG_Z);
    for build in [none, octree, wide] as [fn(Primitives) -> Box<dyn Accelerator>; 3] {
        assert_eq!(build(primitives(&things)).closest(&ray, Interval::FORWARD).map(|hit| hit.primitive), Some(1));
    }
}

#[test]
fn nothing_and_not_a_number_are_no_hit() {
    let things = vec![Thing::Sphere(Vec3::ZERO, 1.0); 20];
    for build in [none, octree, wide] as [fn(Primitives) -> Box<dyn Accelerator>; 3] {
        assert_eq!(build(Primitives::default()).closest(&Ray::new(Vec3::ZERO, Vec3::X), Interval::FORWARD), None);
        for ray in [Ray::new(Vec3::NAN, Vec3::X), Ray::new(Vec3::ZERO, Vec3::NAN), Ray::new(Vec3::ZERO, Vec3::ZERO)] {
            assert_eq!(build(primitives(&things)).closest(&ray, Interval::FORWARD), None, "{ray:?}");
        }
    }
}

#[test]
fn cells_divide_a_large_scene_and_not_a_small_one() {
    let grid = |n: i32| -> Vec<Thing> {
        let at = |i: i32| Vec3::new((i % 10) as f32, (i / 10 % 10) as f32, (i / 100) as f32);
        (0..n).map(|i| Thing::Sphere(at(i), 0.3)).collect()
    };
    let small = octree(primitives(&grid(2))).statistics();
    assert_eq!((small.branches, small.depth, small.references), (0, 0, 2));
    let large = octree(primitives(&grid(1000))).statistics();
    assert!(large.branches > 50 && large.depth >= 2 && large.references >= 1000, "{large:?}");
}
