use glam::DVec3;
use std::f64::consts::TAU;
use std::fmt::Write;

/// A radius below this is 0 but for rounding.
const ON_AXIS: f64 = 1e-9;

/// Triangles with a normal at each vertex, counter-clockwise seen from outside: what the big scenes are built of.
///
/// Only `+ - * /`, square roots and the crate `libm` make the numbers, so that a scene is the same text on every machine.
#[derive(Debug, Default)]
pub(super) struct Mesh {
    /// The points.
    pub(super) points: Vec<DVec3>,
    /// The unit normals at the points.
    pub(super) normals: Vec<DVec3>,
    /// Three indices into the points each.
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// Adds a vertex, and returns its index.
    pub(super) fn vertex(&mut self, point: DVec3, normal: DVec3) -> u32 {
        self.points.push(point);
        self.normals.push(normal);
        u32::try_from(self.points.len() - 1).expect("a scene's mesh is far smaller than 2^32 points")
    }

    /// A tube around a path of at least two points, closed by a flat disc at each end.
    pub(super) fn tube(&mut self, path: &[DVec3], radius: f64, sides: u32) {
        let last = path.len() - 1;
        let tangent = |i: usize| (path[(i + 1).min(last)] - path[i.saturating_sub(1)]).normalize();
        let mut across = tangent(0).any_orthonormal_vector();
        let mut rings = Vec::with_capacity(path.len());
        for (i, &center) in path.iter().enumerate() {
            // The frame of the ring before, turned as little as possible, so that the tube is not wrung.
            across = across.reject_from_normalized(tangent(i)).normalize();
            rings.push(self.circle(center, across, tangent(i).cross(across), radius, sides));
        }
        for pair in rings.windows(2) {
            self.band(pair[0], pair[1], sides);
        }
        self.disc(path[0], -tangent(0), radius, sides);
        self.disc(path[last], tangent(last), radius, sides);
    }

    /// A straight, closed tube.
    pub(super) fn rod(&mut self, from: DVec3, to: DVec3, radius: f64, sides: u32) {
        self.tube(&[from, to], radius, sides);
    }

    /// A flat disc that looks along the unit vector `normal`.
    pub(super) fn disc(&mut self, center: DVec3, normal: DVec3, radius: f64, sides: u32) {
        let across = normal.any_orthonormal_vector();
        let rim = self.circle(center, across, normal.cross(across), radius, sides);
        let middle = self.vertex(center, normal);
        for i in 0..sides {
            self.normals[(rim + i) as usize] = normal;
            self.triangles.push([middle, rim + i, rim + (i + 1) % sides]);
        }
    }

    /// A ring (torus) around a vertical axis.
    pub(super) fn ring(&mut self, center: DVec3, radius: f64, thickness: f64, segments: u32, sides: u32) {
        let first = self.points.len() as u32;
        for i in 0..segments {
            let outward = on_circle(i, segments);
            self.circle(center + outward * radius, outward, DVec3::Z, thickness, sides);
        }
        for i in 0..segments {
            // The circles run from outward to up, against the way around the axis: hence the swapped bands.
            self.band(first + (i + 1) % segments * sides, first + i * sides, sides);
        }
    }

    /// A surface of revolution around the vertical axis through the origin. The profile is (radius, height), with the outside on
    /// its right. It is smooth: an edge is made by two profiles that end in the same point.
    pub(super) fn lathe(&mut self, profile: &[(f64, f64)], segments: u32) {
        let last = profile.len() - 1;
        let first = self.points.len() as u32;
        for (i, &(radius, height)) in profile.iter().enumerate() {
            let (before, after) = (profile[i.saturating_sub(1)], profile[(i + 1).min(last)]);
            let (along_radius, along_height) = (after.0 - before.0, after.1 - before.1);
            for segment in 0..segments {
                let outward = on_circle(segment, segments);
                let normal = (outward * along_height - DVec3::Z * along_radius).normalize();
                self.vertex(outward * radius + DVec3::Z * height, normal);
            }
        }
        for i in 0..last {
            let (low, high) = (first + i as u32 * segments, first + (i as u32 + 1) * segments);
            for segment in 0..segments {
                let next = (segment + 1) % segments;
                // A point on the axis is no edge: there one triangle is enough.
                if profile[i].0 > ON_AXIS {
                    self.triangles.push([low + segment, low + next, high + next]);
                }
                if profile[i + 1].0 > ON_AXIS {
                    self.triangles.push([low + segment, high + next, high + segment]);
                }
            }
        }
    }

