//! What is measured: for each primitive girasol's kernel, the naive one, and perhaps somebody's own.

use geometry::{Aabb, BoxProbe, Ellipsoid, Intersection, Interval, Kernels, Primitive, Ray, Sphere, Triangle, naive};

use super::aimed::GivenPlane;
use super::figure::{BLUE, GREEN, Key, Mark, ORANGE, Part};
use super::truth::{self, Truth};

/// Whose a kernel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Ours,
    Naive,
    Yours,
}

impl Role {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Ours => "girasol",
            Self::Naive => "naive",
            Self::Yours => "yours",
        }
    }
}

/// The colour of its points in diagrams.
pub(crate) fn color(role: Role) -> [u8; 3] {
    match role {
        Role::Naive => ORANGE,
        Role::Ours => BLUE,
        Role::Yours => GREEN,
    }
}

/// How its points are drawn.
pub(crate) fn mark(role: Role) -> Mark {
    match role {
        Role::Naive => Mark::Ring,
        Role::Ours => Mark::Disc,
        Role::Yours => Mark::Square,
    }
}

/// Those that appear, in the order of a legend.
pub(crate) fn roles(all: impl IntoIterator<Item = Role>) -> Vec<Role> {
    let all: Vec<Role> = all.into_iter().collect();
    [Role::Naive, Role::Ours, Role::Yours].into_iter().filter(|role| all.contains(role)).collect()
}

/// What the points stand for.
pub(crate) fn legend(roles: impl IntoIterator<Item = Role>) -> Part {
    let key = |role: Role| Key { color: color(role), mark: mark(role), name: role.name().to_owned() };
    Part::Legend(roles.into_iter().map(key).collect())
}

/// A kernel of one primitive.
pub(crate) struct Contender<Shape> {
    pub(crate) role: Role,
    /// What it does, in a few words.
    pub(crate) what: &'static str,
    pub(crate) run: Run<Shape>,
}

/// All are called in the same way, through one pointer.
pub(crate) type Run<Shape> = Box<dyn Fn(&Shape, &Ray, Interval) -> Option<Intersection>>;

/// A primitive with its kernels.
pub(crate) struct Subject<Shape> {
    /// Lower case, for people and programs.
    pub(crate) name: &'static str,
    pub(crate) contenders: Vec<Contender<Shape>>,
    pub(crate) truth: fn(&Shape, &Ray) -> Truth,
    /// What a wrong hit means.
    pub(crate) false_hits: FalseHits,
}

/// What a hit means where there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FalseHits {
    /// A misjudgement, like a miss where there is a hit.
    AreWrong,
    /// Some work for nothing: boxes are only asked for what is in them.
    AreHarmless,
}

fn contenders<Shape>(
    ours: (&'static str, Run<Shape>),
    naive: (&'static str, Run<Shape>),
    yours: Option<Run<Shape>>,
) -> Vec<Contender<Shape>> {
    let contender = |role, (what, run)| Contender { role, what, run };
    let yours = yours.map(|run| contender(Role::Yours, ("from Modules", run)));
    [contender(Role::Naive, naive), contender(Role::Ours, ours)].into_iter().chain(yours).collect()
}

pub(crate) fn sphere(kernels: &Kernels) -> Subject<Sphere> {
    Subject {
        name: "sphere",
        contenders: contenders(
            ("half-b quadratic, f64", Box::new(|sphere, ray, within| sphere.intersect(ray, within))),
            ("school's quadratic formula, f32", Box::new(naive::quadratic_formula)),
            kernels.sphere.map(|kernel| Box::new(kernel) as Run<Sphere>),
        ),
        truth: truth::sphere,
        false_hits: FalseHits::AreWrong,
    }
}

pub(crate) fn ellipsoid(kernels: &Kernels) -> Subject<Ellipsoid> {
    Subject {
        name: "ellipsoid",
        contenders: contenders(
            ("translation first, then f64", Box::new(|ellipsoid, ray, within| ellipsoid.intersect(ray, within))),
            ("inverse matrix, f32", Box::new(naive::single_precision_inverse)),
            kernels.ellipsoid.map(|kernel| Box::new(kernel) as Run<Ellipsoid>),
        ),
        truth: truth::ellipsoid,
        false_hits: FalseHits::AreWrong,
    }
}

pub(crate) fn triangle(kernels: &Kernels) -> Subject<Triangle> {
    Subject {
        name: "triangle",
        contenders: contenders(
            ("edge functions, f64", Box::new(|triangle, ray, within| triangle.intersect(ray, within))),
            ("Möller-Trumbore, f32, epsilon 1e-6", Box::new(naive::moeller_trumbore)),
            kernels.triangle.map(|kernel| Box::new(kernel) as Run<Triangle>),
        ),
        truth: truth::triangle,
        false_hits: FalseHits::AreWrong,
    }
}

pub(crate) fn plane(kernels: &Kernels) -> Subject<GivenPlane> {
    Subject {
        name: "plane",
        contenders: contenders(
            ("n.(p - o) / n.d, f64", Box::new(|given, ray, within| given.plane.intersect(ray, within))),
            (
                "f32, |n.d| < 1e-6 rejected",
                Box::new(|given, ray, within| naive::rejecting_near_parallel(&given.plane, ray, within)),
            ),
            kernels.plane.map(|kernel| -> Run<GivenPlane> {
                Box::new(move |given: &GivenPlane, ray: &Ray, within| kernel(&given.plane, ray, within))
            }),
        ),
        truth: |given, ray| truth::plane(given.point, given.normal, ray),
        false_hits: FalseHits::AreWrong,
    }
}

pub(crate) fn aabb(kernels: &Kernels) -> Subject<Aabb> {
    let entry = |clipped: Option<Interval>| clipped.map(|inside| Intersection::at(inside.min));
    Subject {
        name: "box",
        contenders: contenders(
            (
                "slabs with slack, f32",
                Box::new(move |bounds, ray, within| {
                    entry(BoxProbe::new(ray, bounds.magnitude()).clip(*bounds, within))
                }),
            ),
            ("slabs, f32", Box::new(move |bounds, ray, within| entry(naive::slab_test(bounds, ray, within)))),
            kernels.aabb.map(|kernel| -> Run<Aabb> {
                Box::new(move |bounds: &Aabb, ray: &Ray, within| entry(kernel(bounds, ray, within)))
            }),
        ),
        truth: truth::aabb,
        false_hits: FalseHits::AreHarmless,
    }
}
