use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use scene_format::{
    Code, Diagnostic, FileError, Files, SceneFile, SearchPath, Spanned,
    scene_file::{self, Paint, ShaderKind, Statement},
};
use shading::{Absorption, Color, Shader, Texture, sunflow};

use super::color::linear;
use super::picture::decode;
use crate::{Dialect, Modules};

/// The shaders of a scene, by name: each is made, and its texture read, when the first object uses it.
pub(super) struct ShaderTable<'a> {
    modules: &'a Modules,
    texture_path: SearchPath,
    files: &'a dyn Files,
    declared: BTreeMap<&'a str, Declared<'a>>,
    /// The names of all shaders of the scene, before or behind the object that is read.
    expected: BTreeSet<&'a str>,
    textures: BTreeMap<String, ReadTexture>,
    pub(super) made: Vec<Box<dyn Shader>>,
    default: Option<u32>,
    pub(super) diagnostics: Vec<Diagnostic>,
}

/// What the shaders of a scene need, and which it does not need.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ShadingNeeds {
    /// The types of the shaders in use, each once.
    pub types: Vec<String>,
    /// The names of the textures that were read, each once.
    pub textures: Vec<String>,
    /// The memory that they take, in bytes.
    pub texture_bytes: usize,
    /// The shaders that no object uses: they were not made, nor their textures read.
    pub unused: Vec<String>,
}

/// A texture that was read, and the memory that it takes.
struct ReadTexture {
    texture: Arc<dyn Texture>,
    bytes: usize,
}

struct Declared<'a> {
    shader: &'a scene_file::Shader,
    made: Option<u32>,
}

impl<'a> ShaderTable<'a> {
    pub(super) fn new(modules: &'a Modules, texture_path: SearchPath, files: &'a dyn Files) -> Self {
        Self {
            modules,
            texture_path,
            files,
            declared: BTreeMap::new(),
            expected: BTreeSet::new(),
            textures: BTreeMap::new(),
            made: Vec::new(),
            default: None,
            diagnostics: Vec::new(),
        }
    }

    /// Takes note of the names of all shaders that a scene declares anywhere, for messages.
    pub(super) fn expect(&mut self, file: &'a SceneFile) {
        for statement in &file.statements {
            match &statement.value {
                Statement::Shader(shader) => {
                    self.expected.insert(&shader.name.value);
                }
                Statement::Include { file: Some(included), .. } => self.expect(&included.scene),
                _ => {}
            }
        }
    }

    /// Takes note of a shader.
    pub(super) fn declare(&mut self, shader: &'a scene_file::Shader) {
        self.declared.insert(&shader.name.value, Declared { shader, made: None });
    }

    /// The number of the shader with a name.
    pub(super) fn used(&mut self, name: &Spanned<String>) -> u32 {
        let Some(declared) = self.declared.get(name.value.as_str()) else {
            let known: Vec<_> = self.declared.keys().map(|known| format!("`{known}`")).collect();
            let help = match known.len() {
                _ if self.expected.contains(name.value.as_str()) => {
                    "it is declared further down: a shader stands before the objects that name it".to_owned()
                }
                0 => "no shader is declared before this object".to_owned(),
                1..=8 => format!("declared before it: {}", known.join(", ")),
                count => format!("{count} shaders are declared before it, none of that name"),
            };
            self.diagnostics.push(
                Diagnostic::warning(
                    Code::UndeclaredShader,
                    name.span,
                    format!("no shader `{}` is declared before its use", name.value),
                )
                .label("rendered in the default colour")
                .help(help),
            );
            return self.default_shader();
        };
        if let Some(made) = declared.made {
            return made;
        }
        let shader = declared.shader;
        if self.modules.dialect == Dialect::Sunflow {
            self.diagnostics.extend(warn_of_gloss(shader));
        }
        let shader = self.make(&shader.kind);
        let number = self.add(shader);
        if let Some(declared) = self.declared.get_mut(name.value.as_str()) {
            declared.made = Some(number);
        }
        number
    }

    /// The number of a shader like the one with a name, for a surface whose normals have a length.
    pub(super) fn used_with_normals(&mut self, name: &Spanned<String>, length: f32) -> u32 {
        // The plain one, too: so it is known to be in use.
        let plain = self.used(name);
        match self.declared.get(name.value.as_str()).map(|declared| &declared.shader.kind) {
            Some(kind) if length != 1.0 => {
                let shader = self.make(kind);
                self.add(Box::new(sunflow::LongNormal { shader, length }))
            }
            _ => plain,
        }
    }

    /// The shader of objects that have none.
    pub(super) fn default_shader(&mut self) -> u32 {
        if let Some(number) = self.default {
            return number;
        }
        let number = self.add((self.modules.shaders.constant)(self.default_color()));
        self.default = Some(number);
        number
    }

    /// What a surface gets whose own shader is not there: light grey, so that it is seen; black in Sunflow.
    fn default_color(&self) -> Color {
        match self.modules.dialect {
            Dialect::Report => Color::grey(0.6),
            Dialect::Sunflow => Color::BLACK,
        }
    }

    /// What the shaders that were used need.
    pub(super) fn needs(&self) -> ShadingNeeds {
        let (used, unused): (Vec<_>, Vec<_>) = self.declared.iter().partition(|(_, declared)| declared.made.is_some());
        let mut types: Vec<String> =
            used.iter().map(|(_, declared)| type_name(&declared.shader.kind).to_owned()).collect();
        types.sort();
        types.dedup();
        ShadingNeeds {
            types,
            textures: self.textures.keys().cloned().collect(),
            texture_bytes: self.textures.values().map(|read| read.bytes).sum(),
            unused: unused.iter().map(|(name, _)| (**name).to_owned()).collect(),
        }
    }

