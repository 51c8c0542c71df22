//! Figure 3: where new rays start.

use geometry::{Interval, Mesh, Primitives, Ray, RayOrigin, Sphere, Surface, Transform, naive, unit_cube};
use glam::{DVec3, Vec3};
use render::Modules;
use serde_json::{Value, json};

use super::chart::{Chart, Line, Series};
use super::figure::{BLUE, Figure, GREEN, GREY, Key, Mark, ORANGE, PINK, Part};
use super::random::Random;
use super::steps::Steps;
use super::{Effort, text};
use crate::report::Failure;
use crate::table::Align;

/// Sizes of the bodies: 1e-3 to 1e6.
const DECADES: std::ops::RangeInclusive<i32> = -3..=6;

/// Steps of [`figure`]: one for each body and size.
pub(crate) const STEPS: usize = 20;

/// The second surface's distance from the first, in sizes.
const GAP: f64 = 1e-5;

/// A way to start a new ray.
struct Way {
    name: &'static str,
    color: [u8; 3],
    mark: Mark,
    point: Point,
    origin: RayOrigin,
}

/// Where the surface is taken to be.
#[derive(Clone, Copy, PartialEq)]
enum Point {
    /// The point of the primitive itself.
    OfSurface,
    /// `o + t d` in `f32`.
    AlongRay,
}

fn ways(modules: &Modules) -> Vec<Way> {
    let way = |name, color, mark, point, origin| Way { name, color, mark, point, origin };
    let mut ways = vec![
        way("no offset", GREY, Mark::Ring, Point::AlongRay, (|surface, _| surface.position) as RayOrigin),
        way("t from 10⁻⁴ on", PINK, Mark::Ring, Point::AlongRay, naive::offset_along_ray),
        way("10⁻⁴ along the normal", ORANGE, Mark::Ring, Point::AlongRay, naive::offset_along_normal),
        way("girasol: by the error bound", BLUE, Mark::Disc, Point::OfSurface, Surface::origin_towards),
    ];
    if is_somebodys_own(modules.ray_origin) {
        ways.push(way("yours", GREEN, Mark::Square, Point::OfSurface, modules.ray_origin));
    }
    ways
}

/// Whether a way to start differs from girasol's on a few surfaces: functions themselves cannot be compared.
fn is_somebodys_own(origin: RayOrigin) -> bool {
    let mut random = Random::new(0, "somebody's own");
    (0..100).any(|_| {
        let point = (random.direction() * random.magnitude(1e-3, 1e6)).as_vec3();
        let surface = Surface::rounded(point, point.abs().max_element(), random.direction().as_vec3());
        let direction = random.direction();
        origin(&surface, direction) != surface.origin_towards(direction)
    })
}

/// What went wrong, as shares of the rays.
#[derive(Clone, Copy, Default)]
struct Wrong {
    acne: f64,
    leaks: f64,
}

pub(crate) fn figure(modules: &Modules, effort: &Effort, steps: &Steps) -> Result<Figure, Failure> {
    let ways = ways(modules);
    let sizes: Vec<f64> = DECADES.map(|decade| libm::exp10(f64::from(decade))).collect();
    let key = |way: &Way| Key { color: way.color, mark: way.mark, name: way.name.to_owned() };
    let mut parts = vec![Part::Legend(ways.iter().map(key).collect())];
    let mut data = Vec::new();
    let mut rows = Vec::new();
    for (body, enclose) in [("sphere", nested_spheres as Enclose), ("cube", nested_cubes)] {
        let mut found: Vec<Vec<Wrong>> = ways.iter().map(|_| Vec::new()).collect();
        for &size in &sizes {
            for (found, wrong) in found.iter_mut().zip(measured(body, enclose, size, &ways, effort)) {
                found.push(wrong);
            }
            steps.advance();
        }
        let chart = |name: &str, what: &str, of: fn(&Wrong) -> f64| {
            chart(&format!("{name}: {body}"), what, &sizes, &ways, &found, of)
        };
        parts.push(Part::Row(vec![
            chart("Acne", "rays that meet what they leave, share", |wrong| wrong.acne)?,
            chart("Leaks", "rays that jump over a near surface, share", |wrong| wrong.leaks)?,
        ]));
        for (way, found) in ways.iter().zip(&found) {
            let list = |of: fn(&Wrong) -> f64| found.iter().map(of).collect::<Vec<_>>();
            let (acne, leaks) = (list(|wrong| wrong.acne), list(|wrong| wrong.leaks));
            data.push(json!({ "body": body, "way": way.name, "sizes": sizes, "acne": acne, "leaks": leaks }));
            for (what, shares) in [("acne", acne), ("leaks", leaks)] {
                let mut row = vec![body.to_owned(), way.name.to_owned(), what.to_owned()];
                row.extend(shares.into_iter().map(text::share));
                rows.push(row);
            }
        }
    }
    let mut headings: Vec<_> = ["body", "way", "what"].map(|name| (name.to_owned(), Align::Left)).into();
    headings.extend(sizes.iter().map(|size| (format!("{size}"), Align::Right)));
    parts.push(Part::Folded { title: "In numbers".to_owned(), parts: vec![Part::Table { headings, rows }] });
    Ok(Figure {
        id: "new-rays",
        title: "Acne and leaks, for each way to start a new ray",
        caption: "A camera ray meets a body, and a new ray leaves it outwards, into a shell that lies 10⁻⁵ of the size above. It must \
                  not meet the body again (acne: a surface shadows itself) and must meet the shell (else light leaks through \
                  a wall). A constant offset knows one scale: in small scenes it jumps over walls, in large ones it drowns in rounding. \
                  Without any offset up to half of all rays start behind the surface. Girasol moves each ray by the error bound of its \
                  own point: 0 of both, at every scale. All other kernels are girasol's here."
            .to_owned(),
        parts,
        data: Value::from(data),
    })
}

