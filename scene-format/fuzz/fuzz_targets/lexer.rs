//! Whatever the bytes: they are no text, or a text that is laid out, twice the same.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = scene_format::decode(bytes) else { return };
    if let Ok(once) = scene_format::format(&text) {
        assert_eq!(scene_format::format(&once).as_ref(), Ok(&once));
        let read = |text: &str| scene_format::parse("scene.sc", text, &scene_format::NoFiles).scene;
        assert_eq!(read(&once), read(&text));
    }
});
