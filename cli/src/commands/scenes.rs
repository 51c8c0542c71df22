use std::fmt::Write;
use std::path::Path;

use scene_format::Files;

use crate::args::ScenesArguments;
use crate::output::{print, write_file};
use crate::report::{self, Failure};
use crate::scenes::{self, EmbeddedFiles, EmbeddedScene};

pub(crate) fn run(arguments: &ScenesArguments) -> Result<(), Failure> {
    let Some(name) = &arguments.name else { return list() };
    let scene = scenes::find(name).ok_or_else(|| {
        Failure::new(format!("there is no built-in scene `{name}`")).help("`girasol scenes` lists them")
    })?;
    match &arguments.write {
        None => print(&scene.source()),
        Some(folder) => write(scene, folder),
    }
}

fn list() -> Result<(), Failure> {
    let width = scenes::all().iter().map(|scene| scene.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for scene in scenes::all() {
        let _ = writeln!(text, "{:width$}  {}", scene.name, scene.summary);
    }
    print(&text)
}

/// Writes a scene and the textures that it names.
fn write(scene: &EmbeddedScene, folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)
        .map_err(|error| Failure::of(format!("the folder `{}` cannot be made", folder.display()), error))?;
    let source = scene.source();
    let mut written = vec![folder.join(format!("{}.sc", scene.name))];
    write_file(&written[0], source.as_bytes())?;
    for &texture in scenes::texture_names().iter().filter(|&&texture| source.contains(texture)) {
        let bytes = EmbeddedFiles.read(texture).map_err(|error| Failure::new(format!("{texture}: {error:?}")))?;
        let path = folder.join(texture);
        write_file(&path, &bytes)?;
        written.push(path);
    }
    for path in written {
        report::line(format!("{}", path.display()));
    }
    Ok(())
}
