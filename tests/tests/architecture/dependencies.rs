//! Who may know whom: read from the manifests and the sources themselves, so that a wrong `use` fails before it grows.

use std::collections::BTreeMap;
use std::fs;

use crate::sources::{Crate, code_only, paths_in};
use crate::{FLOORS, crates, root};

/// Writes a picture for a test that fails, which no renderer does.
const PICTURES_OF_BROKEN_LAWS: &str = "geometry/src/conformance/picture.rs";

/// What only cli may touch, as the beginnings of paths.
const OUTSIDE_WORLD: [&str; 6] = ["std::fs", "std::net", "std::time", "io::stdout", "io::stderr", "io::stdin"];

/// Macros that write to the terminal.
const WRITING_MACROS: [&str; 5] = ["print!", "println!", "eprint!", "eprintln!", "dbg!"];

fn floor(name: &str) -> Option<usize> {
    FLOORS.iter().position(|floor| floor.contains(&name))
}

/// The workspace's own crates that a crate depends on, in whichever section.
fn known_by(known: &Crate) -> Vec<String> {
    known.dependencies().into_iter().map(|(name, _)| name).filter(|name| floor(name).is_some()).collect()
}

#[test]
fn every_member_of_the_workspace_has_its_floor() {
    let manifest: toml::Table = fs::read_to_string(root().join("Cargo.toml")).unwrap().parse().unwrap();
    let members = manifest["workspace"]["members"].as_array().unwrap();
    let mut members: Vec<_> = members.iter().map(|member| member.as_str().unwrap()).collect();
    let mut houses = FLOORS.concat();
    members.sort_unstable();
    houses.sort_unstable();
    assert_eq!(members, houses);
}

#[test]
fn packages_are_named_like_their_folders() {
    let manifest: toml::Table = fs::read_to_string(root().join("Cargo.toml")).unwrap().parse().unwrap();
    for (name, dependency) in manifest["workspace"]["dependencies"].as_table().unwrap() {
        // Otherwise a crate could stand in a manifest under another's name.
        let path = dependency.get("path").and_then(toml::Value::as_str);
        assert!(path.is_none_or(|path| path == name), "{name} is {path:?}");
        assert_eq!(dependency.get("package"), None, "{name}");
    }
    for package in crates() {
        assert_eq!(package.manifest["package"]["name"].as_str(), Some(package.name.as_str()));
    }
}

#[test]
fn accel_shading_and_scene_format_do_not_know_each_other() {
    let neighbours = FLOORS[1];
    for package in crates().iter().filter(|package| neighbours.contains(&&*package.name)) {
        for known in known_by(package) {
            assert!(!neighbours.contains(&&*known), "{} depends on {known}", package.name);
        }
    }
}

#[test]
fn geometry_knows_no_other_crate_of_the_workspace() {
    assert_eq!(known_by(&Crate::read(&root(), "geometry")), Vec::<String>::new());
}

#[test]
fn nothing_depends_upwards() {
    for package in crates() {
        for known in known_by(&package) {
            assert!(floor(&known) < floor(&package.name), "{} depends on {known}", package.name);
        }
    }
}

