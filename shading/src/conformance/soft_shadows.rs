//! The kit of soft shadows: the lights that take the place of one.
//!
//! **The idea.** A shadow is soft because a lamp is not a point. The report puts a cube of points in its place, which share its light; where
//! only some of them are seen, it is half dark.
//!
//! ```text
//!     * * *
//!     * o *   spacing    3 along each edge: 27 lights around the old one's place, 1/27 of its colour each
//!     * * *
//! ```
//!
//! **The contract.** A [`Cluster`] makes lights of a [`PointLight`] and a [`SoftShadows`]. All keep its power and its falloff.
//!
//! **Hard cases.** One along the edge, which is the light itself; an even number, where none is in the middle. A light far from the origin.
//!
//! **Literature.** Cook, Porter, Carpenter: Distributed Ray Tracing, SIGGRAPH 1984. Shirley, Wang, Zimmerman: Monte Carlo Techniques for Direct
//! Lighting Calculations, TOG 1996.
//!
//! **Exercises.** Pass the kit. Put the lights on a ball's surface: which laws must change? Choose them by chance, and compare the noise of
//! `--light-samples 1`.
//!
//! | mistake | law that names it |
//! |---|---|
//! | no lights | [`one_light_along_the_edge_is_the_light_itself`] |
//! | cluster not sharing its colour: 27 times too bright | [`a_cluster_shares_its_light_s_colour`] |
//! | each light with a third of the colour | [`a_cluster_shares_its_light_s_colour`] |
//! | a square of lights instead of a cube | [`a_cluster_has_as_many_lights_as_a_cube`] |
//! | cluster off-centre | [`a_cluster_is_centred_at_its_light`] |
//! | cluster at the origin of space | [`a_cluster_is_centred_at_its_light`] |
//! | the spacing taken for the cube's edge | [`neighbours_in_a_cluster_stand_a_spacing_apart`] |
//! | power shared as well | [`lights_of_a_cluster_keep_power_and_falloff`] |

use geometry::conformance::{Counterexample, Figure, Ink, Trial, Verdict, same, unit_vector};
use glam::Vec3;
use proptest::prelude::*;

use super::colors;
use crate::{Color, PointLight, SoftShadows};

/// The lights that take the place of one.
pub type Cluster = fn(PointLight, SoftShadows) -> Vec<PointLight>;

/// A light that is to be made soft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Soft {
    /// Where it stands.
    pub position: Vec3,
    /// Its colour.
    pub color: Color,
    /// Its power.
    pub power: f32,
    /// By how many.
    pub soft: SoftShadows,
}

/// Lights up to 100 away, 1 to 6 along the edge.
pub fn softened() -> impl Strategy<Value = Soft> {
    let place = (unit_vector(), prop_oneof![Just(0.0), 0.0..100.0]).prop_map(|(side, far)| (side * far).as_vec3());
    (place, colors(), 0.1_f32..100.0, 1..7_u32, 0.01_f32..2.0).prop_map(
        |(position, color, power, along_edge, spacing)| Soft {
            position,
            color,
            power,
            soft: SoftShadows { along_edge, spacing },
        },
    )
}

/// A falloff that no renderer has.
fn falloff(distance: f32, power: f32) -> f32 {
    power / (power + distance)
}

impl Soft {
    fn lights(&self, cluster: &Cluster) -> Vec<PointLight> {
        cluster(PointLight { position: self.position, color: self.color, power: self.power, falloff }, self.soft)
    }

    /// The verdict on a place, to a rounding of coordinates this large; drawn from above.
    fn near(&self, lights: &[PointLight], expected: Vec3, found: Vec3) -> Verdict {
        if (found - expected).abs().max_element() <= 1e-5 * (1.0 + self.position.length()) {
            return Ok(());
        }
        let drawn = Figure::flat().point(self.position.as_dvec3(), Ink::Expected, "the light");
        let drawn = lights.iter().fold(drawn, |drawn, light| drawn.point(light.position.as_dvec3(), Ink::Found, ""));
        Err(Counterexample::new(format!("{expected:?}"), format!("{found:?}")).drawn(drawn))
    }
}

