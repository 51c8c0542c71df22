use super::noise::{fractal, hash};
use glam::{DVec2, DVec3};
use image::{ImageFormat, Rgb, RgbImage};
use std::f64::consts::{PI, TAU};
use std::io::Cursor;

/// A picture that is computed: the sRGB colour, 0..1, at (u, v), where v = 0 is the bottom row.
pub(super) struct Texture {
    pub(super) name: &'static str,
    size: [u32; 2],
    color: fn(DVec2) -> DVec3,
}

pub(super) const TEXTURES: &[Texture] = &[
    Texture { name: "globe.png", size: [1024, 512], color: globe },
    Texture { name: "swirl.png", size: [512, 256], color: swirl },
    Texture { name: "orientation.png", size: [512, 512], color: orientation },
    Texture { name: "checker.png", size: [512, 512], color: checker },
    Texture { name: "tiles.png", size: [512, 512], color: tiles },
    Texture { name: "wood.png", size: [512, 512], color: wood },
];

impl Texture {
    /// The picture as a PNG file.
    pub(super) fn png(&self) -> Vec<u8> {
        let [width, height] = self.size;
        let picture = RgbImage::from_fn(width, height, |x, y| {
            let u = (f64::from(x) + 0.5) / f64::from(width);
            let v = 1.0 - (f64::from(y) + 0.5) / f64::from(height);
            Rgb((self.color)(DVec2::new(u, v)).to_array().map(|c| (c.clamp(0.0, 1.0) * 255.0 + 0.5) as u8))
        });
        let mut bytes = Cursor::new(Vec::new());
        picture.write_to(&mut bytes, ImageFormat::Png).expect("a picture in memory can always be written");
        bytes.into_inner()
    }
}

/// An invented planet: longitude along u, latitude from the south pole up along v.
fn globe(uv: DVec2) -> DVec3 {
    let at = on_sphere(uv);
    let bend = DVec3::new(fractal(at * 2.1, 4), fractal(at * 2.1 + 40.0, 4), fractal(at * 2.1 + 80.0, 4));
    let height = fractal(at * 1.35 + bend * 0.55 + 5.7, 7) - 0.02;
    let dryness = fractal(at * 2.4 + 120.0, 5);
    let latitude = (uv.y - 0.5) * 180.0;

    let ocean = mix(rgb(0x1a5f96), rgb(0x0b2a5b), step(0.0, -0.22, height));
    let plain = mix(rgb(0x4f8a3c), rgb(0xc9a765), step(-0.05, 0.2, dryness + (20.0 - latitude.abs()) * 0.006));
    let land = mix(plain, rgb(0x7d6446), step(0.14, 0.32, height));
    let land = mix(land, rgb(0xf2f2ee), step(0.36, 0.43, height));
    let land = mix(rgb(0xe0cf9e), land, step(0.0, 0.018, height));
    let ground = mix(mix(ocean, rgb(0x4fa3c4), step(-0.05, 0.0, height)), land, step(-0.003, 0.003, height));
    let ice = step(66.0, 71.0, latitude.abs() + 14.0 * fractal(at * 4.0 + 200.0, 5) + height.max(0.0) * 20.0);
    mix(mix(ground, rgb(0xf4f8fb), ice), rgb(0xfff6d8), 0.45 * graticule(uv))
}

/// A line each 15 degrees, 0..1; the equator and the first meridian are the widest.
fn graticule(uv: DVec2) -> f64 {
    let (longitude, latitude) = (uv.x * 360.0, (uv.y - 0.5) * 180.0);
    let distance = |degrees: f64| (degrees - 15.0 * (degrees / 15.0).round()).abs();
    let width = |degrees: f64| if (degrees / 15.0).round().rem_euclid(24.0) == 0.0 { 0.5 } else { 0.24 };
    // A degree of longitude shrinks towards the poles. There the meridians end at 75 degrees, before they would run together.
    let meridian = distance(longitude) * libm::cos(latitude * PI / 180.0);
    let meridians = if latitude.abs() < 75.0 { 1.0 - step(0.7, 1.3, meridian / width(longitude)) } else { 0.0 };
    let parallels =
        if latitude.abs() < 82.0 { 1.0 - step(0.7, 1.3, distance(latitude) / width(latitude)) } else { 0.0 };
    meridians.max(parallels)
}

