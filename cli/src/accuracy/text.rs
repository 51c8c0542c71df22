//! Numbers as the page shows them.

/// An error in ulps: to two digits, from 1000 on by its power of ten.
pub(crate) fn error(ulps: f64) -> String {
    if ulps.is_nan() {
        "-".to_owned()
    } else if ulps < 0.1 && ulps > 0.0 {
        "< 0.1".to_owned()
    } else if ulps < 10.0 {
        format!("{ulps:.2}")
    } else if ulps < 1000.0 {
        format!("{ulps:.0}")
    } else {
        format!("{ulps:.1e}")
    }
}

/// A share in per cent. None at all and hardly any look different.
pub(crate) fn share(share: f64) -> String {
    if share == 0.0 {
        "0".to_owned()
    } else if share < 0.0001 {
        "< 0.01 %".to_owned()
    } else if share < 0.1 {
        format!("{:.2} %", 100.0 * share)
    } else {
        format!("{:.0} %", 100.0 * share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_the_digits_that_matter() {
        assert_eq!([0.0, 0.02, 0.5, 12.3, 45_678.0].map(error), ["0.00", "< 0.1", "0.50", "12", "4.6e4"]);
        assert_eq!([0.0, 0.00001, 0.0123, 0.42].map(share), ["0", "< 0.01 %", "1.23 %", "42 %"]);
    }
}
