use std::array::from_fn;

use geometry::Ray;
use glam::Vec3;
use shading::{Color, Facing, FacingLanes, Incident, LightFormula, PointLight};

use crate::{
    camera_rays::Samples,
    tracer::{Point, Sight, Tracer},
};

/// What the lights bring to what camera rays see: asked light by light, for many points together.
///
/// ```text
///            * light          the segments from neighbouring points to one light go much the same way: an accelerator
///         / / | \             answers sixteen of them in the time of a few
///   -----.-.--.--.-----
/// ```
///
/// A point's shader is then told what it would have been told, had it asked itself.
#[derive(Default)]
pub(crate) struct Lit {
    /// Each light, if it is the same for all points.
    lights: Vec<Option<PointLight>>,
    /// Places for what each point's lights bring, as many as there are lights. In the end those that reach it stand first, in the lights' order.
    incidents: Vec<Incident>,
    /// What was found at each point.
    found: Vec<Found>,
    /// The points whose shaders ask.
    asking: Vec<Asking>,
    /// Of the light that is being asked: for which points, and the segments to it that must be free.
    places: Vec<usize>,
    segments: Vec<Ray>,
    blocked: Vec<bool>,
}

/// So many points are turned to a light in the same steps.
const LANES: usize = 8;

/// Points that ask by the same formula.
struct Asking {
    formula: LightFormula,
    facing: FacingLanes<LANES>,
    /// Which points they are.
    places: [usize; LANES],
    count: usize,
}

#[derive(Clone, Copy)]
struct Found {
    /// `None` if the point's shader does not ask, and nothing was asked.
    formula: Option<LightFormula>,
    /// How many segments were asked about.
    segments: usize,
    /// How many lights reach the point.
    reached: usize,
}

/// What the lights bring to a point.
#[derive(Clone, Copy)]
pub(crate) struct LitPoint<'a> {
    /// By which formula.
    pub(crate) formula: LightFormula,
    /// In the lights' order.
    pub(crate) incidents: &'a [Incident],
    /// How many shadow rays it took.
    pub(crate) segments: usize,
}

/// What stands in places that are not taken.
const NOTHING: Incident = Incident { direction: Vec3::ZERO, cosine: 0.0, color: Color::BLACK };

/// A light that brings nothing.
const DARK: PointLight = PointLight { position: Vec3::ZERO, color: Color::BLACK, power: 0.0, falloff: |_, _| 0.0 };

impl Lit {
    pub(crate) fn new(tracer: &Tracer<'_>) -> Self {
        let lights = (0..tracer.lights_asked() as u32).map(|number| tracer.light_of_all(number)).collect();
        Self { lights, ..Self::default() }
    }

    /// Forgets what was asked before, and asks for those of the points whose shaders ask lights.
    pub(crate) fn ask<S: Sight>(&mut self, tracer: &Tracer<'_>, samples: &Samples, points: &[Point<'_, S>]) {
        self.found.clear();
        self.asking.clear();
        if self.lights.is_empty() {
            return;
        }
        self.incidents.resize(points.len() * self.lights.len(), NOTHING);
        for (place, point) in points.iter().enumerate() {
            let formula = point.seen.shader.asks_lights();
            if let Some(formula) = formula {
                tracer.facing(formula, &point.seen, |facing| self.add(place, formula, &facing));
            }
            self.found.push(Found { formula, segments: 0, reached: 0 });
        }
        for number in 0..self.lights.len() {
            self.turn_to(number, tracer, samples, points);
            self.follow(number, tracer);
        }
    }

    /// Adds a point that asks.
    #[inline]
    fn add(&mut self, place: usize, formula: LightFormula, facing: &Facing) {
        let has_room = |last: &&mut Asking| last.formula == formula && last.count < LANES;
        if self.asking.last_mut().filter(has_room).is_none() {
            self.asking.push(Asking { formula, facing: FacingLanes::NONE, places: [0; LANES], count: 0 });
        }
        if let Some(last) = self.asking.last_mut() {
            last.facing.put(last.count, facing);
            last.places[last.count] = place;
            last.count += 1;
        }
    }

    /// Finds for which points a light may count, and the segments to it.
    fn turn_to<S: Sight>(&mut self, number: usize, tracer: &Tracer<'_>, samples: &Samples, points: &[Point<'_, S>]) {
        let Self { lights, incidents, found, asking, places, segments, .. } = self;
        for Asking { formula, facing, places: asked, count } in asking {
            let arrives = |lane: usize, incident, segment| {
                let place = asked[lane];
                incidents[place * lights.len() + number] = incident;
                found[place].segments += 1;
                places.push(place);
                segments.push(segment);
            };
            match &lights[number] {
                Some(light) => formula.arriving_lanes(facing, *count, |_| light, arrives),
                None => {
                    let drawn = |lane| tracer.light_of(number as u32, samples, &points[asked[lane]]).unwrap_or(DARK);
                    let drawn: [_; LANES] = from_fn(|lane| if lane < *count { drawn(lane) } else { DARK });
                    formula.arriving_lanes(facing, *count, |lane| &drawn[lane], arrives);
                }
            }
        }
    }

    /// Follows the segments to a light, and keeps what it brings where nothing is in the way.
    fn follow(&mut self, number: usize, tracer: &Tracer<'_>) {
        let lights = self.lights.len();
        self.blocked.resize(self.segments.len(), false);
        tracer.blocked_many(&self.segments, &mut self.blocked);
        for (&point, &blocked) in self.places.iter().zip(&self.blocked) {
            if !blocked {
                let (reached, first) = (&mut self.found[point].reached, point * lights);
                self.incidents[first + *reached] = self.incidents[first + number];
                *reached += 1;
            }
        }
        self.places.clear();
        self.segments.clear();
    }

    /// What arrives at a point; `None` if it was not asked for.
    pub(crate) fn at(&self, point: usize) -> Option<LitPoint<'_>> {
        let &Found { formula, segments, reached } = self.found.get(point)?;
        let first = point * self.lights.len();
        Some(LitPoint { formula: formula?, incidents: &self.incidents[first..first + reached], segments })
    }
}
