/// The bytes of a file are no text, so it is no scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("this is not a text file")]
pub struct NotText;

/// The text of a file: UTF-8, and Latin-1 where it is not that, as older exporters wrote it.
///
/// # Errors
/// [`NotText`], when it holds bytes that no text has: a NUL anywhere; outside UTF-8 any control character but white space.
pub fn decode(bytes: &[u8]) -> Result<String, NotText> {
    if bytes.contains(&0) {
        return Err(NotText);
    }
    match str::from_utf8(bytes) {
        Ok(text) => Ok(text.to_owned()),
        Err(_) if bytes.iter().any(|&byte| byte < b' ' && !byte.is_ascii_whitespace()) => Err(NotText),
        // A byte of Latin-1 is the character of the same number.
        Err(_) => Ok(bytes.iter().map(|&byte| char::from(byte)).collect()),
    }
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
    fn pictures_and_utf_16_are_no_text() {
        assert_eq!(decode(b"\x89PNG\r\n\x1a\n"), Err(NotText));
        assert_eq!(decode(b"\xff\xfei\0m\0"), Err(NotText));
    }
}
