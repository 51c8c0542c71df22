use super::Parser;
use super::block::{Block, Field};
use super::cursor::Cursor;
use super::report::Read;
use crate::diagnostic::Diagnostic;
use crate::lexer::Token;
use crate::number::{BadNumber, Number};
use crate::scene_file::{Mesh, MeshForm, PerVertex, Triple};
use crate::span::Span;

/// The fields of a mesh, as far as they were there.
pub(super) struct MeshFields<'s> {
    form: MeshForm,
    points: Option<Vec<Triple>>,
    triangles: Option<Vec<[u32; 3]>>,
    normals: PerVertex<3>,
    uvs: PerVertex<2>,
    face_shaders: Option<Vec<u32>>,
    /// Where the triangles' numbers begin: they have no places of their own, and are looked up again for a message.
    triangles_begin: Option<Cursor<'s>>,
}

/// A list whose length stands before it.
#[derive(Clone, Copy)]
struct List<'s> {
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
            normals: PerVertex::None,
            uvs: PerVertex::None,
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
                mesh.points = Some(self.rows(list)?);
                self.expect_end(list)?;
            }
            "triangles" => {
                let list = self.list(field)?;
                mesh.triangles_begin = Some(self.cursor.clone());
                mesh.triangles = Some(self.rows(list)?);
                self.expect_end(list)?;
            }
            "normals" => mesh.normals = self.per_vertex(mesh, field)?,
            "uvs" => mesh.uvs = self.per_vertex(mesh, field)?,
            _ => {
                let count = self.known_count(mesh.triangles.as_deref(), "triangles", field)?;
                let list = List { what: field.text, count, counted_at: field.span };
                let rows: Vec<[u32; 1]> = self.rows(list)?;
                mesh.face_shaders = Some(rows.into_iter().map(|[shader]| shader).collect());
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
            let error = Diagnostic::error(first.span, "a mesh begins with the counts of its points and triangles");
            return self.fail(error.label(format!("expected {}", u32::KIND)));
        };
        let points = List { what: "points", count: count as usize, counted_at: first.span };
        let triangles = List { what: "triangles", ..self.list(first)? };
        let capacity = self.capacity(points.count, 9);
        let (mut positions, mut normals) = (Vec::with_capacity(capacity), Vec::with_capacity(capacity));
        let mut uvs = Vec::with_capacity(capacity);
        for row in 0..points.count {
            self.line_start("v", points, row)?;
            let [x, y, z, nx, ny, nz, u, v] = self.row(points, row)?;
            positions.push([x, y, z]);
            normals.push([nx, ny, nz]);
            uvs.push([u, v]);
        }
        mesh.points = Some(positions);
        mesh.normals = PerVertex::Vertex(normals);
        mesh.uvs = PerVertex::Vertex(uvs);
        mesh.triangles_begin = Some(self.cursor.clone());
        let mut corners = Vec::with_capacity(self.capacity(triangles.count, 4));
        for row in 0..triangles.count {
            self.line_start("t", triangles, row)?;
            corners.push(self.row(triangles, row)?);
        }
        mesh.triangles = Some(corners);
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
            let error = Diagnostic::error(span, "a triangle has a corner that is no point of the mesh")
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
            let count = self.known_count(mesh.points.as_deref(), "points", field)?;
            let list = List { what: field.text, count, counted_at: vertex.span };
            let rows = self.rows(list)?;
            self.expect_end(list)?;
            PerVertex::Vertex(rows)
        } else if let Some(facevarying) = self.take("facevarying") {
            let count = self.known_count(mesh.triangles.as_deref(), "triangles", field)?.saturating_mul(3);
            let list = List { what: field.text, count, counted_at: facevarying.span };
            let rows: Vec<[f32; N]> = self.rows(list)?;
            self.expect_end(list)?;
            PerVertex::FaceVarying(rows.as_chunks::<3>().0.to_vec())
        } else {
            let message = format!("`{}` needs to know what its values belong to", field.text);
            return self.fail_expected(message, "`none`, `vertex` or `facevarying`");
        };
        Ok(values)
    }

    /// The length of a list that other values are counted by.
    fn known_count<T>(&mut self, list: Option<&[T]>, name: &str, field: Token<'_>) -> Read<usize> {
        match list {
            Some(list) => Ok(list.len()),
            None => {
                let error = Diagnostic::error(field.span, format!("`{}` stands before `{name}`", field.text));
                let label = format!("how many {name} there are is not known yet");
                self.fail(error.label(label).help(format!("move `{}` behind `{name}`", field.text)))
            }
        }
    }

    /// The count that a list begins with.
    fn list(&mut self, field: Token<'s>) -> Read<List<'s>> {
        let count: u32 = self.number(field)?;
        Ok(List { what: field.text, count: count as usize, counted_at: self.cursor.previous() })
    }

    /// `count` rows of `N` numbers.
    fn rows<const N: usize, T: Number>(&mut self, list: List<'_>) -> Read<Vec<[T; N]>> {
        let mut rows = Vec::with_capacity(self.capacity(list.count, N));
        for row in 0..list.count {
            rows.push(self.row(list, row)?);
        }
        Ok(rows)
    }

    fn row<const N: usize, T: Number>(&mut self, list: List<'_>, row: usize) -> Read<[T; N]> {
        let mut numbers = [T::default(); N];
        for number in &mut numbers {
            *number = match self.cursor.peek().map(|token| T::read(token.text)) {
                Some(Ok(number)) => number,
                Some(Err(bad)) => return self.ends_early(list, row, T::KIND, bad),
                None => return self.ends_early(list, row, T::KIND, BadNumber::NotANumber),
            };
            self.cursor.next();
        }
        Ok(numbers)
    }

    /// Room for a list as long as announced, or as long as the rest of the file can hold: a row of `N` words takes at least
    /// two bytes for each.
    fn capacity(&self, count: usize, words: usize) -> usize {
        count.min(self.cursor.remaining() / (2 * words))
    }

    fn line_start(&mut self, word: &str, list: List<'_>, row: usize) -> Read<()> {
        match self.take(word) {
            Some(_) => Ok(()),
            None => self.ends_early(list, row, &format!("`{word}`"), BadNumber::NotANumber),
        }
    }

    fn ends_early<T>(&mut self, list: List<'_>, row: usize, expected: &str, bad: BadNumber) -> Read<T> {
        let what = list.what;
        let message = match bad {
            BadNumber::NotFinite => format!("{} is not a finite number", self.found()),
            BadNumber::OutOfRange => format!("{} is out of range among the {what}", self.found()),
            BadNumber::NotANumber => format!("the {what} end after {row} of {}", list.count),
        };
        let error = Diagnostic::error(self.cursor.here(), message)
            .label(format!("expected {expected}, found {}", self.found()))
            .note(list.counted_at, format!("announced as {} here", list.count));
        let help = self.number_help(bad).unwrap_or("correct the count, or write what is missing");
        self.fail(error.help(help))
    }

    /// After the list no number may come, or its count was wrong.
    fn expect_end(&mut self, list: List<'_>) -> Read<()> {
        if !self.at_number() {
            return Ok(());
        }
        let error = Diagnostic::error(self.cursor.here(), format!("there are more {} than announced", list.what))
            .label(format!("expected the next field, found {}", self.found()))
            .note(list.counted_at, format!("announced as {} here", list.count))
            .help("correct the count, or remove what is too much");
        self.fail(error)
    }
}

/// The `at`th number of a list, counted from 0, past the `t`s between them.
fn number_at(mut cursor: Cursor<'_>, at: usize) -> Option<Token<'_>> {
    let mut numbers = std::iter::from_fn(|| cursor.next()).filter(|token| token.text != "t");
    numbers.nth(at)
}
