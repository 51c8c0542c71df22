//! What can be read can be printed and read again: the same scene, without an error.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scene_format::{NoFiles, Severity, parse, print};

fuzz_target!(|text: &str| {
    let parsed = parse("scene.sc", text, &NoFiles);
    if parsed.diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error) {
        return;
    }
    let printed = print(&parsed.scene);
    let again = parse("scene.sc", &printed, &NoFiles);
    assert_eq!(again.scene, parsed.scene, "{printed}");
});
