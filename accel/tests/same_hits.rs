//! Every accelerator finds the hit that asking every primitive finds, bit for bit.

use accel::{Accelerator, Hits, Instructions, Step, none, octree, wide, wide_up_to, wide_with};
use geometry::conformance::{Aimed, Enclosed, closed_meshes, times, triangles, wild_vectors};
use geometry::{BoxProbe, Ellipsoid, Interval, Kernels, Mesh, Primitive, Primitives, Ray, Sphere, Transform};
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

/// A ray, or how to aim one at the things.
#[derive(Clone, Debug)]
enum Aim {
    Free(Ray),
    /// From a point, so many times as far away, at a place of a triangle: a corner, a place on an edge, one inside.
    At {
        from: Vec3,
        far: f32,
        triangle: prop::sample::Index,
        weights: [f32; 3],
        length: f32,
    },
    /// In a triangle's plane: from one place of it to another, the first as far outside as its weights say.
    Within {
        triangle: prop::sample::Index,
        from: [f32; 3],
        to: [f32; 3],
    },
}

impl Aim {
    fn ray(&self, things: &[Thing]) -> Ray {
        let triangles: Vec<[Vec3; 3]> = things
            .iter()
            .filter_map(|thing| if let Thing::Triangle(corners) = thing { Some(*corners) } else { None })
            .collect();
        let place = |index: &prop::sample::Index, [a, b, c]: [f32; 3]| {
            if triangles.is_empty() {
                return Vec3::new(a, b, c);
            }
            let corners = triangles[index.index(triangles.len())];
            a * corners[0] + b * corners[1] + c * corners[2]
        };
        match self {
            Self::Free(ray) => *ray,
            Self::At { from, far, triangle, weights, length } => {
                let origin = *from * *far;
                Ray::new(origin, (place(triangle, *weights) - origin) * *length)
            }
            Self::Within { triangle, from, to } => {
                let origin = place(triangle, *from);
                Ray::new(origin, place(triangle, *to) - origin)
            }
        }
    }
}

