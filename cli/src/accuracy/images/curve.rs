//! Error against cost, and what is read off between the measured points.

/// A measured point of a sampling of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Point {
    /// Camera rays a pixel, in the mean.
    pub(crate) rays_per_pixel: f64,
    /// All rays of a picture, those to lights included. The cost that is the same on every machine.
    pub(crate) rays: f64,
    /// The time for a picture.
    pub(crate) seconds: f64,
    /// See [`crate::metrics::rmse`]; over several pictures, the root of the mean square.
    pub(crate) rmse: f64,
    /// The mean of [`crate::metrics::flip`].
    pub(crate) flip: f64,
}

/// What a point is read for.
pub(crate) type Measure = fn(&Point) -> f64;

/// The error that a curve has at a cost, on straight lines between its points on log-log axes. `None` outside the curve: nothing is
/// made up beyond what was measured.
///
/// ```text
///   error |  o
///         |    `.
///         |      `o. <- read off between two points
///         |          `- .o
///         +-------------------- cost
/// ```
pub(crate) fn error_at(curve: &[Point], cost: Measure, wanted: f64, error: Measure) -> Option<f64> {
    between(curve, cost, wanted, error)
}

/// The least cost at which a curve's error has fallen to the wanted one; as [`error_at`].
pub(crate) fn cost_for(curve: &[Point], error: Measure, wanted: f64, cost: Measure) -> Option<f64> {
    between(curve, error, wanted, cost)
}

/// The second measure of the first place where the first one has the wanted value.
fn between(curve: &[Point], known: Measure, wanted: f64, sought: Measure) -> Option<f64> {
    curve.windows(2).find_map(|pair| {
        let [from, to] = [&pair[0], &pair[1]];
        let place = |point| libm::log(known(point));
        let share = if known(from) == known(to) {
            (known(from) == wanted).then_some(0.0)
        } else {
            Some((libm::log(wanted) - place(from)) / (place(to) - place(from)))
        };
        let share = share.filter(|share| (0.0..=1.0).contains(share))?;
        let [start, end] = [sought(from), sought(to)];
        // 0 has no logarithm, but is as good an end as any.
        Some(match share {
            _ if start == end => start,
            0.0 => start,
            1.0 => end,
            _ => libm::exp(libm::log(start) * (1.0 - share) + libm::log(end) * share),
        })
    })
}

/// The mean that ratios have: 2 and 1/2 give 1. `None` for no numbers at all.
pub(crate) fn geometric_mean(ratios: impl IntoIterator<Item = f64>) -> Option<f64> {
    let logarithms: Vec<f64> = ratios.into_iter().map(libm::log).collect();
    let count = logarithms.len() as f64;
    (count > 0.0).then(|| libm::exp(logarithms.into_iter().sum::<f64>() / count))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Errors that fall as the power of the cost, from 1 to 64 rays.
    fn falling(power: f64, factor: f64) -> Vec<Point> {
        [1.0, 4.0, 16.0, 64.0]
            .map(|rays| {
                let error = factor * f64::powf(rays, power);
                Point { rays_per_pixel: rays, rays: 10.0 * rays, seconds: rays / 100.0, rmse: error, flip: error }
            })
            .to_vec()
    }

    fn assert_close(found: Option<f64>, expected: f64) {
        assert!(found.is_some_and(|found| (found / expected - 1.0).abs() < 1e-12), "{found:?}, not {expected}");
    }

    #[test]
    fn powers_are_straight_lines() {
        // 0.5 x 10^-1/2 at 10 rays, 0.1 seconds; and back.
        let curve = falling(-0.5, 0.5);
        let error = 0.5 / 10_f64.sqrt();
        assert_close(error_at(&curve, |p| p.seconds, 0.1, |p| p.rmse), error);
        assert_close(cost_for(&curve, |p| p.rmse, error, |p| p.rays), 100.0);
        assert_close(error_at(&curve, |p| p.seconds, 0.16, |p| p.rmse), 0.125);
    }

    #[test]
    fn twice_as_steep_needs_the_root_of_the_rays() {
        // 1 / n falls to 1 / 4, as 1 / sqrt(n) does at 16, with 4 rays.
        assert_close(cost_for(&falling(-1.0, 1.0), |p| p.flip, 0.25, |p| p.rays_per_pixel), 4.0);
    }

    #[test]
    fn nothing_is_read_off_beyond_the_curve() {
        let curve = falling(-0.5, 0.5);
        assert_eq!(error_at(&curve, |p| p.seconds, 1.0, |p| p.rmse), None);
        assert_eq!(cost_for(&curve, |p| p.rmse, 0.6, |p| p.rays), None);
        assert_eq!(cost_for(&curve, |p| p.rmse, 0.01, |p| p.rays), None);
    }

    #[test]
    fn no_error_at_all_can_be_read_off_too() {
        let mut curve = falling(-0.5, 0.0);
        assert_eq!(cost_for(&curve, |p| p.rmse, 0.0, |p| p.rays), Some(10.0));
        assert_eq!(error_at(&curve, |p| p.rays, 20.0, |p| p.rmse), Some(0.0));
        curve[0].rmse = 0.5;
        assert_eq!([10.0, 40.0].map(|cost| error_at(&curve, |p| p.rays, cost, |p| p.rmse)), [Some(0.5), Some(0.0)]);
    }

    #[test]
    fn the_first_place_counts_where_an_error_rises_again() {
        let mut curve = falling(-1.0, 1.0);
        curve[2].rmse = 1.0;
        assert_close(cost_for(&curve, |p| p.rmse, 0.5, |p| p.rays_per_pixel), 2.0);
    }

    #[test]
    fn ratios_have_a_geometric_mean() {
        assert_close(geometric_mean([2.0, 0.5, 8.0]), 2.0);
        assert_eq!(geometric_mean([]), None);
    }
}
