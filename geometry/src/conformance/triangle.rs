//! A ray and a triangle.
//!
//! The idea: the ray meets the triangle's plane in one point, and that lies in the triangle if none of its three weights is negative.
//! Each weight is a volume: that of the ray's direction and two corners, seen from the origin.
//!
//! ```text
//!        c                     volumes of d, b, c  :  weight of a
//!       / \                               d, c, a  :  weight of b, which is u
//!      / x \    <--- o                    d, a, b  :  weight of c, which is v
//!     a-----b                  all of one sign: the ray passes between the three edges
//! ```
//!
//! **The contract** is [`crate::Primitive::intersect`]'s: a triangle is met from both sides, its edges and corners belong to it, and
//! `u` and `v` are the weights of the second and third corner. A triangle without area, or seen edge-on, is not met.
//!
//! **The laws** stand below from the easiest on. The hard cases: edges that two triangles share (both or one may be met, never
//! neither: light would leak in), slivers of 1 : 1e6, rays within 1e-6 of the plane, triangles of 1e-6 beside an origin 1e6 of their sizes off.
//! What they are held against are the volumes in rational numbers.
//!
//! **Literature.** Möller, Trumbore: Fast, Minimum Storage Ray/Triangle Intersection, Journal of Graphics Tools, 1997. Woop, Benthin,
//! Wald: Watertight Ray/Triangle Intersection, JCGT, 2013. Kensler, Shirley: Optimizing Ray-Triangle Intersection via Automated Search,
//! IEEE Symposium on Interactive Ray Tracing, 2006, on the volumes. Shewchuk: Adaptive Precision Floating-Point Arithmetic and Fast
//! Robust Geometric Predicates, 1997.
//!
//! **Exercises.** 1. Pass the kit up to `a_triangle_without_area_is_never_met` with Möller and Trumbore's test; what becomes of their
//! epsilon? 2. Pass `no_ray_leaves_a_closed_mesh_through_its_edges_or_corners`. 3. Pass it all. 4. Beat the reference, which
//! answers in `f64`: how much of it can `f32` decide for certain?
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`a_triangle_straight_ahead_is_met`] |
//! | t is the distance to the plane | [`a_triangle_straight_ahead_is_met`] |
//! | u + v is not looked at | [`a_ray_beside_the_triangle_misses_it`] |
//! | one edge is not looked at | [`a_ray_beside_the_triangle_misses_it`] |
//! | culled from behind | [`a_triangle_is_met_from_behind`] |
//! | the absolute value of t | [`a_triangle_behind_the_ray_is_not_met`] |
//! | the direction is normalised | [`t_counts_multiples_of_the_direction`] |
//! | the interval is not checked | [`a_hit_outside_the_interval_does_not_count`] |
//! | u and v are swapped | [`u_and_v_are_the_weights_of_the_second_and_third_corner`] |
//! | u and v are those of the first two corners | [`u_and_v_are_the_weights_of_the_second_and_third_corner`] |
//! | edges do not belong to it | [`edges_and_corners_belong_to_the_triangle`] |
//! | Möller's and Trumbore's epsilon | [`a_small_triangle_is_met`] |
//! | a comparison that NaN passes | [`what_is_no_number_is_not_met`] |
//! | corners in a row have an area, by rounding | [`a_triangle_without_area_is_never_met`] |
//! | edges decided one by one, in f64 | [`no_ray_leaves_a_closed_mesh_through_its_edges_or_corners`] |
//! | t of the weighted depths | [`t_is_exact_to_half_an_ulp`] |

use glam::{DVec3, Vec3, dvec3};

use proptest::prelude::*;

use super::claim::{Truth, broken, wild_claim};
use super::exact::{DOUBLE, Exact, SINGLE, ULPS, Vector, approximate, is_within, truths};
use super::plane::exact_t;
use super::{
    Aimed, Enclosed, Figure, Trial, Verdict, closed_meshes, drawn_triangles, flat_triangles, magnitude, triangles,
    wild_intervals, wild_rays, wild_vectors,
};
use crate::{Intersect, Intersection, Interval, Mesh, Ray, Triangle, unit_cube};

/// The part: a plain function, the field `triangle` of [`crate::Kernels`].
pub type Part = Intersect<Triangle>;

