//! Numbers as the format writes them: Java's decimal forms, since Sunflow reads with Java.

/// Why a word is no usable number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BadNumber {
    /// It is no number at all, or has a fraction where none may be.
    NotANumber,
    /// It is `NaN` or infinite, or too large for a 32-bit float.
    NotFinite,
    /// It is a whole number, but not one that is possible here.
    OutOfRange,
}

/// A number of the kind that lists hold.
pub(crate) trait Number: Copy + Default {
    /// What an error message says was expected.
    const KIND: &'static str;

    /// Reads a word.
    fn read(word: &str) -> Result<Self, BadNumber>;
}

impl Number for f32 {
    const KIND: &'static str = "a number";

    fn read(word: &str) -> Result<Self, BadNumber> {
        float(word)
    }
}

impl Number for u32 {
    const KIND: &'static str = "a whole number from 0 on";

    fn read(word: &str) -> Result<Self, BadNumber> {
        u32::try_from(integer(word)?).map_err(|_| BadNumber::OutOfRange)
    }
}

/// A finite float: decimal, with or without exponent, sign, digits on both sides of the point, and Java's suffix `f` or
/// `d`. The nearest 32-bit float.
pub(crate) fn float(word: &str) -> Result<f32, BadNumber> {
    let number = word.parse::<f32>().or_else(|_| without_suffix(word).parse::<f32>());
    match number {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(BadNumber::NotFinite),
        Err(_) => Err(BadNumber::NotANumber),
    }
}

/// A whole number, with or without sign and leading zeros.
pub(crate) fn integer(word: &str) -> Result<i64, BadNumber> {
    use std::num::IntErrorKind::{NegOverflow, PosOverflow};
    word.parse::<i64>().map_err(|error| match error.kind() {
        PosOverflow | NegOverflow => BadNumber::OutOfRange,
        _ => BadNumber::NotANumber,
    })
}

fn without_suffix(word: &str) -> &str {
    // Only behind a digit or point: `inf` must not become `in`.
    match word.strip_suffix(['f', 'F', 'd', 'D']) {
        Some(stem) if stem.ends_with(|end: char| end.is_ascii_digit() || end == '.') => stem,
        _ => word,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_are_read_in_all_of_javas_decimal_forms() {
        for (word, number) in
            [("1", 1.0), ("-.5", -0.5), ("+2.5E-1f", 0.25), ("3.", 3.0), ("007", 7.0), ("1e2d", 100.0)]
        {
            assert_eq!(float(word), Ok(number), "{word}");
        }
    }

    #[test]
    fn what_is_not_finite_is_told_from_what_is_no_number() {
        for word in ["NaN", "Infinity", "-inf", "1e99"] {
            assert_eq!(float(word), Err(BadNumber::NotFinite), "{word}");
        }
        for word in ["", "-165,", "0x10", "f", "}", "1.2.3", "1ff"] {
            assert_eq!(float(word), Err(BadNumber::NotANumber), "{word}");
        }
    }

    #[test]
    fn integers_have_no_fraction() {
        assert_eq!(integer("+004"), Ok(4));
        assert_eq!(integer("4.0"), Err(BadNumber::NotANumber));
        assert_eq!(integer("99999999999999999999"), Err(BadNumber::OutOfRange));
        assert_eq!(u32::read("-1"), Err(BadNumber::OutOfRange));
    }
}
