use crate::files::{FileError, Files};

/// The directories that textures or includes are looked for in, in the order in which they were added.
///
/// The scene file's own directory is the one that [`Files`] starts from; it is written `""`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SearchPath {
    directories: Vec<String>,
}

impl SearchPath {
    /// No directory yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds the directory of a file that is read; for the scene file itself, whose path is its bare name, that is `""`.
    pub fn add_directory_of(&mut self, file: &str) {
        self.push(directory_of(&tidy(file)).to_owned());
    }

    /// Adds what `texturepath` or `includepath` names in `file`: relative directories count from the directory of that file.
    pub fn add(&mut self, directory: &str, file: &str) {
        self.push(join(directory_of(&tidy(file)), &tidy(directory)));
    }

    /// The directories, in the order in which they are searched.
    pub fn directories(&self) -> impl Iterator<Item = &str> {
        self.directories.iter().map(String::as_str)
    }

    /// Reads the first file of that name: in each directory, then by the name alone. Gives its path and its bytes.
    ///
    /// Scenes come from Windows and from Blender: backslashes count as slashes, and a leading `//` is dropped.
    ///
    /// # Errors
    /// [`FileError::NotFound`] when no directory has it; [`FileError::Unreadable`] when the first that has it cannot be read.
    pub fn find(&self, name: &str, files: &dyn Files) -> Result<(String, Vec<u8>), FileError> {
        let name = tidy(name);
        let bare = (!self.directories.iter().any(String::is_empty)).then_some("");
        for directory in self.directories().chain(bare) {
            let path = join(directory, &name);
            match files.read(&path) {
                Ok(bytes) => return Ok((path, bytes)),
                Err(FileError::NotFound) => {}
                Err(error) => return Err(error),
            }
        }
        Err(FileError::NotFound)
    }

    fn push(&mut self, directory: String) {
        if !self.directories.contains(&directory) {
            self.directories.push(directory);
        }
    }
}

/// A path with `/` between its parts, and none that is empty or `.`.
fn tidy(path: &str) -> String {
    let path = path.replace('\\', "/");
    let path = path.strip_prefix("//").unwrap_or(&path);
    let parts: Vec<&str> = path.split('/').filter(|part| !part.is_empty() && *part != ".").collect();
    let root = if path.starts_with('/') { "/" } else { "" };
    format!("{root}{}", parts.join("/"))
}

fn directory_of(path: &str) -> &str {
    match path.rfind('/') {
        Some(0) => "/",
        Some(slash) => path.get(..slash).unwrap_or_default(),
        None => "",
    }
}

fn join(directory: &str, path: &str) -> String {
    if directory.is_empty() || is_absolute(path) {
        path.to_owned()
    } else if path.is_empty() {
        directory.to_owned()
    } else {
        format!("{}/{path}", directory.trim_end_matches('/'))
    }
}

/// `/...`, or a drive of Windows: `C:...`.
fn is_absolute(path: &str) -> bool {
    let mut characters = path.chars();
    match characters.next() {
        Some('/') => true,
        Some(first) => first.is_ascii_alphabetic() && characters.next() == Some(':'),
        None => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Files that hold their own path.
    struct Named(&'static [&'static str]);

    impl Files for Named {
        fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
            if self.0.contains(&path) { Ok(path.into()) } else { Err(FileError::NotFound) }
        }
    }

    fn found(path: &SearchPath, name: &str, files: &'static [&'static str]) -> Option<String> {
        path.find(name, &Named(files)).ok().map(|(path, _)| path)
    }

    fn path() -> SearchPath {
        let mut path = SearchPath::new();
        path.add_directory_of("main.sc");
        path.add("textures", "main.sc");
        path.add_directory_of("parts/wheel.sc");
        path.add("../shared/", "parts/wheel.sc");
        path
    }

    #[test]
    fn directories_count_from_the_file_that_names_them() {
        assert_eq!(path().directories().collect::<Vec<_>>(), ["", "textures", "parts", "parts/../shared"]);
    }

    #[test]
    fn the_first_directory_that_has_the_file_wins() {
        assert_eq!(found(&path(), "a.png", &["parts/a.png", "textures/a.png"]).as_deref(), Some("textures/a.png"));
        assert_eq!(found(&path(), "a.png", &["b.png"]), None);
    }

    #[test]
    fn the_bare_name_is_tried_even_without_directories() {
        assert_eq!(found(&SearchPath::new(), "a.png", &["a.png"]).as_deref(), Some("a.png"));
    }

    #[test]
    fn paths_of_windows_and_blender_are_understood() {
        assert_eq!(found(&path(), "inc\\.\\Cube.sc", &["inc/Cube.sc"]).as_deref(), Some("inc/Cube.sc"));
        assert_eq!(found(&path(), "//a.png", &["a.png"]).as_deref(), Some("a.png"));
        assert_eq!(found(&path(), "C:\\a.png", &["C:/a.png"]).as_deref(), Some("C:/a.png"));
    }

    #[test]
    fn an_absolute_name_is_looked_for_where_it_says() {
        assert_eq!(found(&path(), "/x/a.png", &["textures//x/a.png", "/x/a.png"]).as_deref(), Some("/x/a.png"));
    }

    #[test]
    fn a_file_that_cannot_be_read_ends_the_search() {
        struct Locked;
        impl Files for Locked {
            fn read(&self, _path: &str) -> Result<Vec<u8>, FileError> {
                Err(FileError::Unreadable("permission denied".to_owned()))
            }
        }
        assert_eq!(path().find("a", &Locked), Err(FileError::Unreadable("permission denied".to_owned())));
    }
}
