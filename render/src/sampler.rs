use glam::DVec2;

mod random;
mod sobol;

pub use random::{centred, random};
pub use sobol::sobol;

/// Which random point is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sample {
    /// Chosen by the user: another seed is another picture of the same scene.
    pub seed: u32,
    /// The pixel, from the top left.
    pub pixel: [u32; 2],
    /// The pixel is cut into that many zones across and as many down: a power of two.
    pub zones: u32,
    /// How many points there are for this purpose in the pixel, a multiple of `zones` x `zones`. Where that is not known
    /// beforehand, the most that there can be.
    pub count: u32,
    /// Which of them: 0 to `count` - 1.
    pub index: u32,
    /// What it is for.
    pub purpose: Purpose,
}

/// What a random point is for. Those for different purposes must not depend on each other: the mean over a pixel's rays is then right
/// in every one of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The place in the pixel, x to the right and y downwards. Of any `zones` x `zones` points that follow each other from a
    /// multiple of that, each falls into a zone of its own.
    Pixel,
    /// The place on the lens.
    Lens,
    /// Which light of a cluster is asked: by x alone.
    Light {
        /// The cluster's number.
        cluster: u32,
        /// How the ray came to the point that is lit; see [`shading::Bounces::path`].
        path: u32,
    },
}

/// Where samples fall: fills in points of the unit square (1 excluded), the one wanted and those with the next indices, each a function of
/// which it is. No state, so that the picture depends on no order. A pixel with a single ray does not ask for a place in the pixel:
/// it takes the centre.
pub type Sampler = fn(Sample, &mut [DVec2]);

impl Sample {
    /// A sampler's point for this sample alone.
    pub fn point(self, sampler: Sampler) -> DVec2 {
        let mut point = [DVec2::ZERO];
        sampler(self, &mut point);
        point[0]
    }

    /// Fills in points one by one: for samplers that have nothing to share between them.
    pub fn each(self, points: &mut [DVec2], point: impl Fn(Self) -> DVec2) {
        for (number, place) in points.iter_mut().enumerate() {
            *place = point(Self { index: self.index.wrapping_add(number as u32), ..self });
        }
    }
}

impl Purpose {
    /// A number for each purpose; those of lights are scattered over 32 bits.
    fn number(self) -> u32 {
        match self {
            Self::Pixel => 0,
            Self::Lens => 1,
            Self::Light { cluster, path } => hash([cluster, path]),
        }
    }
}

/// 32 random bits for some words.
fn hash<const N: usize>(words: [u32; N]) -> u32 {
    words.into_iter().fold(0x9E37_79B9, |hash: u32, word| scramble(hash ^ word).wrapping_add(0x9E37_79B9))
}

/// Spreads each bit over all others. (Wellons 2018, "lowbias32".)
pub(crate) fn scramble(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x7FEB_352D);
    bits ^= bits >> 15;
    bits = bits.wrapping_mul(0x846C_A68B);
    bits ^ bits >> 16
}
