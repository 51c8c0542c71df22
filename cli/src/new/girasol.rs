use std::env;
use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::report::Failure;

/// Where a new crate finds girasol's own crates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Girasol {
    /// A checkout on this machine.
    Checkout(PathBuf),
    /// The URL of a git repository, which Cargo fetches.
    Git(String),
}

impl Girasol {
    /// What `--girasol` names: a URL, or the folder of a checkout.
    pub(crate) fn named(place: &str) -> Result<Self, Failure> {
        if place.contains("://") || place.starts_with("git@") {
            return Ok(Self::Git(place.to_owned()));
        }
        let folder =
            fs::canonicalize(place).map_err(|error| Failure::of(format!("`{place}` cannot be opened"), error))?;
        if is_checkout(&folder) {
            Ok(Self::Checkout(folder))
        } else {
            Err(Failure::new(format!(
                "`{place}` is no checkout of girasol: it has no geometry/Cargo.toml and cli/Cargo.toml"
            ))
            .help("give the folder that has them, or the URL of its git repository, as in https://..."))
        }
    }

    /// The checkout that the current folder lies in, or else the one that this program was built in.
    pub(crate) fn around() -> Result<Self, Failure> {
        let starts = [env::current_dir().ok(), env::current_exe().and_then(fs::canonicalize).ok()];
        let mut folders = starts.iter().flatten().flat_map(|start| start.ancestors());
        let found = folders.find(|folder| is_checkout(folder)).map(|folder| Self::Checkout(folder.to_owned()));
        found.ok_or_else(|| {
            Failure::new("where is girasol? Neither the current folder nor this program lies in a checkout of it")
                .help("say so with --girasol: the folder of its checkout, or the URL of its git repository")
        })
    }

    /// The dependency on one of its crates, as it stands in the manifest of a crate in a folder.
    pub(crate) fn dependency(&self, krate: &str, folder: &Path) -> String {
        let value = |key: &str, value: &str| format!("{{ {key} = {} }}", toml::Value::from(value));
        match self {
            Self::Checkout(checkout) => value("path", &relative(folder, &checkout.join(krate)).replace('\\', "/")),
            Self::Git(url) => value("git", url),
        }
    }
}

fn is_checkout(folder: &Path) -> bool {
    ["geometry", "cli"].iter().all(|krate| folder.join(krate).join("Cargo.toml").is_file())
}

/// The way from one folder to another, both absolute: by `..` where they have anything in common.
fn relative(from: &Path, to: &Path) -> String {
    let (from, to): (Vec<Component<'_>>, Vec<Component<'_>>) = (from.components().collect(), to.components().collect());
    let common = from.iter().zip(&to).take_while(|(one, other)| one == other).count();
    // The root alone is no common ground: an absolute path says more.
    let way: PathBuf = if common > 1 {
        from[common..].iter().map(|_| Component::ParentDir).chain(to[common..].iter().copied()).collect()
    } else {
        to.into_iter().collect()
    };
    way.display().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_way_from_a_folder_to_another_is_short() {
        let way = |from: &str, to: &str| relative(Path::new(from), Path::new(to));
        assert_eq!(way("/home/me/my-octree", "/home/me/girasol/cli"), "../girasol/cli");
        assert_eq!(way("/home/me/a/b", "/home/me/cli"), "../../cli");
        assert_eq!(way("/tmp/my-octree", "/home/me/girasol/cli"), "/home/me/girasol/cli");
    }

    #[test]
    fn a_url_is_no_path() {
        for url in ["https://example.org/girasol.git", "ssh://git@example.org/girasol", "git@example.org:girasol"] {
            let girasol = Girasol::named(url).unwrap();
            assert_eq!(girasol.dependency("cli", Path::new("/x")), format!("{{ git = \"{url}\" }}"));
        }
        assert!(Girasol::named("/no/such/folder").is_err());
    }
}
