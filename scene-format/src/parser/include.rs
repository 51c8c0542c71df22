use std::borrow::Cow;

use super::Parser;
use super::cursor::Cursor;
use super::report::Read;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Severity};
use crate::files::FileError;
use crate::lexer::Token;
use crate::scene_file::{Included, Statement};
use crate::span::{FileId, Source, Spanned};
use crate::{Limits, decode};

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
        if !self.follows_includes {
            return Ok(Statement::Include { path, file: None });
        }
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
        let error = |code, message: String| Box::new(Diagnostic::error(code, name.span, message));
        let extension = name.value.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
        if matches!(extension.as_str(), "sca" | "scb" | "rib" | "ra2" | "ra3") {
            let message = format!("cannot include `{}`: only .sc files are read", name.value);
            return Err(error(Code::UnusableFile, message));
        }
        let (path, bytes) = self.context.include_path.find(&name.value, self.files).map_err(|why| match why {
            FileError::NotFound => {
                let places: Vec<_> =
                    self.context.include_path.directories().map(|place| format!("`{place}/`")).collect();
                let places = places.join(", ").replacen("`/`", "the scene's own directory", 1);
                let error = error(Code::FileNotFound, format!("cannot find the include `{}`", name.value));
                Box::new(error.help(format!("looked in {places}; `includepath` adds a directory")))
            }
            FileError::Unreadable(why) => {
                error(Code::UnusableFile, format!("cannot read the include `{}`: {why}", name.value))
            }
        })?;
        let open = &self.context.open_files;
        if open.contains(&path) {
            let error = error(Code::IncludeCycle, format!("`{path}` includes itself"));
            return Err(Box::new(error.label(format!("{} -> {path}", open.join(" -> ")))));
        }
        let Limits { include_depth, files, bytes: most_bytes, .. } = self.context.limits;
        let over = |what: String| Err(error(Code::OverLimit, what));
        if open.len() > include_depth {
            return over(format!("more than {include_depth} files that include each other"));
        }
        if self.context.sources.files.len() >= files {
            return over(format!("more than {files} files are included"));
        }
        if self.context.included_bytes.saturating_add(bytes.len()) > most_bytes {
            return over(format!("the includes have more than {most_bytes} bytes"));
        }
        let text = decode(&bytes).map_err(|why| error(Code::UnusableFile, format!("cannot read `{path}`: {why}")))?;
        Ok((path, text))
    }

    fn read_include(&mut self, name: &Spanned<String>, path: String, text: String) -> Included {
        let file = self.context.sources.files.len() as FileId;
        // The text is handed over once it has been read: the reader borrows from it.
        let source = Source { name: path.clone(), text: Cow::Borrowed(""), included_at: Some(name.span) };
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
            follows_includes: true,
        };
        let scene = parser.scene_file(Severity::Warning);
        self.context.open_files.pop();
        if let Some(source) = self.context.sources.files.get_mut(file as usize) {
            source.text = Cow::Owned(text);
        }
        Included { path, scene }
    }
}
