use std::ops::ControlFlow;

use render::{Assembled, Film, Lighting, Modules, Settings};
use scene_format::Files;

use crate::MemoryFiles;

/// A scene's text and all that it is rendered with: from text to linear film in one call.
#[derive(Clone)]
pub struct Rendering<F = MemoryFiles> {
    /// The `.sc` text.
    pub text: String,
    /// What it refers to.
    pub files: F,
    /// The parts.
    pub modules: Modules,
    /// Light beyond what the text says.
    pub lighting: Lighting,
}

impl Rendering {
    /// A scene that refers to no file, with girasol's own parts.
    pub fn of(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            files: MemoryFiles::default(),
            modules: Modules::default(),
            lighting: Lighting::default(),
        }
    }

    /// A scene without lights in which every matt surface shows its own colour, neither dimmed nor shaded.
    pub fn flat(text: impl Into<String>) -> Self {
        Self { lighting: Lighting { ambient: 1.0, ..Lighting::default() }, ..Self::of(text) }
    }
}

impl<F: Files> Rendering<F> {
    /// The scene, and the settings that its text asks for.
    ///
    /// # Panics
    /// If there is anything to say about the text, be it only a warning.
    pub fn assemble(&self) -> Assembled {
        let parsed = (self.modules.parse)("test.sc", &self.text, &self.files, &self.modules.limits);
        assert!(parsed.diagnostics.is_empty(), "{:#?} in\n{}", parsed.diagnostics, self.text);
        match render::assemble(&parsed.scene, &self.modules, &self.lighting, &self.files) {
            Ok(assembled) if assembled.warnings.is_empty() => assembled,
            Ok(assembled) => panic!("{:#?} in\n{}", assembled.warnings, self.text),
            Err(diagnostics) => panic!("{diagnostics:#?} in\n{}", self.text),
        }
    }

    /// The picture with the text's own settings.
    pub fn film(&self) -> Film {
        self.film_with(|settings| settings)
    }

    /// The picture with other settings.
    ///
    /// # Panics
    /// As [`Self::assemble`] does.
    pub fn film_with(&self, change: impl FnOnce(Settings) -> Settings) -> Film {
        let Assembled { scene, settings, .. } = self.assemble();
        let film = render::render(&scene, &change(settings), &|_| ControlFlow::Continue(()));
        film.expect("nothing breaks the rendering off")
    }
}
