use super::keywords::nearest;
use super::layout::Mark;
use super::report::{Read, quoted};
use super::{Parser, Reported};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::{Transform, TransformStep};
use crate::span::Spanned;

const STEPS: &[&str] =
    &["translate", "scaleu", "scale", "scalex", "scaley", "scalez", "rotatex", "rotatey", "rotatez", "rotate"];

impl<'s> Parser<'s> {
    /// What follows the word `transform`: one transform, or several of a moving object.
    pub(super) fn transform(&mut self, field: Token<'s>) -> Read<Spanned<Transform>> {
        let Some(steps) = self.take("steps") else { return self.matrix(field) };
        self.placed(|parser| {
            let (times, steps) = parser.moving(steps, Self::matrix)?;
            Ok(Transform::Moving { times, steps })
        })
    }

    /// What follows the word `steps`: `N times T0 T1` and N things.
    pub(super) fn moving<T>(
        &mut self,
        steps: Token<'s>,
        mut read: impl FnMut(&mut Self, Token<'s>) -> Read<T>,
    ) -> Read<(Spanned<[f32; 2]>, Vec<T>)> {
        let count = self.integer(steps, 1..=i32::MAX.into())?;
        let times = self.expect("times", "`steps` needs `times` after its count")?;
        let times = self.floats(times)?;
        let warning = Diagnostic::warning(Code::MovementNotRendered, steps.span, "movement is not rendered");
        self.context.report(warning.label("everything stands where the first step puts it"));
        // Not collected by a size hint: the count is the file's, and may be anything.
        let mut places = Vec::new();
        for _ in 0..count {
            if let Some(place) = self.cursor.peek() {
                self.mark(place, Mark::Field);
            }
            places.push(read(self, steps)?);
        }
        Ok((times, places))
    }

    pub(super) fn matrix(&mut self, field: Token<'s>) -> Read<Spanned<Transform>> {
        let start = self.cursor.here();
        let transform = if let Some(row) = self.take("row") {
            let elements = self.floats::<16>(row)?.value;
            let [.., a, b, c, d] = elements;
            self.check_last_row(row, [a, b, c, d])?;
            Transform::Row(elements)
        } else if let Some(col) = self.take("col") {
            let elements = self.floats::<16>(col)?.value;
            let [_, _, _, a, _, _, _, b, _, _, _, c, _, _, _, d] = elements;
            self.check_last_row(col, [a, b, c, d])?;
            Transform::Col(elements)
        } else if let Some(open) = self.take("{") {
            let steps = self.steps()?;
            self.close_group(open, "the transform")?;
            Transform::Steps(steps)
        } else {
            return self.fail_expected(format!("`{}` needs a transform", field.text), "`{`, `row` or `col`");
        };
        Ok(Spanned::new(transform, start.to(self.cursor.previous())))
    }

    /// A transform keeps parallels parallel: its matrix ends with 0 0 0 1.
    fn check_last_row(&mut self, form: Token<'_>, row: [f32; 4]) -> Read<()> {
        if row == [0.0, 0.0, 0.0, 1.0] {
            return Ok(());
        }
        let [a, b, c, d] = row;
        let matrix = form.span.to(self.cursor.previous());
        let error = Diagnostic::error(Code::NotAffine, matrix, "the last row of a transform must be 0 0 0 1")
            .label(format!("found {a} {b} {c} {d}"))
            .help("`row` takes the matrix row by row, `col` column by column: exchange them if it is the other way");
        self.fail(error)
    }

    fn steps(&mut self) -> Read<Vec<Spanned<TransformStep>>> {
        let mut steps = Vec::new();
        let mut failed = false;
        while let Some(word) = self.cursor.peek().filter(|word| !word.is_open() && !word.is_close()) {
            if self.cursor.at_statement() || self.ends_transform(word) {
                break;
            }
            self.cursor.next();
            self.mark(word, Mark::Field);
            match self.step(word) {
                Ok(step) => {
                    let place = word.span.to(self.cursor.previous());
                    steps.extend(step.map(|step| Spanned::new(step, place)));
                }
                Err(Reported) => {
                    failed = true;
                    self.skip_to_step();
                }
            }
        }
        if failed {
            // The brace that closes the steps is taken by the caller only when all is well.
            self.take("}");
            return Err(Reported);
        }
        Ok(steps)
    }

    /// A field of an object or camera that stands among the steps: the brace before it is missing.
    fn ends_transform(&self, word: Token<'_>) -> bool {
        matches!(word.text, "type" | "name" | "shader" | "shaders" | "fov" | "aspect")
    }

    /// One step; `None` for one that is unknown and was skipped.
    fn step(&mut self, word: Token<'s>) -> Read<Option<TransformStep>> {
        Ok(Some(match word.text {
            "translate" => TransformStep::Translate(self.floats(word)?.value),
            "scaleu" => TransformStep::ScaleUniform(self.number(word)?),
            "scale" => TransformStep::Scale(self.floats(word)?.value),
            "scalex" => TransformStep::ScaleX(self.number(word)?),
            "scaley" => TransformStep::ScaleY(self.number(word)?),
            "scalez" => TransformStep::ScaleZ(self.number(word)?),
            "rotatex" => TransformStep::RotateX(self.number(word)?),
            "rotatey" => TransformStep::RotateY(self.number(word)?),
            "rotatez" => TransformStep::RotateZ(self.number(word)?),
            "rotate" => {
                let [x, y, z, degrees] = self.floats(word)?.value;
                TransformStep::Rotate { axis: [x, y, z], degrees }
            }
            _ => {
                let message = format!("unknown step {} in a transform", quoted(word));
                let diagnostic = match nearest(word.text, STEPS) {
                    Some(meant) => Diagnostic::error(Code::UnknownStep, word.span, message)
                        .help(format!("did you mean `{meant}`?")),
                    None => Diagnostic::warning(Code::UnknownStep, word.span, message).label("skipped"),
                };
                self.context.report(diagnostic);
                self.skip_to_step();
                return Ok(None);
            }
        }))
    }

    fn skip_to_step(&mut self) {
        while let Some(word) = self.cursor.peek() {
            if word.is_open() || word.is_close() || STEPS.contains(&word.text) || self.cursor.at_statement() {
                return;
            }
            if self.ends_transform(word) {
                return;
            }
            self.cursor.next();
        }
    }
}
