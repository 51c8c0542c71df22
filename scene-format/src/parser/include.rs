use super::Parser;
use super::cursor::Cursor;
use super::report::Read;
use crate::decode;
use crate::diagnostic::{Diagnostic, Severity};
use crate::files::FileError;
use crate::lexer::Token;
use crate::scene_file::{Included, Statement};
use crate::span::{FileId, Source, Spanned};

/// How deep files may include files.
const DEEPEST: usize = 32;

/// How many files may take part in a scene: a few that include each other twice would otherwise grow without end.
const MOST_FILES: usize = 4096;

/// How many bytes all includes together may have.
const MOST_BYTES: usize = 1 << 30;

impl<'s> Parser<'s> {
    /// `includepath DIRECTORY`
    pub(super) fn include_path(&mut self, keyword: Token<'s>) -> Read<Statement> {
        let directory = self.string(keyword)?;
        self.context.include_path.add(&directory.value, self.path);
        Ok(Statement::IncludePath(directory))
    }

    /// `include FILE`: reads that file in place.
    pub(super) fn include(&mut self, keyword: Token<'s>) -> Read<Statement> {
        let path = self.string(keyword)?;
        let file = match self.find_include(&path) {
            Ok((found, text)) => Some(self.read_include(&path, found, text)),
            Err(error) => {
                self.context.report(*error);
                None
            }
        };
        Ok(Statement::Include { path, file })
    }

    /// The path and text of an include, or why it cannot be had.
    fn find_include(&self, name: &Spanned<String>) -> Result<(String, String), Box<Diagnostic>> {
        let error = |message: String| Box::new(Diagnostic::error(name.span, message));
        let extension = name.value.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
        if matches!(extension.as_str(), "sca" | "scb" | "rib" | "ra2" | "ra3") {
            let message = format!("cannot include `{}`: only .sc files are read", name.value);
            return Err(error(message));
        }
        let (path, bytes) = self.context.include_path.find(&name.value, self.files).map_err(|why| match why {
            FileError::NotFound => {
                let places: Vec<_> =
                    self.context.include_path.directories().map(|place| format!("`{place}/`")).collect();
                let places = places.join(", ").replacen("`/`", "the scene's own directory", 1);
                let error = error(format!("cannot find the include `{}`", name.value));
                Box::new(error.help(format!("looked in {places}; `includepath` adds a directory")))
            }
            FileError::Unreadable(why) => error(format!("cannot read the include `{}`: {why}", name.value)),
        })?;
        let open = &self.context.open_files;
        if open.contains(&path) {
            let error = error(format!("`{path}` includes itself"));
            return Err(Box::new(error.label(format!("{} -> {path}", open.join(" -> ")))));
        }
        if open.len() > DEEPEST {
            return Err(error(format!("more than {DEEPEST} files that include each other")));
        }
        if self.context.sources.files.len() >= MOST_FILES {
            return Err(error(format!("more than {MOST_FILES} files are included")));
        }
        if self.context.included_bytes.saturating_add(bytes.len()) > MOST_BYTES {
            return Err(error(format!("the includes have more than {MOST_BYTES} bytes")));
        }
        let text = decode(&bytes).map_err(|why| error(format!("cannot read `{path}`: {why}")))?;
        Ok((path, text))
    }

    fn read_include(&mut self, name: &Spanned<String>, path: String, text: String) -> Included {
        let file = self.context.sources.files.len() as FileId;
        // The text is handed over once it has been read: the reader borrows from it.
        let source = Source { name: path.clone(), text: String::new(), included_at: Some(name.span) };
        self.context.sources.files.push(source);
        self.context.included_bytes += text.len();
        self.context.include_path.add_directory_of(&path);
        self.context.open_files.push(path.clone());
        let mut parser = Parser {
            cursor: Cursor::new(&text, file),
            path: &path,
            files: self.files,
            context: self.context,
            unbalanced: false,
        };
        let scene = parser.scene_file(Severity::Warning);
        self.context.open_files.pop();
        if let Some(source) = self.context.sources.files.get_mut(file as usize) {
            source.text = text;
        }
        Included { path, scene }
    }
}
