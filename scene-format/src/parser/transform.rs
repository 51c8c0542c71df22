use super::keywords::nearest;
use super::report::{Read, quoted};
use super::{Parser, Reported};
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::scene_file::{Transform, TransformStep};
use crate::span::Spanned;

const STEPS: &[&str] =
    &["translate", "scaleu", "scale", "scalex", "scaley", "scalez", "rotatex", "rotatey", "rotatez", "rotate"];

impl<'s> Parser<'s> {
    /// What follows the word `transform`: one transform, or several of a moving object, whose first is taken.
    pub(super) fn transform(&mut self, field: Token<'s>) -> Read<Spanned<Transform>> {
        match self.take("steps") {
            Some(steps) => self.moving(steps, Self::matrix),
            None => self.matrix(field),
        }
    }

    /// What follows the word `steps`: `N times T0 T1` and N things. Gives the first.
    pub(super) fn moving<T>(
        &mut self,
        steps: Token<'s>,
        mut read: impl FnMut(&mut Self, Token<'s>) -> Read<T>,
    ) -> Read<T> {
        let count = self.integer(steps, 1..=i32::MAX.into())?;
        let times = self.expect("times", "`steps` needs `times` after its count")?;
        let _times: [f32; 2] = self.floats(times)?;
        let warning = Diagnostic::warning(steps.span, "movement is not rendered");
        self.context.report(warning.label("everything stands where the first step puts it"));
        let first = read(self, steps)?;
        for _ in 1..count {
            read(self, steps)?;
        }
        Ok(first)
    }

    fn matrix(&mut self, field: Token<'s>) -> Read<Spanned<Transform>> {
        let start = self.cursor.here();
        let transform = if let Some(row) = self.take("row") {
            let elements: [f32; 16] = self.floats(row)?;
            let [.., a, b, c, d] = elements;
            self.check_last_row(row, [a, b, c, d])?;
            Transform::Row(elements)
        } else if let Some(col) = self.take("col") {
            let elements: [f32; 16] = self.floats(col)?;
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
        let error = Diagnostic::error(matrix, "the last row of a transform must be 0 0 0 1")
            .label(format!("found {a} {b} {c} {d}"))
            .help("`row` takes the matrix row by row, `col` column by column: exchange them if it is the other way");
        self.fail(error)
    }

    fn steps(&mut self) -> Read<Vec<TransformStep>> {
        let mut steps = Vec::new();
        let mut failed = false;
        while let Some(word) = self.cursor.peek().filter(|word| !word.is_open() && !word.is_close()) {
            if self.cursor.at_statement() || self.ends_transform(word) {
                break;
            }
            self.cursor.next();
            match self.step(word) {
                Ok(step) => steps.extend(step),
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
            "translate" => TransformStep::Translate(self.floats(word)?),
            "scaleu" => TransformStep::ScaleUniform(self.float(word)?),
            "scale" => TransformStep::Scale(self.floats(word)?),
            "scalex" => TransformStep::ScaleX(self.float(word)?),
            "scaley" => TransformStep::ScaleY(self.float(word)?),
            "scalez" => TransformStep::ScaleZ(self.float(word)?),
            "rotatex" => TransformStep::RotateX(self.float(word)?),
            "rotatey" => TransformStep::RotateY(self.float(word)?),
            "rotatez" => TransformStep::RotateZ(self.float(word)?),
            "rotate" => {
                let [x, y, z, degrees] = self.floats(word)?;
                TransformStep::Rotate { axis: [x, y, z], degrees }
            }
            _ => {
                let message = format!("unknown step {} in a transform", quoted(word));
                let diagnostic = match nearest(word.text, STEPS) {
                    Some(meant) => Diagnostic::error(word.span, message).help(format!("did you mean `{meant}`?")),
                    None => Diagnostic::warning(word.span, message).label("skipped"),
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