    /// The mesh as an `object` of type `generic-mesh`.
    pub(super) fn object(&self, name: &str, shader: &str) -> String {
        let mut text = format!("\nobject {{\n  shader {shader}\n  type generic-mesh\n  name {name}\n");
        let mut lines = |heading: &str, rows: &mut dyn Iterator<Item = String>| {
            let _ = writeln!(text, "  {heading}");
            for row in rows {
                let _ = writeln!(text, "    {row}");
            }
        };
        lines(&format!("points {}", self.points.len()), &mut self.points.iter().map(|&p| numbers(p, 5)));
        let corners = self.triangles.iter().map(|[a, b, c]| format!("{a} {b} {c}"));
        lines(&format!("triangles {}", self.triangles.len()), &mut { corners });
        lines("normals vertex", &mut self.normals.iter().map(|&n| numbers(n, 4)));
        text.push_str("  uvs none\n}\n");
        text
    }

    /// A circle's vertices, their normals outward; the index of the first one.
    fn circle(&mut self, center: DVec3, across: DVec3, along: DVec3, radius: f64, sides: u32) -> u32 {
        let first = self.points.len() as u32;
        for i in 0..sides {
            let place = on_circle(i, sides);
            let normal = across * place.x + along * place.y;
            self.vertex(center + normal * radius, normal);
        }
        first
    }

    /// Joins two circles whose first vertices are given, the second one further along the axis that they turn around.
    fn band(&mut self, near: u32, far: u32, sides: u32) {
        for i in 0..sides {
            let next = (i + 1) % sides;
            self.triangles.push([near + i, near + next, far + next]);
            self.triangles.push([near + i, far + next, far + i]);
        }
    }
}

/// The corner `i` of a regular polygon on the unit circle around the vertical axis.
pub(super) fn on_circle(i: u32, corners: u32) -> DVec3 {
    let angle = TAU * f64::from(i) / f64::from(corners);
    DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
}

/// Three numbers with that many decimals, without idle zeros.
fn numbers(vector: DVec3, decimals: usize) -> String {
    vector.to_array().map(|number| short(number, decimals)).join(" ")
}

/// A number with that many decimals, without idle zeros.
pub(super) fn short(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six times the volume that the triangles enclose: positive if they are counter-clockwise seen from outside.
    fn volume(mesh: &Mesh) -> f64 {
        let at = |i: u32| mesh.points[i as usize];
        mesh.triangles.iter().map(|&[a, b, c]| at(a).dot(at(b).cross(at(c)))).sum()
    }

    fn normals_agree_with_winding(mesh: &Mesh) -> bool {
        let at = |i: u32| mesh.points[i as usize];
        mesh.triangles.iter().all(|&corners| {
            let [a, b, c] = corners.map(at);
            corners.iter().all(|&i| (b - a).cross(c - a).dot(mesh.normals[i as usize]) > 0.0)
        })
    }

    #[test]
    fn a_tube_is_counter_clockwise_seen_from_outside() {
        let mut mesh = Mesh::default();
        mesh.tube(&[DVec3::ZERO, DVec3::X, DVec3::new(2.0, 0.2, 0.1)], 0.1, 8);
        assert!(volume(&mesh) > 0.0 && normals_agree_with_winding(&mesh));
    }

    #[test]
    fn a_ring_is_counter_clockwise_seen_from_outside() {
        let mut mesh = Mesh::default();
        mesh.ring(DVec3::Z, 2.0, 0.2, 24, 8);
        assert!(volume(&mesh) > 0.0 && normals_agree_with_winding(&mesh));
    }

    #[test]
    fn a_lathed_cone_is_counter_clockwise_seen_from_outside() {
        let mut mesh = Mesh::default();
        mesh.lathe(&[(0.0, -1.0), (1.0, 0.0), (0.0, 1.0)], 12);
        assert!(volume(&mesh) > 0.0);
    }

    #[test]
    fn numbers_are_written_without_idle_zeros() {
        assert_eq!([1.5, -0.0, -0.000_001, 10.0, 0.123_456_7].map(|n| short(n, 5)).join(" "), "1.5 0 0 10 0.12346");
        assert_eq!(short(100.0, 0), "100");
    }
}
