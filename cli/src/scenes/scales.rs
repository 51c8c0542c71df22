use std::fmt::Write;

use glam::DVec3;

use super::mesh::on_circle;

/// How large the four still lifes are.
const SIZES: [f64; 4] = [1e-3, 1.0, 1e3, 1e6];
/// The middle of the first table, in sizes from the eye; the next ones stand further right.
const FIRST: DVec3 = DVec3::new(-3.3, 10.0, -3.0);
const APART: f64 = 2.2;
/// Triangles of each table: thin ones.
const SLICES: u32 = 40;

/// The same still life at four sizes, as far away as they are large.
pub(super) fn scene() -> String {
    let mut text = include_str!("../../scenes/scales.sc").to_owned();
    for (column, size) in (0..).zip(SIZES) {
        let middle = FIRST + DVec3::X * APART * f64::from(column);
        // Numbers are written out in full, whatever their size.
        let at = |offset: DVec3| {
            let place = (middle + offset) * size;
            format!("{:e} {:e} {:e}", place.x, place.y, place.z)
        };
        let _ = write!(
            text,
            "\nobject {{\n  shader table\n  type generic-mesh\n  name table{column}\n  points {}\n    {}\n",
            SLICES + 1,
            at(DVec3::ZERO)
        );
        for corner in 0..SLICES {
            let _ = writeln!(text, "    {}", at(on_circle(corner, SLICES)));
        }
        let _ = writeln!(text, "  triangles {SLICES}");
        for corner in 0..SLICES {
            let _ = writeln!(text, "    0 {} {}", corner + 1, (corner + 1) % SLICES + 1);
        }
        let _ = write!(
            text,
            "  normals none\n  uvs none\n}}\nobject {{\n  shader cube\n  transform {{\n    scaleu {:e}\n    rotatez 25\n    \
             translate {}\n  }}\n  type box\n  name cube{column}\n}}\n",
            0.62 * size,
            at(DVec3::new(0.33, 0.3, 0.31))
        );
        for (shader, radius, x, y) in [("ball", 0.33, -0.42, 0.2), ("glass", 0.24, 0.05, -0.5)] {
            let _ = write!(
                text,
                "object {{\n  shader {shader}\n  type sphere\n  name {shader}{column}\n  c {}\n  r {:e}\n}}\n",
                at(DVec3::new(x, y, radius)),
                radius * size
            );
        }
    }
    text
}
