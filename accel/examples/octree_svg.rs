//! Draws the octree of a small scene, cut through the middle, and what one ray visits of it:
//! `cargo run -p accel --example octree_svg > accel/docs/octree.svg`.
//!
//! The octree itself has nothing to draw with. But it asks the box test that it is given ([`geometry::Kernels`]), and a box test can
//! write down what it is asked: one that always says yes is shown every cell.
#![allow(clippy::print_stdout, unreachable_pub)]

use std::cell::RefCell;

use accel::octree;
use geometry::{Aabb, BoxProbe, Interval, Kernels, Primitives, Ray, Sphere};
use glam::{Vec2, Vec3};

thread_local! {
    static ASKED: RefCell<Vec<Aabb>> = const { RefCell::new(Vec::new()) };
}

fn everything(bounds: &Aabb, _: &Ray, _: Interval) -> Option<Interval> {
    ASKED.with_borrow_mut(|asked| asked.push(*bounds));
    // No hit comes before it, so that none ends the search.
    Some(Interval { min: f32::NEG_INFINITY, max: f32::INFINITY })
}

fn on_the_way(bounds: &Aabb, ray: &Ray, within: Interval) -> Option<Interval> {
    let way = BoxProbe::new(ray, bounds.magnitude()).clip(*bounds, within);
    if way.is_some() {
        ASKED.with_borrow_mut(|asked| asked.push(*bounds));
    }
    way
}

/// Small ones in two heaps, and a few large ones.
fn spheres() -> Vec<Sphere> {
    let heap = |x: f32, y: f32, count: u32| {
        // Each by the golden angle further round than the last: its cosine and sine, so that the figure is the same everywhere.
        let turn = Vec2::new(-0.737_369, 0.675_490);
        let turns = std::iter::successors(Some(Vec2::X), move |last| Some(turn.rotate(*last)));
        (0..count).zip(turns).map(move |(number, turned)| {
            let place = Vec2::new(x, y) + 0.27 * (number as f32).sqrt() * turned;
            Sphere { center: place.extend(0.0), radius: 0.08 }
        })
    };
    let large = [(1.2, 6.4, 0.9), (6.9, 1.3, 1.0), (4.6, 4.4, 0.45), (0.9, 3.2, 0.35), (7.2, 4.3, 0.3)];
    let large = large.map(|(x, y, radius)| Sphere { center: Vec3::new(x, y, 0.0), radius });
    heap(2.3, 1.7, 40).chain(heap(6.0, 6.1, 50)).chain(large).collect()
}

/// The cells that a box test is asked about, each once, in their order; of two that lie one above the other the one that the drawing
/// plane passes.
fn cells(aabb: geometry::Clip, ray: &Ray) -> Vec<Aabb> {
    let mut primitives = Primitives::default();
    spheres().into_iter().for_each(|sphere| primitives.add_sphere(sphere));
    let kernels = Kernels { aabb: Some(aabb), ..Kernels::default() };
    octree(primitives.with_kernels(kernels)).closest(ray, Interval::FORWARD);
    let mut asked = ASKED.take();
    // The first is the box around all.
    asked.remove(0);
    asked.retain(|cell| cell.min.z <= ray.origin.z && ray.origin.z < cell.max.z);
    asked
}

fn main() {
    print!("{}", svg());
}

/// The figure.
pub fn svg() -> String {
    // A hair above the plane of all centres, which is the border between cells.
    let ray = Ray::new(Vec3::new(-0.1, 3.75, 0.01), Vec3::new(1.0, 0.31, 0.0));
    let all = cells(everything, &ray);
    let visited = cells(on_the_way, &ray);
    // A cell is divided if another that was asked about lies in it.
    let leaves: Vec<Aabb> =
        visited.iter().filter(|cell| !all.iter().any(|other| is_part(*other, **cell))).copied().collect();
    let mut primitives = Primitives::default();
    spheres().into_iter().for_each(|sphere| primitives.add_sphere(sphere));
    let hit = octree(primitives).closest(&ray, Interval::FORWARD);
    let mut svg = vec![
        concat!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="-16 -4 630 612" "#,
            r#"width="420" height="400" font-family="sans-serif">"#
        )
        .to_owned(),
        r##"<rect x="-16" y="-4" width="630" height="612" fill="#fff"/>"##.to_owned(),
    ];
    svg.extend(leaves.iter().map(|cell| rect(*cell, "#ffe9b8", "none")));
    svg.extend(all.iter().map(|cell| rect(*cell, "none", "#7a869a")));
    for (number, Sphere { center, radius }) in (0..).zip(spheres()) {
        let fill = if hit.is_some_and(|hit| hit.primitive == number) { "#d1495b" } else { "#8fb8de" };
        svg.push(format!(
            r##"<circle cx="{:.1}" cy="{:.1}" r="{:.1}" fill="{fill}" fill-opacity=".8" stroke="#30475e"/>"##,
            across(center.x),
            down(center.y),
            radius * SCALE
        ));
    }
    let end = ray.at(hit.map_or(9.0, |hit| f64::from(hit.t))).as_vec3();
    svg.push(format!(
        r##"<line x1="{:.1}" y1="{:.1}" x2="{:.1}" y2="{:.1}" stroke="#d1495b" stroke-width="2"/>"##,
        across(ray.origin.x),
        down(ray.origin.y),
        across(end.x),
        down(end.y)
    ));
    for (number, cell) in (1..).zip(&leaves) {
        let (x, y) = (across(cell.min.x) + 2.0, down(cell.max.y) + 12.0);
        svg.push(format!(r##"<text x="{x:.1}" y="{y:.1}" font-size="12" fill="#333">{number}</text>"##));
    }
    svg.push("</svg>\n".to_owned());
    svg.join("\n")
}

fn is_part(small: Aabb, large: Aabb) -> bool {
    let center = Aabb::around([small.center()]);
    small.extent().x < 0.75 * large.extent().x && large.contains(center)
}

/// Pixels for a unit: the root's edge is about 8.
const SCALE: f32 = 75.0;

fn across(x: f32) -> f32 {
    SCALE * x
}

/// Up is up.
fn down(y: f32) -> f32 {
    600.0 - SCALE * y
}

fn rect(cell: Aabb, fill: &str, stroke: &str) -> String {
    let size = cell.extent() * SCALE;
    format!(
        r#"<rect x="{:.1}" y="{:.1}" width="{:.1}" height="{:.1}" fill="{fill}" stroke="{stroke}"/>"#,
        across(cell.min.x),
        down(cell.max.y),
        size.x,
        size.y
    )
}