    fn add(&mut self, shader: Box<dyn Shader>) -> u32 {
        self.made.push(shader);
        self.made.len() as u32 - 1
    }

    fn make(&mut self, kind: &ShaderKind) -> Box<dyn Shader> {
        if let (Dialect::Sunflow, ShaderKind::Shiny { diffuse, reflection }) = (self.modules.dialect, kind) {
            return Box::new(sunflow::Shiny { diffuse: self.paint(diffuse), reflection: reflection.value });
        }
        if let Some((paint, specular, exponent)) = matt_parts(kind) {
            return (self.modules.shaders.phong)(self.paint(&paint), specular, exponent);
        }
        match kind {
            ShaderKind::Constant(color) => (self.modules.shaders.constant)(linear(color)),
            ShaderKind::Mirror(reflection) => (self.modules.shaders.mirror)(linear(reflection)),
            ShaderKind::Glass { eta, color, absorption } => {
                (self.modules.shaders.glass)(eta.value, linear(color), absorbing(absorption))
            }
            _ => (self.modules.shaders.constant)(self.default_color()),
        }
    }

    fn paint(&mut self, paint: &Paint) -> Arc<dyn Texture> {
        match paint {
            Paint::Color(color) => Arc::new(linear(color)),
            Paint::Texture(name) => match self.texture(name) {
                Ok(texture) => texture,
                Err(diagnostic) => {
                    self.diagnostics.push(diagnostic);
                    Arc::new(self.default_color())
                }
            },
        }
    }

    /// A texture from its file: found, read and decoded once for each name.
    fn texture(&mut self, name: &Spanned<String>) -> Result<Arc<dyn Texture>, Diagnostic> {
        if let Some(read) = self.textures.get(&name.value) {
            return Ok(Arc::clone(&read.texture));
        }
        let (_, bytes) = self.texture_path.find(&name.value, self.files).map_err(|error| match error {
            FileError::NotFound => {
                let message = format!("there is no texture `{}`", name.value);
                Diagnostic::error(Code::FileNotFound, name.span, message)
                    .label("no such file")
                    .help(self.where_looked())
            }
            FileError::Unreadable(reason) => {
                Diagnostic::error(Code::UnusableFile, name.span, format!("the texture `{}` cannot be read", name.value))
                    .label(reason)
            }
        })?;
        let picture = decode(&bytes, &self.modules.limits).map_err(|reason| {
            Diagnostic::error(
                Code::UnusableFile,
                name.span,
                format!("the texture `{}` is not a picture that can be read", name.value),
            )
            .label(reason)
            .help("textures are PNG, JPG, GIF or BMP files")
        })?;
        let bytes = picture.bytes();
        let texture = (self.modules.texture)(picture);
        self.textures.insert(name.value.clone(), ReadTexture { texture: Arc::clone(&texture), bytes });
        Ok(texture)
    }

    fn where_looked(&self) -> String {
        let named = |directory: &str| match directory {
            "" => "the scene's own directory".to_owned(),
            other => format!("`{other}`"),
        };
        let directories: Vec<_> = self.texture_path.directories().map(named).collect();
        format!("looked in {}; `texturepath DIRECTORY` before the shader adds another", directories.join(", "))
    }
}

/// The paint, highlight and exponent of what is rendered as phong; without a highlight where the type is another.
fn matt_parts(kind: &ShaderKind) -> Option<(Paint, Color, f32)> {
    match kind {
        ShaderKind::Phong { diffuse, specular, exponent, .. } => {
            Some((diffuse.clone(), linear(specular), exponent.value))
        }
        ShaderKind::Diffuse(diffuse) | ShaderKind::Shiny { diffuse, .. } => Some((diffuse.clone(), Color::BLACK, 1.0)),
        ShaderKind::Unrendered(_) | ShaderKind::Unknown { .. } => Some((kind.own_paint()?, Color::BLACK, 1.0)),
        ShaderKind::Constant(_) | ShaderKind::Mirror(_) | ShaderKind::Glass { .. } => None,
    }
}

/// What Sunflow would reflect in a phong surface, and girasol does not.
fn warn_of_gloss(shader: &scene_file::Shader) -> Option<Diagnostic> {
    /// Where the file does not say.
    const SUNFLOW_S_SAMPLES: u32 = 4;
    let ShaderKind::Phong { specular, samples, .. } = &shader.kind else { return None };
    let samples = samples.map_or(SUNFLOW_S_SAMPLES, |samples| samples.value);
    (samples > 0 && linear(specular) != Color::BLACK).then(|| {
        Diagnostic::warning(
            Code::GlossNotRendered,
            shader.name.span,
            format!("`{}` is rendered without glossy reflections", shader.name.value),
        )
        .label(format!("Sunflow follows {samples} of them from each point seen"))
        .help("to compare pictures, let the shader end with `samples 0`, also for Sunflow")
    })
}

/// A shader's type, as a scene names it.
fn type_name(kind: &ShaderKind) -> &str {
    match kind {
        ShaderKind::Constant(_) => "constant",
        ShaderKind::Diffuse(_) => "diffuse",
        ShaderKind::Phong { .. } => "phong",
        ShaderKind::Mirror(_) => "mirror",
        ShaderKind::Glass { .. } => "glass",
        ShaderKind::Shiny { .. } => "shiny",
        ShaderKind::Unrendered(block) => &block.kind,
        ShaderKind::Unknown { block, .. } => &block.keyword,
    }
}

fn absorbing(absorption: &scene_file::Absorption) -> Option<Absorption> {
    let distance = absorption.distance.map(|distance| distance.value).filter(|&distance| distance > 0.0)?;
    // Sunflow's default: grey.
    let color = absorption.color.as_ref().map_or(Color::grey(0.5), |color| linear(color));
    Some(Absorption { distance, color })
}
