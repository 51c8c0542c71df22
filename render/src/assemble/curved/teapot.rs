use geometry::Mesh;
use glam::DVec3;
use scene_format::scene_file::Subdivision;

use super::patchwork::Patchwork;

/// How many patches the teapot has.
pub(in super::super) const TEAPOT_PATCHES: usize = 4 * PROFILES.len() + 2 * RIBBONS.len();

/// Curves of four points, radius and height, that are turned around the z axis: the lower and upper body, the rim, its inside, the
/// lid and its knob. (Newell's teapot of 1975, forty times its size, as it stands in Sunflow.)
const PROFILES: [[[f64; 2]; 4]; 6] = [
    [[80.0, 30.0], [80.0, 12.0], [60.0, 3.0], [60.0, 0.0]],
    [[60.0, 90.0], [70.0, 69.0], [80.0, 48.0], [80.0, 30.0]],
    [[56.0, 90.0], [53.5, 95.25], [57.5, 95.25], [60.0, 90.0]],
    [[50.0, 90.0], [52.0, 90.0], [54.0, 90.0], [56.0, 90.0]],
    [[8.0, 102.0], [16.0, 96.0], [52.0, 96.0], [52.0, 90.0]],
    [[0.0, 120.0], [32.0, 120.0], [0.0, 108.0], [8.0, 102.0]],
];

/// Bent tubes, the handle's two halves and the spout's: four rings, of each the inner place (x, z), the outer one, and half its
/// width.
const RIBBONS: [[[f64; 5]; 4]; 4] = [
    [
        [-64.0, 75.0, -60.0, 84.0, 12.0],
        [-92.0, 75.0, -100.0, 84.0, 12.0],
        [-108.0, 75.0, -120.0, 84.0, 12.0],
        [-108.0, 66.0, -120.0, 66.0, 12.0],
    ],
    [
        [-108.0, 66.0, -120.0, 66.0, 12.0],
        [-108.0, 57.0, -120.0, 48.0, 12.0],
        [-100.0, 39.0, -106.0, 31.5, 12.0],
        [-80.0, 30.0, -76.0, 18.0, 12.0],
    ],
    [
        [68.0, 51.0, 68.0, 18.0, 26.4],
        [104.0, 51.0, 124.0, 27.0, 26.4],
        [92.0, 78.0, 96.0, 75.0, 10.0],
        [108.0, 90.0, 132.0, 90.0, 10.0],
    ],
    [
        [108.0, 90.0, 132.0, 90.0, 10.0],
        [112.0, 93.0, 141.0, 93.75, 10.0],
        [116.0, 93.0, 138.0, 94.5, 6.0],
        [112.0, 90.0, 128.0, 90.0, 6.0],
    ],
];

pub(in super::super) fn teapot(subdivision: &Subdivision) -> Mesh {
    /// How far the inner points of a curve lie from its ends, for a quarter of a circle; Newell's choice (0.5523 is nearer).
    const QUARTER: f64 = 0.56;
    let mut patches = Patchwork::default();
    for profile in PROFILES {
        for quarter in 0..4 {
            let turned = |x: f64, y: f64| match quarter {
                0 => [-x, -y],
                1 => [y, -x],
                2 => [x, y],
                _ => [-y, x],
            };
            let circle = [[1.0, 0.0], [1.0, QUARTER], [QUARTER, 1.0], [0.0, 1.0]].map(|[x, y]| turned(x, y));
            let row = |[radius, height]: [f64; 2]| circle.map(|[x, y]| DVec3::new(radius * x, radius * y, height));
            patches.add_patch(&profile.map(row), subdivision);
        }
    }
    for ribbon in RIBBONS {
        let side = |[x, z, other_x, other_z, width]: [f64; 5]| {
            [[x, 0.0, z], [x, width, z], [other_x, width, other_z], [other_x, 0.0, other_z]].map(DVec3::from)
        };
        patches.add_patch(&ribbon.map(side), subdivision);
        let mirrored = |ring| {
            let [a, b, c, d] = side(ring).map(|point| point * DVec3::new(1.0, -1.0, 1.0));
            [d, c, b, a]
        };
        patches.add_patch(&ribbon.map(mirrored), subdivision);
    }
    patches.finish()
}

#[cfg(test)]
mod tests {
    use super::super::triangles_of;
    use super::*;

    #[test]
    fn the_teapot_is_as_large_as_newell_s() {
        let made = teapot(&Subdivision::default());
        let (mut min, mut max) = (glam::Vec3::INFINITY, glam::Vec3::NEG_INFINITY);
        for position in &made.positions {
            (min, max) = (min.min(*position), max.max(*position));
        }
        // The handle's and spout's curves stay within their points at -120 and 141; the lid's knob reaches 120.
        assert!((-121.0..-110.0).contains(&min.x) && (130.0..141.0).contains(&max.x), "{min} {max}");
        assert_eq!((min.z, max.z), (0.0, 120.0));
        assert!((max.y - 80.0).abs() < 0.2 && (min.y + 80.0).abs() < 0.2, "{min} {max}");
        assert!(triangles_of(TEAPOT_PATCHES, &Subdivision::default()) == Some(32 * 128));
    }
}
