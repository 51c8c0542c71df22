//! Reads a scene: statements, one after the other, each by the file in `parser/` that is named after it.
//!
//! Every reading function either gives its value, or has reported an error and gives [`Reported`]; the reader then goes on
//! at the next place that makes sense: the next field of the block, the end of the block, the next statement.

mod block;
mod camera;
mod color;
mod cursor;
mod curved;
mod image;
mod include;
mod instance;
mod keywords;
mod layout;
mod light;
mod mesh;
mod names;
mod object;
mod report;
mod shader;
mod shape;
mod statement;
mod transform;
mod unknown;
mod unrendered;
mod value;

use std::borrow::Cow;

use crate::code::Code;
use crate::diagnostic::{Diagnostic, Severity};
use crate::files::{Files, NoFiles};
use crate::lexer::Token;
use crate::scene_file::{SceneFile, Statement};
use crate::span::{Source, Sources, Span, Spanned};
use crate::{Limits, Parsed, SearchPath};
use cursor::Cursor;
pub(crate) use layout::{Mark, Marks};
use report::{Read, Reported};

/// Reads a scene, and through `files` what it includes.
///
/// `name` is what messages call it; its last part is the scene's own path, which no include may lead back to. Everything
/// that is wrong is told in one run. What could not be read is left out of the scene, so a scene with errors is not whole.
pub fn parse<'s>(name: &str, source: &'s str, files: &dyn Files) -> Parsed<'s> {
    parse_within(name, source, files, &Limits::default())
}

/// Reads a scene as [`parse`] does, with other limits than the usual ones.
pub fn parse_within<'s>(name: &str, source: &'s str, files: &dyn Files, limits: &Limits) -> Parsed<'s> {
    let mut context = Context::new(limits);
    let path = name.rsplit(['/', '\\']).next().unwrap_or_default().to_owned();
    context.include_path.add_directory_of("");
    context.open_files.push(path.clone());
    context.sources.files.push(Source { name: name.to_owned(), text: Cow::Borrowed(""), included_at: None });
    let scene = if u32::try_from(source.len()).is_err() {
        context.report(Diagnostic::error(Code::OverLimit, Span::default(), "the file is larger than 4 GiB"));
        SceneFile::default()
    } else {
        let mut parser = Parser {
            cursor: Cursor::new(source, 0),
            path: &path,
            files,
            context: &mut context,
            unbalanced: false,
            follows_includes: true,
        };
        parser.scene_file(Severity::Error)
    };
    let mut sources: Sources<'s> = context.sources;
    if let Some(scene_file) = sources.files.first_mut() {
        scene_file.text = Cow::Borrowed(source);
    }
    let mut diagnostics = context.diagnostics;
    diagnostics.sort_by_key(|diagnostic| (diagnostic.span.file, diagnostic.span.start));
    Parsed { scene, diagnostics, sources }
}

/// What a scene file consists of, for whoever lays it out anew; its includes are not looked at. An error means that it cannot be
/// known.
pub(crate) fn marks_of(source: &str) -> Result<Marks, Diagnostic> {
    let limits = Limits::default();
    let mut context = Context { marks: Some(Vec::new()), ..Context::new(&limits) };
    let mut parser = Parser {
        cursor: Cursor::new(source, 0),
        path: "",
        files: &NoFiles,
        context: &mut context,
        unbalanced: false,
        follows_includes: false,
    };
    parser.scene_file(Severity::Warning);
    let mut marks = context.marks.unwrap_or_default();
    marks.sort_by_key(|(place, _)| *place);
    match context.diagnostics.into_iter().find(|diagnostic| diagnostic.severity == Severity::Error) {
        Some(error) => Err(error),
        None => Ok(marks),
    }
}

/// What the scene file and all its includes share.
struct Context {
    limits: Limits,
    marks: Option<Marks>,
    /// The scene file's own text is put in at the end.
    sources: Sources<'static>,
    diagnostics: Vec<Diagnostic>,
    /// How many of the diagnostics are errors: a block compares it before and after.
    errors: usize,
    names: names::Names,
    include_path: SearchPath,
    /// The paths of the files that are being read: each was included by the one before it.
    open_files: Vec<String>,
    /// The bytes of all includes so far.
    included_bytes: usize,
}

impl Context {
    fn new(limits: &Limits) -> Self {
        Self {
            limits: *limits,
            marks: None,
            sources: Sources::default(),
            diagnostics: Vec::new(),
            errors: 0,
            names: names::Names::default(),
            include_path: SearchPath::new(),
            open_files: Vec::new(),
            included_bytes: 0,
        }
    }
}

