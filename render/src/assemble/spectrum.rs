//! Colours that are given by their spectrum. They come out as Sunflow has them: the spectrum's integral, in nanometres, with the
//! matching functions of the CIE, not normalised to anything.

/// Wavelengths of [`MATCHING`], in nanometres.
const SHORTEST: u16 = 380;
const STEP: u16 = 5;

/// CIE XYZ of a spectrum; of one that is 1 everywhere about 106.9 in each channel.
///
/// The sum takes the place of an integral; 5 nanometres are the step that CIE 15:2004, section 7.1, recommends for it.
fn xyz_of(spectrum: impl Fn(f64) -> f64) -> [f32; 3] {
    let mut sum = [0.0; 3];
    for (number, weights) in (0u16..).zip(MATCHING) {
        let power = spectrum(f64::from(SHORTEST + STEP * number));
        for (channel, weight) in sum.iter_mut().zip(weights) {
            *channel += power * weight * f64::from(STEP);
        }
    }
    // Beyond any light there is; so that no colour becomes infinite.
    sum.map(|channel| channel.clamp(-1e36, 1e36) as f32)
}

/// The light of a black body: the power that a square metre of it gives off, for each metre of wavelength. (Planck's law, with
/// the two radiation constants as Sunflow has them.)
pub(super) fn blackbody(kelvin: f32) -> [f32; 3] {
    xyz_of(|nanometres| {
        let wavelength = nanometres * 1e-9;
        let exponent = 1.4388e-2 / (wavelength * f64::from(kelvin));
        let fifth_power = wavelength * wavelength * wavelength * wavelength * wavelength;
        3.741_83e-16 / (fifth_power * libm::expm1(exponent))
    })
}

/// A spectrum of evenly spaced values: see `scene_file::Color::Spectrum`.
pub(super) fn sampled(range: [f32; 2], values: &[f32]) -> [f32; 3] {
    let [from, to] = range.map(f64::from);
    let spacing = (to - from) / values.len() as f64;
    xyz_of(|nanometres| {
        let place = (nanometres - from) / spacing;
        if !(from..=to).contains(&nanometres) || !place.is_finite() {
            return 0.0;
        }
        let before = place as usize;
        let value = |at: usize| values.get(at).or(values.last()).map_or(0.0, |&value| f64::from(value));
        let share = place - before as f64;
        (1.0 - share) * value(before) + share * value(before + 1)
    })
}

