//! An accelerator: which primitive does a ray meet first, without asking all of them?
//!
//! The idea: sort space, not rays. What stands in a cell that the ray does not pass need not be asked; and once a hit is nearer than the next
//! cell, nothing behind it need be.
//!
//! ```text
//!   +-------+-------+      1. asks its two, finds nothing
//!   | 1  o  | o |   |      2. asks the triangle, which it meets only in 3: the search goes on
//!   |  o    |---+---|      3. finds it again, and o behind it: the nearest counts
//!  -+-------|-2-\-3-|-->
//!   |       |   | o\|      a tree halves cells until few primitives are left in each
//!   +-------+-------+
//! ```
//!
//! **The contract** of [`crate::Accelerator`]: the hit that asking every primitive gives, **bit for bit**, and of hits at one distance the lowest
//! number's. [`geometry::Primitives::intersect`] alone decides what is a hit; a tree may only leave out what the ray cannot meet. Infinite planes
//! never come in: the renderer keeps them beside the accelerator, since no box holds them.
//!
//! **The laws** stand below from the easiest on. The hard cases: primitives in several cells, flat and equal ones, ties, rays in the planes between
//! cells and along edges, origins inside, far intervals, batches, NaN. What they are held against is a loop over all primitives.
//!
//! **Literature.** Glassner: Space Subdivision for Fast Ray Tracing, IEEE CG&A, 1984. MacDonald, Booth: Heuristics for Ray Tracing Using
//! Space Subdivision, The Visual Computer, 1990. Revelles, Ureña, Lastra: An Efficient Parametric Algorithm for Octree Traversal, WSCG,
//! 2000. Amanatides, Woo: A Fast Voxel Traversal Algorithm for Ray Tracing, Eurographics, 1987. Ize: Robust BVH Ray Traversal, JCGT,
//! 2013. Wald, Benthin, Boulos: Getting Rid of Packets, 2008, and this crate's own pages.
//!
//! **Exercises.** 1. Pass the kit with a loop over all primitives: then you know what it asks. 2. Pass it with an octree of pointers.
//! 3. Ask fewer primitives: count them in [`crate::Accelerator::visits`]. 4. Beat [`crate::octree`], then [`crate::wide`] on
//! `girasol bench`; the page of this crate says what each step gained.
//!
//! # Mistakes, and the law that names each
//!
//! | mistake | law |
//! |---|---|
//! | nothing is returned | [`one_primitive_is_found`] |
//! | an empty tree has a root all the same | [`nothing_is_found_where_there_is_nothing`] |
//! | a leaf's last primitive is lost | [`every_primitive_is_found`] |
//! | the last of eight children is lost | [`every_primitive_is_found`] |
//! | a primitive stands only in the cell of its centre | [`every_primitive_is_found`] |
//! | only a leaf's first hit is looked at | [`the_nearest_of_several_is_found`] |
//! | the number in the leaf instead of the one in the whole | [`a_hit_has_the_number_of_its_primitive`] |
//! | children in the order of their places, and the first hit ends the search | [`the_nearest_of_several_is_found`] |
//! | the first child that is hit ends the search | [`a_hit_beyond_its_cell_does_not_end_the_search`] |
//! | flat boxes are lost | [`flat_boxes_are_not_lost`] |
//! | a direction of 0 along an axis loses the box | [`rays_along_the_axes_lose_nothing`] |
//! | NaN loses the box | [`rays_along_the_axes_lose_nothing`] |
//! | an origin inside a box counts as a miss | [`rays_that_start_among_the_primitives_lose_nothing`] |
//! | the interval is not looked at | [`hits_outside_the_interval_do_not_count`] |
//! | of two equal hits the last counts | [`the_lowest_number_wins_a_tie`] |
//! | any does not look at the interval | [`any_says_whether_something_is_found`] |
//! | any looks at one leaf alone | [`any_says_whether_something_is_found`] |
//! | a ray of a batch is cut to the hit of the one before | [`many_rays_find_what_each_finds_alone`] |
//! | a miss of a batch leaves what stood there | [`many_rays_find_what_each_finds_alone`] |
//! | a triangle test of its own | [`the_kernels_of_the_primitives_decide`] |

use geometry::conformance::{Counterexample, Trial, Verdict};
use geometry::{BoxProbe, Hit, Interval, Kernels, Primitive, Primitives, Ray};

use super::{Asked, scenes};
use crate::Accelerator;

/// The part: a plain function that builds an accelerator of primitives.
pub type Part = fn(Primitives) -> Box<dyn Accelerator>;

