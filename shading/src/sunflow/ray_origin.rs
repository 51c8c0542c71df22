use geometry::Surface;
use glam::{DVec3, Vec3};

/// How far Sunflow's rays start off a surface, at least, in the scene's units: a scene of that size is full of its traces.
const LEAST_BIAS: f32 = 0.001;

/// The same in units in the last place of the coordinate on the axis nearest to the normal.
const LEAST_BIAS_IN_ULPS: f32 = 25.0;

/// Where Sunflow's rays start: `max(0.001, 25 ulp(p))` off the point along the geometric normal, which is taken as long as it is; p is the
/// coordinate on the axis nearest to it. As a [`geometry::RayOrigin`].
pub fn ray_origin(surface: &Surface, direction: DVec3) -> Vec3 {
    let normal = surface.geometric_normal;
    let position = surface.position.abs();
    // Nearly always: no coordinate is so great that its units count.
    let bias = if position.max_element() < FAR_OUT { LEAST_BIAS } else { bias(normal.abs(), position) };
    surface.position + normal * if direction.as_vec3().dot(normal) < 0.0 { -bias } else { bias }
}

/// Below it, 25 units in the last place are less than a thousandth: 25 x 2^-15 = 0.00076.
const FAR_OUT: f32 = 512.0;

#[cold]
fn bias(nearness: Vec3, position: Vec3) -> f32 {
    let coordinate = if nearness.x > nearness.y && nearness.x > nearness.z {
        position.x
    } else if nearness.y > nearness.z {
        position.y
    } else {
        position.z
    };
    LEAST_BIAS.max(LEAST_BIAS_IN_ULPS * (coordinate.next_up() - coordinate))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(position: Vec3, normal: Vec3) -> Surface {
        Surface::rounded(position, 0.0, normal)
    }

    #[test]
    fn rays_start_a_thousandth_off_on_the_side_they_go_to() {
        let floor = at(Vec3::new(5.0, 5.0, 0.0), Vec3::Z);
        assert_eq!(ray_origin(&floor, DVec3::new(3.0, 0.0, 0.1)), Vec3::new(5.0, 5.0, 0.001));
        assert_eq!(ray_origin(&floor, DVec3::new(3.0, 0.0, -0.1)), Vec3::new(5.0, 5.0, -0.001));
        // Twice the normal is twice as far.
        assert_eq!(ray_origin(&at(Vec3::ZERO, 2.0 * Vec3::Z), DVec3::Z), Vec3::new(0.0, 0.0, 0.002));
    }

    #[test]
    fn where_units_in_the_last_place_are_not_looked_at_they_do_not_count() {
        assert_eq!(bias(Vec3::X, Vec3::splat(FAR_OUT.next_down())), LEAST_BIAS);
        assert!(bias(Vec3::X, Vec3::splat(2.0 * FAR_OUT)) > LEAST_BIAS);
    }

    #[test]
    fn far_out_it_is_25_units_in_the_last_place_along_the_normals_longest_axis() {
        // From 2^23 to 2^24 a unit in the last place is 1.
        let far = Vec3::new(1.0, 8_388_608.0, 1.0);
        assert_eq!(ray_origin(&at(far, Vec3::Y), DVec3::Y).y, 8_388_633.0);
        assert_eq!(ray_origin(&at(far, Vec3::X), DVec3::X).x, 1.001);
        assert_eq!(ray_origin(&at(far, Vec3::Z), DVec3::Z).z, 1.001);
        for (far, normal) in [(Vec3::X, Vec3::X), (Vec3::Z, Vec3::Z)] {
            let far = Vec3::ONE + 8_388_607.0 * far;
            assert_eq!(ray_origin(&at(far, normal), normal.as_dvec3()), far + 25.0 * normal);
        }
        // Of axes that are equally near, the later one.
        let across = Vec3::new(8_388_608.0, 1.0, 1.0);
        assert_eq!(ray_origin(&at(across, Vec3::new(1.0, 1.0, 0.0)), DVec3::X).y, 1.001);
        assert_eq!(ray_origin(&at(across, Vec3::new(1.0, 0.0, 1.0)), DVec3::X).z, 1.001);
    }
}
