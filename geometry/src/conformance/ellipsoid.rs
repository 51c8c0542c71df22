//! A ray and an ellipsoid: the unit sphere under an affine map.
//!
//! The idea: do not move the sphere, move the ray. `M^-1` takes it into the space in which the ellipsoid is the unit sphere; what is met
//! there at `t` is met here at the same `t`, as long as nobody normalises the direction on the way.
//!
//! ```text
//!      here                        there
//!     ___                           _
//!   /     \   <--- o       M^-1    / \  <------ o      o + t d  -->  M^-1 o + t (M^-1 d)
//!  (   x   )             ------>  ( x )
//!   \ ___ /                        \_/
//! ```
//!
//! **The contract** is [`crate::Primitive::intersect`]'s: the nearest `t` strictly inside the interval, `u` and `v` left at 0. The
//! normal is not the kernel's ([`super::normal_matrix`]).
//!
//! **The laws** go from a sphere that is merely moved to what `f64` can tell; they stand below in that order. The hard cases: maps
//! that stretch 1 : 1000 and shear (a rounding is multiplied by the condition number), centres far from the origin of space (a folded
//! matrix `M^-1 o = A^-1 o - A^-1 c` cancels: take the translation off first), mirrors.
//!
//! **Literature.** Roth: Ray Casting for Modeling Solids, 1982, on rays in an object's own space. Glassner (ed.): An
//! Introduction to Ray Tracing, 1989, chapter 2. Pharr, Jakob, Humphreys: Physically Based Rendering, 4th ed. 2023, 6.1.4.
//!
//! **Exercises.** 1. Pass the kit up to `nothing_but_t_is_told` with your own sphere kernel inside. 2. Pass it all. 3. Make
//! `girasol accuracy` show no error greater than the reference's. 4. Beat the reference in instructions: which of its `f64`
//! steps may be `f32` without breaking a law?
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`a_moved_sphere_is_met_where_it_is`] |
//! | the translation moves the direction, too | [`a_moved_sphere_is_met_where_it_is`] |
//! | the map in place of its inverse | [`a_moved_sphere_is_met_where_it_is`] |
//! | the direction is normalised in the sphere's space | [`t_counts_multiples_of_the_direction`] |
//! | the transpose in place of the inverse | [`a_stretched_ellipsoid_is_met_where_its_equation_says`] |
//! | the root of the discriminant's absolute value | [`a_ray_beside_the_ellipsoid_misses_it`] |
//! | the absolute value of t | [`an_ellipsoid_behind_the_ray_is_not_met`] |
//! | only the near side is looked at | [`from_inside_the_far_side_is_met`] |
//! | the interval is not checked | [`a_hit_outside_the_interval_does_not_count`] |
//! | the inverse matrix folded, in f32 | [`a_far_translation_costs_nothing`] |
//! | an epsilon for the discriminant | [`hit_and_miss_are_right_unless_the_map_cannot_tell`] |

use std::ops::Range;

use glam::{DMat3, DVec3};

use super::claim::{Truth, broken, wild_claim};
use super::exact::{DOUBLE, Exact, Quadratic, ULPS, Vector, approximate, truths};
use super::{
    Aimed, Figure, Trial, Verdict, drawn_ellipsoids, ellipsoids, moved_spheres, wild_intervals, wild_maps, wild_rays,
};
use crate::{Ellipsoid, Intersect, Intersection, Interval, Primitive, Ray, Transform};

/// The part: a plain function, the field `ellipsoid` of [`crate::Kernels`].
pub type Part = Intersect<Ellipsoid>;

const UNIT: Range<f64> = 1.0..1.000_001;
const ANY_LENGTH: Range<f64> = 0.25..4.0;