/// A single thing, and a ray at its middle.
pub fn one_primitive_is_found(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::alone(), |asked| closest(part, asked, Some))
}

/// No things, or all of them behind.
pub fn nothing_is_found_where_there_is_nothing(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::nothing_ahead(), |asked| closest(part, asked, Some))
}

/// Of many small spheres each is found by a ray that meets no other one.
pub fn every_primitive_is_found(part: &Part, trial: &Trial) -> Verdict {
    const SOMETHING: Hit = Hit { t: 0.0, u: 0.0, v: 0.0, primitive: 0 };
    trial.search(scenes::each_of_many(), |asked| closest(part, asked, |_| Some(SOMETHING)))
}

/// Spheres in a row along a ray: the nearest is the answer, in whatever order they stand.
pub fn the_nearest_of_several_is_found(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::in_a_row(), |asked| closest(part, asked, |hit| Some(Hit { primitive: 0, ..hit })))
}

/// A hit names the primitive by its number among all, not among those of its leaf.
pub fn a_hit_has_the_number_of_its_primitive(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::each_of_many(), |asked| closest(part, asked, Some))
}

/// What stands in several cells may be met beyond the one in which it was asked; a nearer thing may stand in between.
pub fn a_hit_beyond_its_cell_does_not_end_the_search(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::large_among_small(), |asked| closest(part, asked, Some))
}

/// Boxes without thickness are passed in one point.
pub fn flat_boxes_are_not_lost(part: &Part, trial: &Trial) -> Verdict {
    // Neighbours share corners and edges; which of them is met there is a law of its own.
    trial.search(scenes::flat(), |asked| closest(part, asked, |hit| Some(Hit { u: 0.0, v: 0.0, primitive: 0, ..hit })))
}

/// A component of 0 makes an infinite reciprocal, and in the plane of a face `0 * infinity`, a NaN.
pub fn rays_along_the_axes_lose_nothing(part: &Part, trial: &Trial) -> Verdict {
    trial.times(4).search(scenes::along_axes(), |asked| closest(part, asked, Some))
}

/// The way through the cell of the origin begins behind the ray.
pub fn rays_that_start_among_the_primitives_lose_nothing(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::from_inside(), |asked| closest(part, asked, Some))
}

/// Hits count strictly inside the interval that was asked for.
pub fn hits_outside_the_interval_do_not_count(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::with_intervals(), |asked| closest(part, asked, Some))
}

/// Of equal hits the one with the lowest number is the answer, so that a picture does not depend on the tree.
pub fn the_lowest_number_wins_a_tie(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::twins(), |asked| closest(part, asked, Some))
}

/// Shadow rays ask only whether something is there.
pub fn any_says_whether_something_is_found(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::with_intervals(), |asked| any(part, asked))
}

/// Many rays at once, as the renderer asks them.
pub fn many_rays_find_what_each_finds_alone(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::bundles(), |asked| many(part, asked))
}

/// No plane divides what is equal: the tree must end all the same.
pub fn equal_primitives_do_not_divide_for_ever(part: &Part, trial: &Trial) -> Verdict {
    let few = Trial { cases: trial.cases.div_ceil(8), ..*trial };
    few.search(scenes::all_the_same(), |asked| closest(part, asked, Some))
}

/// NaN anywhere in a ray is no hit; infinities and zeros make no panic.
pub fn a_ray_without_numbers_finds_nothing(part: &Part, trial: &Trial) -> Verdict {
    trial.search(scenes::wild(), |asked| closest(part, asked, Some).and_then(|()| any(part, asked)))
}

/// What decides a hit is the primitives' own test, which may be somebody's kernel.
pub fn the_kernels_of_the_primitives_decide(part: &Part, trial: &Trial) -> Verdict {
    // A box test as good as the reference's; triangles that are met from the front alone.
    let kernels = Kernels {
        aabb: Some(|bounds, ray, within| BoxProbe::new(ray, bounds.magnitude()).clip(*bounds, within)),
        triangle: Some(|triangle, ray, within| {
            let from_front = triangle.scaled_normal().dot(ray.direction.as_dvec3()) < 0.0;
            triangle.intersect(ray, within).filter(|_| from_front)
        }),
        ..Kernels::default()
    };
    trial.search(scenes::everything(), |asked| everything(part, asked, &asked.primitives().with_kernels(kernels)))
}

