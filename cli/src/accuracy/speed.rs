//! Figure 1: what a test costs, and how wrong it is.

use render::Modules;
use serde_json::{Value, json};

use super::chart::{Chart, Line, Series};
use super::families::{self, Family};
use super::figure::{BLUE, Figure, GREEN, GREY, Key, Mark, ORANGE, PINK, Part};
use super::kernels::{self, Role, Subject};
use super::measure::{Errors, Summary, errors, nanoseconds};
use super::steps::Steps;
use super::{Effort, instructions::Counts, text};
use crate::report::Failure;
use crate::table::Align;

/// What was found of one kernel in one family.
struct Finding {
    family: String,
    summary: Summary,
    nanoseconds: f64,
    instructions: Option<f64>,
}

/// What was found of one kernel.
struct Findings {
    primitive: &'static str,
    role: Role,
    what: &'static str,
    by_family: Vec<Finding>,
    /// Over all families.
    all: Summary,
    /// The geometric mean over the families.
    nanoseconds: f64,
    /// Likewise.
    instructions: Option<f64>,
}

/// Steps of [`figure`].
pub(crate) fn steps() -> usize {
    families::spheres().len()
        + families::ellipsoids().len()
        + families::triangles().len()
        + families::planes().len()
        + families::boxes().len()
}

pub(crate) fn figure(modules: &Modules, counts: &Counts, effort: &Effort, steps: &Steps) -> Result<Figure, Failure> {
    let own = &modules.kernels;
    let findings = [
        measured(&kernels::sphere(own), &families::spheres(), counts, effort, steps),
        measured(&kernels::ellipsoid(own), &families::ellipsoids(), counts, effort, steps),
        measured(&kernels::triangle(own), &families::triangles(), counts, effort, steps),
        measured(&kernels::plane(own), &families::planes(), counts, effort, steps),
        measured(&kernels::aabb(own), &families::boxes(), counts, effort, steps),
    ];
    let findings: Vec<Findings> = findings.into_iter().flatten().collect();
    let mut parts = vec![legend(&findings), chart(&findings)?, summary_table(&findings)];
    parts.push(Part::Text(counts.explanation()));
    parts.push(Part::Heading("By family".to_owned()));
    parts.extend(COLORS.iter().map(|(primitive, _)| family_table(primitive, &findings)));
    Ok(Figure {
        id: "speed",
        title: "Time against error, for every kernel",
        caption: "Each point is a kernel: to the left it is fast, at the bottom it is right. A line leads from the naive kernel to \
                  girasol's. The error is the one that 99.9 % of the hits keep below, over all families, hard ones included; half an ulp \
                  is the least possible. Girasol's box test is meant to err: it widens every box, so that it loses nothing."
            .to_owned(),
        parts,
        data: Value::from(findings.iter().map(Findings::json).collect::<Vec<_>>()),
    })
}

const COLORS: [(&str, [u8; 3]); 5] =
    [("sphere", BLUE), ("ellipsoid", PINK), ("triangle", ORANGE), ("plane", GREEN), ("box", GREY)];

pub(super) fn mark(role: Role) -> Mark {
    match role {
        Role::Ours => Mark::Disc,
        Role::Naive => Mark::Ring,
        Role::Yours => Mark::Square,
    }
}

fn measured<Shape>(
    subject: &Subject<Shape>,
    families: &[Family<Shape>],
    counts: &Counts,
    effort: &Effort,
    steps: &Steps,
) -> Vec<Findings> {
    let mut all = vec![Errors::default(); subject.contenders.len()];
    let mut rows: Vec<Vec<Finding>> = subject.contenders.iter().map(|_| Vec::new()).collect();
    for family in families {
        let found = errors(subject, family, effort.seed, effort.cases);
        let times = nanoseconds(subject, family, effort.seed, effort.rounds);
        for (i, (errors, nanoseconds)) in found.iter().zip(times).enumerate() {
            all[i].and(errors);
            let instructions = counts.of(subject.name, subject.contenders[i].role, &family.name);
            let summary = errors.summary(subject.false_hits);
            rows[i].push(Finding { family: family.name.clone(), summary, nanoseconds, instructions });
        }
        steps.advance();
    }
    let finish = |((contender, by_family), all): ((&kernels::Contender<Shape>, Vec<Finding>), Errors)| Findings {
        primitive: subject.name,
        role: contender.role,
        what: contender.what,
        all: all.summary(subject.false_hits),
        nanoseconds: geometric_mean(by_family.iter().map(|finding| Some(finding.nanoseconds))).unwrap_or(f64::NAN),
        instructions: geometric_mean(by_family.iter().map(|finding| finding.instructions)),
        by_family,
    };
    subject.contenders.iter().zip(rows).zip(all).map(finish).collect()
}

