//! Crates as they lie on the disk: their manifests and their sources, read just well enough to see what they name.

use std::fs;
use std::path::{Path, PathBuf};

/// A package of the workspace.
pub(crate) struct Crate {
    /// Its folder's name.
    pub(crate) name: String,
    pub(crate) manifest: toml::Table,
    folder: PathBuf,
}

impl Crate {
    pub(crate) fn read(root: &Path, name: &str) -> Self {
        let folder = root.join(name);
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap().parse().unwrap();
        Self { name: name.to_owned(), manifest, folder }
    }

    /// All dependencies: of the crate, its tests, its build, and of single platforms. A renamed one under its true name.
    pub(crate) fn dependencies(&self) -> Vec<(String, toml::Value)> {
        let platforms = self
            .manifest
            .get("target")
            .and_then(toml::Value::as_table)
            .into_iter()
            .flat_map(|platforms| platforms.values().filter_map(toml::Value::as_table));
        let sections = platforms.chain([&self.manifest]).flat_map(|table| {
            ["dependencies", "dev-dependencies", "build-dependencies"].into_iter().filter_map(|name| table.get(name))
        });
        sections
            .filter_map(toml::Value::as_table)
            .flatten()
            // A crate's tests may name the crate itself, to switch on its features.
            .filter(|(_, value)| value.get("path").and_then(toml::Value::as_str) != Some("."))
            .map(|(name, value)| (true_name(name, value), value.clone()))
            .collect()
    }

    /// The files under `src` with their texts.
    pub(crate) fn sources(&self) -> Vec<(PathBuf, String)> {
        let mut folders = vec![self.folder.join("src")];
        let mut sources = Vec::new();
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|ending| ending == "rs") {
                    let text = fs::read_to_string(&path).unwrap();
                    sources.push((path, text));
                }
            }
        }
        assert!(!sources.is_empty(), "{}", self.name);
        sources
    }
}

fn true_name(name: &str, value: &toml::Value) -> String {
    let package = value.get("package").and_then(toml::Value::as_str);
    let folder = value.get("path").and_then(toml::Value::as_str).and_then(|path| path.rsplit('/').next());
    package.or(folder).unwrap_or(name).to_owned()
}

/// A source text without its comments, strings and characters.
pub(crate) fn code_only(text: &str) -> String {
    let mut code = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let skipped = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            block_comment(rest)
        } else if let Some(raw) = raw_string(rest).filter(|_| !code.ends_with(|letter: char| letter.is_alphanumeric()))
        {
            raw
        } else if first == '"' {
            quoted(rest, '"')
        } else if first == '\'' && is_character(rest) {
            quoted(rest, '\'')
        } else {
            code.push(first);
            rest = &rest[first.len_utf8()..];
            continue;
        };
        code.push(' ');
        rest = &rest[skipped..];
    }
    code
}

