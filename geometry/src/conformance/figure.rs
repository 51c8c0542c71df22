use std::fmt::Write;

use glam::{DVec2, DVec3, dvec2};

use crate::{Aabb, Ray};

/// A drawing of one case: a ray, what it is to meet, and where; seen at right angles to a plane through the ray, which runs to
/// the right.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    origin: DVec3,
    right: DVec3,
    up: DVec3,
    /// Whether the ray that runs to the right is part of the case.
    has_ray: bool,
    marks: Vec<Mark>,
}

/// What a mark is drawn in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// What the scene consists of.
    Shape,
    /// Where it should be, by the law.
    Expected,
    /// Where the part put it.
    Found,
}

#[derive(Clone, Debug, PartialEq)]
enum Mark {
    Circle { center: DVec2, radius: f64 },
    Lines { points: Vec<DVec2>, ink: Ink },
    Point { at: DVec2, ink: Ink, label: String },
}

/// The picture's width, in pixels.
const WIDTH: f64 = 640.0;

/// Its height, in pixels.
const HEIGHT: f64 = 400.0;

/// What is left free around what it shows, in pixels.
const MARGIN: f64 = 60.0;

/// A ray's origin is shown if it is no further from the rest than so many times its size.
const FAR: f64 = 3.0;

impl Figure {
    /// The plane through a ray in which a point lies, such as the centre of what it is aimed at.
    pub fn through(ray: &Ray, point: DVec3) -> Self {
        let origin = ray.origin.as_dvec3();
        let right = ray.direction.as_dvec3().try_normalize().unwrap_or(DVec3::X);
        let beside = (point - origin).reject_from(right);
        let up = beside.try_normalize().unwrap_or_else(|| right.any_orthonormal_vector());
        Self { origin, right, up, has_ray: true, marks: Vec::new() }
    }

    /// The plane of x, to the right, and y, upwards, without a ray: places in a pixel, on a lens.
    pub fn flat() -> Self {
        Self { origin: DVec3::ZERO, right: DVec3::X, up: DVec3::Y, has_ray: false, marks: Vec::new() }
    }

    /// With a sphere.
    #[must_use]
    pub fn sphere(self, center: DVec3, radius: f64) -> Self {
        let center = self.seen(center);
        self.with(Mark::Circle { center, radius })
    }

    /// With a closed line through points.
    #[must_use]
    pub fn outline(self, corners: &[DVec3]) -> Self {
        let points = corners.iter().chain(corners.first()).map(|&corner| self.seen(corner)).collect();
        self.with(Mark::Lines { points, ink: Ink::Shape })
    }

    /// With the edges of a box.
    #[must_use]
    pub fn cuboid(self, aabb: &Aabb) -> Self {
        let [low, high] = [aabb.min.as_dvec3(), aabb.max.as_dvec3()];
        let face = |z: f64| {
            [(low.x, low.y), (high.x, low.y), (high.x, high.y), (low.x, high.y)].map(|(x, y)| DVec3::new(x, y, z))
        };
        let upright = |figure: Self, (bottom, top): (DVec3, DVec3)| figure.line(bottom, top, Ink::Shape);
        let faces = self.outline(&face(low.z)).outline(&face(high.z));
        face(low.z).into_iter().zip(face(high.z)).fold(faces, upright)
    }

    /// With a straight line, such as a normal or a ray that leaves.
    #[must_use]
    pub fn line(self, from: DVec3, to: DVec3, ink: Ink) -> Self {
        let points = vec![self.seen(from), self.seen(to)];
        self.with(Mark::Lines { points, ink })
    }

    /// With a point.
    #[must_use]
    pub fn point(self, at: DVec3, ink: Ink, label: impl Into<String>) -> Self {
        let at = self.seen(at);
        self.with(Mark::Point { at, ink, label: label.into() })
    }