/// Reads one file.
struct Parser<'s> {
    cursor: Cursor<'s>,
    /// The path of this file.
    path: &'s str,
    files: &'s dyn Files,
    context: &'s mut Context,
    /// Whether an unknown block was found that nothing closes: the braces of this file cannot be relied on.
    unbalanced: bool,
    follows_includes: bool,
}

impl<'s> Parser<'s> {
    /// Reads all statements; `if_empty` says how bad it is when there is none.
    fn scene_file(&mut self, if_empty: Severity) -> SceneFile {
        let mut scene = SceneFile::default();
        let mut empty = true;
        while let Some(keyword) = self.cursor.next() {
            empty = false;
            self.mark(keyword, Mark::Statement);
            match self.statement(keyword) {
                Ok(Some(statement)) => {
                    let statement = Spanned::new(statement, keyword.span.to(self.cursor.previous()));
                    add_statement(&mut scene.statements, statement);
                }
                Ok(None) => {}
                Err(Reported) => self.skip_statement(),
            }
        }
        self.warn_of_unclosed_marks();
        if empty {
            let message = "the file has no statement";
            self.context.report(match if_empty {
                Severity::Error => Diagnostic::error(Code::EmptyFile, self.cursor.here(), message),
                Severity::Warning => Diagnostic::warning(Code::EmptyFile, self.cursor.here(), message),
            });
        }
        scene
    }

    fn warn_of_unclosed_marks(&mut self) {
        for quote in self.cursor.unclosed_quotes() {
            let warning = Diagnostic::warning(Code::UnclosedQuote, *quote, "this quote is not closed in its line")
                .label("one name, up to the end of the line")
                .help("put a `\"` behind the name, or remove the first one: only names with spaces need any");
            self.context.report(warning);
        }
        if let Some(comment) = self.cursor.unclosed_comment() {
            let warning = Diagnostic::warning(Code::UnclosedComment, comment, "this comment is never closed")
                .label("takes the rest of the file")
                .help("end it with `*/`, with white space on both sides");
            self.context.report(warning);
        }
    }

    /// Reads one statement; `None` when there was nothing worth keeping.
    fn statement(&mut self, keyword: Token<'s>) -> Read<Option<Statement>> {
        let statement = match keyword.text {
            "image" => Statement::Image(self.image(keyword)?),
            "bucket" => Statement::Bucket(self.bucket(keyword)?),
            "trace-depths" => Statement::TraceDepths(self.trace_depths(keyword)?),
            "background" => Statement::Background(self.background(keyword)?),
            "camera" => self.camera(keyword)?,
            "shader" => Statement::Shader(self.shader(keyword)?),
            "object" => Statement::Object(self.object(keyword)?),
            "instance" => Statement::Instance(self.instance(keyword)?),
            "light" => Statement::Light(self.light(keyword)?),
            "texturepath" => Statement::TexturePath(self.string(keyword)?),
            "includepath" => self.include_path(keyword)?,
            "include" => self.include(keyword)?,
            "{" | "}" => {
                self.stray_brace(keyword);
                return Ok(None);
            }
            _ => self.unrendered_statement(keyword)?,
        };
        Ok(Some(statement))
    }

    fn stray_brace(&mut self, brace: Token<'_>) {
        let label = if brace.is_open() { "no statement stands before it" } else { "no block is open here" };
        let warning =
            Diagnostic::warning(Code::StrayBrace, brace.span, format!("`{}` stands between statements", brace.text))
                .label(label)
                .help("remove it, or look for a brace too many or too few before it");
        self.context.report(warning);
        self.cursor.forget_depth();
    }
}

/// Adds a statement. Words that nobody knows, after words that nobody knows and no block ended, are more of the same: where the one
/// statement ends and the other begins could not be told when they are printed.
fn add_statement(statements: &mut Vec<Spanned<Statement>>, statement: Spanned<Statement>) {
    match (statements.last_mut(), statement) {
        (
            Some(Spanned { value: Statement::Unknown(before), span }),
            Spanned { value: Statement::Unknown(more), span: further },
        ) if before.words.last().is_none_or(|word| word.value != "}") => {
            before.words.push(more.keyword);
            before.words.extend(more.words);
            *span = span.to(further);
        }
        (_, statement) => statements.push(statement),
    }
}
