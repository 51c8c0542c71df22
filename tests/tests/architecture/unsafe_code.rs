//! `unsafe` stands in one module of accel, and nowhere else.

use std::fs;

use crate::sources::code_only;
use crate::{crates, root};

/// The module of accel that may have it, with the files below it.
const EXCEPTION: &str = "accel/src/wide/simd";

#[test]
fn the_lint_forbids_it_but_in_accel_where_it_is_denied() {
    let manifest: toml::Table = fs::read_to_string(root().join("Cargo.toml")).unwrap().parse().unwrap();
    assert_eq!(manifest["workspace"]["lints"]["rust"]["unsafe_code"].as_str(), Some("forbid"));
    for package in crates() {
        let lints = &package.manifest["lints"];
        if package.name == "accel" {
            // But for this one lint they are the workspace's.
            let mut own = lints.as_table().unwrap().clone();
            assert_eq!(own["rust"]["unsafe_code"].as_str(), Some("deny"));
            own["rust"].as_table_mut().unwrap().insert("unsafe_code".to_owned(), "forbid".into());
            assert_eq!(Some(&own), manifest["workspace"]["lints"].as_table());
        } else {
            assert_eq!(lints.get("workspace").and_then(toml::Value::as_bool), Some(true), "{}", package.name);
        }
    }
}

#[test]
fn no_other_file_has_it() {
    let mut seen = 0;
    for package in crates() {
        for (path, text) in package.sources() {
            let code = code_only(&text);
            let mut words = code.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
            if words.any(|word| word == "unsafe") {
                let file = path.strip_prefix(root()).unwrap().display().to_string().replace('\\', "/");
                assert!(file.starts_with(EXCEPTION), "{file}");
                seen += 1;
            }
        }
    }
    assert!(seen > 0, "the search finds the exception");
}