/// A triangle in front of the ray, seen from its front, is met to three digits where a drawing on paper shows it.
pub fn a_triangle_straight_ahead_is_met(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_triangles(1.0..10.0, 1.0), |drawn| is_met(part, &drawn.inside(), Interval::FORWARD))
}

/// A ray that passes the plane outside, beyond any of the three edges, is no hit.
pub fn a_ray_beside_the_triangle_misses_it(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_triangles(1.0..10.0, 1.0), |drawn| {
        (0..3).try_for_each(|edge| is_met(part, &drawn.beyond(edge), Interval::FORWARD))
    })
}

/// Both sides are met.
pub fn a_triangle_is_met_from_behind(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_triangles(1.0..10.0, 1.0), |drawn| is_met(part, &drawn.from_behind(), Interval::FORWARD))
}

/// What lies behind the origin is not met.
pub fn a_triangle_behind_the_ray_is_not_met(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_triangles(-10.0..-1.0, 1.0), |drawn| is_met(part, &drawn.inside(), Interval::FORWARD))
}

/// The direction need not be a unit vector: if it is four times as long, `t` is a quarter as much.
pub fn t_counts_multiples_of_the_direction(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_triangles(1.0..10.0, 4.0), |drawn| is_met(part, &drawn.inside(), Interval::FORWARD))
}

/// A hit counts strictly inside the interval.
pub fn a_hit_outside_the_interval_does_not_count(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_triangles(1.0..10.0, 1.0), |drawn| {
        let Aimed { shape, ray } = drawn.inside();
        let Some(met) = part(&shape, &ray, Interval::FORWARD) else { return Ok(()) };
        let after = |min: f32| Interval { min, max: f32::INFINITY };
        for within in
            [Interval::FORWARD.up_to(0.9 * met.t), Interval::FORWARD.up_to(met.t), after(1.1 * met.t), after(met.t)]
        {
            let none = Truth { t: None, tolerance: 0.0 };
            none.judge(&ray, part(&shape, &ray, within), || scene(&Aimed { shape, ray }))?;
        }
        Ok(())
    })
}

/// `u` belongs to the second corner, `v` to the third, to three digits.
pub fn u_and_v_are_the_weights_of_the_second_and_third_corner(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_triangles(1.0..10.0, 1.0), |drawn| {
        let aimed = drawn.inside();
        let found = part(&aimed.shape, &aimed.ray, Interval::FORWARD);
        let [_, b, c] = drawn.weights;
        match found {
            Some(met) if (f64::from(met.u) - b).abs() > DRAWN || (f64::from(met.v) - c).abs() > DRAWN => {
                let expected = format!("u = {b}, v = {c}, to {DRAWN:e}");
                Err(broken(&aimed.ray, (&expected, Some(f64::from(met.t))), found, scene(&aimed)))
            }
            _ => Ok(()),
        }
    })
}

/// Of a triangle on whole numbers, met straight from above, and with an area of a power of two: whatever formula is used, it rounds
/// nothing.
pub fn edges_and_corners_belong_to_the_triangle(part: &Part, trial: &Trial) -> Verdict {
    let place = [-8..8_i32, -8..8, -8..8];
    let power_of_two = || prop::sample::select(vec![1, 2, 4]);
    let cases = (place, 0..3_usize, power_of_two(), power_of_two(), 0..6_usize, power_of_two());
    trial.search(cases, |&(place, axis, width, height, spot, above)| {
        let along = |x: i32, y: i32, z: i32| {
            let mut v = [0.0; 3];
            (v[axis], v[(axis + 1) % 3], v[(axis + 2) % 3]) = (x as f32, y as f32, z as f32);
            Vec3::from(v)
        };
        let start = Vec3::from(place.map(|x| x as f32));
        // Twice the size, so that the middles of the edges are whole numbers.
        let corners = [start, start + along(0, 2 * width, 0), start + along(0, 0, 2 * height)];
        let spots = [(0, 0), (2, 0), (0, 2), (1, 0), (1, 1), (0, 1)];
        let (x, y) = spots[spot];
        let target = start + along(0, x * width, y * height);
        let aimed = Aimed { shape: Triangle { corners }, ray: Ray::new(target + along(above, 0, 0), along(-1, 0, 0)) };
        let truth = Truth { t: Some(f64::from(above)), tolerance: DRAWN };
        truth.judge(&aimed.ray, part(&aimed.shape, &aimed.ray, Interval::FORWARD), || scene(&aimed))
    })
}