/// Ribbons of coloured glass in milk: a toy marble.
fn swirl(uv: DVec2) -> DVec3 {
    let at = on_sphere(uv);
    let turn = TAU * uv.x + 3.2 * at.z + 1.6 * fractal(at * 1.4 + 9.0, 4);
    let milk = mix(rgb(0xf6f1e4), rgb(0xddd6c8), step(-0.3, 0.5, fractal(at * 3.0, 4)));
    let blue = mix(milk, rgb(0x1c4fa3), step(0.25, 0.42, libm::sin(2.0 * turn)));
    let orange = mix(blue, rgb(0xe8742a), step(0.55, 0.68, libm::sin(3.0 * turn + 1.3)));
    mix(orange, rgb(0x8c1d2c), step(0.86, 0.93, libm::sin(5.0 * turn + 0.4)))
}

/// Tells up from down and left from right: an F, an arrow up, and a colour in each corner (red and green above, blue and
/// yellow below).
fn orientation(uv: DVec2) -> DVec3 {
    let inside =
        |left: f64, bottom: f64, right: f64, top: f64| (left..right).contains(&uv.x) && (bottom..top).contains(&uv.y);
    let corner = DVec2::new((uv.x - 0.5).abs(), (uv.y - 0.5).abs());
    if corner.max_element() > 0.485 {
        return rgb(0x2b2d3a);
    }
    if corner.min_element() > 0.33 {
        let colors = [[0x2f6fd6, 0xf2c230], [0xd6322f, 0x2fa84f]];
        return rgb(colors[usize::from(uv.y > 0.5)][usize::from(uv.x > 0.5)]);
    }
    let letter = inside(0.27, 0.2, 0.36, 0.8) || inside(0.27, 0.71, 0.58, 0.8) || inside(0.27, 0.46, 0.5, 0.55);
    let arrow =
        inside(0.665, 0.2, 0.715, 0.6) || (0.55..0.8).contains(&uv.y) && (uv.x - 0.69).abs() < (0.8 - uv.y) * 0.5;
    if letter || arrow { rgb(0x2b2d3a) } else { rgb(0xf1ead8) }
}

/// Eight by eight fields; the lower left one is dark.
fn checker(uv: DVec2) -> DVec3 {
    let [x, y] = (uv * 8.0).to_array().map(|c| c as u32);
    if (x + y).is_multiple_of(2) { rgb(0x23303c) } else { rgb(0xefe6d2) }
}

/// Four by four stone tiles with joints between them; its edges fit together.
fn tiles(uv: DVec2) -> DVec3 {
    let place = uv * 4.0;
    let [x, y] = place.to_array().map(|c| c as u32);
    let edge = (place - place.floor() - 0.5).abs().max_element();
    let shade = f64::from(hash(x, y, 7) % 1000) / 1000.0;
    let grain = 0.05 * fractal(DVec3::new(place.x * 9.0, place.y * 9.0, 3.0), 4);
    let stone = mix(rgb(0xb9b2a4), rgb(0x9aa3a8), shade) * (0.94 + 0.1 * shade) + grain;
    mix(stone, rgb(0x5c5a58), step(0.475, 0.485, edge))
}

/// Four planks along u.
fn wood(uv: DVec2) -> DVec3 {
    let plank = (uv.y * 4.0).floor();
    let within = uv.y * 4.0 - plank;
    let at = DVec3::new(uv.x * 1.6 + plank * 7.3, within * 3.4 + plank * 3.1, plank * 2.7);
    let warped = at.y + 1.6 * fractal(DVec3::new(at.x, at.y * 0.6, at.z), 3);
    let rings = 0.5 + 0.5 * libm::sin(warped * 7.0);
    let fibre = fractal(DVec3::new(uv.x * 6.0, uv.y * 190.0, plank), 4);
    let tone = 0.1 * (f64::from(hash(plank as u32, 3, 5) % 1000) / 1000.0 - 0.5);
    let timber = mix(rgb(0xd3a066), rgb(0xa06c3b), rings * 0.75) + (0.1 * fibre + tone);
    mix(timber, rgb(0x4a2d17), step(0.482, 0.494, (within - 0.5).abs()))
}

/// The point of the unit sphere that a texture's (u, v) falls on, north up.
fn on_sphere(uv: DVec2) -> DVec3 {
    let (longitude, latitude) = (TAU * uv.x, (uv.y - 0.5) * PI);
    let level = libm::cos(latitude);
    DVec3::new(level * libm::cos(longitude), level * libm::sin(longitude), libm::sin(latitude))
}

/// 0 at `from`, 1 at `to`, smooth between and constant beyond.
fn step(from: f64, to: f64, at: f64) -> f64 {
    let t = ((at - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

fn mix(from: DVec3, to: DVec3, share: f64) -> DVec3 {
    from + (to - from) * share
}

/// A colour as web pages write it.
fn rgb(hex: u32) -> DVec3 {
    let [_, red, green, blue] = hex.to_be_bytes();
    DVec3::from([red, green, blue].map(f64::from)) / 255.0
}
