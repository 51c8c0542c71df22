/// The bytes of a file are no text, so it is no scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("this is not a text file")]
pub struct NotText;

/// The text of a file: UTF-16 where a byte order mark says so, else UTF-8, and Latin-1 where it is not that, as older exporters
/// wrote it. A carriage return that ends a line alone, as on old Macs, becomes a newline.
///
/// # Errors
/// [`NotText`], when it holds bytes that no text has: a NUL anywhere; outside UTF-8 any control character but white space.
pub fn decode(bytes: &[u8]) -> Result<String, NotText> {
    let text = match bytes {
        [0xff, 0xfe, units @ ..] => utf_16(units, u16::from_le_bytes)?,
        [0xfe, 0xff, units @ ..] => utf_16(units, u16::from_be_bytes)?,
        _ => match str::from_utf8(bytes) {
            Ok(text) => text.to_owned(),
            Err(_) if bytes.iter().any(|&byte| byte < b' ' && !byte.is_ascii_whitespace()) => return Err(NotText),
            // A byte of Latin-1 is the character of the same number.
            Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
        },
    };
    if text.contains('\0') { Err(NotText) } else { Ok(with_newlines(text)) }
}

fn utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, NotText> {
    let (units, rest) = bytes.as_chunks();
    let text = char::decode_utf16(units.iter().map(|&bytes| unit(bytes))).collect::<Result<_, _>>();
    text.ok().filter(|_| rest.is_empty()).ok_or(NotText)
}

/// The text with a newline for each carriage return that none follows.
fn with_newlines(text: String) -> String {
    let alone = |at: usize| text.as_bytes().get(at + 1) != Some(&b'\n');
    if !text.match_indices('\r').any(|(at, _)| alone(at)) {
        return text;
    }
    text.char_indices().map(|(at, character)| if character == '\r' && alone(at) { '\n' } else { character }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utf_8_is_taken_as_it_is() {
        assert_eq!(decode("% Bäume".as_bytes()).as_deref(), Ok("% Bäume"));
    }

    #[test]
    fn other_text_is_latin_1() {
        assert_eq!(decode(b"% B\xe4ume\r\n").as_deref(), Ok("% Bäume\r\n"));
    }

    #[test]
    fn utf_16_is_known_by_its_byte_order_mark() {
        let units = || "\u{feff}% B\u{e4}ume \u{1f33b}\n".encode_utf16();
        let little: Vec<u8> = units().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = units().flat_map(u16::to_be_bytes).collect();
        assert_eq!(decode(&little).as_deref(), Ok("% B\u{e4}ume \u{1f33b}\n"));
        assert_eq!(decode(&big), decode(&little));
        assert_eq!(decode(&little[..little.len() - 1]), Err(NotText));
        assert_eq!(decode(b"\xff\xfe\0\0"), Err(NotText));
        assert_eq!(decode(b"\xff\xfe\0\xd8"), Err(NotText));
    }

    #[test]
    fn carriage_returns_alone_end_lines() {
        assert_eq!(decode(b"image {\r  aa 0 1\r\n}\r\r").as_deref(), Ok("image {\n  aa 0 1\r\n}\n\n"));
    }

    #[test]
    fn pictures_and_what_holds_a_nul_are_no_text() {
        assert_eq!(decode(b"\x89PNG\r\n\x1a\n"), Err(NotText));
        assert_eq!(decode(b"i\0m\0"), Err(NotText));
    }
}
