//! What is aimed at, and whether it is reached: the median of the meshes, and the least.

use crate::table::{Row, Who};

/// How many times as fast as another one is to be on each kind of rays.
struct Target {
    one: Who,
    other: Who,
    kinds: &'static [&'static str],
    /// In the median of the meshes.
    median: f64,
    /// On every mesh.
    least: f64,
}

const fn target(one: Who, other: Who, kinds: &'static [&'static str], median: f64, least: f64) -> Target {
    Target { one, other, kinds, median, least }
}

const ALL: &[&str] = &["primary", "shadow", "diffuse"];
const COHERENT: &[&str] = &["primary", "shadow"];

const TARGETS: [Target; 10] = [
    target(Who::Watertight, Who::Embree, &["primary"], 1.15, 1.0),
    target(Who::Watertight, Who::Embree, &["shadow"], 1.2, 1.0),
    target(Who::Watertight, Who::Embree, &["diffuse"], 1.1, 0.9),
    target(Who::WatertightMany, Who::Embree, &["primary"], 2.6, 2.1),
    target(Who::WatertightMany, Who::Embree, &["shadow"], 2.0, 1.0),
    target(Who::WatertightMany, Who::Packets, COHERENT, 1.05, 0.95),
    target(Who::WatertightMany, Who::Embree, &["diffuse"], 1.4, 1.1),
    target(Who::Exact, Who::Robust, ALL, 1.2, 1.0),
    target(Who::Exact, Who::Embree, ALL, 1.0, 0.85),
    target(Who::ExactMany, Who::Embree, &["primary"], 2.2, 1.8),
];

/// What would be better still.
const STRETCH: [Target; 6] = [
    target(Who::Watertight, Who::Embree, &["primary"], 1.3, 1.0),
    target(Who::Watertight, Who::Embree, &["shadow"], 1.35, 1.0),
    target(Who::Watertight, Who::Embree, &["diffuse"], 1.25, 0.9),
    target(Who::WatertightMany, Who::Embree, &["primary"], 3.4, 2.1),
    target(Who::WatertightMany, Who::Embree, &["shadow"], 3.0, 1.0),
    target(Who::Exact, Who::Robust, ALL, 1.4, 1.0),
];

/// On the fence, for each kind of rays.
const THIN: f64 = 1.2;

pub fn print(rows: &[Row]) {
    println!("\n| target | rays | meshes | median | aim | least | aim | |\n|---|---|---|---|---|---|---|---|");
    for target in &TARGETS {
        judge(target, rows, "");
    }
    for kind in ALL {
        let fence = rows.iter().find(|row| row.mesh == "fence" && row.kind == *kind);
        if let Some(ratio) = fence.and_then(|row| row.ratio(Who::Watertight, &[Who::Embree])) {
            println!(
                "| thin triangles: Watertight to Embree | {kind} | fence | {ratio:.2} | {THIN} | | | {} |",
                met(ratio >= THIN)
            );
        }
    }
    for target in &STRETCH {
        judge(target, rows, "stretch: ");
    }
}

fn judge(target: &Target, rows: &[Row], prefix: &str) {
    for kind in target.kinds {
        let of_kind = rows.iter().filter(|row| row.kind == *kind);
        let mut ratios: Vec<_> =
            of_kind.filter_map(|row| Some((row.ratio(target.one, &[target.other])?, row.mesh))).collect();
        ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
        let [(least, mesh), ..] = ratios[..] else { continue };
        let (one, other, meshes) = (target.one, target.other, ratios.len());
        let median = 0.5 * (ratios[(meshes - 1) / 2].0 + ratios[meshes / 2].0);
        println!(
            "| {prefix}{one:?} to {other:?} | {kind} | {meshes} | {median:.2} | {} | {least:.2} ({mesh}) | {} | {} |",
            target.median,
            target.least,
            met(median >= target.median && least >= target.least),
        );
    }
}

fn met(is: bool) -> &'static str {
    if is { "met" } else { "**missed**" }
}
