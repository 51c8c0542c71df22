//! What accelerators tell of themselves, and of what a ray visits.

use accel::{Accelerator, Step, Visits, none, octree, wide, wide_up_to};
use geometry::{Interval, Mesh, Primitives, Ray, Sphere};
use glam::Vec3;

/// 1000 spheres of radius 0.3 on the whole numbers from 0 to 9.
fn spheres() -> Primitives {
    let mut primitives = Primitives::default();
    for number in 0..1000 {
        let center = Vec3::new((number % 10) as f32, (number / 10 % 10) as f32, (number / 100) as f32);
        primitives.add_sphere(Sphere { center, radius: 0.3 });
    }
    primitives
}

fn visits(accelerator: &dyn Accelerator, origin: [f32; 3], direction: [f32; 3]) -> Visits {
    accelerator.visits(&Ray::new(origin.into(), direction.into()), Interval::FORWARD)
}

#[test]
fn every_primitive_is_asked_without_an_accelerator() {
    assert_eq!(visits(&*none(spheres()), [-5.0, 0.0, 0.0], [0.0, 0.0, 1.0]), Visits { nodes: 0, primitives: 1000 });
}

#[test]
fn a_ray_past_everything_visits_the_root_at_most() {
    for tree in [octree(spheres()), wide(spheres())] {
        let Visits { nodes, primitives } = visits(&*tree, [-5.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
        assert!(nodes <= 1 && primitives == 0, "{nodes} {primitives}");
    }
}

#[test]
fn a_ray_between_the_spheres_visits_more_than_one_that_stops_at_the_first() {
    for tree in [octree(spheres()), wide(spheres())] {
        let stopped = visits(&*tree, [-5.0, 4.0, 4.0], [1.0, 0.0, 0.0]);
        let passing = visits(&*tree, [-5.0, 4.25, 4.25], [1.0, 0.0, 0.0]);
        assert!(stopped.nodes >= 1 && stopped.primitives >= 1, "{stopped:?}");
        assert!(passing.nodes > stopped.nodes && passing.primitives < 500, "{passing:?} {stopped:?}");
    }
}

/// A ray that is not ordinary is answered by asking every primitive.
#[test]
fn a_ray_that_is_no_number_asks_every_primitive() {
    for tree in [octree(spheres()), wide(spheres())] {
        assert_eq!(visits(&*tree, [f32::NAN, 0.0, 0.0], [1.0, 0.0, 0.0]), Visits { nodes: 0, primitives: 1000 });
    }
}

/// The unit of all costs is a primitive that is asked.
#[test]
fn a_leaf_is_expected_to_cost_what_asking_its_primitives_costs() {
    let mut two = Primitives::default();
    two.add_sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
    two.add_sphere(Sphere { center: Vec3::X, radius: 1.0 });
    assert_eq!([none, octree, wide].map(|build| build(two.clone()).statistics().cost), [2.0; 3]);
}

#[test]
fn each_accelerator_is_expected_to_cost_less_than_the_one_before_it() {
    let costs = [none, octree, wide].map(|build| build(spheres()).statistics().cost);
    assert_eq!(costs[0], 1000.0);
    assert!(costs[0] > costs[1] && costs[1] > costs[2], "{costs:?}");
}

#[test]
fn each_step_of_the_wide_octree_is_expected_to_cost_no_more_than_the_one_before_it() {
    let costs = Step::ALL.map(|step| wide_up_to(spheres(), step).statistics().cost);
    assert!(costs[0] > 1.05 * costs[1], "{costs:?}");
    // Spheres are not cut.
    assert_eq!(costs[1], costs[2]);
}

/// Walls behind each other, along an axis, 1 apart. Of the first and the last of them only one half is there.
fn walls(count: u32, halves: u32, [along, right, up]: [Vec3; 3]) -> Primitives {
    let corners = [-right - up, right - up, right + up, up - right];
    let is_half = |wall: u32| wall < halves || wall >= count - halves;
    let faces = |wall: u32| {
        [[0, 1, 2], [0, 2, 3]]
            .into_iter()
            .skip(usize::from(is_half(wall)))
            .map(move |face| face.map(|corner| 4 * wall + corner))
    };
    let mut primitives = Primitives::default();
    primitives.add_mesh(Mesh {
        positions: (0..count).flat_map(|wall| corners.map(|corner| wall as f32 * along + corner)).collect(),
        triangles: (0..count).flat_map(faces).collect(),
        ..Mesh::default()
    });
    primitives
}

/// What is nearer is visited first: whichever way a ray goes through the walls, it stops at the first that it meets.
#[test]
fn a_ray_that_meets_the_first_of_many_walls_visits_few() {
    for (count, halves) in [(10, 0), (1000, 0), (1000, 100)] {
        for axis in 0..3 {
            let axes @ [along, right, up] = [0, 1, 2].map(|next| Vec3::AXES[(axis + next) % 3]);
            let primitives = walls(count, halves, axes);
            for tree in [octree(primitives.clone()), wide(primitives.clone())] {
                for (start, way) in [(-1.0, along), (count as f32, -along)] {
                    let ray = Ray::new(start * along + 0.3 * right + 0.1 * up, way);
                    assert_eq!(tree.closest(&ray, Interval::FORWARD).map(|hit| hit.t), Some(1.0 + halves as f32));
                    let visited = tree.visits(&ray, Interval::FORWARD).primitives;
                    assert!(
                        visited <= u64::from(halves + 8),
                        "{visited} of {count} walls, {halves} of them halves, {way}"
                    );
                }
            }
        }
    }
}

/// Two rows of eight stacks of walls. A ray through a stack of each meets two boxes of a node's sixteen, and stops in the first.
#[test]
fn of_two_boxes_the_nearer_is_visited_first() {
    for axis in 0..3 {
        let [along, right, up] = [0, 1, 2].map(|next| Vec3::AXES[(axis + next) % 3]);
        let place = |wall: u32| {
            let (row, stack, depth) = (wall / 32, wall / 4 % 8, wall % 4);
            (10.0 * row as f32 + 0.1 * depth as f32) * along + 10.0 * stack as f32 * right
        };
        let corners = [-right - up, right - up, right + up, up - right];
        let faces = |wall: u32| [[0, 1, 2], [0, 2, 3]].map(|face| face.map(|corner| 4 * wall + corner));
        let mut primitives = Primitives::default();
        primitives.add_mesh(Mesh {
            positions: (0..64).flat_map(|wall| corners.map(|corner| place(wall) + corner)).collect(),
            triangles: (0..64).flat_map(faces).collect(),
            ..Mesh::default()
        });
        for tree in [octree(primitives.clone()), wide(primitives.clone())] {
            for stack in 0..8 {
                let beside = 10.0 * stack as f32 * right + 0.3 * right + 0.1 * up;
                for (start, way) in [(-5.0, along), (15.0, -along)] {
                    let visited = tree.visits(&Ray::new(start * along + beside, way), Interval::FORWARD).primitives;
                    assert!((1..=8).contains(&visited), "{visited} of stack {stack}, {way}");
                }
            }
        }
    }
}
