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

/// Squares of edge 2 across an axis, the first of `axes`: where each stands, and how many of its two triangles are there.
fn walls([_, right, up]: [Vec3; 3], places: impl Iterator<Item = (Vec3, usize)>) -> Primitives {
    let mut mesh = Mesh::default();
    for (place, triangles) in places {
        let first = mesh.positions.len() as u32;
        mesh.positions.extend([-right - up, right - up, right + up, up - right].map(|corner| place + corner));
        let faces = [[0, 2, 3], [0, 1, 2]].into_iter().take(triangles);
        mesh.triangles.extend(faces.map(|face| face.map(|corner| first + corner)));
    }
    let mut primitives = Primitives::default();
    primitives.add_mesh(mesh);
    primitives
}

/// The axes, beginning with each of them.
fn turned_axes() -> [[Vec3; 3]; 3] {
    [0, 1, 2].map(|axis| [0, 1, 2].map(|next| Vec3::AXES[(axis + next) % 3]))
}

/// What is nearer is visited first: whichever way a ray goes through walls behind each other, it stops at the first that it meets. It passes those
/// of the first and the last of which only one half is there.
#[test]
fn a_ray_that_meets_the_first_of_many_walls_visits_few() {
    for (count, halves) in [(10, 0), (1000, 0), (1000, 100)] {
        for axes @ [along, right, up] in turned_axes() {
            let triangles = |wall: u32| if (halves..count - halves).contains(&wall) { 2 } else { 1 };
            let primitives = walls(axes, (0..count).map(|wall| (wall as f32 * along, triangles(wall))));
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
    for axes @ [along, right, up] in turned_axes() {
        let place = |wall: u32| {
            let (row, stack, depth) = (wall / 32, wall / 4 % 8, wall % 4);
            (10.0 * row as f32 + 0.1 * depth as f32) * along + 10.0 * stack as f32 * right
        };
        let primitives = walls(axes, (0..64).map(|wall| (place(wall), 2)));
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
