//! Every part of the course's report, from `.sc` text to linear film; the numbers come from its formulas:
//!
//! ```text
//! E_l = colour_l x falloff(d) if the point sees light l, else 0        falloff(d) = max(0, 1 - d/P)
//! constant  colour x sum E_l max(0, n.l)
//! phong     diffuse(u, v) x sum E_l max(0, n.l) + spec x sum E_l max(0, r.v)^exponent
//! mirror    refl x trace(reflected)
//! glass     color x (kr x trace(reflected) + (1 - kr) x trace(refracted)), inside x exp(-t/distance (1 - absorption colour))
//! no lights constant and phong: colour x ambient
//! ```

mod antialiasing;
mod assignment;
mod cameras;
mod cubes;
mod depth_of_field;
mod glass;
mod lights;
mod matt;
mod meshes;
mod mirrors;
mod octree;
mod pictures;
mod planes;
mod shadows;
mod soft_shadows;
mod spheres;
mod textures;
mod threads;
mod transforms;

use shading::{Color, srgb};
use tests::{MemoryFiles, Rendering};

/// A point or vector.
type Triple = [f64; 3];

/// A picture of one pixel, whose one ray goes from `eye` to `target`.
fn look(eye: Triple, target: Triple) -> String {
    let along_z = eye[0] == target[0] && eye[1] == target[1];
    let up = if along_z { "0 1 0" } else { "0 0 1" };
    let [[a, b, c], [x, y, z]] = [eye, target];
    format!(
        "image {{ resolution 1 1 }}
         camera {{ type pinhole eye {a} {b} {c} target {x} {y} {z} up {up} fov 30 aspect 1 }}\n"
    )
}

/// The first pixel.
fn seen(rendering: &Rendering) -> Color {
    rendering.film().pixels[0]
}

/// What a ray sees in a scene without lights whose surfaces show their own colours.
fn flat(eye: Triple, target: Triple, scene: &str) -> Color {
    seen(&Rendering::flat(look(eye, target) + scene))
}

/// What a ray sees in a scene with its own lights.
fn lit(eye: Triple, target: Triple, scene: &str) -> Color {
    seen(&Rendering::of(look(eye, target) + scene))
}

#[track_caller]
fn assert_close(found: Color, expected: [f64; 3], tolerance: f64) {
    for (channel, value) in found.to_array().into_iter().zip(expected) {
        assert!((f64::from(channel) - value).abs() <= tolerance, "{found:?} is not {expected:?}");
    }
}

/// A shader of one colour.
fn constant(name: &str, color: &str) -> String {
    format!("shader {{ name {name} type constant color {color} }}\n")
}

const WHITE: &str = "shader { name white type constant color 1 1 1 }\n";

/// The bytes of a picture's texel: column from the left, row from the bottom.
fn texel_bytes(column: u32, row: u32) -> [u8; 3] {
    [40 + 50 * column as u8, 40 + 50 * row as u8, 200]
}

/// A texel's linear colour.
fn texel(column: u32, row: u32) -> [f64; 3] {
    texel_bytes(column, row).map(|byte| srgb::decode_byte(byte).into())
}

/// A picture in which every texel has its own colour.
fn test_picture(width: u32, height: u32) -> image::RgbImage {
    image::RgbImage::from_fn(width, height, |x, y| image::Rgb(texel_bytes(x, height - 1 - y)))
}

fn encoded(picture: &image::RgbImage, format: image::ImageFormat) -> Vec<u8> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut bytes, format).expect("a small picture can be encoded");
    bytes.into_inner()
}

/// A scene without lights that can use the shader `textured`, whose texture is the test picture of a size.
fn textured(width: u32, height: u32, text: &str) -> Rendering {
    let shader = "shader { name textured type diffuse texture test.png }\n";
    let png = encoded(&test_picture(width, height), image::ImageFormat::Png);
    Rendering { files: MemoryFiles::default().with("test.png", png), ..Rendering::flat(format!("{shader}{text}")) }
}