/// All kinds of things, rays and intervals, bit for bit.
pub fn every_ray_finds_what_asking_every_primitive_finds(part: &Part, trial: &Trial) -> Verdict {
    trial.times(4).search(scenes::everything(), |asked| everything(part, asked, &asked.primitives()))
}

/// Bundles as a camera's or a light's, that packets take together; more than two packets, and not a whole number of them.
pub fn bundles_of_rays_find_what_asking_every_primitive_finds(part: &Part, trial: &Trial) -> Verdict {
    trial.times(4).search(scenes::bundles(), |asked| everything(part, asked, &asked.primitives()))
}

/// Triangles of any size and shape.
pub fn slivers_giants_and_dust_are_found(part: &Part, trial: &Trial) -> Verdict {
    trial.times(4).search(scenes::slivers_giants_and_dust(), |asked| everything(part, asked, &asked.primitives()))
}

/// Every ray is aimed at a corner, an edge or a triangle of a closed mesh around it.
pub fn no_ray_leaves_a_closed_mesh(part: &Part, trial: &Trial) -> Verdict {
    let few = Trial { cases: trial.cases.div_ceil(4), ..*trial };
    few.search(scenes::inside_closed_meshes(), |asked| everything(part, asked, &asked.primitives()))
}

/// Long thin triangles, which may be cut in pieces.
pub fn crossing_wires_are_found(part: &Part, trial: &Trial) -> Verdict {
    let few = Trial { cases: trial.cases.div_ceil(4), ..*trial };
    few.search(scenes::wires(), |asked| everything(part, asked, &asked.primitives()))
}

geometry::kit! { $crate
    /// Names the laws of an accelerator as tests: `accel::conformance!(my_octree::build);`.
    conformance, Part, accelerator;
    one_primitive_is_found: "nothing is asked yet: ask each primitive by Primitives::intersect, and keep the nearest hit";
    nothing_is_found_where_there_is_nothing: "an empty tree has no root to start from, or what is behind counts";
    every_primitive_is_found: "a primitive is lost while building: the last of a leaf, one on a dividing plane, a whole child";
    the_nearest_of_several_is_found: "the first hit ends the search, or the interval is not cut to the nearest hit so far";
    a_hit_has_the_number_of_its_primitive: "the hit has its place in the leaf, not the number in the whole";
    a_hit_beyond_its_cell_does_not_end_the_search: "a hit found in a cell ends the search although it lies behind the next cell";
    flat_boxes_are_not_lost: "the box test wants the ray to be inside for longer than a point: `<` where `<=` is due";
    rays_that_start_among_the_primitives_lose_nothing: "a box that is entered behind the origin counts as missed";
    the_lowest_number_wins_a_tie: "hits are compared by t alone, or a box at just the distance of the nearest hit is left out";
    rays_along_the_axes_lose_nothing: "0 times infinity is NaN in the box test, and a comparison with it loses the box";
    hits_outside_the_interval_do_not_count: "every hit ahead counts: the interval is not passed on";
    any_says_whether_something_is_found: "any looks at other primitives or another interval than closest";
    many_rays_find_what_each_finds_alone: "a ray of a batch inherits the nearest hit of the one before it";
    equal_primitives_do_not_divide_for_ever: "cells are divided as long as they hold too many primitives, at whatever depth";
    a_ray_without_numbers_finds_nothing: "a comparison with NaN is false, and what follows takes it for a hit";
    the_kernels_of_the_primitives_decide: "triangles are tested by a function of its own, not by Primitives::intersect";
    every_ray_finds_what_asking_every_primitive_finds: "a box test without slack for rounding loses what it touches; see geometry::BoxProbe";
    bundles_of_rays_find_what_asking_every_primitive_finds: "what all rays of a bundle share is taken from its first";
    slivers_giants_and_dust_are_found: "the slack of a box test is a fixed number, not a share of the coordinates";
    no_ray_leaves_a_closed_mesh: "rays at edges pass between boxes that should touch";
    crossing_wires_are_found: "a triangle cut in pieces is looked for in its own box, not in its pieces'";
}

/// Every primitive, one after the other: the definition of the right answer.
fn nearest_of_all(primitives: &Primitives, ray: &Ray, within: Interval) -> Option<Hit> {
    let hits = (0..primitives.len()).filter_map(|number| primitives.intersect(number, ray, within));
    hits.reduce(|nearest, hit| if hit.is_before(nearest) { hit } else { nearest })
}

