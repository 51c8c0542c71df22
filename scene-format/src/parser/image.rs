use super::Parser;
use super::block::Field;
use super::report::{Read, quoted};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::{Bucket, BucketOrder, Color, Image, TraceDepths};
use crate::span::Spanned;

impl<'s> Parser<'s> {
    pub(super) fn image(&mut self, keyword: Token<'s>) -> Read<Image> {
        const FIELDS: &[&str] =
            &["resolution", "sampler", "aa", "samples", "contrast", "filter", "jitter", "show-aa", "cache", "output"];
        let block = self.open(keyword, FIELDS, &[])?;
        let mut image = Image::default();
        self.fields(&block, |parser, field| {
            match field.text {
                "resolution" => {
                    image.resolution = Some(parser.placed(|parser| Ok([parser.edge(field)?, parser.edge(field)?]))?);
                }
                "sampler" => image.sampler = Some(parser.string(field)?),
                "aa" => {
                    image.aa = Some(parser.placed(|parser| Ok([parser.exponent(field)?, parser.exponent(field)?]))?);
                }
                "samples" => image.samples = Some(parser.count(field)?),
                "contrast" => image.contrast = Some(parser.float(field)?),
                "filter" => image.filter = Some(parser.string(field)?),
                "jitter" => image.jitter = Some(parser.boolean(field)?),
                "show-aa" => image.show_aa = Some(parser.boolean(field)?),
                "cache" => image.cache = Some(parser.boolean(field)?),
                "output" => image.output = Some(parser.string(field)?),
                _ => return Ok(Field::Unknown),
            }
            if let "show-aa" | "cache" | "output" = field.text {
                let message = format!("`{}` does nothing", field.text);
                parser.context.report(Diagnostic::warning(Code::Ignored, field.span, message).label("ignored"));
            }
            Ok(Field::Known)
        })?;
        Ok(image)
    }

    fn edge(&mut self, field: Token<'_>) -> Read<u32> {
        let most = self.context.limits.picture_edge;
        let edge = self.at_least_one(field)?;
        if edge <= most {
            return Ok(edge);
        }
        let message = format!("`{}` must be from 1 to {most}", field.text);
        let error = Diagnostic::error(Code::OverLimit, self.cursor.previous(), message);
        self.fail(error.label(format!("found `{edge}`")))
    }

    /// A count of pixels, which Sunflow raises to the least that is possible; with a warning.
    fn at_least_one(&mut self, field: Token<'_>) -> Read<u32> {
        let number = self.integer(field, i32::MIN.into()..=i32::MAX.into())?;
        if let Ok(pixels @ 1..) = u32::try_from(number) {
            return Ok(pixels);
        }
        let message = format!("`{}` must be 1 or greater", field.text);
        let warning = Diagnostic::warning(Code::OutOfRange, self.cursor.previous(), message);
        self.context.report(warning.label(format!("found `{number}`, taken as 1")));
        Ok(1)
    }

    fn exponent(&mut self, field: Token<'_>) -> Read<i32> {
        Ok(self.integer(field, i32::MIN.into()..=i32::MAX.into())? as i32)
    }

    /// `bucket SIZE ORDER`
    pub(super) fn bucket(&mut self, keyword: Token<'s>) -> Read<Bucket> {
        let size = self.placed(|parser| parser.at_least_one(keyword))?;
        let word = self.word(keyword)?;
        let (mut name, mut reversed) = (word.text, false);
        if let Some((first, second)) = name.split_once(' ').filter(|(first, _)| reverses(first)) {
            (name, reversed) = (second.trim(), !first.is_empty());
        } else if reverses(name) {
            // The quotes around `reverse row` were forgotten.
            (name, reversed) = (self.word(keyword)?.text, true);
        }
        let order = BucketOrder::from_name(name).unwrap_or_else(|| {
            let default = BucketOrder::default();
            let warning =
                Diagnostic::warning(Code::UnknownOrder, word.span, format!("unknown bucket order {}", quoted(word)))
                    .label(format!("taken as `{}`", default.name()))
                    .help(format!("the orders are {}", BucketOrder::ALL.map(BucketOrder::name).join(", ")));
            self.context.report(warning);
            default
        });
        Ok(Bucket { size, order: Spanned::new(order, word.span.to(self.cursor.previous())), reversed })
    }

    pub(super) fn trace_depths(&mut self, keyword: Token<'s>) -> Read<TraceDepths> {
        let block = self.open(keyword, &["diff", "refl", "refr"], &[])?;
        let mut depths = TraceDepths::default();
        self.fields(&block, |parser, field| {
            match field.text {
                "diff" => depths.diffuse = Some(parser.count(field)?),
                "refl" => depths.reflection = Some(parser.count(field)?),
                "refr" => depths.refraction = Some(parser.count(field)?),
                _ => return Ok(Field::Unknown),
            }
            Ok(Field::Known)
        })?;
        Ok(depths)
    }

    pub(super) fn background(&mut self, keyword: Token<'s>) -> Read<Spanned<Color>> {
        let block = self.open(keyword, &["color"], &[])?;
        let mut color = None;
        self.fields(&block, |parser, field| {
            if field.text != "color" {
                return Ok(Field::Unknown);
            }
            color = Some(parser.color(field)?);
            Ok(Field::Known)
        })?;
        self.require(&block, color, "color", "color r g b")
    }
}

fn reverses(word: &str) -> bool {
    matches!(word, "reverse" | "inverse" | "invert")
}
