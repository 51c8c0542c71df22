use super::Parser;
use super::block::{Block, Field};
use super::cursor::Cursor;
use super::layout::Mark;
use super::report::Read;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::number::{BadNumber, Number};
use crate::scene_file::{Mesh, MeshForm, PerVertex, Triple};
use crate::span::{Span, Spanned};

/// Rows are read in pieces of this many: so a count that is not true takes no memory.
const PIECE: usize = 4096;

/// The fields of a mesh, as far as they were there.
pub(super) struct MeshFields<'s> {
    form: MeshForm,
    points: Option<Spanned<Vec<Triple>>>,
    triangles: Option<Spanned<Vec<[u32; 3]>>>,
    normals: Spanned<PerVertex<3>>,
    uvs: Spanned<PerVertex<2>>,
    face_shaders: Option<Spanned<Vec<u32>>>,
    /// Where the triangles' numbers begin: they have no places of their own, and are looked up again for a message.
    triangles_begin: Option<Cursor<'s>>,
}

/// A list whose length stands before it.
#[derive(Clone, Copy)]
pub(super) struct List<'s> {
    /// What is listed, as messages call it.
    what: &'s str,
    count: usize,
    /// Where the count stands.
    counted_at: Span,
}

impl MeshFields<'_> {
    pub(super) fn new(form: MeshForm) -> Self {
        Self {
            form,
            points: None,
            triangles: None,
            normals: Spanned::default(),
            uvs: Spanned::default(),
            face_shaders: None,
            triangles_begin: None,
        }
    }
}

impl<'s> Parser<'s> {
    pub(super) fn mesh_field(&mut self, mesh: &mut MeshFields<'s>, field: Token<'s>) -> Read<Field> {
        if mesh.form != MeshForm::Generic {
            return Ok(Field::Unknown);
        }
        match field.text {
            "points" => {
                let list = self.list(field)?;
                mesh.points = Some(self.placed(|parser| parser.rows(list))?);
                self.expect_end(list)?;
            }
            "triangles" => {
                let list = self.list(field)?;
                mesh.triangles_begin = Some(self.cursor.clone());
                mesh.triangles = Some(self.placed(|parser| parser.rows(list))?);
                self.expect_end(list)?;
            }
            "normals" => mesh.normals = self.placed(|parser| parser.per_vertex(mesh, field))?,
            "uvs" => mesh.uvs = self.placed(|parser| parser.per_vertex(mesh, field))?,
            _ => {
                let Some(triangles) = &mesh.triangles else { return self.too_early(field, "triangles") };
                let list = self.announced(field, triangles.len(), field.span)?;
                let rows: Spanned<Vec<[u32; 1]>> = self.placed(|parser| parser.rows(list))?;
                mesh.face_shaders = Some(Spanned::new(rows.value.into_flattened(), rows.span));
                self.expect_end(list)?;
            }
        }
        Ok(Field::Known)
    }

    /// The old form: two counts, then lines `v x y z nx ny nz u v` and `t a b c`. The first count is taken already.
    pub(super) fn mesh_lines(&mut self, mesh: &mut MeshFields<'s>, first: Token<'s>) -> Read<Field> {
        if mesh.form == MeshForm::Generic || mesh.points.is_some() {
            return Ok(Field::Unknown);
        }
        let Ok(count) = u32::read(first.text) else {
            let message = "a mesh begins with the counts of its points and triangles";
            let error = Diagnostic::error(Code::NotANumber, first.span, message);
            return self.fail(error.label(format!("expected {}", u32::KIND)));
        };
        let points = List { what: "points", ..self.announced(first, count as usize, first.span)? };
        let triangles = List { what: "triangles", ..self.list(first)? };
        let capacity = self.capacity(points.count, 9);
        let (mut positions, mut normals) = (Vec::with_capacity(capacity), Vec::with_capacity(capacity));
        let mut uvs = Vec::with_capacity(capacity);
        let place = self.cursor.here();
        self.lettered_rows("v", points, |[x, y, z, nx, ny, nz, u, v]: [f32; 8]| {
            positions.push([x, y, z]);
            normals.push([nx, ny, nz]);
            uvs.push([u, v]);
        })?;
        let place = place.to(self.cursor.previous());
        mesh.points = Some(Spanned::new(positions, place));
        mesh.normals = Spanned::new(PerVertex::Vertex(normals), place);
        mesh.uvs = Spanned::new(PerVertex::Vertex(uvs), place);
        mesh.triangles_begin = Some(self.cursor.clone());
        let place = self.cursor.here();
        let mut corners = Vec::with_capacity(self.capacity(triangles.count, 4));
        self.lettered_rows("t", triangles, |row| corners.push(row))?;
        mesh.triangles = Some(Spanned::new(corners, place.to(self.cursor.previous())));
        Ok(Field::Known)
    }