/// The answer to each ray alone, as far as it is looked at.
fn closest(part: &Part, asked: &Asked, seen: fn(Hit) -> Option<Hit>) -> Verdict {
    let primitives = asked.primitives();
    let built = part(primitives.clone());
    asked.rays.iter().try_for_each(|(ray, within)| {
        let expected = nearest_of_all(&primitives, ray, *within);
        let found = built.closest(ray, *within);
        if expected.and_then(seen) == found.and_then(seen) {
            Ok(())
        } else {
            Err(wrong(&asked.alone(*ray, *within), ray, "", expected, found))
        }
    })
}

/// Whether there is any answer to each ray alone.
fn any(part: &Part, asked: &Asked) -> Verdict {
    let primitives = asked.primitives();
    let built = part(primitives.clone());
    asked.rays.iter().try_for_each(|(ray, within)| {
        let expected = nearest_of_all(&primitives, ray, *within);
        let found = built.any(ray, *within);
        if expected.is_some() == found {
            Ok(())
        } else {
            Err(wrong_any(&asked.alone(*ray, *within), ray, "any", expected, found))
        }
    })
}

/// The answers to all rays at once, ahead of them.
fn many(part: &Part, asked: &Asked) -> Verdict {
    let primitives = asked.primitives();
    let built = part(primitives.clone());
    let rays: Vec<Ray> = asked.rays.iter().map(|&(ray, _)| ray).collect();
    let (hits, found) = together(&*built, &rays);
    rays.iter().zip(hits).zip(found).try_for_each(|((ray, hit), found)| {
        let expected = nearest_of_all(&primitives, ray, Interval::FORWARD);
        if hit != expected {
            return Err(wrong(asked, ray, "closest_many, ", expected, hit));
        }
        if found == expected.is_some() { Ok(()) } else { Err(wrong_any(asked, ray, "any_many", expected, found)) }
    })
}

/// What is ahead of each ray, and whether anything is, asked at once. What stands in the answers' places before is to be written over.
fn together(built: &dyn Accelerator, rays: &[Ray]) -> (Vec<Option<Hit>>, Vec<bool>) {
    const LEFT_FROM_BEFORE: Option<Hit> = Some(Hit { t: 1.0, u: 0.0, v: 0.0, primitive: 0 });
    let mut hits = vec![LEFT_FROM_BEFORE; rays.len()];
    built.closest_many(rays, &mut hits);
    let mut found: Vec<bool> = (0..rays.len()).map(|number| number.is_multiple_of(2)).collect();
    built.any_many(rays, Interval::FORWARD, &mut found);
    (hits, found)
}

/// All ways to ask.
fn everything(part: &Part, asked: &Asked, primitives: &Primitives) -> Verdict {
    let built = part(primitives.clone());
    let rays: Vec<Ray> = asked.rays.iter().map(|&(ray, _)| ray).collect();
    let (hits, blocked) = together(&*built, &rays);
    for ((&(ray, within), together), blocked) in asked.rays.iter().zip(hits).zip(blocked) {
        let expected = nearest_of_all(primitives, &ray, within);
        let alone = built.closest(&ray, within);
        if alone != expected {
            return Err(wrong(&asked.alone(ray, within), &ray, "", expected, alone));
        }
        if built.any(&ray, within) != expected.is_some() {
            return Err(wrong_any(&asked.alone(ray, within), &ray, "any", expected, expected.is_none()));
        }
        let expected = nearest_of_all(primitives, &ray, Interval::FORWARD);
        if together != expected {
            return Err(wrong(asked, &ray, "closest_many, ", expected, together));
        }
        if blocked != expected.is_some() {
            return Err(wrong_any(asked, &ray, "any_many", expected, blocked));
        }
    }
    Ok(())
}

/// How a ray of those asked was answered: `asked` is as little as it takes, one ray or all that were asked together.
fn wrong(asked: &Asked, ray: &Ray, how: &str, expected: Option<Hit>, found: Option<Hit>) -> Box<Counterexample> {
    let which = format!("{how}{ray:?}: ");
    let broken = Counterexample::new(format!("{which}{expected:?}"), format!("{found:?}"));
    broken.of(asked).drawn(asked.drawn(ray, expected, found))
}

fn wrong_any(asked: &Asked, ray: &Ray, how: &str, hit: Option<Hit>, found: bool) -> Box<Counterexample> {
    let expected = format!("{how}, {ray:?}: {}, since the nearest hit is {hit:?}", hit.is_some());
    Counterexample::new(expected, format!("{found}")).of(asked).drawn(asked.drawn(ray, hit, None))
}