    /// With the place on the ray at `t`, if there is one.
    #[must_use]
    pub fn hit(self, ray: &Ray, t: Option<f32>, ink: Ink) -> Self {
        match t.map(f64::from) {
            None => self,
            Some(t) => {
                let at = ray.origin.as_dvec3() + t * ray.direction.as_dvec3();
                self.point(at, ink, format!("t = {t}"))
            }
        }
    }

    fn with(mut self, mark: Mark) -> Self {
        self.marks.push(mark);
        self
    }

    fn seen(&self, point: DVec3) -> DVec2 {
        let from_origin = point - self.origin;
        dvec2(from_origin.dot(self.right), from_origin.dot(self.up))
    }

    /// As an SVG of 640 x 400 pixels. What is no number is left out.
    pub fn to_svg(&self) -> String {
        let (low, high) = self.extent();
        let size = (high - low).max(DVec2::splat(1e-300));
        let scale = ((WIDTH - 2.0 * MARGIN) / size.x).min((HEIGHT - 2.0 * MARGIN) / size.y);
        let middle = (low + high) / 2.0;
        let place = |point: DVec2| {
            let from_middle = (point - middle) * scale;
            dvec2(WIDTH / 2.0 + from_middle.x, HEIGHT / 2.0 - from_middle.y)
        };
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"13\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        );
        if self.has_ray {
            draw_ray(&mut svg, place(DVec2::ZERO));
        }
        for mark in self.marks.iter().filter(|mark| mark.is_finite()) {
            mark.draw(&mut svg, scale, place);
        }
        let key = [(Ink::Shape, "scene"), (Ink::Expected, "expected"), (Ink::Found, "found")];
        for (number, (ink, word)) in key.into_iter().enumerate() {
            let (x, color) = (12.0 + 90.0 * number as f64, ink.color());
            let _ = writeln!(svg, "<text x=\"{x}\" y=\"{}\" fill=\"{color}\">{word}</text>", HEIGHT - 10.0);
        }
        svg.push_str("</svg>\n");
        svg
    }

    /// The corners of what is shown.
    fn extent(&self) -> (DVec2, DVec2) {
        let mut low = DVec2::INFINITY;
        let mut high = DVec2::NEG_INFINITY;
        for mark in self.marks.iter().filter(|mark| mark.is_finite()) {
            let (least, most) = mark.extent();
            (low, high) = (low.min(least), high.max(most));
        }
        if low.x > high.x {
            return (DVec2::ZERO, DVec2::ONE);
        }
        if !self.has_ray {
            return (low, high);
        }
        // The ray's own height, and its origin if that is near.
        (low.y, high.y) = (low.y.min(0.0), high.y.max(0.0));
        let size = (high - low).max_element().max(f64::MIN_POSITIVE);
        if low.x > 0.0 && low.x < FAR * size {
            low.x = 0.0;
        }
        if high.x < 0.0 && -high.x < FAR * size {
            high.x = 0.0;
        }
        (low, high)
    }
}

/// A ray to the right, from where it starts, which may be off the left edge.
fn draw_ray(svg: &mut String, start: DVec2) {
    let from = start.x.max(8.0);
    let _ = writeln!(
        svg,
        "<path d=\"M{from:.2} {y:.2}H{end:.2}m-9 -5l9 5l-9 5\" fill=\"none\" stroke=\"#d08000\" stroke-width=\"1.5\"/>",
        y = start.y,
        end = WIDTH - 8.0
    );
    if start.x >= 8.0 {
        let _ = writeln!(svg, "<circle cx=\"{:.2}\" cy=\"{:.2}\" r=\"4\" fill=\"#d08000\"/>", start.x, start.y);
    }
}

impl Ink {
    fn color(self) -> &'static str {
        match self {
            Self::Shape => "#30507a",
            Self::Expected => "#1a8a3a",
            Self::Found => "#c02030",
        }
    }
}

impl Mark {
    fn is_finite(&self) -> bool {
        match self {
            Self::Circle { center, radius } => center.is_finite() && radius.is_finite(),
            Self::Point { at, .. } => at.is_finite(),
            Self::Lines { points, .. } => points.iter().all(|point| point.is_finite()),
        }
    }

