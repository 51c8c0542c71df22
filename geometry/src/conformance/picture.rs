use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use super::Figure;

/// Writes the figure of a broken law to `conformance/LAW.svg` in the folder that the tests were built in, or in the one for
/// temporary files. `None` if it cannot be written: a picture is no reason to lose a report.
///
/// The only place below `cli` that writes a file, and only for a test that fails.
pub(super) fn keep(law: &str, figure: &Figure) -> Option<PathBuf> {
    let program = env::current_exe().ok();
    // Cargo marks its folder so that backups leave it out.
    let target = program.as_deref().and_then(|it| it.ancestors().find(|folder| folder.join("CACHEDIR.TAG").exists()));
    let folder = target.map_or_else(env::temp_dir, Path::to_owned).join("conformance");
    let path = folder.join(format!("{law}.svg"));
    fs::create_dir_all(&folder).and_then(|()| fs::write(&path, figure.to_svg())).ok()?;
    Some(path)
}
