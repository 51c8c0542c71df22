//! The kit of a texture: a picture laid over a surface.
//!
//! **The idea.** A picture is known at its texels' centres. Between them it is mixed; beyond its edges it begins again.
//!
//! ```text
//!   v = 1 +---+---+---+     row 0 of the file is at the top, v = 0 at the bottom
//!         | 0 | 1 | 2 |     the centre of column i of w: u = (i + 0.5) / w
//!         +---+---+---+     of row j of h: v = 1 - (j + 0.5) / h
//!         | 3 | 4 | 5 |     between four centres: the mean, weighted by how near each is
//!   v = 0 +---+---+---+
//!       u = 0         1
//! ```
//!
//! **The contract.** A [`Picture`] makes a [`Texture`] of an [`ImageTexture`], which holds the texels of a file, 8-bit sRGB. Its colours are
//! linear: `decode` comes before the mixing. It asks for the coordinates at most once, since they are computed then.
//!
//! **Hard cases.** Coordinates below 0, where remainders are negative. The seam, where the last column mixes with the first. Pictures of one
//! texel. NaN and infinity: any colour, but a colour.
//!
//! **Literature.** Williams: Pyramidal Parametrics, SIGGRAPH 1983. Heckbert: Survey of Texture Mapping, 1986. IEC 61966-2-1 (sRGB).
//!
//! **Exercises.** Pass the kit for the nearest texel up to the centres' law, then mix. Add a pyramid against aliasing: what would a texture have
//! to be told that it is not? Beat [`ImageTexture`] in time with another order of the texels in memory.
//!
//! | mistake | law that names it |
//! |---|---|
//! | nothing is returned | [`a_picture_of_one_texel_is_that_colour_everywhere`] |
//! | sRGB taken for linear | [`a_picture_of_one_texel_is_that_colour_everywhere`] |
//! | v flipped | [`a_texel_s_centre_has_its_colour`] |
//! | u mirrored | [`a_texel_s_centre_has_its_colour`] |
//! | u and v exchanged | [`a_texel_s_centre_has_its_colour`] |
//! | texel off by half | [`a_texel_s_centre_has_its_colour`] |
//! | texture not repeated: clamped | [`a_texture_repeats`] |
//! | mirrored below 0: the remainder's sign | [`a_texture_repeats`] |
//! | the nearest texel | [`between_centres_texels_mix_by_nearness`] |
//! | mixed before it is decoded | [`between_centres_texels_mix_by_nearness`] |
//! | a seam: the edge does not mix with the other one | [`a_texture_has_no_seam`] |
//! | the coordinates asked several times | [`coordinates_are_asked_for_once`] |
//! | a panic at NaN | [`what_is_no_number_has_a_colour_too`] |

use std::cell::Cell;
use std::sync::Arc;

use geometry::conformance::{Counterexample, Figure, Ink, Trial, Verdict, same, wild_numbers};
use glam::{DVec2, Vec2};
use proptest::prelude::*;

use crate::{Color, ImageTexture, Texture, srgb};

/// A texture from a picture's texels.
pub type Picture = fn(ImageTexture) -> Arc<dyn Texture>;

/// A picture: its texels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Texels {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// 8-bit sRGB.
    pub texels: Vec<[u8; 3]>,
}

/// Pictures of 1 to 5 texels along each edge.
pub fn pictures() -> impl Strategy<Value = Texels> {
    (1_usize..6, 1_usize..6).prop_flat_map(|(width, height)| {
        prop::collection::vec(any::<[u8; 3]>(), width * height).prop_map(move |texels| Texels { width, height, texels })
    })
}

impl Texels {
    fn texture(&self, picture: &Picture) -> Arc<dyn Texture> {
        picture(
            ImageTexture::new(self.width, self.height, self.texels.clone()).expect("as many texels as there must be"),
        )
    }

    /// A texel's linear colour; beyond the edges the picture begins again.
    fn texel(&self, column: i64, row: i64) -> [f64; 3] {
        let [column, row] =
            [(column, self.width), (row, self.height)].map(|(number, count)| number.rem_euclid(count as i64) as usize);
        self.texels[row * self.width + column].map(|byte| srgb::decode_byte(byte).into())
    }

    /// The middle of a texel.
    fn centre(&self, column: i64, row: i64) -> DVec2 {
        let place =
            DVec2::new(column as f64 + 0.5, row as f64 + 0.5) / DVec2::new(self.width as f64, self.height as f64);
        DVec2::new(place.x, 1.0 - place.y)
    }

    /// The verdict on the colour at a place; right to a part in 250, a step of 8 bits, times how much the picture changes there.
    fn shows(&self, picture: &Picture, uv: DVec2, expected: [f64; 3], exact: f64) -> Verdict {
        let found = self.texture(picture).color(&|| uv.as_vec2());
        let near = |(found, expected): (f32, f64)| (f64::from(found) - expected).abs() <= exact;
        if found.to_array().into_iter().zip(expected).all(near) {
            return Ok(());
        }
        let expected = Color::from(expected.map(|channel| channel as f32));
        let at = format!(" at {:?}", uv.as_vec2());
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|corner| corner.extend(0.0));
        let figure = Figure::flat().outline(&corners).point(uv.extend(0.0), Ink::Expected, "u, v");
        Err(Counterexample::new(format!("{expected:?}{at}"), format!("{found:?}")).drawn(figure))
    }
}

/// How exact a colour must be where the coordinates are an `f32`'s, up to 4, and the picture has up to 5 texels.
const EXACT: f64 = 1e-5;

