use std::ops::Range;

use shading::Color;

use crate::{
    Crop, LostRays, Purpose, RayCounts, Sample, Settings,
    passes::{Passes, Plan},
};

/// A pixel's neighbours are those up to so many columns and rows away. Two find little more, and spread the rays wider.
const REACH: u32 = 1;

/// Renders a picture in two passes, so that its rays go where neighbouring ones differ.
///
/// ```text
///   first pass            second pass
///   +----+----+----+      +----+----+----+     Each pixel gets its least number of rays, then twice, four times, eight times
///   |.  .|.  .|.  .|      |.  .|....|....|     as many, by how far the first rays of its eight neighbours are apart; never by
///   |    |    |   #|      |    |....|..##|     its own. An edge through it goes through some of them, too.
///   +----+----+---##      +----+----+---##
/// ```
///
/// A pixel whose own rays decided would be wrong in the mean: it would stop where they happen to agree, and go on where they do not. (Kirk and
/// Arvo: Unbiased Sampling Techniques for Image Synthesis, SIGGRAPH 1991.) Its neighbours' random numbers have nothing to do with
/// its own, so here every pixel is right in the mean, exactly.
///
/// With rays in proportion to the standard deviation, the error of the picture is the least that so many rays can give it. (Neyman: On the Two
/// Different Aspects of the Representative Method, 1934.)
pub(crate) fn render(settings: &Settings, mut passes: Passes<'_>) -> Option<(Vec<Color>, RayCounts, LostRays)> {
    let window = settings.window();
    let around = window.grown(REACH, settings.size);
    let first = passes.pass(around, &First { settings })?;
    let plan = Second { settings, around, first: &first.pixels };
    let second = passes.pass(window, &plan)?;
    let pixels = second.colors(&plan, window);
    let (mut rays, mut lost) = (first.rays, first.lost);
    rays += second.rays;
    lost.append(second.lost);
    Some((pixels, rays, lost))
}

/// The first pass: the least rays for each pixel.
struct First<'a> {
    settings: &'a Settings,
}

/// What a pixel's first rays brought.
#[derive(Clone, Copy, Default)]
struct FirstRays {
    /// The sum of their colours.
    total: Color,
    /// The sums, by channel, of what is seen of them, and of its square.
    seen: [f64; 3],
    squares: [f64; 3],
}

impl Plan for First<'_> {
    type Pixel = FirstRays;

    fn rays(&self, pixel: [u32; 2]) -> (Sample, Range<u32>) {
        (samples(self.settings, pixel), 0..self.settings.least_rays())
    }

    fn add(&self, first: &mut FirstRays, color: Color) {
        first.total += color;
        for (channel, value) in color.to_array().into_iter().enumerate() {
            let seen = seen(value);
            first.seen[channel] += seen;
            first.squares[channel] += seen * seen;
        }
    }

    fn color(&self, _pixel: [u32; 2], first: &FirstRays) -> Color {
        first.total / self.settings.least_rays() as f32
    }
}

/// The second pass: the rest of each pixel's rays.
struct Second<'a> {
    settings: &'a Settings,
    /// The first pass' area and pixels.
    around: Crop,
    first: &'a [FirstRays],
}

/// What the rest of a pixel's rays brought.
#[derive(Clone, Copy, Default)]
struct Rest {
    total: Color,
    rays: u32,
}

impl Plan for Second<'_> {
    type Pixel = Rest;

    fn rays(&self, pixel: [u32; 2]) -> (Sample, Range<u32>) {
        let least = self.settings.least_rays();
        let deviation = deviation(neighbours(pixel, self.around, self.first), least);
        (samples(self.settings, pixel), least..count(self.settings, deviation))
    }

    fn add(&self, rest: &mut Rest, color: Color) {
        rest.total += color;
        rest.rays += 1;
    }

    fn color(&self, pixel: [u32; 2], rest: &Rest) -> Color {
        let first = self.first[self.around.index(pixel)].total;
        (first + rest.total) / (self.settings.least_rays() + rest.rays) as f32
    }
}

/// How light a channel looks, from 0 to 1: nearly what sRGB makes of it.
fn seen(channel: f32) -> f64 {
    f64::from(channel.clamp(0.0, 1.0)).sqrt()
}

/// Any number of them may be asked for, so their zones are those of the fewest.
fn samples(settings: &Settings, pixel: [u32; 2]) -> Sample {
    let zones = 1 << settings.least_aa.min(settings.aa);
    Sample { seed: settings.seed, pixel, zones, count: settings.rays_per_pixel(), index: 0, purpose: Purpose::Pixel }
}

