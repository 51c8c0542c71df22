//! Numbers as the format writes them: Java's forms, since Sunflow reads with Java.

use crate::code::Code;

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

impl BadNumber {
    pub(crate) fn code(self) -> Code {
        match self {
            Self::NotANumber => Code::NotANumber,
            Self::NotFinite => Code::NotFinite,
            Self::OutOfRange => Code::OutOfRange,
        }
    }
}

/// A number of the kind that lists hold.
pub(crate) trait Number: Copy + Default {
    /// What an error message says was expected.
    const KIND: &'static str;

    /// Reads a word.
    fn read(word: &str) -> Result<Self, BadNumber>;

    /// Reads a number that begins with a byte, and gives the place behind it: the same number as [`Self::read`], or `None` where
    /// that must look.
    fn scan(bytes: &[u8], start: usize) -> Option<(Self, usize)>;
}

impl Number for f32 {
    const KIND: &'static str = "a number";

    fn read(word: &str) -> Result<Self, BadNumber> {
        float(word)
    }

    fn scan(bytes: &[u8], start: usize) -> Option<(Self, usize)> {
        scan_float(bytes, start)
    }
}

impl Number for u32 {
    const KIND: &'static str = "a whole number from 0 on";

    fn read(word: &str) -> Result<Self, BadNumber> {
        u32::try_from(integer(word)?).map_err(|_| BadNumber::OutOfRange)
    }

    fn scan(bytes: &[u8], start: usize) -> Option<(Self, usize)> {
        /// So many digits are always less than 2^32.
        const SAFE_DIGITS: usize = 9;
        let (number, end) = scan_digits(bytes, start, 0);
        (start < end && end - start <= SAFE_DIGITS).then_some((number as u32, end))
    }
}

/// Digits from a byte on, behind those of a number so far; wraps when there are more than 19.
fn scan_digits(bytes: &[u8], start: usize, so_far: u64) -> (u64, usize) {
    let (mut number, mut at) = (so_far, start);
    while let Some(digit @ b'0'..=b'9') = bytes.get(at) {
        number = number.wrapping_mul(10).wrapping_add(u64::from(digit - b'0'));
        at += 1;
    }
    (number, at)
}

/// A float in plain decimal form.
///
/// Digits that fit in 53 bits and a power of ten up to 10^22 are exact as `f64`, so their product or quotient is rounded once
/// (Clinger: How to Read Floating Point Numbers Accurately, 1990, section 3). To round that once more to `f32` gives the nearest
/// `f32`, too, unless the `f64` lies in the middle between two of them: then it may stand for a number beside the middle.
fn scan_float(bytes: &[u8], start: usize) -> Option<(f32, usize)> {
    /// So many digits are always less than 2^64.
    const MOST_DIGITS: usize = 19;
    const POWERS: [f64; 23] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
        1e20, 1e21, 1e22,
    ];
    /// What `f64` has beyond `f32`: 29 bits of the fraction, and the first of them alone.
    const BEYOND: u64 = (1 << 29) - 1;
    const MIDDLE: u64 = 1 << 28;

    let negative = bytes.get(start) == Some(&b'-');
    let first = start + usize::from(negative || bytes.get(start) == Some(&b'+'));
    let (mut digits, mut end) = scan_digits(bytes, first, 0);
    let mut count = end - first;
    let mut exponent = 0i64;
    if bytes.get(end) == Some(&b'.') {
        let point = end + 1;
        (digits, end) = scan_digits(bytes, point, digits);
        exponent = -((end - point) as i64);
        count += end - point;
    }
    if count == 0 || count > MOST_DIGITS || digits > 1 << 53 {
        return None;
    }
    if let Some(b'e' | b'E') = bytes.get(end) {
        let below_one = bytes.get(end + 1) == Some(&b'-');
        let from = end + 1 + usize::from(below_one || bytes.get(end + 1) == Some(&b'+'));
        let (size, behind) = scan_digits(bytes, from, 0);
        if behind == from || behind - from > 3 {
            return None;
        }
        exponent += if below_one { -(size as i64) } else { size as i64 };
        end = behind;
    }
    let power = *POWERS.get(exponent.unsigned_abs() as usize)?;
    let size = if exponent < 0 { digits as f64 / power } else { digits as f64 * power };
    let in_doubt =
        size.to_bits() & BEYOND == MIDDLE || !(f64::from(f32::MIN_POSITIVE)..f64::from(f32::MAX)).contains(&size);
    if in_doubt && digits != 0 {
        return None;
    }
    let size = size as f32;
    Some((if negative { -size } else { size }, end))
}

