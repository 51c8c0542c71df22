use glam::Vec3;

use crate::Color;

/// The share of a light's colour that arrives, from its distance (0 or greater) and its power: 0 or greater, and 0 where an argument
/// is NaN.
pub type Falloff = fn(distance: f32, power: f32) -> f32;

/// A light that shines from a point to all sides.
#[derive(Clone, Copy, Debug)]
pub struct PointLight {
    /// Where it stands.
    pub position: Vec3,
    /// Its colour.
    pub color: Color,
    /// Its power: with the linear falloff the distance at which it ends.
    pub power: f32,
    /// How its light falls off.
    pub falloff: Falloff,
}

impl PointLight {
    /// The light that arrives at a distance where nothing is in its way.
    pub fn at_distance(&self, distance: f32) -> Color {
        self.color * (self.falloff)(distance, self.power)
    }
}

/// The report's equation (2): `max(0, 1 - d / P)`. A light without power lights nothing.
///
/// In `f32`, right to 4.5e-8: the quotient's rounding, and below a half that of the difference, 3/4 of 2^-24 together.
pub fn linear_falloff(distance: f32, power: f32) -> f32 {
    // f32::max turns the NaN of 0 / 0 into 0.
    if power > 0.0 { (1.0 - distance / power).max(0.0) } else { 0.0 }
}

/// The report's equation (1), its first version: `P / (ln(d + 1) + 1)`. At distance 0 it is P, which may be more than 1.
///
/// Right to 0.51 ulp: in `f64`, with `ln(d + 1)` in one step (in `f32`, 2.3 ulp).
pub fn logarithmic_falloff(distance: f32, power: f32) -> f32 {
    (f64::from(power) / (libm::log1p(f64::from(distance)) + 1.0)).max(0.0) as f32
}

/// The report's soft shadows: each light becomes a cube of lights around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoftShadows {
    /// Lights along each edge of the cube, at least 1.
    pub along_edge: u32,
    /// The distance between neighbours.
    pub spacing: f32,
}

impl Default for SoftShadows {
    /// The report's 3 x 3 x 3 lights, 0.1 apart.
    fn default() -> Self {
        Self { along_edge: 3, spacing: 0.1 }
    }
}

/// The cluster that takes a light's place: a cube of lights centred at it, sharing its colour evenly.
pub fn light_cluster(light: PointLight, soft: SoftShadows) -> Vec<PointLight> {
    let edge = soft.along_edge.max(1);
    let count = edge * edge * edge;
    let offset = |index: u32| (index as f32 - 0.5 * (edge - 1) as f32) * soft.spacing;
    (0..count)
        .map(|index| {
            let place = Vec3::new(offset(index % edge), offset(index / edge % edge), offset(index / (edge * edge)));
            PointLight { position: light.position + place, color: light.color / count as f32, ..light }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_light_falls_evenly_to_nothing_at_its_power() {
        assert_eq!([0.0, 5.0, 10.0, 20.0].map(|d| linear_falloff(d, 10.0)), [1.0, 0.5, 0.0, 0.0]);
        assert_eq!(linear_falloff(0.0, 0.0), 0.0);
    }

    #[test]
    fn logarithmic_light_has_halved_at_e_minus_one() {
        assert_eq!(logarithmic_falloff(0.0, 8.0), 8.0);
        assert_eq!(logarithmic_falloff(std::f32::consts::E - 1.0, 8.0), 4.0);
    }

    #[test]
    fn a_cluster_keeps_the_lights_place_and_amount() {
        let light = PointLight { position: Vec3::ONE, color: Color::WHITE, power: 5.0, falloff: linear_falloff };
        let cluster = light_cluster(light, SoftShadows::default());
        assert_eq!(cluster.len(), 27);
        let mean = cluster.iter().map(|light| light.position).sum::<Vec3>() / 27.0;
        assert!((mean - light.position).length() < 1e-6);
        let amount: Color = cluster.iter().map(|light| light.color).sum();
        assert!((amount.g - 1.0).abs() < 1e-6);
        let reach = cluster.iter().map(|light| (light.position - Vec3::ONE).abs().max_element()).fold(0.0, f32::max);
        assert!((reach - 0.1).abs() < 1e-6, "neighbours stand 0.1 apart");
    }
}
