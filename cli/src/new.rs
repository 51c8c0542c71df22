//! Crates for parts of one's own, made from a template: a stub that compiles, its kit as tests, the task.

mod girasol;
mod name;
mod readme;
mod template;

use std::path::{Path, PathBuf};

use crate::parts::Part;

pub(crate) use girasol::Girasol;
pub(crate) use name::check_name;
pub(crate) use template::Template;

/// The files of a new crate in a folder: their paths in it, and their texts.
pub(crate) fn files(part: Part, name: &str, folder: &Path, girasol: &Girasol) -> Vec<(PathBuf, String)> {
    let template = Template::of(part);
    let krate = name.replace('-', "_");
    [
        ("Cargo.toml".into(), Template::manifest(name, folder, girasol)),
        ("rust-toolchain.toml".into(), include_str!("../../rust-toolchain.toml").to_owned()),
        (".gitignore".into(), "/target\n*.png\n*-compare.html\n".to_owned()),
        ("README.md".into(), readme::readme(part, &template, name)),
        ("src/main.rs".into(), template.main(&krate)),
        ("src/lib.rs".into(), template.library()),
        (format!("src/{}.rs", template.module), template.stub().to_owned()),
        ("tests/laws.rs".into(), template.tests(&krate)),
    ]
    .into_iter()
    .map(|(path, text): (String, String)| (path.into(), text))
    .collect()
}
