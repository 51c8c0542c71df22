//! Textures from PNG, JPG, GIF and BMP files.

use image::{ImageFormat, Rgb, RgbImage};
use shading::srgb;
use tests::{MemoryFiles, Rendering};

use super::{assert_close, encoded, look, seen, texel, textured};

const COLOR: [u8; 3] = [200, 100, 50];

/// The colour of a plane under a texture from a file.
fn texture(name: &str, bytes: Vec<u8>) -> shading::Color {
    let text = look([3.0, 2.0, 5.0], [3.0, 3.0, 0.0])
        + &format!("shader {{ name t type diffuse texture {name} }} object {{ shader t type plane p 0 0 0 n 0 0 1 }}");
    seen(&Rendering { files: MemoryFiles::default().with(name, bytes), ..Rendering::flat(text) })
}

#[test]
fn all_four_formats_give_the_same_colour() {
    let picture = RgbImage::from_pixel(16, 16, Rgb(COLOR));
    let expected = COLOR.map(|byte| f64::from(srgb::decode_byte(byte)));
    for (name, format) in [("a.png", ImageFormat::Png), ("a.gif", ImageFormat::Gif), ("a.bmp", ImageFormat::Bmp)] {
        assert_close(texture(name, encoded(&picture, format)), expected, 1e-6);
    }
    // JPG keeps it to a level or two of 255: less than 0.02 in linear light.
    assert_close(texture("a.jpg", encoded(&picture, ImageFormat::Jpeg)), expected, 0.02);
}

#[test]
fn all_four_formats_stand_upright() {
    // Red below, blue above: the plane's texture goes up along +y, and y = 3 is in the lower half of its 10 units.
    let picture = RgbImage::from_fn(16, 16, |_, y| Rgb(if y < 8 { [0, 0, 255] } else { [255, 0, 0] }));
    for format in [ImageFormat::Png, ImageFormat::Gif, ImageFormat::Bmp, ImageFormat::Jpeg] {
        assert_close(texture("a", encoded(&picture, format)), [1.0, 0.0, 0.0], 0.03);
    }
}

#[test]
fn the_content_says_the_format_and_not_the_name() {
    let picture = RgbImage::from_pixel(4, 4, Rgb(COLOR));
    let expected = COLOR.map(|byte| f64::from(srgb::decode_byte(byte)));
    assert_close(texture("a.jpg", encoded(&picture, ImageFormat::Png)), expected, 1e-6);
}

#[test]
fn texels_are_mixed_in_linear_light() {
    // Halfway between the middles of the two lower texels of a plane's 10 units, at (5, 2.5).
    let text = look([5.0, 1.5, 5.0], [5.0, 2.5, 0.0]) + "object { shader textured type plane p 0 0 0 n 0 0 1 }";
    let [left, right] = [texel(0, 0), texel(1, 0)];
    let mean = std::array::from_fn(|channel| 0.5 * (left[channel] + right[channel]));
    assert_close(seen(&textured(2, 2, &text)), mean, 1e-5);
}

#[test]
fn a_texture_is_the_matt_part_of_phong() {
    // Under a light 5 above of power 20, seen along the mirrored light: 0.75 (texture + spec).
    let text = look([2.5, 2.5, 5.0], [2.5, 2.5, 0.0])
        + "shader { name paint type phong texture test.png spec 0.1 0.2 0.3 7 samples 0 }
           object { shader paint type plane p 0 0 0 n 0 0 1 } light { type point color 1 1 1 power 20 p 2.5 2.5 5 }";
    let [r, g, b] = texel(0, 0);
    assert_close(seen(&textured(2, 2, &text)), [0.75 * (r + 0.1), 0.75 * (g + 0.2), 0.75 * (b + 0.3)], 1e-5);
}