/// Rays in general, along axes and faces, with components zero and denormal, from far away, aimed at corners, edges and places of
/// triangles, and running in their planes.
fn aim() -> impl Strategy<Value = Aim> {
    let zeroed = (point(), 0_usize..8, prop_oneof![Just(0.0_f32), Just(1e-45), Just(1e-39), Just(1e-30)]).prop_map(
        |(direction, keep, tiny)| {
            let component = |axis: usize| {
                if keep >> axis & 1 == 1 { direction[axis] } else { tiny.copysign(direction[axis]) }
            };
            Vec3::new(component(0), component(1), component(2))
        },
    );
    let far = || prop_oneof![4 => Just(1.0_f32), 1 => Just(1e3_f32), 1 => Just(1e6_f32), 1 => Just(4e6_f32)];
    let length = || prop_oneof![3 => Just(1.0_f32), 1 => 1e-3_f32..1e3, 1 => Just(1e-20_f32), 1 => Just(1e20_f32)];
    let corner = prop::sample::select(vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let edge = (0.0_f32..1.0, 0_usize..3).prop_map(|(a, turn)| {
        let mut weights = [a, 1.0 - a, 0.0];
        weights.rotate_left(turn);
        weights
    });
    let inside = (0.0_f32..1.0, 0.0_f32..1.0).prop_map(|(a, b)| [a * (1.0 - b), (1.0 - a) * (1.0 - b), b]);
    let weights = || prop_oneof![corner.clone(), edge.clone(), inside.clone()];
    let around = prop_oneof![weights(), (-3.0_f32..3.0, -3.0_f32..3.0).prop_map(|(a, b)| [a, b, 1.0 - a - b])];
    let index = any::<prop::sample::Index>;
    prop_oneof![
        (point(), point()).prop_map(|(origin, direction)| Aim::Free(Ray::new(origin, direction))),
        (point(), zeroed, far()).prop_map(|(origin, direction, far)| Aim::Free(Ray::new(origin * far, direction))),
        (point(), point(), far(), length()).prop_map(|(origin, target, far, length)| {
            Aim::Free(Ray::new(origin * far, (target - origin * far) * length))
        }),
        (point(), far(), index(), weights(), length()).prop_map(|(from, far, triangle, weights, length)| Aim::At {
            from,
            far,
            triangle,
            weights,
            length
        }),
        (index(), around, weights()).prop_map(|(triangle, from, to)| Aim::Within { triangle, from, to }),
        (wild_vectors(), wild_vectors()).prop_map(|(origin, direction)| Aim::Free(Ray::new(origin, direction))),
    ]
}

fn interval() -> impl Strategy<Value = Interval> {
    prop_oneof![
        Just(Interval::FORWARD),
        Just(Interval::SEGMENT),
        Just(Interval { min: f32::NEG_INFINITY, max: f32::INFINITY }),
        (-2.0_f32..2.0, 0.0_f32..4.0).prop_map(|(min, length)| Interval { min, max: min + length })
    ]
}

/// All that promise the hits of asking every primitive: the octree, and the wide one with each instruction set that there is here.
fn accelerators(primitives: &Primitives) -> Vec<(String, Box<dyn Accelerator>)> {
    let wide = Instructions::ALL.into_iter().filter_map(|instructions| {
        let built = wide_with(primitives.clone(), Hits::Exact, instructions)?;
        Some((format!("wide, {instructions:?}"), built))
    });
    let less = ("wide, one level a node".to_owned(), wide_up_to(primitives.clone(), Step::OneLevel));
    wide.chain([("octree".to_owned(), octree(primitives.clone())), less]).collect()
}

/// Holds every accelerator to the hits of asking every primitive: one ray at a time, and many at once.
fn assert_same_hits(all: &Primitives, rays: &[(Ray, Interval)]) {
    let asked = none(all.clone());
    let forward: Vec<Ray> = rays.iter().map(|&(ray, _)| ray).collect();
    let expected: Vec<_> = rays.iter().map(|(ray, within)| asked.closest(ray, *within)).collect();
    let ahead: Vec<_> = forward.iter().map(|ray| asked.closest(ray, Interval::FORWARD)).collect();
    for (name, accelerator) in accelerators(all) {
        for (&(ray, within), &expected) in rays.iter().zip(&expected) {
            assert_eq!(accelerator.closest(&ray, within), expected, "{name}: {ray:?} {within:?}");
            assert_eq!(accelerator.any(&ray, within), expected.is_some(), "{name}: {ray:?} {within:?}");
        }
        let mut hits = vec![None; rays.len()];
        accelerator.closest_many(&forward, &mut hits);
        for ((ray, hit), expected) in forward.iter().zip(hits).zip(&ahead) {
            assert_eq!(hit, *expected, "{name}, many: {ray:?}");
        }
        let mut found = vec![false; rays.len()];
        accelerator.any_many(&forward, Interval::FORWARD, &mut found);
        for ((ray, found), expected) in forward.iter().zip(found).zip(&ahead) {
            assert_eq!(found, expected.is_some(), "{name}, any of many: {ray:?}");
        }
    }
}

proptest! {
    #![proptest_config(times(8))]

    #[test]
    fn every_accelerator_finds_what_asking_every_primitive_finds(
        things in prop::collection::vec(thing(), 0..60),
        aims in prop::collection::vec((aim(), interval()), 40),
    ) {
        let rays: Vec<_> = aims.iter().map(|(aim, within)| (aim.ray(&things), *within)).collect();
        assert_same_hits(&primitives(&things), &rays);
    }

    /// Bundles as a camera's or a light's, that packets take together; more than two packets, and not a whole number of them.
    #[test]
    fn so_it_does_for_bundles_of_rays(
        things in prop::collection::vec(thing(), 0..60),
        origin in point(), target in point(), spread in prop_oneof![Just(0.0_f32), Just(0.5)],
        jitter in prop::collection::vec(([-1.0_f32..1.0, -1.0_f32..1.0, -1.0_f32..1.0], 0..20_u32), 37),
    ) {
        let bundled = |&([x, y, z], wild): &([f32; 3], u32)| {
            let jitter = Vec3::new(x, y, z);
            // Factors, so that signs and zeros stay as they are. One in twenty goes another way.
            let direction = (target - origin) * (Vec3::ONE + 0.3 * jitter);
            (Ray::new(origin + spread * jitter, if wild == 0 { -direction } else { direction }), Interval::FORWARD)
        };
        assert_same_hits(&primitives(&things), &jitter.iter().map(bundled).collect::<Vec<_>>());
        let bundle: Vec<_> = jitter.iter().map(|&(jitter, _)| bundled(&(jitter, 1))).collect();
        assert_same_hits(&primitives(&things), &bundle);
    }

    /// Triangles of any size and shape, up to 1e6 times as far from the origin as they are large, beside each other.
    #[test]
    fn so_it_does_among_slivers_giants_and_dust(
        aimed in prop::collection::vec(triangles(), 1..40),
    ) {
        let mut all = Primitives::default();
        for Aimed { shape, .. } in &aimed {
            let mesh = Mesh { positions: shape.corners.to_vec(), triangles: vec![[0, 1, 2]], ..Mesh::default() };
            all.add_mesh(mesh);
        }
        let rays: Vec<_> = aimed.iter().map(|aimed| (aimed.ray, Interval::FORWARD)).collect();
        assert_same_hits(&all, &rays);
    }

    #[test]
    fn watertight_hits_do_not_depend_on_the_instructions(
        things in prop::collection::vec(thing(), 0..60),
        aims in prop::collection::vec((aim(), interval()), 40),
    ) {
        let all = primitives(&things);
        let rays: Vec<Ray> = aims.iter().map(|(aim, _)| aim.ray(&things)).collect();
        let mut first = None;
        for instructions in Instructions::ALL {
            let Some(wide) = wide_with(all.clone(), Hits::Watertight, instructions) else { continue };
            let mut hits = vec![None; rays.len()];
            wide.closest_many(&rays, &mut hits);
            let alone: Vec<_> = rays.iter().zip(&aims).map(|(ray, (_, within))| wide.closest(ray, *within)).collect();
            let expected = first.get_or_insert((hits.clone(), alone.clone()));
            prop_assert_eq!(&(hits, alone), expected, "{:?}", instructions);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: times(1).cases / 4, ..times(1) })]

    #[test]
    fn so_it_does_from_inside_closed_meshes_where_each_ray_is_aimed_at_a_corner_or_an_edge(
        Enclosed { mesh, rays } in closed_meshes(),
    ) {
        let mut all = Primitives::default();
        all.add_mesh(mesh);
        let rays: Vec<_> = rays.into_iter().map(|ray| (ray, Interval::FORWARD)).collect();
        assert_same_hits(&all, &rays);
    }

    /// Sixteen rays a few roundings apart, aimed at a corner or an edge: a packet finds what each ray finds alone.
    #[test]
    fn watertight_packets_hit_what_each_ray_hits(Enclosed { mesh, rays } in closed_meshes()) {
        let mut all = Primitives::default();
        all.add_mesh(mesh);
        let wide = accel::wide_watertight(all);
        for ray in &rays {
            let beside = |step: u16| {
                let factor = |bits: u16| 1.0 + f32::from(bits & 3) * f32::EPSILON;
                ray.direction * Vec3::new(factor(step), factor(step >> 1), factor(step >> 2))
            };
            let bundle: Vec<_> = (0..16).map(|step| Ray::new(ray.origin, beside(step))).collect();
            let mut hits = vec![None; bundle.len()];
            wide.closest_many(&bundle, &mut hits);
            let alone: Vec<_> = bundle.iter().map(|ray| wide.closest(ray, Interval::FORWARD)).collect();
            prop_assert_eq!(hits, alone);
        }
    }

    #[test]
    fn watertight_hits_leave_no_gap_in_closed_meshes(Enclosed { mesh, rays } in closed_meshes()) {
        let mut all = Primitives::default();
        all.add_mesh(mesh);
        for instructions in Instructions::ALL {
            let Some(wide) = wide_with(all.clone(), Hits::Watertight, instructions) else { continue };
            for ray in &rays {
                prop_assert!(wide.closest(ray, Interval::FORWARD).is_some(), "{instructions:?}: {ray:?}");
                prop_assert!(wide.any(ray, Interval::FORWARD), "{instructions:?}: {ray:?}");
            }
        }
    }

    /// Crossing wires, whose thin triangles the wide octree cuts in pieces: one triangle stands in many leaves.
    #[test]
    fn so_it_does_where_thin_triangles_are_cut_in_pieces(
        (slope, width, wave) in (0.8_f32..1.2, 0.001_f32..0.02, point()),
        aims in prop::collection::vec(aim(), 60),
    ) {
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
        let all = primitives(&things);
        prop_assert!(wide(all.clone()).statistics().references > 2 * things.len(), "they are not cut: {:?}", wide(all.clone()).statistics());
        let rays: Vec<_> = aims.iter().map(|aim| (aim.ray(&things), Interval::FORWARD)).collect();
        assert_same_hits(&all, &rays);
    }

    #[test]
    fn so_it_does_with_a_students_own_kernels(
        things in prop::collection::vec(thing(), 8..60),
        aims in prop::collection::vec((aim(), interval()), 40),
    ) {
        let rays: Vec<_> = aims.iter().map(|(aim, within)| (aim.ray(&things), *within)).collect();
        // A box test as good as the reference's; triangles that are met from the front alone.
        let kernels = Kernels {
            aabb: Some(|bounds, ray, within| BoxProbe::new(ray, bounds.magnitude()).clip(*bounds, within)),
            triangle: Some(|triangle, ray, within| {
                let from_front = triangle.scaled_normal().dot(ray.direction.as_dvec3()) < 0.0;
                triangle.intersect(ray, within).filter(|_| from_front)
            }),
            ..Kernels::default()
        };
        assert_same_hits(&primitives(&things).with_kernels(kernels), &rays);
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
