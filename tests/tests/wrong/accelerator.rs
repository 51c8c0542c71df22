use accel::conformance::accelerator::{LAWS, Part};
use geometry::conformance::Trial;

use crate::Kit;
use crate::naive_octree::{Mistake, build};

#[test]
fn every_mistake_in_an_accelerator_is_named() {
    Kit { page: "accel/src/conformance/accelerator.rs", laws: LAWS }.catches([
        ("nothing is returned", (|_| Box::new(Nothing)) as Part, "one_primitive_is_found"),
        (
            "an empty tree has a root all the same",
            |all| build(all, Mistake::EmptyTreeHasARoot),
            "nothing_is_found_where_there_is_nothing",
        ),
        ("a leaf's last primitive is lost", |all| build(all, Mistake::LastOfALeafLost), "every_primitive_is_found"),
        ("the last of eight children is lost", |all| build(all, Mistake::LastChildLost), "every_primitive_is_found"),
        (
            "a primitive stands only in the cell of its centre",
            |all| build(all, Mistake::OnlyInTheCellOfItsCentre),
            "every_primitive_is_found",
        ),
        (
            "only a leaf's first hit is looked at",
            |all| build(all, Mistake::FirstHitOfALeaf),
            "the_nearest_of_several_is_found",
        ),
        (
            "the number in the leaf instead of the one in the whole",
            |all| build(all, Mistake::NumberInTheLeaf),
            "a_hit_has_the_number_of_its_primitive",
        ),
        (
            "children in the order of their places, and the first hit ends the search",
            |all| build(all, Mistake::ChildrenInAnyOrder),
            "the_nearest_of_several_is_found",
        ),
        (
            "the first child that is hit ends the search",
            |all| build(all, Mistake::FirstLeafThatIsHit),
            "a_hit_beyond_its_cell_does_not_end_the_search",
        ),
        ("flat boxes are lost", |all| build(all, Mistake::FlatLost), "flat_boxes_are_not_lost"),
        (
            "a direction of 0 along an axis loses the box",
            |all| build(all, Mistake::ZeroLost),
            "rays_along_the_axes_lose_nothing",
        ),
        ("NaN loses the box", |all| build(all, Mistake::NanLost), "rays_along_the_axes_lose_nothing"),
        (
            "an origin inside a box counts as a miss",
            |all| build(all, Mistake::InsideLost),
            "rays_that_start_among_the_primitives_lose_nothing",
        ),
        (
            "the interval is not looked at",
            |all| build(all, Mistake::IntervalIgnored),
            "hits_outside_the_interval_do_not_count",
        ),
        ("of two equal hits the last counts", |all| build(all, Mistake::LastOfATie), "the_lowest_number_wins_a_tie"),
        (
            "any does not look at the interval",
            |all| build(all, Mistake::AnyIgnoresTheInterval),
            "any_says_whether_something_is_found",
        ),
        (
            "any looks at one leaf alone",
            |all| build(all, Mistake::AnyLooksAtOneLeaf),
            "any_says_whether_something_is_found",
        ),
        (
            "a ray of a batch is cut to the hit of the one before",
            |all| build(all, Mistake::BatchInherits),
            "many_rays_find_what_each_finds_alone",
        ),
        (
            "a miss of a batch leaves what stood there",
            |all| build(all, Mistake::BatchKeepsWhatWasThere),
            "many_rays_find_what_each_finds_alone",
        ),
        (
            "a triangle test of its own",
            |all| build(all, Mistake::OwnTriangleTest),
            "the_kernels_of_the_primitives_decide",
        ),
    ]);
}

/// What is built right passes: so it is the mistake that is caught.
#[test]
fn the_octree_that_is_spoilt_is_right_otherwise() {
    let right: Part = |all| build(all, Mistake::Nothing);
    for law in LAWS {
        assert_eq!(law.check(&right, &Trial { cases: 64, seed: 1 }).map_err(|broken| broken.to_string()), Ok(()));
    }
}

struct Nothing;

impl accel::Accelerator for Nothing {
    fn closest(&self, _: &geometry::Ray, _: geometry::Interval) -> Option<geometry::Hit> {
        None
    }

    fn any(&self, _: &geometry::Ray, _: geometry::Interval) -> bool {
        false
    }
}
