use geometry::Ray;
use glam::Vec3;
use shading::{Color, Incident};

use crate::{
    Sample,
    tracer::{Seen, Tracer},
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
    /// Places for what each point's lights bring; each has as many as there are lights, and takes the first.
    incidents: Vec<Incident>,
    places: usize,
    /// What was found at each point; `None` if it was not asked for.
    found: Vec<Option<Found>>,
    /// Which points one light is asked for, and the segments to it that must be free.
    asked: Vec<usize>,
    segments: Vec<Ray>,
    blocked: Vec<bool>,
}

#[derive(Clone, Copy, Default)]
struct Found {
    /// How many segments were asked about.
    segments: usize,
    /// How many of the point's places are taken, by lights that reach it.
    taken: usize,
}

/// What the lights bring to a point.
#[derive(Clone, Copy)]
pub(crate) struct LitPoint<'a> {
    /// In the lights' order.
    pub(crate) incidents: &'a [Incident],
    /// How many shadow rays it took.
    pub(crate) segments: usize,
}

/// What stands in places that are not taken.
const NOTHING: Incident = Incident { direction: Vec3::ZERO, cosine: 0.0, color: Color::BLACK };

impl Lit {
    /// Forgets what was asked before, and asks for those of the points whose shaders ask lights.
    pub(crate) fn ask(&mut self, tracer: &Tracer<'_>, points: &[(Sample, Option<Seen>)]) {
        self.places = tracer.lights_asked();
        self.found.clear();
        self.found.extend(points.iter().map(|(_, seen)| {
            let asks = self.places > 0 && seen.as_ref().is_some_and(|seen| tracer.asks_lights(seen));
            asks.then(Found::default)
        }));
        if self.found.iter().all(Option::is_none) {
            return;
        }
        self.incidents.resize(points.len() * self.places, NOTHING);
        for number in 0..self.places as u32 {
            self.ask_light(number, tracer, points);
        }
    }

    fn ask_light(&mut self, number: u32, tracer: &Tracer<'_>, points: &[(Sample, Option<Seen>)]) {
        self.asked.clear();
        self.segments.clear();
        for (point, ((sample, seen), found)) in points.iter().zip(&mut self.found).enumerate() {
            if let (Some(seen), Some(found)) = (seen, found)
                && let Some((incident, segment)) = tracer.arriving(number, sample, seen)
            {
                found.segments += 1;
                // In the next free place, taken only if nothing is in the way.
                self.incidents[point * self.places + found.taken] = incident;
                self.asked.push(point);
                self.segments.push(segment);
            }
        }
        self.blocked.resize(self.segments.len(), false);
        tracer.blocked_many(&self.segments, &mut self.blocked);
        for (&point, &blocked) in self.asked.iter().zip(&self.blocked) {
            if !blocked && let Some(found) = &mut self.found[point] {
                found.taken += 1;
            }
        }
    }

    /// What arrives at a point; `None` if it was not asked for.
    pub(crate) fn at(&self, point: usize) -> Option<LitPoint<'_>> {
        let Found { segments, taken } = self.found[point]?;
        let first = point * self.places;
        Some(LitPoint { incidents: &self.incidents[first..first + taken], segments })
    }
}