/// A sphere that was turned and moved, and a direction of length 1.
pub fn a_moved_sphere_is_met_where_it_is(part: &Part, trial: &Trial) -> Verdict {
    trial.search(moved_spheres(2.0..10.0, 0.0..0.9, UNIT), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// The same with directions of any length: twice as long a direction, half of the `t`.
pub fn t_counts_multiples_of_the_direction(part: &Part, trial: &Trial) -> Verdict {
    trial.search(moved_spheres(2.0..10.0, 0.0..0.9, ANY_LENGTH), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// Stretched, sheared, mirrored, to three digits.
pub fn a_stretched_ellipsoid_is_met_where_its_equation_says(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_ellipsoids(2.0..10.0, 0.0..0.9), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// A ray that goes by is no hit, though it may pass the box.
pub fn a_ray_beside_the_ellipsoid_misses_it(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_ellipsoids(2.0..10.0, 1.1..1.7), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// What lies behind the origin is not met.
pub fn an_ellipsoid_behind_the_ray_is_not_met(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_ellipsoids(-10.0..-2.0, 0.0..0.9), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// From inside the far side is met.
pub fn from_inside_the_far_side_is_met(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_ellipsoids(-0.4..0.4, 0.0..0.8), |aimed| is_met(part, aimed, Interval::FORWARD, DRAWN))
}

/// A hit counts strictly inside the interval.
pub fn a_hit_outside_the_interval_does_not_count(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_ellipsoids(2.0..10.0, 0.0..0.9), |aimed| {
        let shape = placed(&aimed.shape);
        let Some(first) = part(&shape, &aimed.ray, Interval::FORWARD) else { return Ok(()) };
        is_met(part, aimed, Interval::FORWARD.up_to(0.9 * first.t), DRAWN)?;
        let ends_there = part(&shape, &aimed.ray, Interval::FORWARD.up_to(first.t));
        Truth { t: None, tolerance: 0.0 }.judge(&aimed.ray, ends_there, || scene(aimed))
    })
}

/// Where the near side lies before the interval, the far one is asked.
pub fn the_far_side_is_met_where_the_near_one_does_not_count(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_ellipsoids(2.0..10.0, 0.0..0.9), |aimed| {
        let [near, far] = equation(&aimed.shape, &aimed.ray).roots().expect("the ray is aimed at the ellipsoid");
        is_met(part, aimed, Interval { min: (0.5 * (near + far)) as f32, max: f32::INFINITY }, DRAWN)
    })
}

/// `u` and `v` of an intersection are a triangle's.
pub fn nothing_but_t_is_told(part: &Part, trial: &Trial) -> Verdict {
    trial.search(drawn_ellipsoids(2.0..10.0, 0.0..0.9), |aimed| {
        let found = part(&placed(&aimed.shape), &aimed.ray, Interval::FORWARD);
        let expected = found.map(|met| Intersection::at(met.t));
        if found == expected { Ok(()) } else { Err(broken(&aimed.ray, ("u = 0 and v = 0", None), found, scene(aimed))) }
    })
}

/// NaN in a ray or an interval is no hit; infinities and zeros make no panic.
pub fn what_is_no_number_is_not_met(part: &Part, trial: &Trial) -> Verdict {
    trial.times(32).search((wild_maps(), wild_rays(), wild_intervals()), |&(map, ray, within)| {
        Ellipsoid::new(map).map_or(Ok(()), |shape| wild_claim(part(&shape, &ray, within), false, &ray, within))
    })
}

/// A centre far from the origin of space, a ray near the centre: the difference of the two is exact.
pub fn a_far_translation_costs_nothing(part: &Part, trial: &Trial) -> Verdict {
    let far = (drawn_ellipsoids(2.0..10.0, 0.0..0.9), super::unit_vector(), super::magnitude(1e4, 1e6));
    trial.search(far, |&(Aimed { mut shape, mut ray }, side, distance)| {
        shape.translation += side * distance;
        ray.origin += (side * distance).as_vec3();
        is_met(part, &Aimed { shape, ray }, Interval::FORWARD, 1e-5)
    })
}

/// Where the map's own precision can tell.
pub fn hit_and_miss_are_right_unless_the_map_cannot_tell(part: &Part, trial: &Trial) -> Verdict {
    trial.times(8).search(ellipsoids(), |aimed| {
        let Aimed { shape, ray } = aimed;
        let equation = equation(shape, ray);
        let error = 4.0 * line_error(shape, ray);
        // Where the origin is on the surface to that precision, the near root may be on either side of it.
        let (_, determinant) = to_unit(shape, &DVec3::ZERO.into());
        let off_surface = approximate(&equation.c) / approximate(&(&determinant * &determinant));
        if depth(&equation, shape).abs() <= error || off_surface.abs() <= error {
            return Ok(());
        }
        let found = part(&placed(shape), ray, Interval::FORWARD);
        match (equation.first_ahead(), found) {
            (Some(_), None) => Err(broken(ray, ("a hit", None), found, scene(aimed))),
            (None, Some(_)) => Err(broken(ray, ("None", None), found, scene(aimed))),
            _ => Ok(()),
        }
    })
}

/// To half an ulp, and what the inverse map, kept in `f64`, loses: its roundings are multiplied by the map's condition
/// number and by the distance in radii, and at a shallow depth by its reciprocal.
pub fn t_is_the_nearest_root_ahead_to_half_an_ulp_of_the_map(part: &Part, trial: &Trial) -> Verdict {
    trial.times(8).search(ellipsoids(), |aimed| {
        let Aimed { shape, ray } = aimed;
        let equation = equation(shape, ray);
        let error = 4.0 * line_error(shape, ray);
        let depth = depth(&equation, shape);
        let found = part(&placed(shape), ray, Interval::FORWARD);
        let Some(hit) = found.filter(|_| depth > error) else { return Ok(()) };
        let (direction, determinant) = to_unit(shape, &ray.direction.into());
        let speed = direction.approximate().length() / approximate(&determinant).abs();
        let range = truths(hit.t, ULPS, error * (1.0 + 1.0 / depth.sqrt()) / speed);
        let near_start = range[0] <= Exact::ZERO;
        let root = equation.first_ahead();
        if near_start || root.is_some_and(|root| equation.root_is_within(root, &range)) {
            return Ok(());
        }
        let truth = root.and_then(|root| equation.roots().map(|roots| roots[root]));
        let expected = truth.map_or("None".to_owned(), |t| format!("t = {t}, as exactly as the map allows"));
        Err(broken(ray, (&expected, truth), found, scene(aimed)))
    })
}

crate::kit! { $crate
    /// Names the laws of a ray and an ellipsoid as tests of an [`crate::Intersect`]: `geometry::ellipsoid_conformance!(my_ellipsoid);`.
    ellipsoid_conformance, Part, ellipsoid;
    a_moved_sphere_is_met_where_it_is: "nothing is returned yet: take the ray into the unit sphere's space by Ellipsoid::to_unit, and solve |o + t d| = 1 there; a direction is not moved by a translation";
    t_counts_multiples_of_the_direction: "the direction is normalised in the sphere's space, and t is the distance there";
    a_stretched_ellipsoid_is_met_where_its_equation_says: "a stretch is undone by another matrix than the inverse, or t is taken for a distance";
    a_ray_beside_the_ellipsoid_misses_it: "a negative discriminant is not taken for a miss, or the box is tested instead of the body";
    an_ellipsoid_behind_the_ray_is_not_met: "a negative t is returned";
    from_inside_the_far_side_is_met: "only the lesser of the two t is looked at";
    a_hit_outside_the_interval_does_not_count: "the interval is not asked whether it contains t, or its ends count as inside";
    the_far_side_is_met_where_the_near_one_does_not_count: "the far side is tried only if the near one is behind the origin";
    nothing_but_t_is_told: "texture coordinates are put into the barycentric weights u and v";
    what_is_no_number_is_not_met: "a comparison is written so that NaN passes it, such as `!(t <= min)`";
    a_far_translation_costs_nothing: "the translation is folded into the inverse matrix, where it cancels against the origin's; take the centre off the origin first";
    hit_and_miss_are_right_unless_the_map_cannot_tell: "a step is taken in f32, or the discriminant is compared with an epsilon";
    t_is_the_nearest_root_ahead_to_half_an_ulp_of_the_map: "b^2 - 4 a c cancels where the ray comes from far off or grazes the body";
}

/// What laws about easy cases ask of `t`: three digits.
const DRAWN: f64 = 1e-3;

fn placed(map: &Transform) -> Ellipsoid {
    Ellipsoid::new(*map).expect("the kit's maps have an inverse")
}

/// The nearest root in the interval is met.
fn is_met(part: &Part, aimed: &Aimed<Transform>, within: Interval, tolerance: f64) -> Verdict {
    let roots = equation(&aimed.shape, &aimed.ray).roots();
    let t = roots.and_then(|roots| roots.into_iter().find(|&t| within.contains(t as f32)));
    let found = part(&placed(&aimed.shape), &aimed.ray, within);
    Truth { t, tolerance }.judge(&aimed.ray, found, || scene(aimed))
}

/// The ellipsoid's outlines in the three planes of its axes.
fn scene(Aimed { shape, ray }: &Aimed<Transform>) -> Figure {
    let outline = |figure: Figure, axes: [DVec3; 2]| {
        let around = (0..48).map(|step| {
            let (sin, cos) = libm::sincos(f64::from(step) * std::f64::consts::TAU / 48.0);
            shape.point(axes[0] * cos + axes[1] * sin)
        });
        figure.outline(&around.collect::<Vec<_>>())
    };
    let figure = Figure::through(ray, shape.translation).cuboid(&placed(shape).bounds());
    [[DVec3::X, DVec3::Y], [DVec3::Y, DVec3::Z], [DVec3::Z, DVec3::X]].into_iter().fold(figure, outline)
}

/// The map's inverse times its determinant, by cofactors, applied to a vector; and the determinant.
pub fn to_unit(map: &Transform, v: &Vector) -> (Vector, Exact) {
    let [x, y, z] = [map.linear.x_axis, map.linear.y_axis, map.linear.z_axis].map(Vector::from);
    let rows = [y.cross(&z), z.cross(&x), x.cross(&y)];
    let determinant = rows[0].dot(&x);
    (Vector(rows.map(|row| row.dot(v))), determinant)
}

/// `|M^-1 p|^2 - 1` of a point seen from the centre, times the determinant squared: positive outside.
pub fn outside(map: &Transform, point: &Vector) -> Exact {
    let (unit, determinant) = to_unit(map, &point.minus(&map.translation.into()));
    unit.dot(&unit) - &determinant * &determinant
}

/// The equation of `t`, scaled by the determinant squared.
pub fn equation(map: &Transform, ray: &Ray) -> Quadratic {
    let (from_center, determinant) = to_unit(map, &Vector::from(ray.origin).minus(&map.translation.into()));
    let (direction, _) = to_unit(map, &ray.direction.into());
    Quadratic {
        a: direction.dot(&direction),
        half_b: from_center.dot(&direction),
        c: from_center.dot(&from_center) - &determinant * &determinant,
    }
}

/// What a rounding in `f64` moves the line by, as the unit sphere sees it. The inverse is off by the map's condition number,
/// and by what cancels in its determinant (Hadamard's ratio: the axes' lengths over the volume); the origin by its distance too.
pub fn line_error(map: &Transform, ray: &Ray) -> f64 {
    let lengths = |m: DMat3| DVec3::new(m.x_axis.length(), m.y_axis.length(), m.z_axis.length());
    let inverse = map.linear.inverse();
    let condition = lengths(map.linear).length() * lengths(inverse).length();
    let skew = lengths(map.linear).element_product() / map.linear.determinant().abs();
    let distance = (inverse * (ray.origin.as_dvec3() - map.translation)).length();
    DOUBLE * (condition + skew) * (distance + 1.0)
}

/// How deep the line runs in the unit sphere: half the chord, squared; negative outside.
pub fn depth(equation: &Quadratic, map: &Transform) -> f64 {
    let (_, determinant) = to_unit(map, &DVec3::ZERO.into());
    approximate(&(equation.discriminant() / &equation.a / (&determinant * &determinant)))
}
