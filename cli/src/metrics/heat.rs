use std::f64::consts::TAU;

/// The colour, in sRGB bytes, that shows a share of 0 to 1: from black over violet, red and orange to white.
///
/// Its lightness rises with the share, so that it reads as well in grey, and to an eye that does not tell red from green. It is a "cubehelix" (Green
/// 2011, "A colour scheme for the display of astronomical intensity images", Bulletin of the Astronomical Society of India 39, equation 2): the
/// grey axis with a spiral around it, here of less than half a turn that begins at blue. Shares outside are clamped; NaN is green, which no share is.
pub fn heat(share: f64) -> [u8; 3] {
    const HUE: f64 = 1.4;
    const TURNS: f64 = 0.4;
    if share.is_nan() {
        return [0, 255, 0];
    }
    let grey = share.clamp(0.0, 1.0);
    let angle = TAU * (1.0 + TURNS * grey);
    let amplitude = HUE * grey * (1.0 - grey) / 2.0;
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    // Each channel's axes are such that the spiral does not change the luma 0.30 R + 0.59 G + 0.11 B.
    [[-0.14861, 1.78277], [-0.29227, -0.90649], [1.97294, 0.0]].map(|[along_cos, along_sin]| {
        let channel = grey + amplitude * (along_cos * cos + along_sin * sin);
        (channel.clamp(0.0, 1.0) * 255.0).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_runs_from_black_to_white_and_never_gets_darker() {
        assert_eq!((heat(0.0), heat(1.0)), ([0; 3], [255; 3]));
        let luma = |share: u32| {
            let [r, g, b] = heat(f64::from(share) / 255.0).map(f64::from);
            0.30 * r + 0.59 * g + 0.11 * b
        };
        for share in 1..=255 {
            assert!(luma(share) > luma(share - 1), "{share}");
        }
    }

    #[test]
    fn what_is_no_share_stands_out() {
        assert_eq!([heat(-1.0), heat(2.0)], [heat(0.0), heat(1.0)]);
        assert!((0..=1000).all(|share| heat(f64::from(share) / 1000.0) != heat(f64::NAN)));
    }
}