    pub(super) fn finish_mesh(&mut self, block: &Block<'s>, mesh: MeshFields<'s>) -> Read<Mesh> {
        let form = if mesh.form == MeshForm::Generic { "points <count> x y z ..." } else { "<points> <triangles>" };
        let points = self.require(block, mesh.points, "points", form)?;
        let triangles = self.require(block, mesh.triangles, "triangles", "triangles <count> a b c ...")?;
        let out_of_range = |index: &u32| *index as usize >= points.len();
        if let Some(at) = triangles.as_flattened().iter().position(out_of_range) {
            let number = mesh.triangles_begin.and_then(|begin| number_at(begin, at));
            let span = number.map_or(block.keyword.span, |number| number.span);
            let last = points.len().checked_sub(1).map_or_else(String::new, |last| format!(": the last one is {last}"));
            let error =
                Diagnostic::error(Code::NoSuchPoint, span, "a triangle has a corner that is no point of the mesh")
                    .label(format!("in triangle number {}, counted from 0", at / 3))
                    .help(format!("points are counted from 0, and there are {}{last}", points.len()));
            return self.fail(error);
        }
        let MeshFields { form, normals, uvs, face_shaders, .. } = mesh;
        Ok(Mesh { form, points, triangles, normals, uvs, face_shaders })
    }

    fn per_vertex<const N: usize>(&mut self, mesh: &MeshFields<'s>, field: Token<'s>) -> Read<PerVertex<N>> {
        if self.take("none").is_some() {
            return Ok(PerVertex::None);
        }
        let values = if let Some(vertex) = self.take("vertex") {
            let Some(points) = &mesh.points else { return self.too_early(field, "points") };
            let list = List { what: field.text, count: points.len(), counted_at: vertex.span };
            let rows = self.rows(list)?;
            self.expect_end(list)?;
            PerVertex::Vertex(rows)
        } else if let Some(facevarying) = self.take("facevarying") {
            let Some(triangles) = &mesh.triangles else { return self.too_early(field, "triangles") };
            let list = List { what: field.text, count: triangles.len(), counted_at: facevarying.span };
            let rows = self.groups(list)?;
            self.expect_end(list)?;
            PerVertex::FaceVarying(rows)
        } else {
            let message = format!("`{}` needs to know what its values belong to", field.text);
            return self.fail_expected(message, "`none`, `vertex` or `facevarying`");
        };
        Ok(values)
    }

    /// Reports that values stand before the list that they are counted by.
    pub(super) fn too_early<T>(&mut self, field: Token<'_>, name: &str) -> Read<T> {
        let message = format!("`{}` stands before `{name}`", field.text);
        let error = Diagnostic::error(Code::TooEarly, field.span, message);
        let label = format!("how many {name} there are is not known yet");
        self.fail(error.label(label).help(format!("move `{}` behind `{name}`", field.text)))
    }

    /// A count and so many numbers.
    pub(super) fn number_list(&mut self, field: Token<'s>) -> Read<Vec<f32>> {
        let list = self.list(field)?;
        let rows: Vec<[f32; 1]> = self.rows(list)?;
        self.expect_end(list)?;
        Ok(rows.into_flattened())
    }

