use glam::DVec3;
use scene_format::scene_file::Triple;

use super::super::placement::dvec3;

/// The spheres of a flake, centre and radius each: the first, and nine of a third of its size around it, six below and three above
/// as seen from where it grew. (Haines: A Proposal for Standard Graphics Environments, 1987; the angles are Sunflow's.)
pub(in super::super) fn sphereflake(level: u32, axis: Triple, radius: f32) -> Vec<(DVec3, f64)> {
    fn grow(spheres: &mut Vec<(DVec3, f64)>, level: u32, center: DVec3, radius: f64, up: DVec3) {
        spheres.push((center, radius));
        let Some(below) = level.checked_sub(1) else { return };
        let [x, y, z] = up.to_array();
        // The axis that `up` leans to least has no part in the first of the two others.
        let across = if x * x < y * y && x * x < z * z {
            DVec3::new(0.0, z, -y)
        } else if y * y < z * z {
            DVec3::new(z, 0.0, -x)
        } else {
            DVec3::new(y, -x, 0.0)
        };
        let second = up.cross(across.normalize_or_zero());
        let first = up.cross(second);
        let step = std::f64::consts::PI / 3.0;
        let lower = (0..6).map(|number| (-0.3, f64::from(number) * step));
        let upper = (0..3).map(|number| (0.6, f64::from(6 * 3 - 1 + 6 * number) * step / 3.0));
        for (height, angle) in lower.chain(upper) {
            let (sin, cos) = libm::sincos(angle);
            let out = (up * height + first * sin + second * cos).normalize_or_zero();
            grow(spheres, below, center + out * (radius * 4.0 / 3.0), radius / 3.0, out);
        }
    }
    let mut spheres = Vec::new();
    grow(&mut spheres, level, DVec3::ZERO, f64::from(radius).abs(), dvec3(axis).normalize_or_zero());
    spheres
}

/// How often a flake is grown at most: to 597,871 spheres.
pub(in super::super) const DEEPEST_FLAKE: u32 = 6;

/// How many spheres a flake has, if that can be counted: 1 + 9 + 81 ...
pub(in super::super) fn spheres_of(level: u32) -> Option<usize> {
    Some((9usize.checked_pow(level.checked_add(1)?)? - 1) / 8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_sphere_of_a_flake_touches_the_one_it_grows_from() {
        let spheres = sphereflake(2, [0.0, 0.0, 2.0], 3.0);
        assert_eq!(Some(spheres.len()), spheres_of(2));
        assert_eq!(spheres[0], (DVec3::ZERO, 3.0));
        for (center, radius) in spheres.iter().filter(|(_, radius)| *radius == 1.0) {
            assert!((center.length() - 4.0).abs() < 1e-12 && *radius == 1.0);
        }
        assert_eq!(spheres.iter().filter(|(_, radius)| *radius == 1.0).count(), 9);
        // Three above, six below.
        assert_eq!(spheres.iter().filter(|(center, radius)| *radius == 1.0 && center.z > 0.0).count(), 3);
        assert_eq!(spheres_of(40), None);
    }
}
