//! Files and stdout: whole or not at all.

use std::io::{Cursor, ErrorKind, Write};
use std::path::Path;

use image::{ExtendedColorType, ImageEncoder, ImageFormat, Rgb32FImage, codecs};
use render::Film;
use tempfile::NamedTempFile;

use crate::report::Failure;

/// What a picture can be written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PictureFormat {
    /// 8-bit sRGB.
    Png,
    /// 8-bit sRGB.
    Bmp,
    /// Linear 32-bit floats.
    OpenExr,
}

impl PictureFormat {
    /// By the ending of a file's name.
    pub(crate) fn of(path: &Path) -> Result<Self, Failure> {
        let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
        match ending.as_deref() {
            Some("png") => Ok(Self::Png),
            Some("bmp") => Ok(Self::Bmp),
            Some("exr") => Ok(Self::OpenExr),
            Some(other) => Err(Failure::new(format!("`{}`: no pictures are written as .{other}", path.display()))),
            None => {
                Err(Failure::new(format!("`{}` has no ending that says what kind of picture it is", path.display())))
            }
        }
        .map_err(|failure| failure.help("end the name in .png or .bmp (8-bit sRGB) or .exr (linear values)"))
    }

    /// The bytes of a picture file.
    pub(crate) fn encode(self, film: &Film) -> Result<Vec<u8>, Failure> {
        let mut bytes = Vec::new();
        let (width, height) = (film.width, film.height);
        let rgb8 = ExtendedColorType::Rgb8;
        let encoded = match self {
            Self::Png => {
                codecs::png::PngEncoder::new(&mut bytes).write_image(&film.to_srgb_bytes(), width, height, rgb8)
            }
            Self::Bmp => {
                codecs::bmp::BmpEncoder::new(&mut bytes).write_image(&film.to_srgb_bytes(), width, height, rgb8)
            }
            Self::OpenExr => {
                let channels = film.pixels.iter().flat_map(|pixel| pixel.to_array()).collect();
                Rgb32FImage::from_raw(width, height, channels)
                    .ok_or_else(|| Failure::new("the picture is not as large as it says"))?
                    .write_to(&mut Cursor::new(&mut bytes), ImageFormat::OpenExr)
            }
        };
        encoded.map_err(|error| Failure::of("the picture cannot be encoded", error))?;
        Ok(bytes)
    }
}

/// Whether a file can stand at a path: asked before the work that makes it.
pub(crate) fn check_place(path: &Path) -> Result<(), Failure> {
    let folder = folder_of(path);
    if path.is_dir() {
        Err(Failure::new(format!("`{}` is a folder", path.display())).help("give the name of a file in it"))
    } else if !folder.is_dir() {
        Err(Failure::new(format!("there is no folder `{}` to write to", folder.display()))
            .help("make it first, or choose another place with -o"))
    } else {
        Ok(())
    }
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Writes a file whole or not at all: what was there stays until the new one is complete.
pub(crate) fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let failed = |error: std::io::Error| {
        let help = match error.kind() {
            ErrorKind::NotFound => "the folder must exist",
            ErrorKind::PermissionDenied => "choose another place with -o",
            _ => "is it a folder, or is the disk full?",
        };
        Failure::of(format!("`{}` cannot be written", path.display()), error).help(help)
    };
    let mut file = NamedTempFile::new_in(folder_of(path)).map_err(failed)?;
    file.write_all(bytes).map_err(failed)?;
    readable_by_all(&file).map_err(failed)?;
    file.persist(path).map_err(|error| failed(error.error))?;
    Ok(())
}

/// A temporary file is its owner's alone; a picture is like any other new file.
#[cfg(unix)]
fn readable_by_all(file: &NamedTempFile) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.as_file().set_permissions(std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn readable_by_all(_file: &NamedTempFile) -> std::io::Result<()> {
    Ok(())
}

/// Writes text to stdout. A reader that has had enough, like `head`, is no failure.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::of("stdout cannot be written to", error)),
        _ => Ok(()),
    }
}
