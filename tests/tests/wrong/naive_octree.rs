//! A small octree that can be built wrong: the mistakes stand where they are made.

use accel::Accelerator;
use geometry::{Aabb, BoxProbe, Hit, Interval, Primitive, Primitives, Ray};
use glam::Vec3;

/// What is done wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mistake {
    Nothing,
    EmptyTreeHasARoot,
    LastOfALeafLost,
    LastChildLost,
    OnlyInTheCellOfItsCentre,
    NumberInTheLeaf,
    FirstHitOfALeaf,
    FirstLeafThatIsHit,
    ChildrenInAnyOrder,
    FlatLost,
    NanLost,
    ZeroLost,
    InsideLost,
    IntervalIgnored,
    LastOfATie,
    AnyIgnoresTheInterval,
    AnyLooksAtOneLeaf,
    BatchInherits,
    BatchKeepsWhatWasThere,
    OwnTriangleTest,
}

pub(crate) struct NaiveOctree {
    primitives: Primitives,
    root: Cell,
    mistake: Mistake,
}

struct Cell {
    bounds: Aabb,
    children: Vec<Cell>,
    numbers: Vec<u32>,
}

pub(crate) fn build(primitives: Primitives, mistake: Mistake) -> Box<dyn Accelerator> {
    let numbers: Vec<u32> = (0..primitives.len()).collect();
    let bounds = numbers.iter().map(|&number| primitives.bounds(number)).fold(Aabb::EMPTY, Aabb::union);
    if numbers.is_empty() && mistake == Mistake::EmptyTreeHasARoot {
        return build(one_sphere(), Mistake::Nothing);
    }
    let root = cell(&primitives, bounds, numbers, 0, mistake);
    Box::new(NaiveOctree { primitives, root, mistake })
}

fn one_sphere() -> Primitives {
    let mut primitives = Primitives::default();
    primitives.add_sphere(geometry::Sphere { center: Vec3::ZERO, radius: 30.0 });
    primitives
}

fn cell(primitives: &Primitives, bounds: Aabb, numbers: Vec<u32>, depth: u32, mistake: Mistake) -> Cell {
    if numbers.len() <= 4 || depth == 4 {
        let mut numbers = numbers;
        if mistake == Mistake::LastOfALeafLost && numbers.len() > 1 {
            numbers.pop();
        }
        return Cell { bounds, children: Vec::new(), numbers };
    }
    let middle = bounds.center();
    let eighths = (0..8_u32).map(|place| {
        let mut eighth = bounds;
        for axis in 0..3 {
            if place >> axis & 1 == 1 { eighth.min[axis] = middle[axis] } else { eighth.max[axis] = middle[axis] }
        }
        let inside = |number: &&u32| {
            let own = primitives.bounds(**number);
            let center = own.center();
            let touched =
                if mistake == Mistake::OnlyInTheCellOfItsCentre { Aabb { min: center, max: center } } else { own };
            touched.overlaps(eighth)
        };
        cell(primitives, eighth, numbers.iter().filter(inside).copied().collect(), depth + 1, mistake)
    });
    let mut children: Vec<Cell> = eighths.collect();
    if mistake == Mistake::LastChildLost {
        children.pop();
    }
    Cell { bounds, children, numbers: Vec::new() }
}

impl NaiveOctree {
    /// Where the ray is in a box.
    fn clip(&self, bounds: Aabb, ray: &Ray, within: Interval) -> Option<Interval> {
        let mistake = self.mistake;
        let sturdy = || BoxProbe::new(ray, self.root.bounds.magnitude()).clip(bounds, within);
        let a = (bounds.min - ray.origin) / ray.direction;
        let b = (bounds.max - ray.origin) / ray.direction;
        match mistake {
            Mistake::FlatLost if bounds.extent().min_element() <= 0.0 => None,
            Mistake::ZeroLost if ray.direction.cmpeq(Vec3::ZERO).any() => None,
            Mistake::NanLost if a.is_nan() || b.is_nan() => None,
            Mistake::InsideLost => sturdy().filter(|part| part.min > within.min),
            _ => sturdy(),
        }
    }