/// The same drawing, 1e-5 to 1e-2 as large, with directions as short: no small number makes a triangle disappear.
pub fn a_small_triangle_is_met(part: &Part, trial: &Trial) -> Verdict {
    trial.search((drawn_triangles(1.0..10.0, 1.0), magnitude(1e-5, 1e-2)), |(drawn, size)| {
        let Aimed { shape: Triangle { corners }, ray } = drawn.inside();
        let size = *size as f32;
        let small = |v: Vec3| v * size;
        let aimed = Aimed {
            shape: Triangle { corners: corners.map(small) },
            ray: Ray::new(small(ray.origin), small(ray.direction)),
        };
        is_met(part, &aimed, Interval::FORWARD)
    })
}

/// NaN anywhere is no hit; infinities and zeros make no panic.
pub fn what_is_no_number_is_not_met(part: &Part, trial: &Trial) -> Verdict {
    let corners = [wild_vectors(), wild_vectors(), wild_vectors()];
    trial.times(32).search((corners, wild_rays(), wild_intervals()), |&(corners, ray, within)| {
        let has_nan = corners.iter().any(|corner| corner.is_nan());
        wild_claim(part(&Triangle { corners }, &ray, within), has_nan, &ray, within)
    })
}

/// Corners in a row, and rays straight at them: rounding must not make an area of it.
pub fn a_triangle_without_area_is_never_met(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(flat_triangles(), |aimed| {
        let found = part(&aimed.shape, &aimed.ray, Interval::FORWARD);
        Truth { t: None, tolerance: 0.0 }.judge(&aimed.ray, found, || scene(aimed))
    })
}

/// From inside a closed mesh every ray meets something, also those at edges and corners.
pub fn no_ray_leaves_a_closed_mesh_through_its_edges_or_corners(part: &Part, trial: &Trial) -> Verdict {
    let is_closed = |mesh: &Mesh, ray: &Ray| {
        let mut triangles = mesh.triangles.iter().map(|corners| corners.map(|corner| mesh.positions[corner as usize]));
        if triangles.any(|corners| part(&Triangle { corners }, ray, Interval::FORWARD).is_some()) {
            return Ok(());
        }
        let outlines =
            mesh.triangles.iter().map(|corners| corners.map(|corner| mesh.positions[corner as usize].as_dvec3()));
        let figure = outlines.fold(Figure::through(ray, ray.at(1.0)), |figure, corners| figure.outline(&corners));
        Err(broken(ray, (&format!("{ray:?} meets a triangle"), Some(1.0)), None, figure))
    };
    let cube = unit_cube();
    let steps = [-0.5, 0.0, 0.5];
    for (x, y, z) in steps.into_iter().flat_map(|x| steps.map(|y| (x, y))).flat_map(|(x, y)| steps.map(|z| (x, y, z))) {
        let origin = dvec3(0.1, -0.2, 0.3);
        is_closed(&cube, &Ray::new(origin.as_vec3(), (dvec3(x, y, z) - origin).as_vec3()))?;
    }
    trial.search(closed_meshes(), |Enclosed { mesh, rays }| rays.iter().try_for_each(|ray| is_closed(mesh, ray)))
}

/// Whether it is met, where no edge is passed as closely as `f64` sees.
pub fn hit_and_miss_are_right_unless_the_ray_passes_an_edge_as_closely_as_f64_sees(
    part: &Part,
    trial: &Trial,
) -> Verdict {
    trial.times(16).search(triangles(), |aimed| {
        let Aimed { shape, ray } = aimed;
        let Some(through) = is_passed(shape, ray) else { return Ok(()) };
        let ahead = exact_t_and_error(shape, ray).map(|(t, error)| {
            let t = approximate(&t);
            (t > 0.0, t.abs() > error)
        });
        if through && !ahead.is_some_and(|(_, is_clear)| is_clear) {
            return Ok(());
        }
        let found = part(shape, ray, Interval::FORWARD);
        match (through && ahead.is_some_and(|(is_ahead, _)| is_ahead), found) {
            (true, None) => Err(broken(ray, ("a hit", None), found, scene(aimed))),
            (false, Some(_)) => Err(broken(ray, ("None", None), found, scene(aimed))),
            _ => Ok(()),
        }
    })
}

