use super::Parser;
use super::block::{Block, Field};
use super::report::Read;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::{BezierMesh, ParticleSource, Shape, Subdivision, Triple};
use crate::span::Spanned;

/// The fields of a Bezier mesh, as far as they were there.
#[derive(Default)]
pub(super) struct BezierFields {
    size: Option<Spanned<[u32; 2]>>,
    wrap: Option<Spanned<[bool; 2]>>,
    points: Option<Spanned<Vec<Triple>>>,
    subdivision: Subdivision,
}

/// The fields of particles, as far as they were there.
#[derive(Default)]
pub(super) struct ParticleFields {
    points: Option<Spanned<Vec<Triple>>>,
    file: Option<Spanned<String>>,
    little_endian: Option<Spanned<()>>,
    count: Option<Spanned<u32>>,
    radius: Option<Spanned<f32>>,
}

impl<'s> Parser<'s> {
    pub(super) fn subdivision_field(&mut self, subdivision: &mut Subdivision, field: Token<'s>) -> Read<Field> {
        match field.text {
            "subdivs" => {
                let count = self.placed(|parser| Ok(parser.integer(field, 1..=i32::MAX.into())? as u32))?;
                subdivision.count = Some(count);
            }
            "smooth" => subdivision.smooth = Some(self.boolean(field)?),
            _ => return Ok(Field::Unknown),
        }
        Ok(Field::Known)
    }

    pub(super) fn bezier_field(&mut self, bezier: &mut BezierFields, field: Token<'s>) -> Read<Field> {
        match field.text {
            "n" => {
                bezier.size = Some(self.placed(|parser| {
                    let mut count = || Ok(parser.integer(field, 1..=i32::MAX.into())? as u32);
                    Ok([count()?, count()?])
                })?);
            }
            "wrap" => {
                let wrap = self.placed(|parser| Ok([parser.boolean(field)?.value, parser.boolean(field)?.value]))?;
                bezier.wrap = Some(wrap);
            }
            "points" => {
                let Some(size) = bezier.size else { return self.too_early(field, "n") };
                let [along_u, along_v] = size.value.map(|count| count as usize);
                let list = self.announced(field, along_u.saturating_mul(along_v), size.span)?;
                bezier.points = Some(self.placed(|parser| parser.rows(list))?);
                self.expect_end(list)?;
            }
            _ => return self.subdivision_field(&mut bezier.subdivision, field),
        }
        Ok(Field::Known)
    }

    pub(super) fn finish_bezier(&mut self, block: &Block<'s>, bezier: BezierFields) -> Read<BezierMesh> {
        let size = self.require(block, bezier.size, "n", "n <nu> <nv>")?;
        let points = self.require(block, bezier.points, "points", "points x y z ...")?;
        let wrap = bezier.wrap.map_or([false; 2], |wrap| wrap.value);
        for (count, wraps) in size.value.into_iter().zip(wrap) {
            let enough = if wraps { count >= 3 } else { count >= 4 };
            if !enough {
                let least = if wraps { 3 } else { 4 };
                let error = Diagnostic::error(Code::OutOfRange, size.span, "a Bezier mesh needs more points")
                    .label(format!("found {count}, where a patch has at least {least}"))
                    .help("a patch has 4 points along each edge; the next one shares a row with it, so 7, 10 ...");
                return self.fail(error);
            }
        }
        Ok(BezierMesh { size, wrap: bezier.wrap, points, subdivision: bezier.subdivision })
    }

    pub(super) fn particle_field(&mut self, particles: &mut ParticleFields, field: Token<'s>) -> Read<Field> {
        match field.text {
            "filename" => particles.file = Some(self.string(field)?),
            "little_endian" => particles.little_endian = Some(Spanned::new((), field.span)),
            "points" => {
                let list = self.list(field)?;
                particles.points = Some(self.placed(|parser| parser.rows(list))?);
                self.expect_end(list)?;
            }
            "num" => particles.count = Some(self.count(field)?),
            "radius" => particles.radius = Some(self.positive(field)?),
            _ => return Ok(Field::Unknown),
        }
        Ok(Field::Known)
    }

    pub(super) fn finish_particles(&mut self, block: &Block<'s>, particles: ParticleFields) -> Read<Shape> {
        let ParticleFields { points, file, little_endian, count, radius } = particles;
        let centers = match (points, file) {
            (Some(points), None) => ParticleSource::Points(points),
            (None, Some(name)) => ParticleSource::File { name, little_endian },
            (Some(points), Some(file)) => {
                let error = Diagnostic::error(Code::Contradiction, file.span, "the particles come from two places")
                    .note(points.span, "these points are here already");
                return self.fail(error);
            }
            (None, None) => self.require(block, None, "points", "points <count> x y z ...` or `filename <file>")?,
        };
        let radius = self.require(block, radius, "radius", "radius <number>")?;
        Ok(Shape::Particles { centers, count, radius })
    }
}
