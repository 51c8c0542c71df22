use std::sync::Arc;

use glam::Vec2;
use shading::{Color, ImageTexture, Texture, conformance::texture};

use crate::Kit;

/// A texture that is a function of the picture and of what asks for the coordinates.
struct Spoilt<F> {
    picture: ImageTexture,
    color: F,
}

impl<F: Fn(&ImageTexture, &dyn Fn() -> Vec2) -> Color + Send + Sync> Texture for Spoilt<F> {
    fn color(&self, uv: &dyn Fn() -> Vec2) -> Color {
        (self.color)(&self.picture, uv)
    }
}

fn spoilt(
    picture: ImageTexture,
    color: impl Fn(&ImageTexture, &dyn Fn() -> Vec2) -> Color + Send + Sync + 'static,
) -> Arc<dyn Texture> {
    Arc::new(Spoilt { picture, color })
}

/// The right colour at another place.
fn moved(picture: ImageTexture, place: fn(Vec2) -> Vec2) -> Arc<dyn Texture> {
    spoilt(picture, move |picture, uv| {
        let place = place(uv());
        picture.color(&|| place)
    })
}

/// A linear value as sRGB encodes it, and back: the curve without its straight part, as good as right.
fn encoded(linear: f32) -> f32 {
    f32::from(shading::srgb::encode_byte(linear)) / 255.0
}

/// A picture's columns and rows.
fn size(picture: &ImageTexture) -> Vec2 {
    Vec2::from(picture.size().map(|count| count as f32))
}

#[test]
fn every_mistake_in_a_texture_is_named() {
    Kit { page: "shading/src/conformance/texture.rs", laws: texture::LAWS }.catches([
        (
            "nothing is returned",
            (|picture| spoilt(picture, |_, _| Color::BLACK)) as texture::Picture,
            "a_picture_of_one_texel_is_that_colour_everywhere",
        ),
        (
            "sRGB taken for linear",
            |picture| spoilt(picture, |picture, uv| picture.color(uv).map(encoded)),
            "a_picture_of_one_texel_is_that_colour_everywhere",
        ),
        ("v flipped", |picture| moved(picture, |uv| Vec2::new(uv.x, 1.0 - uv.y)), "a_texel_s_centre_has_its_colour"),
        ("u mirrored", |picture| moved(picture, |uv| Vec2::new(1.0 - uv.x, uv.y)), "a_texel_s_centre_has_its_colour"),
        ("u and v exchanged", |picture| moved(picture, |uv| Vec2::new(uv.y, uv.x)), "a_texel_s_centre_has_its_colour"),
        (
            "texel off by half",
            |picture| {
                let half = 0.5 / size(&picture);
                spoilt(picture, move |picture, uv| {
                    let place = uv() + half;
                    picture.color(&|| place)
                })
            },
            "a_texel_s_centre_has_its_colour",
        ),
        (
            "texture not repeated: clamped",
            |picture| moved(picture, |uv| uv.clamp(Vec2::ZERO, Vec2::ONE)),
            "a_texture_repeats",
        ),
        (
            "mirrored below 0: the remainder's sign",
            |picture| moved(picture, |uv| Vec2::new((uv.x % 1.0).abs(), (uv.y % 1.0).abs())),
            "a_texture_repeats",
        ),
        (
            "the nearest texel",
            |picture| {
                let size = size(&picture);
                spoilt(picture, move |picture, uv| {
                    let place = ((uv() * size).floor() + 0.5) / size;
                    picture.color(&|| place)
                })
            },
            "between_centres_texels_mix_by_nearness",
        ),
        (
            "mixed before it is decoded",
            |picture| {
                let size = size(&picture);
                spoilt(picture, move |picture, uv| {
                    let place = uv() * size - 0.5;
                    let (first, share) = (place.floor(), place - place.floor());
                    let texel = |dx: f32, dy: f32| {
                        let centre = (first + Vec2::new(dx, dy) + 0.5) / size;
                        picture.color(&|| centre).map(encoded)
                    };
                    let low = texel(0.0, 0.0) * (1.0 - share.x) + texel(1.0, 0.0) * share.x;
                    let high = texel(0.0, 1.0) * (1.0 - share.x) + texel(1.0, 1.0) * share.x;
                    (low * (1.0 - share.y) + high * share.y).map(shading::srgb::decode)
                })
            },
            "between_centres_texels_mix_by_nearness",
        ),
        (
            "a seam: the edge does not mix with the other one",
            |picture| {
                let half = 0.5 / size(&picture);
                spoilt(picture, move |picture, uv| {
                    let uv = uv();
                    let place = (uv - uv.floor()).clamp(half, 1.0 - half);
                    picture.color(&|| place)
                })
            },
            "a_texture_has_no_seam",
        ),
        (
            "the coordinates asked several times",
            |picture| spoilt(picture, |picture, uv| picture.color(&|| Vec2::new(uv().x, uv().y))),
            "coordinates_are_asked_for_once",
        ),
        (
            "a panic at NaN",
            |picture| {
                moved(picture, |uv| {
                    assert!(!uv.is_nan(), "no such texel");
                    uv
                })
            },
            "what_is_no_number_has_a_colour_too",
        ),
    ]);
}