    fn meet(&self, number: u32, ray: &Ray, within: Interval) -> Option<Hit> {
        if self.mistake == Mistake::OwnTriangleTest
            && let Some(triangle) = self.primitives.triangle(number)
        {
            return triangle.intersect(ray, within).map(|met| met.on(number));
        }
        self.primitives.intersect(number, ray, within)
    }

    fn leaf(&self, cell: &Cell, ray: &Ray, within: Interval, mut nearest: Option<Hit>) -> Option<Hit> {
        for (place, &number) in cell.numbers.iter().enumerate() {
            let Some(mut hit) = self.meet(number, ray, within) else { continue };
            if self.mistake == Mistake::NumberInTheLeaf {
                hit.primitive = place as u32;
            }
            let is_before = match self.mistake {
                Mistake::LastOfATie => nearest.is_none_or(|nearest| hit.t <= nearest.t),
                _ => nearest.is_none_or(|nearest| hit.is_before(nearest)),
            };
            if is_before {
                nearest = Some(hit);
            }
            if self.mistake == Mistake::FirstHitOfALeaf {
                break;
            }
        }
        nearest
    }

    fn pass(&self, cell: &Cell, ray: &Ray, within: Interval, nearest: Option<Hit>) -> Option<Hit> {
        let stops = [Mistake::FirstLeafThatIsHit, Mistake::ChildrenInAnyOrder].contains(&self.mistake);
        if cell.children.is_empty() {
            return self.leaf(cell, ray, within, nearest);
        }
        let mut ways: Vec<(f32, &Cell)> =
            cell.children.iter().filter_map(|child| Some((self.clip(child.bounds, ray, within)?.min, child))).collect();
        if self.mistake != Mistake::ChildrenInAnyOrder {
            ways.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        let mut nearest = nearest;
        for (from, child) in ways {
            let is_behind = |hit: Hit| from > hit.t;
            if nearest.is_some_and(|hit| stops || is_behind(hit)) {
                break;
            }
            nearest = self.pass(child, ray, within, nearest);
        }
        nearest
    }

    fn is_ordinary(ray: &Ray) -> bool {
        let length = ray.direction.abs().max_element();
        ray.origin.abs().cmplt(Vec3::splat(1e12)).all() && ray.direction.is_finite() && length < 1e12 && length > 1e-12
    }
}

impl Accelerator for NaiveOctree {
    fn closest(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let within = match self.mistake {
            Mistake::IntervalIgnored => Interval::FORWARD,
            _ => within,
        };
        if !Self::is_ordinary(ray) {
            let all = (0..self.primitives.len()).filter_map(|number| self.meet(number, ray, within));
            return all.reduce(|nearest, hit| if hit.is_before(nearest) { hit } else { nearest });
        }
        self.clip(self.root.bounds, ray, within)?;
        self.pass(&self.root, ray, within, None)
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        match self.mistake {
            Mistake::AnyIgnoresTheInterval => self.closest(ray, Interval::FORWARD).is_some(),
            Mistake::AnyLooksAtOneLeaf => {
                let mut cell = &self.root;
                while let Some(child) =
                    cell.children.iter().find(|child| self.clip(child.bounds, ray, within).is_some())
                {
                    cell = child;
                }
                self.leaf(cell, ray, within, None).is_some()
            }
            _ => self.closest(ray, within).is_some(),
        }
    }

    fn closest_many(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        let mut before: Option<Hit> = None;
        for (ray, hit) in rays.iter().zip(hits) {
            let within = Interval::FORWARD;
            match self.mistake {
                Mistake::BatchInherits => {
                    before = self.closest(ray, within.up_to(before.map_or(f32::INFINITY, |hit| hit.t)));
                    *hit = before;
                }
                Mistake::BatchKeepsWhatWasThere => {
                    if let Some(found) = self.closest(ray, within) {
                        *hit = Some(found);
                    }
                }
                _ => *hit = self.closest(ray, within),
            }
        }
    }
}
