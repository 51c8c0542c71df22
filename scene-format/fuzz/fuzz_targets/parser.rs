//! Any text can be read: soon, without a panic, with messages whose places lie in it.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scene_format::{FileError, Files, Limits, parse_within};

/// Every file holds the text itself, so that includes are followed.
struct Itself<'t>(&'t str);

impl Files for Itself<'_> {
    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        if path.len() < 8 { Ok(self.0.into()) } else { Err(FileError::NotFound) }
    }
}

fuzz_target!(|text: &str| {
    let limits = Limits { include_depth: 3, files: 8, bytes: 1 << 16, elements: 1 << 12, ..Limits::default() };
    let parsed = parse_within("scene.sc", text, &Itself(text), &limits);
    for diagnostic in &parsed.diagnostics {
        parsed.sources.line_column(diagnostic.span);
        let source = &parsed.sources.files[diagnostic.span.file as usize].text;
        assert!(source.get(diagnostic.span.start as usize..diagnostic.span.end as usize).is_some(), "{diagnostic:?}");
    }
});
