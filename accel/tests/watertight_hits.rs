//! What `--hits watertight` promises: the same hits with any instructions, alone and in packets, and no gap in a closed mesh.

use accel::conformance::{Asked, aims, intervals, things};
use accel::{Hits, Instructions, wide_watertight, wide_with};
use geometry::conformance::{Enclosed, closed_meshes, times};
use geometry::{Interval, Primitives, Ray};
use glam::Vec3;
use proptest::prelude::*;

proptest! {
    #![proptest_config(times(8))]

    #[test]
    fn watertight_hits_do_not_depend_on_the_instructions(
        things in prop::collection::vec(things(), 0..60),
        aims in prop::collection::vec((aims(), intervals()), 40),
    ) {
        let rays: Vec<Ray> = aims.iter().map(|(aim, _)| aim.ray(&things)).collect();
        let all = Asked { things, rays: Vec::new() }.primitives();
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

    /// Sixteen rays a few roundings apart, aimed at a corner or an edge: a packet finds what each ray finds alone.
    #[test]
    fn watertight_packets_hit_what_each_ray_hits(Enclosed { mesh, rays } in closed_meshes()) {
        let mut all = Primitives::default();
        all.add_mesh(mesh);
        let wide = wide_watertight(all);
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
}