/// Those around one of an area's pixels, without itself.
fn neighbours<T>([x, y]: [u32; 2], area: Crop, pixels: &[T]) -> impl Iterator<Item = &T> {
    let own = &pixels[area.index([x, y])];
    let near =
        |at: u32, start: u32, length: u32| at.saturating_sub(REACH).max(start)..(at + REACH + 1).min(start + length);
    let (columns, rows) = (near(x, area.x, area.width), near(y, area.y, area.height));
    let rows = rows.flat_map(move |row| {
        let first = area.index([columns.start, row]);
        &pixels[first..first + columns.len()]
    });
    rows.filter(move |pixel| !std::ptr::eq(*pixel, own))
}

/// The standard deviation of what is seen of pixels' first rays, in the channel where it is largest; 0 if there are none, or all are NaN.
fn deviation<'a>(pixels: impl Iterator<Item = &'a FirstRays>, rays_each: u32) -> f64 {
    let (mut count, mut sums, mut squares) = (0.0, [0.0; 3], [0.0; 3]);
    // Not a `for` loop, which would ask at each pixel whether its row has ended.
    pixels.for_each(|pixel| {
        count += f64::from(rays_each);
        for channel in 0..3 {
            sums[channel] += pixel.seen[channel];
            squares[channel] += pixel.squares[channel];
        }
    });
    let variance = |channel: usize| squares[channel] / count - (sums[channel] / count) * (sums[channel] / count);
    (0..3).map(variance).fold(0.0, f64::max).sqrt()
}

/// How many rays a pixel gets: the least, doubled as often as brings it nearest to `4 deviation / contrast` times that, at most
/// [`Settings::rays_per_pixel`]. Four standard deviations are about the difference between the lightest and the darkest of neighbours.
fn count(settings: &Settings, deviation: f64) -> u32 {
    let wanted = 4.0 * deviation / f64::from(settings.contrast);
    let mut count = settings.least_rays();
    // From 2^(k - 1/2) to 2^(k + 1/2), 2^k is nearest.
    let mut next = std::f64::consts::SQRT_2;
    while wanted > next && count <= settings.rays_per_pixel() / 2 {
        count *= 2;
        next *= 2.0;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_are_doubled_in_proportion_to_the_deviation() {
        // aa 1 2, samples 1: 4 to 16 rays. Contrast 0.1: a deviation of 0.025 asks for the least, each doubling of it for twice as many.
        let settings = Settings { least_aa: 1, aa: 2, ..Settings::default() };
        let found =
            [0.0, 0.025, 0.035, 0.036, 0.05, 0.07, 0.071, 0.1, 0.5].map(|deviation| count(&settings, deviation));
        assert_eq!(found, [4, 4, 4, 8, 8, 8, 16, 16, 16]);
    }

    #[test]
    fn a_pixel_gets_at_least_two_rays_and_never_more_than_the_most() {
        let with = |least_aa, aa, samples| Settings { least_aa, aa, samples, ..Settings::default() };
        // The least times a power of two: 2 x 8 = 16, 3 x 4 = 12, 3 x 16 = 48.
        for (settings, least, most) in [(with(0, 2, 1), 2, 16), (with(0, 1, 3), 3, 12), (with(0, 2, 3), 3, 48)] {
            assert_eq!([count(&settings, 0.0), count(&settings, 0.5)], [least, most], "{settings:?}");
        }
    }

    #[test]
    fn no_contrast_and_no_neighbours_ask_for_no_more_than_the_least() {
        let settings = Settings { aa: 2, contrast: 0.0, ..Settings::default() };
        assert_eq!(count(&settings, 0.0), 2);
        assert_eq!(deviation([].into_iter(), 2), 0.0);
    }

    #[test]
    fn the_deviation_is_that_of_what_is_seen_in_the_channel_where_it_is_largest() {
        // Two rays each of linear 0 and 0.25 in green: 0 and 0.5 as seen, 0.25 from their mean.
        let rays = |green: f64| FirstRays {
            seen: [0.0, 2.0 * green, 0.0],
            squares: [0.0, 2.0 * green * green, 0.0],
            ..FirstRays::default()
        };
        assert_eq!(deviation([rays(0.0), rays(seen(0.25))].iter(), 2), 0.25);
    }

    #[test]
    fn a_pixel_has_eight_neighbours_fewer_at_the_border() {
        let area = Crop { x: 5, y: 7, width: 4, height: 3 };
        let pixels: Vec<_> = (0..12).collect();
        let around = |x: u32, y: u32| neighbours([5 + x, 7 + y], area, &pixels).copied().collect::<Vec<_>>();
        assert_eq!(around(1, 1), [0, 1, 2, 4, 6, 8, 9, 10]);
        assert_eq!(around(0, 0), [1, 4, 5]);
        assert_eq!(around(3, 2), [6, 7, 10]);
    }
}