/// It stands where it stood.
pub fn one_light_along_the_edge_is_the_light_itself(cluster: &Cluster, trial: &Trial) -> Verdict {
    let one = softened().prop_map(|light| Soft { soft: SoftShadows { along_edge: 1, ..light.soft }, ..light });
    trial.search(one, |light| {
        let lights = light.lights(cluster);
        same(&vec![light.color], &lights.iter().map(|light| light.color).collect())?;
        light.near(&lights, light.position, lights[0].position)
    })
}

/// The edge to the power of three.
pub fn a_cluster_has_as_many_lights_as_a_cube(cluster: &Cluster, trial: &Trial) -> Verdict {
    trial.search(softened(), |light| {
        let edge = light.soft.along_edge as usize;
        same(&(edge * edge * edge), &light.lights(cluster).len())
    })
}

/// Each has an even share: together they are as bright as it was.
pub fn a_cluster_shares_its_light_s_colour(cluster: &Cluster, trial: &Trial) -> Verdict {
    trial.search(softened(), |light| {
        let lights = light.lights(cluster);
        let share = light.color.map(|channel| channel / lights.len() as f32);
        let near = |found: f32, expected: f32| (found - expected).abs() <= 1e-6 * expected;
        let is_share = |found: Color| found.to_array().into_iter().zip(share.to_array()).all(|(a, b)| near(a, b));
        match lights.iter().find(|light| !is_share(light.color)) {
            None => Ok(()),
            Some(odd) => Err(Counterexample::new(format!("{share:?}"), format!("{:?}", odd.color))),
        }
    })
}

/// The mean of their places is its place.
pub fn a_cluster_is_centred_at_its_light(cluster: &Cluster, trial: &Trial) -> Verdict {
    trial.search(softened(), |light| {
        let lights = light.lights(cluster);
        let mean = lights.iter().map(|light| light.position.as_dvec3()).sum::<glam::DVec3>() / lights.len() as f64;
        light.near(&lights, light.position, mean.as_vec3())
    })
}

/// Along each axis there are as many places as the edge has, a spacing apart, and every combination of them is taken once.
pub fn neighbours_in_a_cluster_stand_a_spacing_apart(cluster: &Cluster, trial: &Trial) -> Verdict {
    trial.search(softened(), |light| {
        let lights = light.lights(cluster);
        let SoftShadows { along_edge: edge, spacing } = light.soft;
        let first = light.position - Vec3::splat(0.5 * (edge - 1) as f32 * spacing);
        let steps = |place: Vec3| ((place - first) / spacing).round();
        let mut taken: Vec<_> =
            lights.iter().map(|light| steps(light.position).to_array().map(|step| step as i64)).collect();
        for found in &lights {
            light.near(&lights, first + steps(found.position) * spacing, found.position)?;
        }
        taken.sort_unstable();
        let range = 0..i64::from(edge);
        let cube =
            range.clone().flat_map(|x| range.clone().flat_map(move |y| (0..i64::from(edge)).map(move |z| [x, y, z])));
        same(&cube.collect(), &taken)
    })
}

/// Only the colour is shared.
pub fn lights_of_a_cluster_keep_power_and_falloff(cluster: &Cluster, trial: &Trial) -> Verdict {
    trial.search(softened(), |light| {
        light.lights(cluster).iter().try_for_each(|found| {
            same(&(light.power, falloff(1.0, light.power)), &(found.power, (found.falloff)(1.0, found.power)))
        })
    })
}

geometry::kit! { $crate
    /// Names the laws of soft shadows as tests: of a function from a light and a [`crate::SoftShadows`] to the lights that take its place.
    soft_shadows_conformance, Cluster, soft_shadows;
    one_light_along_the_edge_is_the_light_itself: "nothing is returned yet: begin with `vec![light]`";
    a_cluster_has_as_many_lights_as_a_cube: "the edge is not taken to the power of three";
    a_cluster_shares_its_light_s_colour: "each light keeps the whole colour, or the share is that of an edge";
    a_cluster_is_centred_at_its_light: "the first light stands where the one stood, or the light's place is not added";
    neighbours_in_a_cluster_stand_a_spacing_apart: "the spacing is divided among the lights, or two indices are exchanged";
    lights_of_a_cluster_keep_power_and_falloff: "the power is shared like the colour, or the falloff is the default one";
}
