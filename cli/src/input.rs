//! Scenes from disk and from the program itself.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use render::{Assembled, Modules, Settings, assemble};
use scene_format::{Diagnostic, FileError, Files, Parsed, Severity, Span};
use shading::SoftShadows;

use crate::options::RenderOptions;
use crate::report::{self, Failure, Show};
use crate::scenes::{self, EmbeddedFiles, EmbeddedScene};

/// The largest file that is read.
const LARGEST_FILE: u64 = 1 << 30;

/// A scene's text, and where it comes from.
pub(crate) struct SceneSource {
    /// What pictures of it are called.
    pub(crate) name: String,
    /// What messages call it.
    label: String,
    text: String,
    files: Box<dyn Files>,
    soft_shadows: Option<SoftShadows>,
}

/// A scene that can be rendered.
pub(crate) struct ReadyScene {
    pub(crate) assembled: Assembled,
    pub(crate) settings: Settings,
}

/// What came of putting a scene together.
pub(crate) struct Examined {
    /// All that is to be said about it, in the order of the source.
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// The scene, unless something keeps it from being put together.
    pub(crate) assembled: Option<Assembled>,
}

impl SceneSource {
    /// A built-in scene's, or a file's.
    pub(crate) fn find(scene: &str) -> Result<Self, Failure> {
        let path = Path::new(scene);
        match scenes::find(scene) {
            Some(embedded) if !path.exists() => Ok(Self::embedded(embedded)),
            _ => Self::file(path),
        }
    }

    pub(crate) fn embedded(scene: &EmbeddedScene) -> Self {
        Self {
            name: scene.name.to_owned(),
            label: format!("{}.sc", scene.name),
            text: scene.source().into_owned(),
            files: Box::new(EmbeddedFiles),
            soft_shadows: scene.soft_shadows.then(SoftShadows::default),
        }
    }

    pub(crate) fn file(path: &Path) -> Result<Self, Failure> {
        let bytes = read(path).map_err(|error| match error {
            FileError::NotFound => no_such_scene(path),
            FileError::Unreadable(reason) => Failure::of(format!("`{}` cannot be read", path.display()), reason),
        })?;
        let text = scene_format::decode(&bytes).map_err(|error| {
            Failure::of(format!("`{}` is not a scene", path.display()), error).help("a .sc scene is a text file")
        })?;
        let directory = path.parent().unwrap_or(Path::new("")).to_owned();
        Ok(Self {
            name: path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
            label: path.display().to_string(),
            text,
            files: Box::new(DiskFiles { directory }),
            soft_shadows: None,
        })
    }

    /// The scenes of a folder, at least one, by name.
    pub(crate) fn folder(path: &Path) -> Result<Vec<Self>, Failure> {
        let failed = |error| Failure::of(format!("the folder `{}` cannot be read", path.display()), error);
        let mut paths = Vec::new();
        for entry in fs::read_dir(path).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            if path.extension().is_some_and(|ending| ending == "sc") {
                paths.push(path);
            }
        }
        if paths.is_empty() {
            return Err(Failure::new(format!("there is no .sc file in the folder `{}`", path.display())));
        }
        paths.sort();
        paths.iter().map(|path| Self::file(path)).collect()
    }

    /// Reads the text.
    pub(crate) fn parse(&self, modules: &Modules) -> Parsed<'_> {
        (modules.parse)(&self.label, &self.text, &*self.files, &modules.limits)
    }

    /// Puts the scene together, if that can be done, and gathers what there is to say about it.
    pub(crate) fn examine(&self, parsed: &Parsed<'_>, options: &RenderOptions, modules: Modules) -> Examined {
        let result =
            assemble(&parsed.scene, &options.modules(modules), &options.lighting(self.soft_shadows), &*self.files);
        let (assembled, of_assembling) = match result {
            Ok(assembled) => {
                let warnings = assembled.warnings.clone();
                (Some(assembled), warnings)
            }
            Err(diagnostics) => (None, diagnostics),
        };
        // What is said of the scene as a whole may only follow from what could not be read.
        let of_assembling =
            of_assembling.into_iter().filter(|said| said.span != Span::default() || !has_errors(&parsed.diagnostics));
        let mut diagnostics: Vec<_> = parsed.diagnostics.iter().cloned().chain(of_assembling).collect();
        diagnostics.sort_by_key(|diagnostic| (diagnostic.span.file, diagnostic.span.start));
        Examined { diagnostics, assembled }
    }

    /// Puts the scene together, and shows what there is to say about it.
    pub(crate) fn assemble(
        &self,
        parsed: &Parsed<'_>,
        options: &RenderOptions,
        modules: Modules,
        show: Show,
    ) -> Result<ReadyScene, Failure> {
        let Examined { diagnostics, assembled } = self.examine(parsed, options, modules);
        report::diagnostics(&diagnostics, &parsed.sources, show);
        match assembled {
            Some(assembled) if !has_errors(&diagnostics) => {
                let settings = options.settings(&assembled.settings)?;
                Ok(ReadyScene { assembled, settings })
            }
            _ => Err(Failure::new(format!("`{}` cannot be rendered: {}", self.label, report::counted(&diagnostics)))),
        }
    }

    /// Its text.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// What messages call it.
    pub(crate) fn label(&self) -> &str {
        &self.label
    }
}

pub(crate) fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
}

fn no_such_scene(path: &Path) -> Failure {
    let wanted = path.to_string_lossy();
    let failure = Failure::new(format!("there is no scene `{wanted}`"));
    let names = scenes::all().iter().map(|scene| scene.name);
    let nearest = names.map(|name| (strsim::damerau_levenshtein(name, &wanted), name)).min();
    match nearest {
        Some((distance, name)) if distance <= 1 + wanted.len() / 4 => {
            failure.help(format!("did you mean the built-in scene `{name}`?"))
        }
        _ => failure.help("give the path of a .sc file, or the name of a built-in scene: `girasol scenes` lists them"),
    }
}

/// Files beside a scene on disk.
struct DiskFiles {
    directory: PathBuf,
}

impl Files for DiskFiles {
    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        read(&self.directory.join(path))
    }
}

/// Reads a regular file of a size that fits in memory: no folder, no endless device.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, FileError> {
    let failed = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => FileError::NotFound,
        _ => FileError::Unreadable(error.to_string()),
    };
    let metadata = fs::metadata(path).map_err(failed)?;
    if metadata.is_dir() {
        return Err(FileError::Unreadable("it is a folder".to_owned()));
    }
    if !metadata.is_file() {
        return Err(FileError::Unreadable("it is not a regular file".to_owned()));
    }
    if metadata.len() > LARGEST_FILE {
        return Err(FileError::Unreadable(format!("it is larger than {} MiB", LARGEST_FILE >> 20)));
    }
    fs::read(path).map_err(failed)
}