/// Where half an ulp of the inputs could not make hit and miss of each other.
pub fn t_is_exact_to_half_an_ulp(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(triangles(), |aimed| {
        let Aimed { shape, ray } = aimed;
        let errors = volume_errors(shape, ray).map(|error| error * SINGLE / DOUBLE);
        let volumes = volumes(shape, ray).map(|volume| approximate(&volume));
        if !((0..3).all(|i| volumes[i] > errors[i]) || (0..3).all(|i| volumes[i] < -errors[i])) {
            return Ok(());
        }
        let (Some(hit), Some((t, error))) = (part(shape, ray, Interval::FORWARD), exact_t_and_error(shape, ray)) else {
            return Ok(());
        };
        // Nor make an origin in front of it one behind it.
        if error * SINGLE / DOUBLE >= approximate(&t).abs() {
            return Ok(());
        }
        is_exact(aimed, &t, hit, 0.0)
    })
}

/// Slivers, edge-on, and origins very near a large triangle included.
pub fn t_is_as_exact_as_f64_sees_on_every_triangle(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(triangles(), |aimed| {
        let Aimed { shape, ray } = aimed;
        if is_passed(shape, ray) != Some(true) {
            return Ok(());
        }
        let (Some(hit), Some((t, error))) = (part(shape, ray, Interval::FORWARD), exact_t_and_error(shape, ray)) else {
            return Ok(());
        };
        is_exact(aimed, &t, hit, error)
    })
}

/// Never below 0 or above 1.
pub fn u_and_v_are_the_exact_weights(part: &Part, trial: &Trial) -> Verdict {
    trial.times(16).search(triangles(), |aimed| {
        let Aimed { shape, ray } = aimed;
        let found = part(shape, ray, Interval::FORWARD);
        let Some(hit) = found.filter(|_| is_passed(shape, ray) == Some(true)) else { return Ok(()) };
        let [a, b, c] = volumes(shape, ray);
        let sum = a + &b + &c;
        let error = 2.0 * volume_errors(shape, ray).into_iter().sum::<f64>() / approximate(&sum).abs();
        let [u, v] = [b / &sum, c / &sum];
        let is_weight = |weight: f32, truth: &Exact| {
            (0.0..=1.0).contains(&weight) && is_within(truth, &truths(weight, ULPS, error))
        };
        if is_weight(hit.u, &u) && is_weight(hit.v, &v) {
            return Ok(());
        }
        let expected = format!("u = {}, v = {}", approximate(&u), approximate(&v));
        Err(broken(ray, (&expected, None), found, scene(aimed)))
    })
}

crate::kit! { $crate
    /// Names the laws of a ray and a triangle as tests of an [`crate::Intersect`]: `geometry::triangle_conformance!(my_triangle);`.
    triangle_conformance, Part, triangle;
    a_triangle_straight_ahead_is_met: "nothing is returned yet: find t from the plane, n.(a - o) / n.d, and the corners' weights there";
    a_ray_beside_the_triangle_misses_it: "a weight is not compared with 0, or u + v not with 1: two triangles make a parallelogram";
    a_triangle_is_met_from_behind: "a negative determinant is taken for a miss";
    a_triangle_behind_the_ray_is_not_met: "t is not compared with the interval, or its absolute value is";
    t_counts_multiples_of_the_direction: "the direction is normalised, and t is a distance";
    a_hit_outside_the_interval_does_not_count: "the interval is not asked whether it contains t, or its ends count as inside";
    u_and_v_are_the_weights_of_the_second_and_third_corner: "u and v are swapped, or one belongs to the first corner";
    edges_and_corners_belong_to_the_triangle: "a weight of 0 is taken for outside: `<=` where `<` is due";
    a_small_triangle_is_met: "the determinant, which has the size of the area, is compared with an epsilon";
    what_is_no_number_is_not_met: "a comparison is written so that NaN passes it, such as `!(t <= min)`";
    a_triangle_without_area_is_never_met: "the weights are divided by a determinant that is rounding noise; the normal of corners in a row is 0";
    no_ray_leaves_a_closed_mesh_through_its_edges_or_corners: "an edge is computed otherwise in each of its two triangles: from each one's own first corner";
    hit_and_miss_are_right_unless_the_ray_passes_an_edge_as_closely_as_f64_sees: "edges are decided in f32, or moved by an epsilon";
    t_is_exact_to_half_an_ulp: "t is computed in f32, or of the corners' depths and weights instead of the plane";
    t_is_as_exact_as_f64_sees_on_every_triangle: "t is made of the weights, which cancel on slivers";
    u_and_v_are_the_exact_weights: "u and v are computed from the hit point in f32, or not cut to 0..1";
}