/// A finite float: decimal, with or without exponent, sign, digits on both sides of the point, and Java's suffix `f` or
/// `d`; or hexadecimal, as in Java and C. The nearest 32-bit float.
pub(crate) fn float(word: &str) -> Result<f32, BadNumber> {
    let stem = without_suffix(word);
    let number = word.parse::<f32>().ok().or_else(|| stem.parse::<f32>().ok()).or_else(|| hexadecimal(stem));
    match number {
        Some(number) if number.is_finite() => Ok(number),
        Some(_) => Err(BadNumber::NotFinite),
        None => Err(BadNumber::NotANumber),
    }
}

/// `0x1.8p3`: hexadecimal digits times a power of two, which must be written.
fn hexadecimal(word: &str) -> Option<f32> {
    let (negative, size) = match word.strip_prefix('-') {
        Some(size) => (true, size),
        None => (false, word.strip_prefix('+').unwrap_or(word)),
    };
    let (digits, power) = size.strip_prefix("0x").or_else(|| size.strip_prefix("0X"))?.split_once(['p', 'P'])?;
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    // 13 digits are exact as `f64`; nobody writes more, and what nobody writes is no number here.
    let count = whole.len() + fraction.len();
    let hexadecimal = |digits: &str| digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    if !(1..=13).contains(&count) || !hexadecimal(whole) || !hexadecimal(fraction) {
        return None;
    }
    let digits = u64::from_str_radix(&format!("{whole}{fraction}"), 16).ok()? as f64;
    let exponent = power.parse::<i32>().ok()?.clamp(-2000, 2000) - 4 * fraction.len() as i32;
    // Halved or doubled step by step: exact until `f64` itself ends, far beyond `f32`.
    let factor = if exponent < 0 { 0.5 } else { 2.0 };
    let size = (0..exponent.unsigned_abs()).fold(digits, |size, _| size * factor) as f32;
    Some(if negative { -size } else { size })
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
    fn hexadecimal_floats_are_read() {
        // 0x1.8p3 is 1.5 times 8; 0x.8p-1 is a quarter.
        for (word, number) in [("0x1.8p3", 12.0), ("-0x.8p-1f", -0.25), ("0X10P0", 16.0), ("+0x0p0", 0.0)] {
            assert_eq!(float(word), Ok(number), "{word}");
        }
        assert_eq!(float("0x1p128"), Err(BadNumber::NotFinite));
        assert_eq!(float("0x1p-2000"), Ok(0.0));
        for word in ["0x1.8", "0xp1", "0x1p", "0x+1p1", "0x1p1.5"] {
            assert_eq!(float(word), Err(BadNumber::NotANumber), "{word}");
        }
    }

    #[test]
    fn a_number_that_is_scanned_is_the_nearest_float() {
        // A hair's breadth beside the middle between two floats, where the nearest `f64` is the middle itself; and the middle.
        let hard = ["1.990870177745819", "1.419909656047821", "1.762408435344696", "16777217"];
        let plain =
            ["0", "-0", "-0.0", "1.", ".5", "+1.5e3", "-2.26733", "3.4e38", "1e-38", "1e-45", "123456789.123456789"];
        for word in hard.into_iter().chain(plain) {
            if let Some((number, end)) = f32::scan(word.as_bytes(), 0) {
                assert_eq!((number.to_bits(), end), (word.parse::<f32>().unwrap().to_bits(), word.len()), "{word}");
            }
        }
        assert!(plain.iter().filter(|word| f32::scan(word.as_bytes(), 0).is_some()).count() >= 7);
        for word in ["", "-", ".", "x", "{", "e5", "1e", "\"1\""] {
            assert_eq!(f32::scan(word.as_bytes(), 0), None, "{word}");
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