/// A place on a picture, as a texel and a place in it.
fn places() -> impl Strategy<Value = (Texels, usize)> {
    (pictures(), any::<prop::sample::Index>()).prop_map(|(picture, at)| {
        let at = at.index(picture.texels.len());
        (picture, at)
    })
}

/// The texel's colour, decoded from sRGB.
pub fn a_picture_of_one_texel_is_that_colour_everywhere(picture: &Picture, trial: &Trial) -> Verdict {
    trial.search((any::<[u8; 3]>(), 0.1..0.9, 0.1..0.9), |&(texel, u, v)| {
        let one = Texels { width: 1, height: 1, texels: vec![texel] };
        one.shows(picture, DVec2::new(u, v), one.texel(0, 0), EXACT)
    })
}

/// Just there nothing is mixed in.
pub fn a_texel_s_centre_has_its_colour(picture: &Picture, trial: &Trial) -> Verdict {
    trial.search(places(), |(texels, at)| {
        let [column, row] = [at % texels.width, at / texels.width].map(|number| number as i64);
        texels.shows(picture, texels.centre(column, row), texels.texel(column, row), EXACT)
    })
}

/// A whole number more or less of u or v changes nothing.
pub fn a_texture_repeats(picture: &Picture, trial: &Trial) -> Verdict {
    trial.search((places(), -3..4_i32, -3..4_i32), |((texels, at), across, up)| {
        let [column, row] = [at % texels.width, at / texels.width].map(|number| number as i64);
        let uv = texels.centre(column, row) + DVec2::new(f64::from(*across), f64::from(*up));
        texels.shows(picture, uv, texels.texel(column, row), EXACT)
    })
}

/// The mean of four texels by how near their centres are, in linear light.
fn mixed(texels: &Texels, picture: &Picture, (column, row): (i64, i64), (x, y): (f64, f64)) -> Verdict {
    let uv = texels.centre(column, row) + DVec2::new(x / texels.width as f64, -y / texels.height as f64);
    let corner = |dx, dy, share: f64| texels.texel(column + dx, row + dy).map(|channel| channel * share);
    let four = [
        corner(0, 0, (1.0 - x) * (1.0 - y)),
        corner(1, 0, x * (1.0 - y)),
        corner(0, 1, (1.0 - x) * y),
        corner(1, 1, x * y),
    ];
    texels.shows(picture, uv, [0, 1, 2].map(|channel| four.iter().map(|texel| texel[channel]).sum()), EXACT)
}

/// Between four centres inside the picture.
pub fn between_centres_texels_mix_by_nearness(picture: &Picture, trial: &Trial) -> Verdict {
    let inside = (pictures(), any::<prop::sample::Index>(), any::<prop::sample::Index>(), 0.0..1.0, 0.0..1.0);
    let inside = inside.prop_filter("one row or column", |(texels, ..)| texels.width > 1 && texels.height > 1);
    trial.search(inside, |(texels, column, row, x, y)| {
        let place = (column.index(texels.width - 1) as i64, row.index(texels.height - 1) as i64);
        mixed(texels, picture, place, (*x, *y))
    })
}

/// Between the last column and the first, the last row and the first.
pub fn a_texture_has_no_seam(picture: &Picture, trial: &Trial) -> Verdict {
    trial.search((pictures(), -6..7_i64, -6..7_i64, 0.0..1.0, 0.0..1.0), |(texels, column, row, x, y)| {
        mixed(texels, picture, (*column, *row), (*x, *y))
    })
}

/// They are computed when asked for.
pub fn coordinates_are_asked_for_once(picture: &Picture, trial: &Trial) -> Verdict {
    trial.search((pictures(), 0.0_f32..1.0, 0.0_f32..1.0), |(texels, u, v)| {
        let asked = Cell::new(0);
        texels.texture(picture).color(&|| {
            asked.set(asked.get() + 1);
            Vec2::new(*u, *v)
        });
        same(&1, &asked.get())
    })
}

/// A number for each channel, from 0 to 1: what a scene's file says must not end the program.
pub fn what_is_no_number_has_a_colour_too(picture: &Picture, trial: &Trial) -> Verdict {
    trial.search((pictures(), wild_numbers(), wild_numbers()), |(texels, u, v)| {
        let found = texels.texture(picture).color(&|| Vec2::new(*u, *v));
        let is_color = found.to_array().iter().all(|channel| (0.0..=1.0).contains(channel));
        if is_color { Ok(()) } else { Err(Counterexample::new("channels from 0 to 1", format!("{found:?}"))) }
    })
}

geometry::kit! { $crate
    /// Names the laws of a texture as tests: of a function from a picture's texels to a [`crate::Texture`].
    texture_conformance, Picture, texture;
    a_picture_of_one_texel_is_that_colour_everywhere: "nothing is returned yet; or the bytes are not decoded to linear light";
    a_texel_s_centre_has_its_colour: "v counts from the bottom and rows from the top; or a texel's centre is taken for its corner";
    a_texture_repeats: "coordinates are clamped, or a remainder below 0 is not brought back";
    between_centres_texels_mix_by_nearness: "the nearest texel is taken, the shares are exchanged, or texels are mixed before they are decoded";
    a_texture_has_no_seam: "the neighbour of the last column is clamped, not the first one";
    coordinates_are_asked_for_once: "the coordinates are asked for again for each texel or axis";
    what_is_no_number_has_a_colour_too: "an index is made of NaN or infinity, or of a number too large for the remainder";
}