/// What laws about easy cases ask of `t`, `u` and `v`: three digits.
const DRAWN: f64 = 1e-3;

/// Met where the exact plane says if the exact volumes have one sign.
fn is_met(part: &Part, aimed: &Aimed<Triangle>, within: Interval) -> Verdict {
    let Aimed { shape, ray } = aimed;
    let volumes = volumes(shape, ray);
    let through = volumes.iter().all(|v| *v >= Exact::ZERO) || volumes.iter().all(|v| *v <= Exact::ZERO);
    let t = exact_t_and_error(shape, ray).map(|(t, _)| approximate(&t));
    let t = t.filter(|&t| through && within.contains(t as f32));
    Truth { t, tolerance: DRAWN }.judge(ray, part(shape, ray, within), || scene(aimed))
}

fn is_exact(aimed: &Aimed<Triangle>, t: &Exact, hit: Intersection, error: f64) -> Verdict {
    if is_within(t, &truths(hit.t, ULPS, error)) {
        return Ok(());
    }
    let t = approximate(t);
    Err(broken(&aimed.ray, (&format!("t = {t}, to half a unit in the last place"), Some(t)), Some(hit), scene(aimed)))
}

fn scene(Aimed { shape, ray }: &Aimed<Triangle>) -> Figure {
    let corners = shape.corners.map(|corner| corner.as_dvec3());
    Figure::through(ray, (corners[0] + corners[1] + corners[2]) / 3.0).outline(&corners)
}

/// The volumes between the ray's direction and two corners seen from the origin: the weights of the corners, times some factor.
pub fn volumes(triangle: &Triangle, ray: &Ray) -> [Exact; 3] {
    let direction = Vector::from(ray.direction);
    let [a, b, c] = triangle.corners.map(|corner| Vector::from(corner).minus(&ray.origin.into()));
    [(&b, &c), (&c, &a), (&a, &b)].map(|(from, to)| direction.dot(&from.cross(to)))
}

/// How far each volume may be off in `f64`: a rounding of the corners' distance from the origin, times the width seen.
fn volume_errors(triangle: &Triangle, ray: &Ray) -> [f64; 3] {
    let direction = ray.direction.as_dvec3();
    let corners = triangle.corners.map(|corner| corner.as_dvec3() - ray.origin.as_dvec3());
    let beside = corners.map(|corner| corner.cross(direction).length());
    let far = corners.map(DVec3::length).into_iter().fold(0.0, f64::max);
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| 4.0 * DOUBLE * far * (beside[i] + beside[j]))
}

/// Whether the exact line passes the triangle, if that is not closer than `f64` sees.
fn is_passed(triangle: &Triangle, ray: &Ray) -> Option<bool> {
    let volumes = volumes(triangle, ray).map(|volume| approximate(&volume));
    let errors = volume_errors(triangle, ray);
    let clear = |sign: f64| (0..3).all(|i| sign * volumes[i] > errors[i]);
    let is_positive = (0..3).any(|i| volumes[i] > errors[i]);
    let is_negative = (0..3).any(|i| volumes[i] < -errors[i]);
    let through = clear(1.0) || clear(-1.0);
    let beside = is_positive && is_negative;
    (through || beside).then_some(through)
}

/// A corner, and the edges' cross product.
pub fn point_and_normal(triangle: &Triangle) -> (Vector, Vector) {
    let [a, b, c] = triangle.corners.map(Vector::from);
    let normal = b.minus(&a).cross(&c.minus(&a));
    (a, normal)
}

/// Where the ray meets the triangle's plane, and how far off `f64` may be, as for any plane; `None` if edge-on.
fn exact_t_and_error(triangle: &Triangle, ray: &Ray) -> Option<(Exact, f64)> {
    let (point, normal) = point_and_normal(triangle);
    exact_t(&point, &normal, ray).map(|(t, scale)| (t, 4.0 * DOUBLE * scale))
}
