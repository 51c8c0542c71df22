use std::num::NonZeroU32;
use std::ops::Range;

use shading::PointLight;

use crate::{Purpose, Sample, Sampler, Scene};

/// How many lights of each cluster are asked at a point where soft shadows may fall. If not all, the sampler chooses, and each counts for
/// those that were not asked: the mean is the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LightSamples {
    /// Every light: the report's. No noise, but each point of each ray costs as many shadow rays.
    All,
    /// A pixel's rays share a cluster out: together they ask each light about four times. Four rays or fewer ask them all; for more, the
    /// grain of the choice stays below that of edges, for a fraction of the shadow rays.
    #[default]
    Shared,
    /// So many, or all if there are not so many.
    Each(NonZeroU32),
}

/// How often a pixel's rays together ask each light of a cluster that they share. Once would do for the mean, but at few rays shows a grain
/// where the report has none.
const SHARED_TURNS: u32 = 4;

impl LightSamples {
    /// How many of a cluster's lights a ray asks at each point.
    fn of_cluster(self, lights: u32, rays_per_pixel: u32) -> u32 {
        match self {
            Self::All => lights,
            Self::Shared => lights.min(lights.saturating_mul(SHARED_TURNS).div_ceil(rays_per_pixel)),
            Self::Each(count) => lights.min(count.get()),
        }
    }
}

/// The lights that are asked at each point, in turn.
pub(crate) struct LightPlan<'a> {
    lights: &'a [PointLight],
    /// `None` where every light is asked.
    draws: Option<Vec<Draw>>,
}

/// One light to be drawn from a cluster.
struct Draw {
    cluster: u32,
    lights: Range<usize>,
    /// Which of the draws from the cluster, and how many there are.
    turn: u32,
    turns: u32,
}

impl<'a> LightPlan<'a> {
    pub(crate) fn new(scene: &'a Scene, samples: LightSamples, rays_per_pixel: u32) -> Self {
        let asked = |cluster: &Range<usize>| samples.of_cluster(cluster.len() as u32, rays_per_pixel);
        let all = scene.clusters.iter().all(|cluster| asked(cluster) as usize == cluster.len());
        let draws = || {
            let numbered = (0..).zip(&scene.clusters);
            let draws = numbered.flat_map(|(cluster, lights)| {
                let turns = asked(lights);
                (0..turns).map(move |turn| Draw { cluster, lights: lights.clone(), turn, turns })
            });
            draws.collect()
        };
        Self { lights: &scene.lights, draws: (!all).then(draws) }
    }

    /// How many there are.
    pub(crate) fn asked(&self) -> usize {
        self.draws.as_ref().map_or(self.lights.len(), Vec::len)
    }

    /// The light to ask at a point in the given turn; `None` after the last.
    pub(crate) fn light(
        &self,
        number: u32,
        path: u32,
        sampler: Sampler,
        sample: impl Fn() -> Sample,
    ) -> Option<PointLight> {
        let Some(draws) = &self.draws else { return self.lights.get(number as usize).copied() };
        draws.get(number as usize)?.light(self.lights, |draw, lights| {
            let sample = sample();
            let wanted = Sample {
                zones: 1,
                count: sample.count.saturating_mul(draw.turns),
                index: sample.index.wrapping_mul(draw.turns).wrapping_add(draw.turn),
                purpose: Purpose::Light { cluster: draw.cluster, path },
                ..sample
            };
            Some((wanted.point(sampler).x * lights as f64) as usize)
        })
    }

    /// The same, if no chance is in it: the light is then that of every point.
    pub(crate) fn of_all(&self, number: u32) -> Option<PointLight> {
        let Some(draws) = &self.draws else { return self.lights.get(number as usize).copied() };
        draws.get(number as usize)?.light(self.lights, |_, _| None)
    }
}

impl Draw {
    /// The light drawn: all in turn, or one by chance, which is given the draw and the number of lights.
    fn light(&self, lights: &[PointLight], by_chance: impl Fn(&Self, usize) -> Option<usize>) -> Option<PointLight> {
        let lights = &lights[self.lights.clone()];
        let in_turn = self.turns as usize == lights.len();
        let chosen = if in_turn { self.turn as usize } else { by_chance(self, lights.len())? };
        let light = *lights.get(chosen)?;
        Some(PointLight { color: light.color * (lights.len() as f32 / self.turns as f32), ..light })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_s_rays_together_ask_each_light_about_four_times() {
        let asked = |rays| LightSamples::Shared.of_cluster(27, rays);
        assert_eq!([1, 2, 4, 5, 16, 108, 1000].map(asked), [27, 27, 27, 22, 7, 1, 1]);
        // A light without cluster is always asked.
        assert_eq!(LightSamples::Shared.of_cluster(1, 16), 1);
    }

    #[test]
    fn no_more_lights_are_asked_than_there_are() {
        let each = |count: u32| LightSamples::Each(NonZeroU32::MIN.saturating_add(count - 1));
        assert_eq!([1, 5, 27, 100].map(|count| each(count).of_cluster(27, 4)), [1, 5, 27, 27]);
        assert_eq!(LightSamples::All.of_cluster(27, 4), 27);
    }
}
