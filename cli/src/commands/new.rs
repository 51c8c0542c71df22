use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use crate::args::NewArguments;
use crate::new::{Girasol, Template, check_name, files};
use crate::output::write_file;
use crate::report::{self, Failure};

pub(crate) fn run(arguments: &NewArguments) -> Result<(), Failure> {
    let girasol = arguments.girasol.as_deref().map_or_else(Girasol::around, Girasol::named)?;
    let name = arguments.name.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    check_name(&name)?;
    let folder = place(&arguments.name, &girasol)?;
    if folder.exists() {
        return Err(Failure::new(format!("`{}` is there already", folder.display()))
            .help("choose another name, or remove it first: nothing is written over"));
    }
    let failed = |error| Failure::of(format!("the folder `{}` cannot be made", folder.display()), error);
    for (path, text) in files(arguments.part, &name, &folder, &girasol) {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap_or(&folder)).map_err(failed)?;
        write_file(&path, text.as_bytes())?;
    }
    // The same versions of all other crates as girasol's: nothing to fetch, and the same bits.
    if let Girasol::Checkout(checkout) = &girasol
        && let Ok(lock) = fs::read(checkout.join("Cargo.lock"))
    {
        write_file(&folder.join("Cargo.lock"), &lock)?;
    }
    report::line(format!(
        "{}: a crate with a stub for your own {}; its README.md has the task\n\n    cd {0}\n    cargo test                                # its laws\n    \
         cargo run --release -- render marbles     # a picture",
        folder.display(),
        Template::of(arguments.part).called
    ));
    Ok(())
}

/// Where the crate is to stand: beside the checkout if a mere name is given inside of it, else where the path says. Absolute.
fn place(wanted: &Path, girasol: &Girasol) -> Result<PathBuf, Failure> {
    let current = env::current_dir().map_err(|error| Failure::of("there is no current folder", error))?;
    let current = fs::canonicalize(&current).unwrap_or(current);
    let is_name = wanted.components().count() == 1;
    let start = match girasol {
        Girasol::Checkout(checkout) if is_name && current.starts_with(checkout) => {
            checkout.parent().unwrap_or(checkout).to_owned()
        }
        _ => current,
    };
    let around = start.join(wanted.parent().unwrap_or(Path::new("")));
    let around = fs::canonicalize(&around)
        .map_err(|error| Failure::of(format!("the folder `{}` cannot be opened", around.display()), error))?;
    Ok(around.join(wanted.file_name().unwrap_or_default()))
}
