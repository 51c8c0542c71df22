//! The ways to choose samples that are held against each other.

use clap::ValueEnum;
use render::{Allotment, LightSamples, Modules, Sampler, Settings, sobol};

use crate::options::SamplerName;

/// A way to choose samples, at several costs.
pub(crate) struct Sampling {
    /// What it is called.
    pub(crate) name: String,
    /// Where samples fall.
    pub(crate) sampler: Sampler,
    /// How many lights of a cluster are asked at a point.
    pub(crate) light_samples: LightSamples,
    /// By rising cost.
    pub(crate) steps: Vec<Step>,
}

/// How many rays there are, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Step {
    /// Zones along a pixel's edge, as a power of two: the fewest and the most.
    aa: [u32; 2],
    /// How far neighbours must be apart for more than the fewest; `None` shares rays out evenly.
    contrast: Option<f32>,
    /// How many pictures with different seeds are rendered so. Their errors are taken together and the least of their times counts, so that
    /// short ones are measured as well as long ones.
    pub(crate) pictures: u32,
}

/// What others are held against: [`all`]'s first, the report's way, at 16 rays a pixel.
pub(crate) const BASE: usize = 0;
pub(crate) const BASE_STEP: usize = 2;

/// 1, 4, 16 and 64 rays a pixel.
const EVEN: [Step; 4] = [
    Step { aa: [0, 0], contrast: None, pictures: 9 },
    Step { aa: [1, 1], contrast: None, pictures: 7 },
    Step { aa: [2, 2], contrast: None, pictures: 4 },
    Step { aa: [3, 3], contrast: None, pictures: 2 },
];

/// From 2 rays a pixel, or 4, to 64, or 256.
const ADAPTIVE: [Step; 4] = [
    Step { aa: [0, 2], contrast: Some(0.2), pictures: 7 },
    Step { aa: [0, 3], contrast: Some(0.1), pictures: 7 },
    Step { aa: [1, 3], contrast: Some(0.1), pictures: 4 },
    Step { aa: [1, 4], contrast: Some(0.05), pictures: 2 },
];

/// The report's way: a random place in each zone, and every light asked. Then all samplers that can be named, and the one of `modules` if it
/// is none of these, with lights shared out among a pixel's rays. Then rays where neighbours differ.
pub(crate) fn all(modules: &Modules) -> Vec<Sampling> {
    let even = |name: &str, sampler| Sampling {
        name: name.to_owned(),
        sampler,
        light_samples: LightSamples::Shared,
        steps: EVEN.to_vec(),
    };
    let mut samplings = vec![Sampling { light_samples: LightSamples::All, ..even("random", render::random) }];
    for name in SamplerName::value_variants().iter().filter(|name| **name != SamplerName::Random) {
        let value = name.to_possible_value();
        samplings.push(even(value.as_ref().map_or("", |value| value.get_name()), name.sampler()));
    }
    if !samplings.iter().any(|ours| std::ptr::fn_addr_eq(ours.sampler, modules.sampler)) {
        samplings.push(even("yours", modules.sampler));
    }
    samplings.push(Sampling { steps: ADAPTIVE.to_vec(), ..even("sobol, adaptive", sobol) });
    samplings
}

impl Step {
    /// The settings with these rays.
    pub(crate) fn settings(self, settings: &Settings) -> Settings {
        Settings {
            least_aa: self.aa[0],
            aa: self.aa[1],
            samples: 1,
            allotment: if self.contrast.is_some() { Allotment::Adaptive } else { Allotment::Even },
            contrast: self.contrast.unwrap_or(settings.contrast),
            ..settings.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sampler_of_one_s_own_appears_beside_ours_once() {
        let names =
            |modules: &Modules| -> Vec<String> { all(modules).into_iter().map(|sampling| sampling.name).collect() };
        let ours = names(&Modules::default());
        assert_eq!(ours[BASE], "random");
        assert!(!ours.contains(&"yours".to_owned()));
        let with_theirs =
            names(&Modules { sampler: |_, points| points.fill(glam::DVec2::splat(0.5)), ..Modules::default() });
        assert_eq!(with_theirs.iter().filter(|name| !ours.contains(name)).collect::<Vec<_>>(), ["yours"]);
    }

    #[test]
    fn the_base_has_sixteen_rays_a_pixel() {
        let base = &all(&Modules::default())[BASE];
        assert_eq!(base.steps[BASE_STEP].settings(&Settings::default()).rays_per_pixel(), 16);
    }
}
