use image::{ImageReader, Limits};
use shading::ImageTexture;

/// A picture from the bytes of a PNG, JPG, GIF or BMP file, whatever its name says.
pub(super) fn decode(bytes: &[u8], most: &scene_format::Limits) -> Result<ImageTexture, String> {
    if has_broken_palette(bytes) {
        return Err("its palette is cut off within a colour".to_owned());
    }
    let mut reader = ImageReader::new(std::io::Cursor::new(bytes)).with_guessed_format().map_err(|e| e.to_string())?;
    let mut limits = Limits::default();
    limits.max_image_width = Some(most.texture_edge);
    limits.max_image_height = Some(most.texture_edge);
    limits.max_alloc = Some(most.texture_bytes);
    reader.limits(limits);
    let image = reader.decode().map_err(|error| error.to_string())?.into_rgb8();
    let (width, height) = image.dimensions();
    let texels = image.pixels().map(|pixel| pixel.0).collect();
    ImageTexture::new(width as usize, height as usize, texels).ok_or_else(|| "the picture is empty".to_owned())
}

/// Whether a PNG file has a palette that is not made of whole colours, three bytes each: the crate `png` 0.18.1 panics at those.
fn has_broken_palette(bytes: &[u8]) -> bool {
    let mut rest = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n").unwrap_or_default();
    // Each chunk: the length of its data, its kind, the data, and four bytes to check them by.
    while let Some((length, chunk)) = rest.split_first_chunk() {
        let length = u32::from_be_bytes(*length) as usize;
        if chunk.starts_with(b"PLTE") && !length.is_multiple_of(3) {
            return true;
        }
        rest = chunk.get(length.saturating_add(8)..).unwrap_or_default();
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of one red pixel with a palette of four bytes. Found by fuzzing.
    const FOUR_BYTES: &[u8] =
        b"\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00\x01\x00\x00\x00\x01\x08\x03\x00\x00\x00(\xcb\
            4\xbb\x00\x00\x00\x04PLTE\xff\x00\x00\x09\x13z\x10/\x00\x00\x00\x01tRNS\x80\xad^[F\x00\x00\x00\x0aID\
            ATx\x9cc`\x00\x00\x00\x02\x00\x01H\xaf\xa4q\x00\x00\x00\x00IEND\xaeB`\x82";

    #[test]
    fn a_palette_that_ends_within_a_colour_is_refused() {
        let said = decode(FOUR_BYTES, &scene_format::Limits::default()).err();
        assert_eq!(said.as_deref(), Some("its palette is cut off within a colour"));
        // Cut off anywhere, it is refused for one reason or the other.
        for end in 0..FOUR_BYTES.len() {
            assert!(decode(&FOUR_BYTES[..end], &scene_format::Limits::default()).is_err(), "{end}");
        }
    }
}
