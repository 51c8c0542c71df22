use geometry::Ray;
use glam::Vec3;
use shading::{Color, Incident, LightFormula, PointLight};

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
    /// Places for what each point's lights bring, as many as there are lights. In the end those that reach it stand first, in the lights' order.
    incidents: Vec<Incident>,
    /// What was found at each point.
    found: Vec<Found>,
    lights: Vec<Asked>,
    blocked: Vec<bool>,
}

/// One light.
#[derive(Default)]
struct Asked {
    /// The light, if it is the same for all points.
    same: Option<PointLight>,
    /// Which points it is asked for, and the segments to it that must be free.
    points: Vec<usize>,
    segments: Vec<Ray>,
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

impl Lit {
    pub(crate) fn new(tracer: &Tracer<'_>) -> Self {
        let asked = |number| Asked { same: tracer.light_of_all(number), ..Asked::default() };
        Self { lights: (0..tracer.lights_asked() as u32).map(asked).collect(), ..Self::default() }
    }

    /// Forgets what was asked before, and asks for those of the points whose shaders ask lights.
    pub(crate) fn ask<S: Sight>(&mut self, tracer: &Tracer<'_>, samples: &Samples, points: &[Point<'_, S>]) {
        self.found.clear();
        if self.lights.is_empty() {
            return;
        }
        self.incidents.resize(points.len() * self.lights.len(), NOTHING);
        for (place, point) in points.iter().enumerate() {
            let formula = point.seen.shader.asks_lights();
            let segments = formula.map_or(0, |formula| self.ask_for(place, point, formula, tracer, samples));
            self.found.push(Found { formula, segments, reached: 0 });
        }
        for number in 0..self.lights.len() {
            self.follow(number, tracer);
        }
    }

    /// Asks all lights for a point; returns how many of them may reach it.
    fn ask_for<S: Sight>(
        &mut self,
        place: usize,
        point: &Point<'_, S>,
        formula: LightFormula,
        tracer: &Tracer<'_>,
        samples: &Samples,
    ) -> usize {
        let first = place * self.lights.len();
        let Some(arriving) = tracer.arriving(formula, &point.seen) else { return 0 };
        let mut segments = 0;
        for (number, asked) in self.lights.iter_mut().enumerate() {
            let found = match &asked.same {
                Some(light) => arriving(light),
                None => tracer.light_of(number as u32, samples, point).and_then(|light| arriving(&light)),
            };
            if let Some((incident, segment)) = found {
                self.incidents[first + number] = incident;
                asked.points.push(place);
                asked.segments.push(segment);
                segments += 1;
            }
        }
        segments
    }

    /// Follows the segments to a light, and keeps what it brings where nothing is in the way.
    fn follow(&mut self, number: usize, tracer: &Tracer<'_>) {
        let lights = self.lights.len();
        let Asked { points, segments, .. } = &mut self.lights[number];
        self.blocked.resize(segments.len(), false);
        tracer.blocked_many(segments, &mut self.blocked);
        for (&point, &blocked) in points.iter().zip(&self.blocked) {
            if !blocked {
                let (reached, first) = (&mut self.found[point].reached, point * lights);
                self.incidents[first + *reached] = self.incidents[first + number];
                *reached += 1;
            }
        }
        points.clear();
        segments.clear();
    }

    /// What arrives at a point; `None` if it was not asked for.
    pub(crate) fn at(&self, point: usize) -> Option<LitPoint<'_>> {
        let &Found { formula, segments, reached } = self.found.get(point)?;
        let first = point * self.lights.len();
        Some(LitPoint { formula: formula?, incidents: &self.incidents[first..first + reached], segments })
    }
}
