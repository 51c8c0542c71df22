//! What mirrors and glass do to a ray. Directions and normals are unit vectors; computed in `f64` from renormalised input.
//!
//! A direction is right to its rounding to `f32`, an angle of 0.87 u with u = 2^-24 (half an ulp in each coordinate), and a share
//! of light to half an ulp of 1; within a few u of the critical angle to 2^-49 / cos(theta_t), what `f64` sees.
//! (`tests/laws/optics.rs`; in `f32` the angle would be off by 4 u / cos(theta_t).)

use glam::{DVec3, Vec3};

/// The direction after a mirror with normal `normal`, on either side. A NaN, an infinity or a zero vector makes NaN, and a ray
/// along that meets nothing.
pub fn reflect(direction: Vec3, normal: Vec3) -> Vec3 {
    let (d, n) = (direction.as_dvec3(), normal.as_dvec3());
    (d - n * (2.0 * d.dot(n) / n.dot(n))).normalize().as_vec3()
}

/// What a smooth border between two media does to a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Border {
    /// The share of light that is reflected, 0 to 1; 1 on total internal reflection.
    pub reflectance: f32,
    /// The direction of what passes; `None` on total internal reflection.
    pub refracted: Option<Vec3>,
}

/// Refraction and its share at a border. `normal` is on the side the ray comes from, and `eta` the index of refraction there
/// over that on the other side: greater than 0.
///
/// All is reflected beyond the critical angle; along the border; where the normal leans away from the ray, as an interpolated one
/// may at the rim of a mesh; and where there is no answer: a NaN, an infinity, a zero vector, an `eta` not above 0.
///
/// ```text
///     d \  | n        sin(theta_t) = eta sin(theta_i)                                  (Snell)
///        \ |          kr = ( ((a - b) / (a + b))^2 + ((c - d) / (c + d))^2 ) / 2       (Fresnel, unpolarised)
///   -------+-------   with a = eta cos(theta_i), b = cos(theta_t), c = eta cos(theta_t), d = cos(theta_i)
///          |\
///          | \ t      t = eta d + (eta cos(theta_i) - cos(theta_t)) n
/// ```
pub fn border(direction: Vec3, normal: Vec3, eta: f32) -> Border {
    let (d, n) = (direction.as_dvec3().normalize(), normal.as_dvec3().normalize());
    let eta = f64::from(eta);
    let cos_in = -d.dot(n);
    // sin^2 from the cross product: 1 - cos^2 would cancel at normal incidence.
    let sin_in: DVec3 = d.cross(n);
    let cos_out_squared = 1.0 - eta * eta * sin_in.dot(sin_in);
    // Written so that a NaN, too, reflects all.
    if !(eta > 0.0 && cos_in > 0.0 && cos_out_squared > 0.0) {
        return Border { reflectance: 1.0, refracted: None };
    }
    let cos_out = cos_out_squared.sqrt();
    let squared = |x: f64| x * x;
    let across = squared((eta * cos_in - cos_out) / (eta * cos_in + cos_out));
    let along = squared((eta * cos_out - cos_in) / (eta * cos_out + cos_in));
    let refracted = d * eta + n * (eta * cos_in - cos_out);
    Border { reflectance: (0.5 * (across + along)) as f32, refracted: Some(refracted.normalize().as_vec3()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mirror_turns_the_normal_part_around() {
        let slanted = Vec3::new(0.6, -0.8, 0.0);
        assert_eq!(reflect(slanted, Vec3::Y), Vec3::new(0.6, 0.8, 0.0));
        assert_eq!(reflect(slanted, -Vec3::Y), Vec3::new(0.6, 0.8, 0.0));
    }

    #[test]
    fn straight_through_glass_loses_the_known_four_percent() {
        // ((1.5 - 1) / (1.5 + 1))^2 = 0.04
        let border = border(-Vec3::Y, Vec3::Y, 1.0 / 1.5);
        assert_eq!(border.refracted, Some(-Vec3::Y));
        assert!((border.reflectance - 0.04).abs() < 1e-7);
    }

    #[test]
    fn refraction_obeys_snell() {
        // sin 0.6 in air, eta 1.5: sin 0.4 in glass.
        let refracted = border(Vec3::new(0.6, -0.8, 0.0), Vec3::Y, 1.0 / 1.5).refracted.unwrap();
        assert!((refracted.x - 0.4).abs() < 1e-7, "{refracted}");
    }

    #[test]
    fn beyond_the_critical_angle_all_is_reflected() {
        // sin 0.6 in glass of 2.0 would be 1.2 outside.
        assert_eq!(border(Vec3::new(0.6, -0.8, 0.0), Vec3::Y, 2.0), Border { reflectance: 1.0, refracted: None });
    }

    /// Fresnel's formulas would reflect 1.02 of the light, and eta 1 infinitely much.
    #[test]
    fn a_normal_that_leans_away_from_the_ray_reflects_all_and_not_more() {
        let away = Vec3::new(0.6, 0.1, 0.0).normalize();
        for eta in [1.0 / 1.5, 1.0, 1.5] {
            assert_eq!(border(away, Vec3::Y, eta), Border { reflectance: 1.0, refracted: None });
        }
    }

    #[test]
    fn no_border_reflects_nothing() {
        let slanted = Vec3::new(0.6, -0.8, 0.0);
        let border = border(slanted, Vec3::Y, 1.0);
        assert!(border.reflectance < 1e-14);
        assert_eq!(border.refracted, Some(slanted));
    }
}
