//! Whatever the bytes of a texture: the scene is refused, or put together, within the limits.
#![no_main]

use libfuzzer_sys::fuzz_target;
use render::{Lighting, Modules};
use scene_format::{FileError, Files, Limits, parse};

const SCENE: &str = "camera { type pinhole eye 0 -5 0 target 0 0 0 up 0 0 1 fov 30 aspect 1 }
shader { name a type diffuse texture picture }
object { shader a type sphere c 0 0 0 r 1 }";

struct Picture<'b>(&'b [u8]);

impl Files for Picture<'_> {
    fn read(&self, _path: &str) -> Result<Vec<u8>, FileError> {
        Ok(self.0.to_vec())
    }
}

fuzz_target!(|bytes: &[u8]| {
    let limits = Limits { texture_edge: 512, texture_bytes: 1 << 22, ..Limits::default() };
    let modules = Modules { limits, ..Modules::default() };
    let scene = parse("scene.sc", SCENE, &Picture(bytes)).scene;
    let _ = render::assemble(&scene, &modules, &Lighting::default(), &Picture(bytes));
});