/// `None` if one of them is not known, or there are none.
fn geometric_mean(numbers: impl Iterator<Item = Option<f64>>) -> Option<f64> {
    let logarithms: Vec<f64> = numbers.map(|number| number.map(libm::log)).collect::<Option<_>>()?;
    (!logarithms.is_empty()).then(|| libm::exp(logarithms.iter().sum::<f64>() / logarithms.len() as f64))
}

fn legend(findings: &[Findings]) -> Part {
    let mut keys: Vec<Key> = COLORS
        .iter()
        .map(|&(name, color)| Key { color, mark: Mark::Disc, name: format!("{name}, girasol's") })
        .collect();
    keys.push(Key { color: GREY, mark: Mark::Ring, name: "naive, of the same colour".to_owned() });
    if findings.iter().any(|findings| findings.role == Role::Yours) {
        keys.push(Key { color: GREY, mark: Mark::Square, name: "yours".to_owned() });
    }
    Part::Legend(keys)
}

fn chart(findings: &[Findings]) -> Result<Part, Failure> {
    let point = |findings: &Findings| [findings.nanoseconds, findings.all.p999];
    let series = |color, mark, line, points| Series { color, mark, line, points, label: None };
    let mut all = Vec::new();
    for (primitive, color) in COLORS {
        let of_primitive = || findings.iter().filter(move |findings| findings.primitive == primitive);
        let both = of_primitive().filter(|findings| findings.role != Role::Yours).map(point).collect();
        all.push(series(color, Mark::None, Line::Thin, both));
        all.extend(of_primitive().map(|findings| {
            let name = if findings.role == Role::Yours { format!("{primitive}, yours") } else { primitive.to_owned() };
            Series { label: Some(name), ..series(color, mark(findings.role), Line::None, vec![point(findings)]) }
        }));
    }
    let chart = Chart {
        title: "A test's time and error".to_owned(),
        x_label: "time of a test, ns".to_owned(),
        y_label: "error of t, ulp (99.9 % are below)".to_owned(),
        x: [1.0, 200.0],
        y: [0.1, 1e8],
        y_floor: None,
        series: all,
    };
    let alt = "Scatter plot of the table below: for each primitive the naive kernel's time and error, and girasol's"
        .to_owned();
    Ok(Part::Svg { svg: chart.svg()?, alt })
}

fn summary_table(findings: &[Findings]) -> Part {
    let row = |findings: &Findings| {
        let mut cells = vec![findings.primitive.to_owned(), findings.role.name().to_owned(), findings.what.to_owned()];
        cells.extend(numbers(findings.nanoseconds, findings.instructions, &findings.all));
        cells
    };
    let left = ["primitive", "whose", "kernel"];
    Part::Table { headings: headings(&left), rows: findings.iter().map(row).collect() }
}

fn family_table(primitive: &str, findings: &[Findings]) -> Part {
    let of_primitive: Vec<&Findings> = findings.iter().filter(|findings| findings.primitive == primitive).collect();
    let families = of_primitive.first().map_or(0, |findings| findings.by_family.len());
    let mut rows = Vec::new();
    for i in 0..families {
        for findings in &of_primitive {
            let Finding { family, summary, nanoseconds, instructions } = &findings.by_family[i];
            let mut cells = vec![family.clone(), findings.role.name().to_owned()];
            cells.extend(numbers(*nanoseconds, *instructions, summary));
            rows.push(cells);
        }
    }
    let mut title = primitive.to_owned();
    title[..1].make_ascii_uppercase();
    Part::Folded { title, parts: vec![Part::Table { headings: headings(&["family", "whose"]), rows }] }
}

fn headings(left: &[&str]) -> Vec<(String, Align)> {
    let right =
        ["ns", "instructions", "p50 ulp", "p99.9 ulp", "max ulp", "misjudged", "false hits", "false misses", "unclear"];
    let left = left.iter().map(|name| ((*name).to_owned(), Align::Left));
    left.chain(right.map(|name| (name.to_owned(), Align::Right))).collect()
}

fn numbers(nanoseconds: f64, instructions: Option<f64>, summary: &Summary) -> [String; 9] {
    [
        format!("{nanoseconds:.1}"),
        instructions.map_or("-".to_owned(), |count| format!("{count:.0}")),
        text::error(summary.p50),
        text::error(summary.p999),
        text::error(summary.max),
        text::share(summary.misjudged),
        text::share(summary.false_hits),
        text::share(summary.false_misses),
        text::share(summary.unclear),
    ]
}

impl Findings {
    fn json(&self) -> Value {
        let by_family = self.by_family.iter().map(|finding| {
            json!({
                "family": finding.family,
                "ns": finding.nanoseconds,
                "instructions": finding.instructions,
                "errors": finding.summary.json(),
            })
        });
        json!({
            "primitive": self.primitive,
            "whose": self.role.name(),
            "kernel": self.what,
            "ns": self.nanoseconds,
            "instructions": self.instructions,
            "errors": self.all.json(),
            "families": by_family.collect::<Vec<_>>(),
        })
    }
}