/// The colour-matching functions of the CIE 1931 standard observer (2 degrees), x, y and z for each wavelength. (CIE 15:2004,
/// table T.4.)
#[rustfmt::skip]
const MATCHING: [[f64; 3]; 81] = [
    [0.001368, 3.9e-05, 0.00645], [0.002236, 6.4e-05, 0.01055], [0.004243, 0.00012, 0.02005],
    [0.00765, 0.000217, 0.03621], [0.01431, 0.000396, 0.06785], [0.02319, 0.00064, 0.1102],
    [0.04351, 0.00121, 0.2074], [0.07763, 0.00218, 0.3713], [0.13438, 0.004, 0.6456],
    [0.21477, 0.0073, 1.03905], [0.2839, 0.0116, 1.3856], [0.3285, 0.01684, 1.62296],
    [0.34828, 0.023, 1.74706], [0.34806, 0.0298, 1.7826], [0.3362, 0.038, 1.77211],
    [0.3187, 0.048, 1.7441], [0.2908, 0.06, 1.6692], [0.2511, 0.0739, 1.5281],
    [0.19536, 0.09098, 1.28764], [0.1421, 0.1126, 1.0419], [0.09564, 0.13902, 0.81295],
    [0.05795, 0.1693, 0.6162], [0.03201, 0.20802, 0.46518], [0.0147, 0.2586, 0.3533],
    [0.0049, 0.323, 0.272], [0.0024, 0.4073, 0.2123], [0.0093, 0.503, 0.1582],
    [0.0291, 0.6082, 0.1117], [0.06327, 0.71, 0.07825], [0.1096, 0.7932, 0.05725],
    [0.1655, 0.862, 0.04216], [0.22575, 0.91485, 0.02984], [0.2904, 0.954, 0.0203],
    [0.3597, 0.9803, 0.0134], [0.43345, 0.99495, 0.00875], [0.51205, 1.0, 0.00575],
    [0.5945, 0.995, 0.0039], [0.6784, 0.9786, 0.00275], [0.7621, 0.952, 0.0021],
    [0.8425, 0.9154, 0.0018], [0.9163, 0.87, 0.00165], [0.9786, 0.8163, 0.0014],
    [1.0263, 0.757, 0.0011], [1.0567, 0.6949, 0.001], [1.0622, 0.631, 0.0008],
    [1.0456, 0.5668, 0.0006], [1.0026, 0.503, 0.00034], [0.9384, 0.4412, 0.00024],
    [0.85445, 0.381, 0.00019], [0.7514, 0.321, 0.0001], [0.6424, 0.265, 5e-05],
    [0.5419, 0.217, 3e-05], [0.4479, 0.175, 2e-05], [0.3608, 0.1382, 1e-05],
    [0.2835, 0.107, 0.0], [0.2187, 0.0816, 0.0], [0.1649, 0.061, 0.0],
    [0.1212, 0.04458, 0.0], [0.0874, 0.032, 0.0], [0.0636, 0.0232, 0.0],
    [0.04677, 0.017, 0.0], [0.0329, 0.01192, 0.0], [0.0227, 0.00821, 0.0],
    [0.01584, 0.005723, 0.0], [0.011359, 0.004102, 0.0], [0.008111, 0.002929, 0.0],
    [0.00579, 0.002091, 0.0], [0.004109, 0.001484, 0.0], [0.002899, 0.001047, 0.0],
    [0.002049, 0.00074, 0.0], [0.00144, 0.00052, 0.0], [0.001, 0.000361, 0.0],
    [0.00069, 0.000249, 0.0], [0.000476, 0.000172, 0.0], [0.000332, 0.00012, 0.0],
    [0.000235, 8.5e-05, 0.0], [0.000166, 6e-05, 0.0], [0.000117, 4.2e-05, 0.0],
    [8.3e-05, 3e-05, 0.0], [5.9e-05, 2.1e-05, 0.0], [4.2e-05, 1.5e-05, 0.0],
];

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_near(found: [f32; 3], expected: [f64; 3], tolerance: f64) {
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((f64::from(found) / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
        }
    }

    /// Where on Planck's locus: CIE standard illuminant A is a black body of 2856 K, at x 0.4476 and y 0.4074 (CIE 15:2004, table
    /// 1); those of 6500 and 10000 K stand at 0.3135, 0.3237 and 0.2807, 0.2884 (Wyszecki and Stiles: Color Science, 1982, table
    /// 1(3.11)).
    #[test]
    fn black_bodies_have_the_colours_of_the_tables() {
        for (kelvin, x, y) in [(2856.0, 0.4476, 0.4074), (6500.0, 0.3135, 0.3237), (10_000.0, 0.2807, 0.2884)] {
            let found = blackbody(kelvin);
            let sum: f32 = found.iter().sum();
            assert!((found[0] / sum - x).abs() < 2e-4 && (found[1] / sum - y).abs() < 2e-4, "{kelvin}: {found:?}");
        }
    }

    /// The same integral in steps of 1 nanometre over the table of 471 wavelengths from 360 to 830.
    #[test]
    fn black_bodies_have_sunflow_s_power() {
        assert_near(blackbody(1000.0), [2.341_231e7, 1.235_474e7, 9.997_539e4], 5e-4);
        assert_near(blackbody(6500.0), [1.369_081e16, 1.413_195e16, 1.584_425e16], 5e-4);
    }

    #[test]
    fn a_spectrum_of_ones_is_the_sum_of_the_table() {
        // 106.865, 106.857 and 106.892 from 360 to 830 nanometres; the ends beyond 380 and 780 hold less than a thousandth.
        assert_near(sampled([300.0, 900.0], &[1.0]), [106.865, 106.857, 106.892], 1e-3);
    }

    /// 0.2 at 400 nanometres, 0.5 at 500, 0.3 at 600 and from there to 700. The oracle's steps are 1 nanometre.
    #[test]
    fn between_its_values_a_spectrum_is_linear() {
        assert_near(sampled([400.0, 700.0], &[0.2, 0.5, 0.3]), [35.394_93, 40.652_97, 38.292_06], 1e-3);
    }

    #[test]
    fn outside_its_range_a_spectrum_is_dark() {
        for range in [[800.0, 900.0], [500.0, 500.0], [700.0, 400.0]] {
            assert_eq!(sampled(range, &[1.0, 2.0]), [0.0; 3], "{range:?}");
        }
    }

    #[test]
    fn no_temperature_and_no_value_makes_it_infinite() {
        for xyz in [blackbody(f32::MAX), blackbody(f32::MIN_POSITIVE), sampled([400.0, 700.0], &[f32::MAX])] {
            assert!(xyz.into_iter().all(f32::is_finite), "{xyz:?}");
        }
    }
}
