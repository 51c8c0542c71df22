use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

/// An empty folder to run the program in, gone at the end of the test.
pub struct Folder {
    folder: TempDir,
    program: &'static str,
}

/// How a run of the program ended.
#[derive(Debug)]
pub struct Ended {
    /// Its exit code; `None` when a signal ended it.
    pub code: Option<i32>,
    /// What it wrote to stdout.
    pub stdout: String,
    /// What it wrote to stderr.
    pub stderr: String,
}

impl Folder {
    /// An empty folder, and the program to run there.
    ///
    /// # Panics
    /// If no folder can be made.
    pub fn for_program(program: &'static str) -> Self {
        Self { folder: TempDir::new().expect("a temporary folder can be made"), program }
    }

    /// The path of a file in the folder.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// With one more file.
    ///
    /// # Panics
    /// If it cannot be written.
    #[must_use]
    pub fn with(self, name: &str, bytes: impl AsRef<[u8]>) -> Self {
        fs::write(self.path(name), bytes).expect("a temporary file can be written");
        self
    }

    /// A file's bytes.
    ///
    /// # Panics
    /// If it is not there.
    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}; there are {:?}", self.names()))
    }

    /// The names of all that is in the folder.
    ///
    /// # Panics
    /// If the folder cannot be read.
    pub fn names(&self) -> BTreeSet<String> {
        let entries = fs::read_dir(self.folder.path()).expect("the folder can be read");
        entries.map(|entry| entry.expect("so can its entries").file_name().to_string_lossy().into_owned()).collect()
    }

    /// The program with arguments, to be started in the folder.
    pub fn command(&self, arguments: &[&str]) -> Command {
        self.command_of(Path::new(self.program), arguments)
    }

    /// Another program with arguments, to be started in the folder.
    pub fn command_of(&self, program: &Path, arguments: &[&str]) -> Command {
        let mut command = Command::new(program);
        command.args(arguments).current_dir(self.folder.path()).env("NO_COLOR", "1").env_remove("RUST_BACKTRACE");
        command
    }

    /// Runs the program in the folder to its end.
    ///
    /// # Panics
    /// If it cannot be started, or panics itself: no input may make it do that.
    pub fn run(&self, arguments: &[&str]) -> Ended {
        let Output { status, stdout, stderr } = self.command(arguments).output().expect("the program can be started");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the program writes UTF-8");
        let ended = Ended { code: status.code(), stdout: text(stdout), stderr: text(stderr) };
        assert!(!ended.stderr.contains("panicked"), "{}", ended.stderr);
        ended
    }
}
