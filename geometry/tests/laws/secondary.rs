//! Rays that leave one surface for the next: no acne (the surface met again), no leak (the next one passed through), for scales
//! from 1e-3 to 1e6 and gaps of 1e-5 of the scale.

use geometry::{
    Ellipsoid, Hit, Interval, Mesh, Primitive, Primitives, Ray, Surface, Transform,
    conformance::{GAP, cube_edges, ellipsoids_apart, planes_apart, spheres_apart, times, triangles_apart},
    unit_cube,
};
use glam::Vec3;
use proptest::prelude::*;

use crate::exact::SINGLE;

/// The ray that leaves the first surface meets the second after at least the gap, and before anything else of the first; the
/// shadow segments to lights before and behind the second are free and blocked.
fn crosses_the_gap(
    first: &dyn Primitive,
    second: &dyn Primitive,
    scale: f32,
    ray: &Ray,
    leaving: Vec3,
) -> Result<(), TestCaseError> {
    let Some(hit) = first.intersect(ray, Interval::FORWARD) else {
        return Err(TestCaseError::fail("the ray is aimed at the first surface"));
    };
    let surface = first.surface(ray, &hit);
    let left = surface.leave(leaving);
    let Some(next) = second.intersect(&left, Interval::FORWARD) else { return Err(TestCaseError::fail("a leak")) };
    let length = left.direction.as_dvec3().length();
    // Nine tenths: the surfaces' coordinates, the hit point and the start are each rounded, 2 to 4 of the gap's 80 roundings.
    prop_assert!(f64::from(next.t) * length >= 0.9 * GAP * f64::from(scale), "t = {}", next.t);
    let again = first.intersect(&left, Interval::FORWARD);
    // What is left inwards has its other side behind the second's near one.
    prop_assert!(again.is_none_or(|again| again.t > next.t), "acne: {:?} before {:?}", again, next);

    for (share, is_blocked) in [(0.5, false), (1.5, true)] {
        let light = left.at(share * f64::from(next.t)).as_vec3();
        let segment = surface.leave_towards(light);
        prop_assert_eq!(first.intersect(&segment, Interval::SEGMENT), None, "acne in the light's way");
        prop_assert_eq!(second.intersect(&segment, Interval::SEGMENT).is_some(), is_blocked, "at {} of the way", share);
    }
    Ok(())
}

proptest! {
    #![proptest_config(times(16))]

    #[test]
    fn from_plane_to_plane_there_is_no_acne_and_no_leak(apart in planes_apart()) {
        let (first, second) = (apart.first.plane().unwrap(), apart.second.plane().unwrap());
        crosses_the_gap(&first, &second, apart.scale, &apart.ray, apart.leaving)?;
    }

    #[test]
    fn from_triangle_to_triangle_there_is_no_acne_and_no_leak(apart in triangles_apart()) {
        crosses_the_gap(&apart.first, &apart.second, apart.scale, &apart.ray, apart.leaving)?;
    }

    #[test]
    fn from_sphere_to_sphere_outwards_and_inwards_there_is_no_acne_and_no_leak(apart in spheres_apart()) {
        crosses_the_gap(&apart.first, &apart.second, apart.scale, &apart.ray, apart.leaving)?;
    }

    #[test]
    fn from_ellipsoid_to_ellipsoid_outwards_and_inwards_there_is_no_acne_and_no_leak(apart in ellipsoids_apart()) {
        let [first, second] = [apart.first, apart.second].map(|map| Ellipsoid::new(map).expect("of full rank"));
        crosses_the_gap(&first, &second, apart.scale, &apart.ray, apart.leaving)?;
    }

    #[test]
    fn a_cube_is_not_met_again_from_outside_near_its_edges(case in cube_edges()) {
        let cube = Cube::new(&case.place);
        let Some((hit, surface)) = cube.nearest(&case.ray) else { return Ok(()) };
        let outward = surface.leave(away(case.leaving, surface.geometric_normal));
        prop_assume!(cosine(&surface, outward.direction) > cube.flatness());
        let again = cube.nearest(&outward);
        prop_assert!(again.is_none(), "acne: {:?} after {:?}", again, hit);
    }

    #[test]
    fn no_ray_leaves_a_cube_from_inside_near_its_edges(case in cube_edges()) {
        let cube = Cube::new(&case.place);
        let Some((hit, surface)) = cube.nearest(&case.ray) else { return Ok(()) };
        // At the very edge half an ulp decides which side of the other face the point is on.
        prop_assume!(cube.distance_from_other_faces(&surface, hit) > 4.0 * surface.error.as_dvec3().length());
        let inward = surface.leave(-away(case.leaving, surface.geometric_normal));
        prop_assume!(cosine(&surface, inward.direction) < -cube.flatness());
        let Some((next, _)) = cube.nearest(&inward) else { return Err(TestCaseError::fail("a leak")) };
        prop_assert_ne!(next.primitive / 2, hit.primitive / 2, "acne");
        let to_middle = surface.leave_towards(case.place.translation.as_vec3());
        prop_assert!(!cube.blocks(&to_middle), "the cube's middle sees all of its inside");
        let to_outside = surface.leave_towards(inward.at(2.0 * f64::from(next.t)).as_vec3());
        prop_assert!(cube.blocks(&to_outside), "light leaks in");
    }
}

/// The direction or its opposite, on the normal's side.
fn away(direction: Vec3, normal: Vec3) -> Vec3 {
    if direction.dot(normal) < 0.0 { -direction } else { direction }
}

fn cosine(surface: &Surface, direction: Vec3) -> f64 {
    surface.geometric_normal.as_dvec3().dot(direction.as_dvec3()) / direction.as_dvec3().length()
}

/// Twelve triangles somewhere.
struct Cube {
    triangles: Primitives,
    place: Transform,
}

impl Cube {
    fn new(place: &Transform) -> Self {
        let Mesh { positions, triangles, .. } = unit_cube();
        let positions = positions.into_iter().map(|position| place.point_f32(position)).collect();
        let mut primitives = Primitives::default();
        primitives.add_mesh(Mesh { positions, triangles, ..Mesh::default() });
        Self { triangles: primitives, place: *place }
    }

    fn nearest(&self, ray: &Ray) -> Option<(Hit, Surface)> {
        let hits = (0..12).filter_map(|number| self.triangles.intersect(number, ray, Interval::FORWARD));
        let hit = hits.reduce(|nearest, hit| if hit.is_before(nearest) { hit } else { nearest })?;
        Some((hit, self.triangles.surface(ray, &hit)))
    }

    fn blocks(&self, segment: &Ray) -> bool {
        (0..12).any(|number| self.triangles.intersect(number, segment, Interval::SEGMENT).is_some())
    }

    /// Corners are rounded, so that the two triangles of a turned face are not quite in one plane: how steep one may rise from
    /// the other. An ulp or two of a corner's coordinates, over the side.
    fn flatness(&self) -> f64 {
        let side = self.place.linear.x_axis.length();
        16.0 * SINGLE * (self.place.translation.length() + side) / side
    }

    /// How far a point of one face is from the planes of the four around it.
    fn distance_from_other_faces(&self, surface: &Surface, hit: Hit) -> f64 {
        let local = self.place.inverse().expect("of full rank").point(surface.position.as_dvec3());
        // Faces come in pairs along x, y, z; two triangles each.
        let own_axis = hit.primitive as usize / 4;
        let margin = |axis: usize| (0.5 - local[axis].abs()) * self.place.linear.x_axis.length();
        (0..3).filter(|&axis| axis != own_axis).map(margin).fold(f64::INFINITY, f64::min)
    }
}