/// The length of a block comment; they nest.
fn block_comment(text: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while at < text.len() {
        if text[at..].starts_with("/*") {
            (depth, at) = (depth + 1, at + 2);
        } else if text[at..].starts_with("*/") {
            (depth, at) = (depth - 1, at + 2);
            if depth == 0 {
                return at;
            }
        } else {
            at += text[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    at
}

/// The length of a raw string, if one begins here.
fn raw_string(text: &str) -> Option<usize> {
    let after_letters = text.strip_prefix("br").or_else(|| text.strip_prefix('r'))?;
    let hashes = after_letters.len() - after_letters.trim_start_matches('#').len();
    let content = after_letters[hashes..].strip_prefix('"')?;
    let end = format!("\"{}", "#".repeat(hashes));
    let length = content.find(&end).map_or(content.len(), |at| at + end.len());
    Some(text.len() - content.len() + length)
}

/// The length of what stands between quotes, these included.
fn quoted(text: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, letter) in text.char_indices().skip(1) {
        match letter {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            _ if letter == quote => return at + 1,
            _ => {}
        }
    }
    text.len()
}

/// Whether a single quote begins a character and not a lifetime.
fn is_character(text: &str) -> bool {
    let mut letters = text.chars().skip(1);
    match letters.next() {
        Some('\\') => true,
        Some(_) => letters.next() == Some('\''),
        None => false,
    }
}

/// A code without comments and strings, without what is compiled for tests alone; and the files that it includes for these alone.
pub(crate) fn without_tests(path: &Path, code: &str) -> (String, Vec<PathBuf>) {
    const MARK: &str = "#[cfg(test)]";
    let (mut kept, mut files, mut rest) = (String::new(), Vec::new(), code);
    while let Some(at) = rest.find(MARK) {
        kept.push_str(&rest[..at]);
        let item = &rest[at + MARK.len()..];
        let end = item.find([';', '{']).unwrap_or(item.len());
        rest = if item[end..].starts_with('{') {
            &item[end + braced(&item[end..])..]
        } else {
            if let Some(module) = item[..end].trim().strip_prefix("mod ") {
                // Beside the file, or in the folder of its name.
                let folder = path.with_extension("");
                files.extend(
                    [&folder, path.parent().unwrap_or(&folder)].map(|folder| folder.join(format!("{module}.rs"))),
                );
            }
            &item[end..]
        };
    }
    kept.push_str(rest);
    (kept, files)
}

/// The length of what stands in braces.
fn braced(code: &str) -> usize {
    let mut depth = 0;
    for (at, letter) in code.char_indices() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    code.len()
}

/// The decimal numbers in a code without comments and strings: their value, how they are written, and the code before them
/// without white space. Whole numbers too; no fields of tuples, no ends of names.
pub(crate) fn numbers(code: &str) -> Vec<(f64, String, String)> {
    let letters: Vec<char> = code.chars().collect();
    let mut found = Vec::new();
    let mut before = String::new();
    let mut at = 0;
    while at < letters.len() {
        let starts = letters[at].is_ascii_digit()
            && !before.ends_with(|letter: char| letter.is_alphanumeric() || letter == '_')
            && (!before.ends_with('.') || before.ends_with(".."));
        let end = if starts { number_end(&letters, at) } else { at + 1 };
        let text: String = letters[at..end].iter().collect();
        if starts {
            let digits = text.replace('_', "");
            let digits = digits.trim_end_matches("f32").trim_end_matches("f64");
            if let Ok(value) = digits.parse() {
                found.push((value, text.clone(), before.clone()));
            }
        }
        before.extend(text.chars().filter(|letter| !letter.is_whitespace()));
        at = end;
    }
    found
}

/// Where a number ends: a point belongs to it if a digit follows, a sign if an exponent's letter precedes.
fn number_end(letters: &[char], start: usize) -> usize {
    let mut end = start + 1;
    while let Some(&letter) = letters.get(end) {
        let next_is_digit = letters.get(end + 1).is_some_and(char::is_ascii_digit);
        let is_part = letter.is_alphanumeric()
            || letter == '_'
            || (letter == '.' && next_is_digit)
            || ("+-".contains(letter) && "eE".contains(letters[end - 1]) && next_is_digit);
        if !is_part {
            break;
        }
        end += 1;
    }
    end
}

/// Every path in a code without comments and strings, with the braces of `use` written out: `std::{fmt, fs::File}` is `std`'s `fmt` and `fs::File`.
/// A renamed part goes under its first name; `self` stands for the path before it.
pub(crate) fn paths_in(code: &str) -> Vec<String> {
    let mut paths = Vec::new();
    let mut words = words(code).into_iter().peekable();
    while let Some(word) = words.next() {
        if word == "use" {
            let mut tree = Vec::new();
            while let Some(word) = words.next_if(|word| word != ";") {
                tree.push(word);
            }
            use_tree(&mut tree.into_iter().peekable(), "", &mut paths);
        } else if is_name(&word) {
            let mut path = word;
            while words.next_if_eq("::").is_some() {
                match words.next_if(|word| is_name(word)) {
                    Some(next) => path = format!("{path}::{next}"),
                    None => break,
                }
            }
            // A single name says nothing of where it comes from.
            if path.contains("::") {
                paths.push(path);
            }
        }
    }
    paths
}

fn use_tree(words: &mut std::iter::Peekable<std::vec::IntoIter<String>>, before: &str, paths: &mut Vec<String>) {
    let mut path = before.to_owned();
    let mut braces = false;
    while let Some(word) = words.next() {
        match &*word {
            "{" => {
                braces = true;
                use_tree(words, &path, paths);
            }
            "," | "}" => {
                if !braces && path != before {
                    paths.push(path);
                }
                if word == "}" {
                    return;
                }
                (path, braces) = (before.to_owned(), false);
            }
            "::" => {}
            "as" => drop(words.next()),
            // The path before it, which is none of the longer ones.
            "self" if !before.is_empty() => {
                paths.push(path.clone());
                braces = true;
            }
            name if path.is_empty() => path = name.to_owned(),
            name => path = format!("{path}::{name}"),
        }
    }
    if !braces && path != before {
        paths.push(path);
    }
}

fn is_name(word: &str) -> bool {
    word.starts_with(|letter: char| letter.is_alphabetic() || letter == '_')
}

/// Names, `::`, and single other characters; white space is left out.
fn words(code: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut in_name = false;
    let mut colons = 0;
    for letter in code.chars() {
        let part_of_name = letter.is_alphanumeric() || letter == '_';
        colons = if letter == ':' { colons + 1 } else { 0 };
        match words.last_mut() {
            Some(word) if part_of_name && in_name => word.push(letter),
            Some(word) if colons == 2 => {
                word.push(letter);
                colons = 0;
            }
            _ if letter.is_whitespace() => {}
            _ => words.push(letter.to_string()),
        }
        in_name = part_of_name;
    }
    words
}
