//! What was measured, as Markdown.

use std::collections::BTreeMap;

/// A contestant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Who {
    Embree,
    Robust,
    Packets,
    Exact,
    ExactMany,
    Watertight,
    WatertightMany,
    Embree4,
    Robust4,
    Packets4,
    ObvhsWide,
    ObvhsBinary,
    Bvh,
}

/// One mesh and one kind of rays.
pub struct Row {
    pub mesh: &'static str,
    pub kind: &'static str,
    rays: usize,
    seconds: BTreeMap<Who, f64>,
    differences: BTreeMap<Who, usize>,
}

/// Of the table that [`Row::line`] is of.
pub const HEAD: &str = "| mesh | rays | Embree, Mrays/s | robust | packets | exact (to robust) | exact many (to packets) | watertight (to robust) \
                        | watertight many (to packets) | differ |\n|---|---|---|---|---|---|---|---|---|---|";

impl Row {
    pub fn new(mesh: &'static str, kind: &'static str, rays: usize) -> Self {
        Self { mesh, kind, rays, seconds: BTreeMap::new(), differences: BTreeMap::new() }
    }

    pub fn took(&mut self, who: Who, seconds: f64) {
        self.seconds.insert(who, seconds);
    }

    /// For how many rays someone finds another triangle than the exact way.
    pub fn differ(&mut self, who: Who, rays: usize) {
        self.differences.insert(who, rays);
    }

    /// How many times as fast one is as the fastest of others, if all took part.
    pub fn ratio(&self, one: Who, others: &[Who]) -> Option<f64> {
        let other = others.iter().filter_map(|who| self.seconds.get(who).copied()).reduce(f64::min)?;
        Some(other / self.seconds.get(&one)?)
    }

    pub fn line(&self) -> String {
        let pair = |who, second| format!("{} ({})", self.shown(who, &[Who::Embree]), self.shown(who, &[second]));
        format!(
            "| {} | {} | {:.1} | {} | {} | {} | {} | {} | {} | {} |",
            self.mesh,
            self.kind,
            self.rays as f64 / self.seconds[&Who::Embree] / 1e6,
            self.shown(Who::Robust, &[Who::Embree]),
            self.shown(Who::Packets, &[Who::Embree]),
            pair(Who::Exact, Who::Robust),
            pair(Who::ExactMany, Who::Packets),
            pair(Who::Watertight, Who::Robust),
            pair(Who::WatertightMany, Who::Packets),
            self.differences[&Who::Robust],
        )
    }

    fn shown(&self, one: Who, others: &[Who]) -> String {
        self.ratio(one, others).map_or("-".to_owned(), |ratio| format!("{ratio:.2}"))
    }

    fn count(&self, who: Who) -> String {
        self.differences.get(&who).map_or("-".to_owned(), usize::to_string)
    }
}

/// girasol's ratio to the others.
pub fn print_others(rows: &[Row]) {
    println!(
        "\n| mesh | rays | to Embree 4: watertight | its robust: exact | its packets: watertight many, exact many \
         | to obvhs: watertight, exact | to bvh: watertight, exact | differ: Embree 4 robust, obvhs wide, binary, bvh |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let obvhs = [Who::ObvhsWide, Who::ObvhsBinary];
    for row in rows {
        let both = |one, other, to: &[Who]| format!("{}, {}", row.shown(one, to), row.shown(other, to));
        println!(
            "| {} | {} | {} | {} | {} | {} | {} | {} |",
            row.mesh,
            row.kind,
            row.shown(Who::Watertight, &[Who::Embree4]),
            row.shown(Who::Exact, &[Who::Robust4]),
            both(Who::WatertightMany, Who::ExactMany, &[Who::Packets4]),
            both(Who::Watertight, Who::Exact, &obvhs),
            both(Who::Watertight, Who::Exact, &[Who::Bvh]),
            [Who::Robust4, Who::ObvhsWide, Who::ObvhsBinary, Who::Bvh].map(|who| row.count(who)).join(", "),
        );
    }
}
