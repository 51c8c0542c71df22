use render::Film;

use super::{MetricError, check_sizes};

/// The root of the mean square difference of two pictures: the mean is over all pixels and their three linear channels alike.
///
/// Nothing is clamped, so that light beyond white counts in full and the error of a mean of n independent rays falls as 1 / sqrt(n).
/// 0 for equal pictures, 1 for white against black; NaN where a channel of either is NaN, infinite where one alone is infinite.
pub fn rmse(one: &Film, other: &Film) -> Result<f64, MetricError> {
    check_sizes(one, other)?;
    let channels =
        |film: &Film| film.pixels.iter().flat_map(|pixel| pixel.to_array()).map(f64::from).collect::<Vec<_>>();
    let (one, other) = (channels(one), channels(other));
    let squares: f64 = one.iter().zip(&other).map(|(a, b)| (a - b) * (a - b)).sum();
    Ok((squares / one.len().max(1) as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use render::{LostRays, RayCounts};
    use shading::Color;

    fn film(width: u32, pixels: Vec<Color>) -> Film {
        Film {
            width,
            height: pixels.len() as u32 / width,
            pixels,
            rays: RayCounts::default(),
            lost: LostRays::default(),
        }
    }

    #[test]
    fn it_is_the_root_of_the_mean_over_pixels_and_channels() {
        let one = film(2, vec![Color::new(0.0, 0.5, 3.0), Color::BLACK]);
        let other = film(2, vec![Color::new(0.0, 0.25, 1.0), Color::grey(0.5)]);
        // (0.25^2 + 2^2 + 3 x 0.5^2) / 6 = 4.8125 / 6
        assert_eq!(rmse(&one, &other), Ok((4.8125_f64 / 6.0).sqrt()));
        assert_eq!(rmse(&other, &one), rmse(&one, &other));
        assert_eq!(rmse(&one, &one), Ok(0.0));
    }

    #[test]
    fn what_is_not_a_number_is_not_hidden() {
        let broken = film(1, vec![Color::new(0.0, f32::NAN, 0.0)]);
        assert!(rmse(&broken, &film(1, vec![Color::BLACK])).unwrap().is_nan());
    }

    #[test]
    fn pictures_of_the_same_number_of_pixels_but_other_sizes_are_not_compared() {
        let (wide, high) = (film(2, vec![Color::BLACK; 2]), film(1, vec![Color::BLACK; 2]));
        assert_eq!(rmse(&wide, &high), Err(MetricError::DifferentSizes { one: [2, 1], other: [1, 2] }));
    }
}
