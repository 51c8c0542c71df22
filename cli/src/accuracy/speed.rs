//! Figure 1: what a test costs, and how wrong it is.

use render::Modules;
use serde_json::{Value, json};

use super::chart::{Chart, Line, Series};
use super::families::{self, Family};
use super::figure::{Figure, Part};
use super::kernels::{self, FalseHits, Role, Subject, color, legend, mark, roles};
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
}

/// What was found of one kernel.
struct Findings {
    primitive: &'static str,
    role: Role,
    what: &'static str,
    false_hits: FalseHits,
    by_family: Vec<Finding>,
    /// Over all families.
    all: Summary,
    /// The mean over the families.
    nanoseconds: f64,
    /// Likewise, if they were counted.
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
    let mut primitives: Vec<&str> = findings.iter().map(|findings| findings.primitive).collect();
    primitives.dedup();
    let charts = primitives.iter().map(|primitive| chart(primitive, &findings)).collect::<Result<_, _>>()?;
    let mut parts = vec![
        legend(roles(findings.iter().map(|findings| findings.role))),
        Part::Row(charts),
        Part::Heading("Over all families".to_owned()),
        summary_table(&findings),
        Part::Text(counts.explanation()),
        Part::Heading("By family".to_owned()),
    ];
    parts.extend(primitives.iter().map(|primitive| family_table(primitive, &findings)));
    Ok(Figure {
        id: "speed",
        title: "Time against error, for every kernel",
        caption: "Each point is a kernel on one family of cases, everyday or hard: to the left it is fast, at the bottom it is right. The \
                  error is the one that 99.9 % of the hits keep below; half an ulp is the least possible. The naive kernels are \
                  faster, and right on everyday cases alone; girasol's are right on all. A box has no \
                  place where it must be met exactly: girasol's test widens every box on purpose and may enter too early, but \
                  never loses one; so its figure shows lost boxes. Its time includes the preparation of the ray, which the octree \
                  pays once for all its boxes."
            .to_owned(),
        parts,
        data: Value::from(findings.iter().map(Findings::json).collect::<Vec<_>>()),
    })
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
            let summary = errors.summary(subject.false_hits);
            rows[i].push(Finding { family: family.name.clone(), summary, nanoseconds });
        }
        steps.advance();
    }
    let finish = |((contender, by_family), all): ((&kernels::Contender<Shape>, Vec<Finding>), Errors)| Findings {
        primitive: subject.name,
        role: contender.role,
        what: contender.what,
        false_hits: subject.false_hits,
        all: all.summary(subject.false_hits),
        nanoseconds: by_family.iter().map(|finding| finding.nanoseconds).sum::<f64>() / by_family.len() as f64,
        instructions: counts.of(subject.name, contender.role),
        by_family,
    };
    subject.contenders.iter().zip(rows).zip(all).map(finish).collect()
}

/// A point for each family: its error, but of a box, which has no place where it is to be met exactly, the share that was lost.
fn chart(primitive: &str, findings: &[Findings]) -> Result<Part, Failure> {
    let only_misses_count = of_primitive(primitive, findings).any(|of| of.false_hits == FalseHits::AreHarmless);
    let value = |summary: &Summary| if only_misses_count { summary.false_misses } else { summary.p999 };
    let (y_label, y, y_floor) = if only_misses_count {
        ("boxes lost, share of clear cases", [1e-5, 1.0], Some("0"))
    } else {
        ("error of t, ulp (99.9 % are below)", [0.1, 1e8], None)
    };
    let series = |findings: &Findings| Series {
        color: color(findings.role),
        mark: mark(findings.role),
        line: Line::None,
        points: findings.by_family.iter().map(|finding| [finding.nanoseconds, value(&finding.summary)]).collect(),
        label: None,
    };
    let title = capitalised(primitive);
    let alt = format!("{title}: time against {y_label}, a point for each kernel and family of the table below");
    let chart = Chart {
        title,
        x_label: "time of a test, ns".to_owned(),
        y_label: y_label.to_owned(),
        x: [2.0, 100.0],
        y,
        y_floor,
        series: of_primitive(primitive, findings).map(series).collect(),
    };
    Ok(Part::Svg { svg: chart.svg()?, alt })
}

fn of_primitive<'a>(primitive: &'a str, findings: &'a [Findings]) -> impl Iterator<Item = &'a Findings> {
    findings.iter().filter(move |findings| findings.primitive == primitive)
}

fn capitalised(name: &str) -> String {
    let mut name = name.to_owned();
    name[..1].make_ascii_uppercase();
    name
}

fn summary_table(findings: &[Findings]) -> Part {
    let row = |findings: &Findings| {
        let mut cells = vec![findings.primitive.to_owned(), findings.role.name().to_owned(), findings.what.to_owned()];
        cells.push(format!("{:.1}", findings.nanoseconds));
        cells.push(findings.instructions.map_or("-".to_owned(), |count| format!("{count:.0}")));
        cells.extend(errors_of(&findings.all));
        cells
    };
    let left = ["primitive", "whose", "kernel"];
    let right = [&["ns", "instructions"][..], &ERRORS].concat();
    Part::Table { headings: headings(&left, &right), rows: findings.iter().map(row).collect() }
}

fn family_table(primitive: &str, findings: &[Findings]) -> Part {
    let rows_of: Vec<&Findings> = of_primitive(primitive, findings).collect();
    let families = rows_of.first().map_or(0, |findings| findings.by_family.len());
    let mut rows = Vec::new();
    for i in 0..families {
        for findings in &rows_of {
            let Finding { family, summary, nanoseconds } = &findings.by_family[i];
            let mut cells = vec![family.clone(), findings.role.name().to_owned(), format!("{nanoseconds:.1}")];
            cells.extend(errors_of(summary));
            cells.extend([summary.false_hits, summary.false_misses, summary.unclear].map(text::share));
            rows.push(cells);
        }
    }
    let right = [&["ns"][..], &ERRORS, &["false hits", "false misses", "unclear"]].concat();
    let table = Part::Table { headings: headings(&["family", "whose"], &right), rows };
    Part::Folded { title: capitalised(primitive), parts: vec![table] }
}

fn headings(left: &[&str], right: &[&str]) -> Vec<(String, Align)> {
    let named = |names: &[&str], align| names.iter().map(|name| ((*name).to_owned(), align)).collect::<Vec<_>>();
    [named(left, Align::Left), named(right, Align::Right)].concat()
}

/// The columns of [`errors_of`].
const ERRORS: [&str; 4] = ["p50 ulp", "p99.9 ulp", "max ulp", "misjudged"];

fn errors_of(summary: &Summary) -> [String; 4] {
    let Summary { p50, p999, max, misjudged, .. } = *summary;
    [text::error(p50), text::error(p999), text::error(max), text::share(misjudged)]
}

impl Findings {
    fn json(&self) -> Value {
        let by_family = self.by_family.iter().map(|finding| {
            json!({
                "family": finding.family,
                "ns": finding.nanoseconds,
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
