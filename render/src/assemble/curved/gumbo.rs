use geometry::Mesh;
use glam::DVec3;
use scene_format::scene_file::Subdivision;

use super::patchwork::Patchwork;

/// How many patches the elephant has.
pub(in super::super) const GUMBO_PATCHES: usize = 128;

/// The patches' points, and whose they are.
const POINTS: &str = include_str!("gumbo.txt");

/// Catmull's elephant: about 24 long, 19 wide and 21 high, on the plane z = 0.
pub(in super::super) fn gumbo(subdivision: &Subdivision) -> Mesh {
    let mut patches = Patchwork::default();
    for controls in controls() {
        patches.add_patch(&controls, subdivision);
    }
    patches.finish()
}

/// The 16 points of each patch.
fn controls() -> impl Iterator<Item = [[DVec3; 4]; 4]> {
    let lines = POINTS.lines().filter(|line| !line.starts_with('%'));
    lines.filter_map(|line| {
        let numbers: Vec<f64> = line.split(' ').filter_map(|word| word.parse().ok()).collect();
        let points: Vec<DVec3> = numbers.as_chunks().0.iter().copied().map(DVec3::from_array).collect();
        let (rows, _) = points.as_chunks();
        rows.try_into().ok()
    })
}

#[cfg(test)]
mod tests {
    use super::super::triangles_of;
    use super::*;

    #[test]
    fn the_elephant_has_all_its_patches_and_stands_on_the_ground() {
        assert_eq!(controls().count(), GUMBO_PATCHES);
        let made = gumbo(&Subdivision::default());
        let (mut min, mut max) = (glam::Vec3::INFINITY, glam::Vec3::NEG_INFINITY);
        for position in &made.positions {
            (min, max) = (min.min(*position), max.max(*position));
        }
        // The soles bulge a little downwards; the ears stand out on both sides of the plane y = 7 that halves it.
        assert!((-1.0..=0.0).contains(&min.z) && (18.0..21.0).contains(&max.z), "{min} {max}");
        assert!((min.y + max.y - 14.0).abs() < 0.1 && max.y - min.y > 15.0, "{min} {max}");
        assert!(made.triangles.len() <= triangles_of(GUMBO_PATCHES, &Subdivision::default()).unwrap());
    }
}
