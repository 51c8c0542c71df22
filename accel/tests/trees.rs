//! What our own trees do beyond the kit: they divide what is large, cut what is thin, and ask the box test that they are given.

use accel::conformance::{Asked, Thing};
use accel::{none, octree, wide};
use geometry::{Interval, Kernels, Primitives, Ray};
use glam::Vec3;

fn primitives(things: Vec<Thing>) -> Primitives {
    Asked { things, rays: Vec::new() }.primitives()
}

/// Crossing wires of thin triangles: one stands in many leaves.
#[test]
fn thin_triangles_are_cut_in_pieces() {
    let wire = |number: u32| {
        let (row, piece) = (number / 4, (number / 2 % 2) as f32);
        let side = if number.is_multiple_of(2) { 1.0 } else { -1.0 };
        let at = |along: f32| Vec3::new(0.06 * row as f32 - 4.0 + side * along, 0.0, along);
        Thing::Triangle([at(4.0 * piece - 4.0), at(4.0 * piece), at(4.0 * piece) + 0.01 * Vec3::X])
    };
    let statistics = wide(primitives((0..512).map(wire).collect())).statistics();
    assert!(statistics.references > 2 * 512, "{statistics:?}");
}

/// What a box test leaves out is not asked.
#[test]
fn the_octree_asks_the_box_test_that_it_is_given() {
    let all = primitives(vec![Thing::Sphere(Vec3::ZERO, 1.0); 20]);
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
    let mut things = vec![other, twin, twin];
    things.extend(std::iter::repeat_n(other, 40));
    let all = primitives(things);
    let ray = Ray::new(Vec3::new(0.25, 0.25, 1.0), Vec3::NEG_Z);
    for build in [none, octree, wide] as [fn(Primitives) -> Box<dyn accel::Accelerator>; 3] {
        assert_eq!(build(all.clone()).closest(&ray, Interval::FORWARD).map(|hit| hit.primitive), Some(1));
    }
}

#[test]
fn cells_divide_a_large_scene_and_not_a_small_one() {
    let grid = |n: i32| -> Vec<Thing> {
        let at = |i: i32| Vec3::new((i % 10) as f32, (i / 10 % 10) as f32, (i / 100) as f32);
        (0..n).map(|i| Thing::Sphere(at(i), 0.3)).collect()
    };
    let small = octree(primitives(grid(2))).statistics();
    assert_eq!((small.branches, small.depth, small.references), (0, 0, 2));
    let large = octree(primitives(grid(1000))).statistics();
    assert!(large.branches > 50 && large.depth >= 2 && large.references >= 1000, "{large:?}");
}