    fn extent(&self) -> (DVec2, DVec2) {
        match self {
            Self::Circle { center, radius } => (*center - DVec2::splat(*radius), *center + DVec2::splat(*radius)),
            Self::Point { at, .. } => (*at, *at),
            Self::Lines { points, .. } => {
                let least = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
                (least, points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max))
            }
        }
    }

    fn draw(&self, svg: &mut String, scale: f64, place: impl Fn(DVec2) -> DVec2) {
        // Writing to a string cannot fail.
        let _ = match self {
            Self::Circle { center, radius } => {
                let (center, color) = (place(*center), Ink::Shape.color());
                let radius = radius * scale;
                writeln!(
                    svg,
                    "<circle cx=\"{:.2}\" cy=\"{:.2}\" r=\"{radius:.2}\" fill=\"{color}\" fill-opacity=\".08\" stroke=\"{color}\"/>",
                    center.x, center.y
                )
            }
            Self::Lines { points, ink } => {
                let points: Vec<String> =
                    points.iter().map(|&point| place(point)).map(|at| format!("{:.2},{:.2}", at.x, at.y)).collect();
                writeln!(svg, "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\"/>", points.join(" "), ink.color())
            }
            Self::Point { at, ink, label } => {
                let (at, color) = (place(*at), ink.color());
                // Expected above the ray, found below it: they may be one place.
                let below = if *ink == Ink::Found { 20.0 } else { -10.0 };
                writeln!(
                    svg,
                    "<circle cx=\"{0:.2}\" cy=\"{1:.2}\" r=\"4\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>\
                     <text x=\"{0:.2}\" y=\"{2:.2}\" fill=\"{color}\" text-anchor=\"middle\">{label}</text>",
                    at.x,
                    at.y,
                    at.y + below
                )
            }
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec3, dvec3};

    /// A ray 10 to the left of a unit sphere, up by half a radius.
    const RAY: Ray = Ray { origin: Vec3::new(-10.0, 0.5, 0.0), direction: Vec3::new(2.0, 0.0, 0.0) };

    #[test]
    fn a_case_is_drawn_to_scale() {
        let figure = Figure::through(&RAY, DVec3::ZERO).sphere(DVec3::ZERO, 1.0).hit(&RAY, Some(5.0), Ink::Found);
        let svg = figure.to_svg();
        // The sphere and the ray fill the height but for the margins: 280 for 2. It hangs below the ray, half a radius off.
        assert!(svg.contains(r##"<circle cx="320.00" cy="200.00" r="140.00" fill="#30507a""##), "{svg}");
        assert!(svg.contains("M8.00 270.00H632.00"), "{svg}");
        // At t = 5 the ray is over the sphere's centre.
        assert!(svg.contains(r##"<circle cx="320.00" cy="270.00" r="4" fill="none" stroke="#c02030""##), "{svg}");
    }

    #[test]
    fn a_near_origin_is_shown() {
        let ray = Ray { origin: Vec3::new(-3.0, 0.0, 0.0), ..RAY };
        let svg = Figure::through(&ray, DVec3::ZERO).sphere(DVec3::ZERO, 1.0).to_svg();
        // 4 are 520 pixels wide, from the origin to the sphere's far side.
        assert!(svg.contains(r#"<circle cx="60.00" cy="200.00" r="4""#), "{svg}");
    }

    #[test]
    fn what_is_no_number_is_left_out() {
        let nan = dvec3(f64::NAN, 0.0, 0.0);
        let figure =
            Figure::through(&RAY, nan).sphere(nan, 1.0).outline(&[DVec3::ZERO, nan]).point(nan, Ink::Found, "");
        let svg = figure.sphere(DVec3::ZERO, f64::INFINITY).to_svg();
        assert!(!svg.contains("NaN") && !svg.contains("inf") && !svg.contains("polyline"), "{svg}");
    }
}
