use glam::{DMat3, DVec2, DVec3};

/// The chromaticities of sRGB's primaries (Rec. ITU-R BT.709).
const PRIMARIES: [[f64; 2]; 3] = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]];

/// The chromaticity of daylight, CIE D65, with the five digits that FLIP's own matrix is made from; sRGB has four, 0.3127 and 0.3290.
const WHITE: [f64; 2] = [0.31271, 0.32902];

/// From linear sRGB to colours that an eye compares, and back.
///
/// Between them stand the CIE's X, Y and Z, here as shares of white's: white is (1, 1, 1).
pub(super) struct ColorModel {
    to_xyz: DMat3,
    from_xyz: DMat3,
}

impl ColorModel {
    pub(super) fn new() -> Self {
        // Of a chromaticity (x, y) and Y = 1: X = x / y, Z = (1 - x - y) / y.
        let xyz = |[x, y]: [f64; 2]| DVec3::new(x / y, 1.0, (1.0 - x - y) / y);
        let [red, green, blue] = PRIMARIES.map(|primary| xyz(primary) / xyz(WHITE));
        let primaries = DMat3::from_cols(red, green, blue);
        // As much of each primary as makes white.
        let to_xyz = primaries * DMat3::from_diagonal(primaries.inverse() * DVec3::ONE);
        Self { to_xyz, from_xyz: to_xyz.inverse() }
    }

    /// Linear RGB in Y, Cx and Cz: lightness, red against green, blue against yellow. A linear kin of L*a*b*, and with its scales (Flohr,
    /// Kolpatzik, Balasubramanian, Carrara, Bouman, Allebach 1993).
    pub(super) fn opponent(&self, rgb: DVec3) -> DVec3 {
        let DVec3 { x, y, z } = self.to_xyz * rgb;
        DVec3::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
    }

    /// The inverse of [`Self::opponent`].
    pub(super) fn rgb(&self, opponent: DVec3) -> DVec3 {
        let y = (opponent.x + 16.0) / 116.0;
        self.from_xyz * DVec3::new(y + opponent.y / 500.0, y, y - opponent.z / 200.0)
    }

    /// Linear RGB in CIE L*a*b*, where equal distances look alike, after Hunt's effect: the darker, the less colour is seen (Hunt 1952; FLIP,
    /// section 4.1).
    pub(super) fn seen(&self, rgb: DVec3) -> DVec3 {
        let DVec3 { x, y, z } = (self.to_xyz * rgb).map(lightness_curve);
        let lightness = 116.0 * y - 16.0;
        let hunt = 0.01 * lightness;
        DVec3::new(lightness, hunt * (500.0 * (x - y)), hunt * (200.0 * (y - z)))
    }
}

/// The cube root, with a straight line for the dark (CIE 15, L*a*b*).
fn lightness_curve(share: f64) -> f64 {
    const DELTA: f64 = 6.0 / 29.0;
    if share > DELTA * DELTA * DELTA { libm::cbrt(share) } else { share / (3.0 * DELTA * DELTA) + 4.0 / 29.0 }
}

/// HyAB, for large distances: that of the lightness plus that of the colour (Abasi, Amani Tehran, Fairchild 2020).
pub(super) fn distance(one: DVec3, other: DVec3) -> f64 {
    let DVec3 { x: lightness, y: a, z: b } = one - other;
    lightness.abs() + DVec2::new(a, b).length()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// L*a*b* of sRGB's primaries, as colour tables give them for D65, before Hunt's factor L* / 100.
    #[test]
    fn the_primaries_are_where_tables_have_them() {
        let known = [[53.24, 80.09, 67.20], [87.73, -86.18, 83.18], [32.30, 79.19, -107.86]];
        for (rgb, [lightness, a, b]) in [DVec3::X, DVec3::Y, DVec3::Z].into_iter().zip(known) {
            let expected = DVec3::new(lightness, a * lightness / 100.0, b * lightness / 100.0);
            let found = ColorModel::new().seen(rgb);
            assert!((found - expected).abs().max_element() < 0.02, "{rgb}: {found}, not {expected}");
        }
    }

    #[test]
    fn white_and_black_have_no_colour() {
        let model = ColorModel::new();
        for (grey, lightness) in [(1.0, 100.0), (0.0, 0.0)] {
            for found in [model.seen(DVec3::splat(grey)), model.opponent(DVec3::splat(grey))] {
                // The linear kin's black is 16 below 0.
                let off = (found.x - lightness).abs().min((found.x - (116.0 * grey - 16.0)).abs());
                assert!(off < 1e-12 && found.y.abs() < 1e-12 && found.z.abs() < 1e-12, "{found}");
            }
        }
    }

    #[test]
    fn opponent_colours_come_back() {
        let model = ColorModel::new();
        let rgb = DVec3::new(0.1, 0.7, 0.4);
        assert!((model.rgb(model.opponent(rgb)) - rgb).abs().max_element() < 1e-14);
    }
}
