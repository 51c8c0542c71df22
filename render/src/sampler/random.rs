use glam::DVec2;

use super::{Purpose, Sample, hash};

/// The report's stochastic sampling: a random place in each zone of the pixel, independent random numbers for everything else.
pub fn random(first: Sample, points: &mut [DVec2]) {
    first.each(points, |sample| match sample.purpose {
        Purpose::Pixel => in_zone(sample, independent(sample)),
        Purpose::Lens | Purpose::Light { .. } => independent(sample),
    });
}

/// Each zone's middle, however many rays it has; all else as [`random`] does it. Sunflow's, without its jitter.
pub fn centred(first: Sample, points: &mut [DVec2]) {
    first.each(points, |sample| match sample.purpose {
        Purpose::Pixel => in_zone(sample, DVec2::splat(0.5)),
        Purpose::Lens | Purpose::Light { .. } => independent(sample),
    });
}

/// A place in the pixel from a place in a zone. The rays go round the zones, row by row from the top left.
fn in_zone(sample: Sample, place: DVec2) -> DVec2 {
    let Sample { zones, index, .. } = sample;
    // A power of two: its division is a shift, and exact.
    let [column, row] = [index, index >> zones.trailing_zeros()].map(|number| f64::from(number & (zones - 1)));
    (DVec2::new(column, row) + place) * (1.0 / f64::from(zones))
}

fn independent(sample: Sample) -> DVec2 {
    let Sample { seed, pixel: [x, y], index, .. } = sample;
    let dimension = sample.purpose.number().wrapping_mul(2);
    // 24 bits: numbers that an f32 holds, too.
    let number = |dimension| f64::from(hash([seed, x, y, index, dimension]) >> 8) * (1.0 / f64::from(1 << 24));
    DVec2::new(number(dimension), number(dimension.wrapping_add(1)))
}
