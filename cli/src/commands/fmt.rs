use std::path::Path;

use scene_format::{NoFiles, format, parse};

use crate::args::FmtArguments;
use crate::input::SceneSource;
use crate::output::{print, write_file};
use crate::report::{self, Failure, Show};

pub(crate) fn run(arguments: &FmtArguments) -> Result<(), Failure> {
    let source = SceneSource::find(&arguments.scene)?;
    let label = source.label();
    let text = match format(source.text()) {
        Ok(text) => text,
        Err(error) => {
            let sources = parse(label, source.text(), &NoFiles).sources;
            report::diagnostics(&[error], &sources, Show::Errors);
            let failure = Failure::new(format!("`{label}` has errors, so its text stays as it is"));
            return Err(failure.help("`girasol check` shows all of them"));
        }
    };
    if arguments.check {
        return match text == source.text() {
            true => Ok(()),
            false => Err(Failure::new(format!("`{label}` is not laid out as `girasol fmt` does"))
                .help("`girasol fmt --write` lays it out")),
        };
    }
    if !arguments.write {
        return print(&text);
    }
    if !Path::new(&arguments.scene).exists() {
        return Err(Failure::new(format!("`{label}` is built in: it cannot be written"))
            .help("`girasol scenes NAME --write FOLDER` makes a file of it"));
    }
    write_file(Path::new(&arguments.scene), text.as_bytes())
}