#[test]
fn only_cli_touches_files_clocks_the_terminal_and_the_network() {
    let mut found = Vec::new();
    for package in crates().iter().filter(|package| !["cli", "tests"].contains(&&*package.name)) {
        for (path, text) in package.sources() {
            if path.ends_with(PICTURES_OF_BROKEN_LAWS) {
                continue;
            }
            for touched in outside_world(&text) {
                found.push(format!("{}: {touched}", path.display()));
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

/// What of the outside world a source text touches.
fn outside_world(text: &str) -> Vec<String> {
    let code = code_only(text);
    let forbidden = |path: &String| {
        // `use std;` and `use std as s;` would hide what follows.
        path == "std" || path.ends_with("::std") || OUTSIDE_WORLD.iter().any(|outside| is_under(path, outside))
    };
    let written = WRITING_MACROS.into_iter().filter(|name| calls(&code, name)).map(str::to_owned);
    paths_in(&code).into_iter().filter(forbidden).chain(written).collect()
}

/// Whether one path contains another as a run of whole parts.
fn is_under(path: &str, part: &str) -> bool {
    format!("::{path}::").contains(&format!("::{part}::"))
}

/// Whether a macro is called: its name, not as the end of another's.
fn calls(code: &str, name: &str) -> bool {
    let ends_a_name = |before: &str| before.ends_with(|letter: char| letter.is_alphanumeric() || letter == '_');
    code.match_indices(name).any(|(at, _)| !ends_a_name(&code[..at]))
}

#[test]
fn the_search_finds_every_way_to_touch_the_outside_world() {
    for text in [
        "use std::fs;",
        "use std::{fmt, fs};",
        "use std::{\n    collections::{BTreeMap, btree_map::Entry},\n    time::{Duration, Instant},\n};",
        "use std::fs::{self, File};",
        "fn f() { std::fs::read(p); }",
        "fn f() { :: std :: time :: Instant::now() }",
        "use std::io::{self, Write}; fn f() { io::stdout(); }",
        "use std::io::{Write, stdout};",
        "use std::{self as s};",
        "use std as s;",
        "use std::net::TcpStream as Stream;",
        "fn f() { println!(\"{}\", 1) }",
        "fn f() { std::eprintln!() }",
        "fn f() { let quote = '\"'; std::fs::read(p); let other = '\"'; }",
        "fn f<'a>() { std::fs::read(p) }",
    ] {
        assert!(!outside_world(text).is_empty(), "{text}");
    }
}

#[test]
fn the_search_lets_pass_what_only_looks_like_it() {
    for text in [
        "// std::fs::read",
        "/// ```\n/// println!()\n/// ```",
        "/* std::time /* nested */ std::net */",
        "fn f() { let text = \"std::fs and \\\" println!()\"; }",
        "fn f() { let text = r#\"std::fs \" println!()\"#; }",
        "use std::io::{Cursor, Read};",
        "use std::fmt::{self, Display};",
        "fn f() { sprint!(); my_println!() }",
        "use my_std::fs_like; fn f() { times::std_fs() }",
    ] {
        assert_eq!(outside_world(text), Vec::<String>::new(), "{text}");
    }
}

#[test]
fn no_crate_has_a_dependency_that_the_workspace_does_not_declare() {
    for package in crates() {
        for (name, dependency) in package.dependencies() {
            let inherited = dependency.get("workspace").and_then(toml::Value::as_bool);
            assert_eq!(inherited, Some(true), "{}: {name}", package.name);
        }
    }
}

#[test]
fn every_dependency_of_the_workspace_has_its_reason_above_it() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    assert_eq!(without_reason(&manifest), Vec::<&str>::new());
}

/// The dependencies on other people's crates that no comment stands above, nor above the group that they are in: the lines up to a
/// comment or an empty line.
fn without_reason(manifest: &str) -> Vec<&str> {
    let section = manifest.lines().skip_while(|line| *line != "[workspace.dependencies]").skip(1);
    let mut explained = false;
    let mut missing = Vec::new();
    for line in section.take_while(|line| !line.starts_with('[')) {
        match line.split_once('=') {
            _ if line.starts_with('#') => explained = true,
            Some((name, dependency)) if !explained && !dependency.contains("path") => missing.push(name.trim()),
            Some(_) => {}
            None => explained = false,
        }
    }
    missing
}

#[test]
fn the_search_for_reasons_finds_what_has_none() {
    let manifest = "[workspace.dependencies]\nours = { path = \"ours\" }\n\n# Why.\na = \"1\"\nb = \"1\"\n\nc = \"1\"\n[other]\nd = 1\n";
    assert_eq!(without_reason(manifest), ["c"]);
}

#[test]
fn each_crate_is_listed_once() {
    let mut seen = BTreeMap::new();
    for name in FLOORS.concat() {
        assert_eq!(seen.insert(name, ()), None, "{name}");
    }
}