fn chart(
    title: &str,
    y_label: &str,
    sizes: &[f64],
    ways: &[Way],
    found: &[Vec<Wrong>],
    of: fn(&Wrong) -> f64,
) -> Result<Part, Failure> {
    let series = |(way, found): (&Way, &Vec<Wrong>)| Series {
        color: way.color,
        mark: way.mark,
        line: Line::Full,
        points: sizes.iter().zip(found).map(|(&size, wrong)| [size, of(wrong)]).collect(),
        label: None,
    };
    let chart = Chart {
        title: title.to_owned(),
        x_label: "size of the body, in the scene's units".to_owned(),
        y_label: y_label.to_owned(),
        x: [sizes[0], sizes[sizes.len() - 1]],
        y: [1e-5, 1.0],
        y_floor: Some("0"),
        series: ways.iter().zip(found).map(series).collect(),
    };
    Ok(Part::Svg { svg: chart.svg()?, alt: format!("{title}: {y_label}, against the size of the body") })
}

/// A body of a size around a centre, and a shell just above it.
type Enclose = fn(Vec3, f64) -> [Primitives; 2];

fn nested_spheres(center: Vec3, size: f64) -> [Primitives; 2] {
    [size, size * (1.0 + GAP)].map(|radius| {
        let mut primitives = Primitives::default();
        primitives.add_sphere(Sphere { center, radius: radius as f32 });
        primitives
    })
}

fn nested_cubes(center: Vec3, size: f64) -> [Primitives; 2] {
    [size, size * (1.0 + GAP)].map(|half| {
        let place = Transform::scale(DVec3::splat(2.0 * half)).then(&Transform::translation(center.as_dvec3()));
        let Mesh { positions, triangles, .. } = unit_cube();
        let positions = positions.into_iter().map(|point| place.point_f32(point)).collect();
        let mut primitives = Primitives::default();
        primitives.add_mesh(Mesh { positions, triangles, ..Mesh::default() });
        primitives
    })
}

fn measured(body: &str, enclose: Enclose, size: f64, ways: &[Way], effort: &Effort) -> Vec<Wrong> {
    let mut random = Random::new(effort.seed, &format!("new rays, {body} {size:e}"));
    let mut wrong = vec![Wrong::default(); ways.len()];
    let mut rays = 0.0;
    for _ in 0..effort.cases {
        let center = (random.direction() * (2.0 * size)).as_vec3();
        let [body, shell] = enclose(center, size);
        let eye = center.as_dvec3() + random.direction() * size * random.between(2.0, 10.0);
        let target = center.as_dvec3() + random.direction() * size * random.unit();
        let ray = Ray::new(eye.as_vec3(), (target - eye).normalize().as_vec3());
        let Some(hit) = closest(&body, &ray) else { continue };
        let surface = body.surface(&ray, &hit);
        let direction = random.direction();
        let outward = direction * direction.dot(surface.geometric_normal.as_dvec3()).signum();
        rays += 1.0;
        for (wrong, way) in wrong.iter_mut().zip(ways) {
            let position = match way.point {
                Point::OfSurface => surface.position,
                Point::AlongRay => naive::hit_point(&ray, hit.t),
            };
            let origin = (way.origin)(&Surface { position, ..surface }, outward);
            let new = Ray::new(origin, outward.as_vec3());
            if closest(&body, &new).is_some() {
                wrong.acne += 1.0;
            }
            if closest(&shell, &new).is_none() {
                wrong.leaks += 1.0;
            }
        }
    }
    wrong.iter().map(|wrong| Wrong { acne: wrong.acne / rays, leaks: wrong.leaks / rays }).collect()
}

fn closest(primitives: &Primitives, ray: &Ray) -> Option<geometry::Hit> {
    let hits = (0..primitives.len()).filter_map(|number| primitives.intersect(number, ray, Interval::FORWARD));
    hits.reduce(|nearest, hit| if hit.is_before(nearest) { hit } else { nearest })
}