    /// The count that a list begins with.
    pub(super) fn list(&mut self, field: Token<'s>) -> Read<List<'s>> {
        let count: u32 = self.number(field)?;
        self.announced(field, count as usize, self.cursor.previous())
    }

    /// A list of a known length, if that is allowed.
    pub(super) fn announced(&mut self, field: Token<'s>, count: usize, counted_at: Span) -> Read<List<'s>> {
        let most = self.context.limits.elements;
        if count > most {
            let message = format!("an object may have at most {most} elements");
            let error = Diagnostic::error(Code::OverLimit, counted_at, message);
            return self.fail(error.label(format!("{count} are announced here")));
        }
        Ok(List { what: field.text, count, counted_at })
    }

    /// `count` rows of `N` numbers.
    pub(super) fn rows<const N: usize, T: Number>(&mut self, list: List<'_>) -> Read<Vec<[T; N]>> {
        let mut rows: Vec<[T; N]> = Vec::with_capacity(self.capacity(list.count, N));
        while rows.len() < list.count {
            let from = rows.len();
            rows.resize((from + PIECE).min(list.count), [T::default(); N]);
            let piece = rows.get_mut(from..).unwrap_or_default();
            self.fill(list, from, N, piece.as_flattened_mut())?;
        }
        Ok(rows)
    }

    /// `count` groups of three rows of `N` numbers.
    fn groups<const N: usize>(&mut self, list: List<'_>) -> Read<Vec<[[f32; N]; 3]>> {
        let mut groups: Vec<[[f32; N]; 3]> = Vec::with_capacity(self.capacity(list.count, 3 * N));
        while groups.len() < list.count {
            let from = groups.len();
            groups.resize((from + PIECE).min(list.count), [[0.0; N]; 3]);
            let piece = groups.get_mut(from..).unwrap_or_default();
            self.fill(list, from, 3 * N, piece.as_flattened_mut().as_flattened_mut())?;
        }
        Ok(groups)
    }

    /// Reads the numbers of some elements of a list, `width` each, from the element numbered `from` on.
    fn fill<T: Number>(&mut self, list: List<'_>, from: usize, width: usize, numbers: &mut [T]) -> Read<()> {
        let mut filled = 0;
        while let Some(rest) = numbers.get_mut(filled..).filter(|rest| !rest.is_empty()) {
            if !self.marks_rows() {
                filled += self.cursor.take_numbers(rest);
            } else if let Some(token) = self.cursor.peek().filter(|_| begins_row(from * width + filled, width)) {
                self.mark(token, Mark::Row);
            }
            if let Some(number) = numbers.get_mut(filled) {
                *number = self.list_number(list, from + filled / width)?;
                filled += 1;
            }
        }
        Ok(())
    }

    /// Reads the rows of a list that begin with a letter.
    fn lettered_rows<const N: usize, T: Number>(
        &mut self,
        letter: &str,
        list: List<'_>,
        mut each: impl FnMut([T; N]),
    ) -> Read<()> {
        let byte = letter.bytes().next().unwrap_or_default();
        let mut row = 0;
        loop {
            if !self.marks_rows() {
                row += self.cursor.take_rows(byte, list.count - row, &mut each);
            }
            if row == list.count {
                return Ok(());
            }
            self.line_start(letter, list, row)?;
            let mut numbers = [T::default(); N];
            for number in &mut numbers {
                *number = self.list_number(list, row)?;
            }
            each(numbers);
            row += 1;
        }
    }

    fn list_number<T: Number>(&mut self, list: List<'_>, row: usize) -> Read<T> {
        let number = match self.cursor.peek().map(|token| T::read(token.text)) {
            Some(Ok(number)) => number,
            Some(Err(bad)) => return self.ends_early(list, row, T::KIND, bad),
            None => return self.ends_early(list, row, T::KIND, BadNumber::NotANumber),
        };
        self.cursor.next();
        Ok(number)
    }

    /// Room for a list as long as announced, or as long as the rest of the file can hold: a row of `N` words takes at least
    /// two bytes for each.
    fn capacity(&self, count: usize, words: usize) -> usize {
        count.min(self.cursor.remaining() / (2 * words))
    }

    fn line_start(&mut self, word: &str, list: List<'_>, row: usize) -> Read<()> {
        match self.take(word) {
            Some(token) => {
                self.mark(token, Mark::Row);
                Ok(())
            }
            None => self.ends_early(list, row, &format!("`{word}`"), BadNumber::NotANumber),
        }
    }

    fn ends_early<T>(&mut self, list: List<'_>, row: usize, expected: &str, bad: BadNumber) -> Read<T> {
        let what = list.what;
        let (code, message) = match bad {
            BadNumber::NotFinite => (bad.code(), format!("{} is not a finite number", self.found())),
            BadNumber::OutOfRange => (bad.code(), format!("{} is out of range among the {what}", self.found())),
            BadNumber::NotANumber => (Code::ListTooShort, format!("the {what} end after {row} of {}", list.count)),
        };
        let error = Diagnostic::error(code, self.cursor.here(), message)
            .label(format!("expected {expected}, found {}", self.found()))
            .note(list.counted_at, format!("announced as {} here", list.count));
        let help = match bad {
            BadNumber::NotANumber => self.number_help(bad).or(Some("correct the count, or write what is missing")),
            BadNumber::OutOfRange | BadNumber::NotFinite => self.number_help(bad),
        };
        self.fail(Diagnostic { help: help.map(str::to_owned), ..error })
    }

    /// After the list no number may come, or its count was wrong.
    pub(super) fn expect_end(&mut self, list: List<'_>) -> Read<()> {
        if !self.at_number() {
            return Ok(());
        }
        let message = format!("there are more {} than announced", list.what);
        let error = Diagnostic::error(Code::ListTooLong, self.cursor.here(), message)
            .label(format!("expected the next field, found {}", self.found()))
            .note(list.counted_at, format!("announced as {} here", list.count))
            .help("correct the count, or remove what is too much");
        self.fail(error)
    }
}

/// Whether a list's number stands at the beginning of a line when the list is laid out.
fn begins_row(at: usize, width: usize) -> bool {
    /// Of single numbers, so many stand in a line; the first ones in that of their count.
    const IN_A_LINE: usize = 10;
    if width == 1 { at > 0 && at.is_multiple_of(IN_A_LINE) } else { at.is_multiple_of(width) }
}

/// The `at`th number of a list, counted from 0, past the `t`s between them.
fn number_at(mut cursor: Cursor<'_>, at: usize) -> Option<Token<'_>> {
    let mut numbers = std::iter::from_fn(|| cursor.next()).filter(|token| token.text != "t");
    numbers.nth(at)
}
