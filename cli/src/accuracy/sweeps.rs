//! Figure 2: how errors grow with what makes a case hard.

use render::Modules;
use serde_json::{Value, json};

use super::Effort;
use super::chart::{Chart, Line, Series};
use super::families::{self, Sweep};
use super::figure::{Figure, Part};
use super::kernels::{self, Role, Subject, color, legend, mark, roles};
use super::measure::{Summary, errors};
use super::steps::Steps;
use crate::report::Failure;

/// Steps of [`figure`]: one for each sweep.
pub(crate) fn steps() -> usize {
    families::sphere_sweeps().len()
        + families::ellipsoid_sweeps().len()
        + families::triangle_sweeps().len()
        + families::plane_sweeps().len()
}

pub(crate) fn figure(modules: &Modules, effort: &Effort, steps: &Steps) -> Result<Figure, Failure> {
    let own = &modules.kernels;
    let mut found = Vec::new();
    found.extend(families::sphere_sweeps().iter().map(|sweep| swept(&kernels::sphere(own), sweep, effort, steps)));
    found
        .extend(families::ellipsoid_sweeps().iter().map(|sweep| swept(&kernels::ellipsoid(own), sweep, effort, steps)));
    found.extend(families::triangle_sweeps().iter().map(|sweep| swept(&kernels::triangle(own), sweep, effort, steps)));
    found.extend(families::plane_sweeps().iter().map(|sweep| swept(&kernels::plane(own), sweep, effort, steps)));

    let mut parts = vec![legend(roles(found.iter().flat_map(|swept| &swept.kernels).map(|(role, _)| *role)))];
    for swept in &found {
        parts.push(Part::Row(vec![swept.error_chart()?, swept.misjudged_chart()?]));
    }
    Ok(Figure {
        id: "sweeps",
        title: "Error and misjudged hits against what makes a case hard",
        caption: "One property grows, all else is everyday. Left the error that 99.9 % of the hits keep below, right the share of clear cases \
                  in which hit and miss are confused; 0 is the lower edge. Girasol's kernels stay at half an ulp and at 0 throughout. \
                  The naive sphere loses all its digits by D/r = 4000, where (D/r)² exceeds what f32 can tell apart; the naive triangle's \
                  error grows with its aspect, and below a size of 0.003 its epsilon takes all; the naive plane does not know the horizon. \
                  The place in the scene harms the naive ellipsoid alone, whose matrix adds up two large translations; the others \
                  subtract before they multiply."
            .to_owned(),
        parts,
        data: Value::from(found.iter().map(Swept::json).collect::<Vec<_>>()),
    })
}

/// What was found on a sweep.
struct Swept {
    title: &'static str,
    label: &'static str,
    values: Vec<f64>,
    /// Of each kernel, at each value.
    kernels: Vec<(Role, Vec<Summary>)>,
}

fn swept<Shape>(subject: &Subject<Shape>, sweep: &Sweep<Shape>, effort: &Effort, steps: &Steps) -> Swept {
    let mut kernels: Vec<(Role, Vec<Summary>)> =
        subject.contenders.iter().map(|contender| (contender.role, Vec::new())).collect();
    for (_, family) in &sweep.points {
        let found = errors(subject, family, effort.seed, effort.cases / 2);
        for ((_, summaries), errors) in kernels.iter_mut().zip(found) {
            summaries.push(errors.summary(subject.false_hits));
        }
    }
    steps.advance();
    let values = sweep.points.iter().map(|(value, _)| *value).collect();
    Swept { title: sweep.title, label: sweep.label, values, kernels }
}

impl Swept {
    fn error_chart(&self) -> Result<Part, Failure> {
        self.chart("error of t, ulp (99.9 % are below)", [0.1, 1e8], None, |summary| summary.p999)
    }

    fn misjudged_chart(&self) -> Result<Part, Failure> {
        self.chart("misjudged, share of clear cases", [1e-5, 1.0], Some("0"), |summary| summary.misjudged)
    }

    fn chart(
        &self,
        y_label: &str,
        y: [f64; 2],
        y_floor: Option<&'static str>,
        of: impl Fn(&Summary) -> f64,
    ) -> Result<Part, Failure> {
        let series = |(role, summaries): &(Role, Vec<Summary>)| Series {
            color: color(*role),
            mark: mark(*role),
            line: Line::Full,
            points: self.values.iter().zip(summaries).map(|(&value, summary)| [value, of(summary)]).collect(),
            label: None,
        };
        let ends = [self.values[0], self.values[self.values.len() - 1]];
        let chart = Chart {
            title: self.title.to_owned(),
            x_label: self.label.to_owned(),
            y_label: y_label.to_owned(),
            x: ends,
            y,
            y_floor,
            series: self.kernels.iter().map(series).collect(),
        };
        Ok(Part::Svg { svg: chart.svg()?, alt: format!("{}: {y_label}, against {}", self.title, self.label) })
    }

    fn json(&self) -> Value {
        let kernel = |(role, summaries): &(Role, Vec<Summary>)| json!({ "whose": role.name(), "errors": summaries.iter().map(Summary::json).collect::<Vec<_>>() });
        json!({
            "sweep": self.title,
            "of": self.label,
            "values": self.values,
            "kernels": self.kernels.iter().map(kernel).collect::<Vec<_>>(),
        })
    }
}
