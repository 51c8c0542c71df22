//! Who may know whom: read from the manifests and the sources themselves, so that a wrong `use` fails before it grows.

mod sources;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use sources::{Crate, code_only, paths_in};

/// The house, from the ground up: a crate may know those on the floors below its own. Crates on one floor do not know each other.
const FLOORS: [&[&str]; 5] = [&["geometry"], &["accel", "shading", "scene-format"], &["render"], &["cli"], &["tests"]];

/// What only cli may touch, as the beginnings of paths.
const OUTSIDE_WORLD: [&str; 6] = ["std::fs", "std::net", "std::time", "io::stdout", "io::stderr", "io::stdin"];

/// Macros that write to the terminal.
const WRITING_MACROS: [&str; 5] = ["print!", "println!", "eprint!", "eprintln!", "dbg!"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace is around this package").to_owned()
}

fn crates() -> Vec<Crate> {
    FLOORS.concat().into_iter().map(|name| Crate::read(&root(), name)).collect()
}

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

/// Functions of numbers whose bits std leaves to the machine or its C library, as methods and by path. Those of the crate `libm` have the
/// same bits everywhere. (`sqrt`, `rem_euclid`, `to_radians` are exact or one rounding; `min` and `max` may give either sign of zero, which
/// nothing here makes a difference of.)
const MACHINE_S_FUNCTIONS: [&str; 26] = [
    "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh",
    "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "powf", "powi", "hypot", "cbrt",
];

/// glam's types with SIMD inside, and their products: another instruction set, other bits. And std's fused multiply-add, which rounds
/// once where the formula rounds twice.
const MACHINE_S_TYPES: [&str; 12] = [
    "Vec3A", "Vec4", "Quat", "DQuat", "Mat2", "Mat3A", "Mat4", "Affine2", "Affine3A", "DAffine2", "DAffine3", "mul_add",
];

#[test]
fn pictures_are_made_of_operations_whose_bits_do_not_depend_on_the_machine() {
    let mut found = Vec::new();
    for package in crates().iter().filter(|package| package.name != "tests") {
        for (path, text) in package.sources() {
            // Of cli only the scenes have a part in pictures; what the laws of the conformance kits compute has none.
            let names = path.to_string_lossy().replace('\\', "/");
            let is_scene = names.contains("/src/scenes");
            if (package.name == "cli" && !is_scene) || names.contains("conformance") || names.ends_with("/laws.rs") {
                continue;
            }
            found.extend(machine_s_operations(&text).into_iter().map(|name| format!("{}: {name}", path.display())));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

/// The names of such operations in a source text, its tests left out: these stand last in a file.
fn machine_s_operations(text: &str) -> Vec<&'static str> {
    let code = code_only(text);
    let code = code.split("#[cfg(test)]").next().unwrap_or_default();
    // A space may stand wherever the formatter breaks a line.
    let code: String = code.split_whitespace().collect::<Vec<_>>().join(" ").replace(" .", ".").replace(" (", "(");
    let is_called = |name: &&&str| {
        ["f32::", "f64::", "."].iter().any(|before| {
            let call = format!("{before}{name}");
            code.match_indices(&call).any(|(at, _)| {
                let after = &code[at + call.len()..];
                // `f64::sin` may also be named without a call.
                after.starts_with('(') || (*before != "." && !after.starts_with(is_part_of_a_name))
            })
        })
    };
    let is_named = |name: &&&str| code.split(|letter| !is_part_of_a_name(letter)).any(|word| word == **name);
    let functions = MACHINE_S_FUNCTIONS.iter().filter(is_called);
    functions.chain(MACHINE_S_TYPES.iter().filter(is_named)).copied().collect()
}

fn is_part_of_a_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

#[test]
fn the_search_for_machine_s_operations_finds_each_and_nothing_else() {
    let found = |text: &str| machine_s_operations(text);
    assert_eq!(found("fn f(x: f64) -> f64 { x.sin() + x.powi(2) }"), ["sin", "powi"]);
    assert_eq!(found("fn f() { map(f32::exp); f64::ln(2.0); }"), ["exp", "ln"]);
    assert_eq!(found("fn f() { x\n    .atan2\n    (y) }"), ["atan2"]);
    assert_eq!(found("use glam::{Quat, Vec3}; fn f() { a.mul_add(b, c) }"), ["Quat", "mul_add"]);
    assert_eq!(
        found(
            "// x.sin()\nfn f() { libm::sin(x); x.sqrt(); x.exponent(); s.log; Vec3::X; } #[cfg(test)] mod tests { x.sin() }"
        ),
        Vec::<&str>::new()
    );
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
fn nothing_is_unsafe() {
    let manifest: toml::Table = fs::read_to_string(root().join("Cargo.toml")).unwrap().parse().unwrap();
    assert_eq!(manifest["workspace"]["lints"]["rust"]["unsafe_code"].as_str(), Some("forbid"));
    for package in crates() {
        let lints = package.manifest.get("lints").and_then(|lints| lints.get("workspace"));
        assert_eq!(
            lints.and_then(toml::Value::as_bool),
            Some(true),
            "{} does not take the workspace's lints",
            package.name
        );
        for (path, text) in package.sources() {
            let code = code_only(&text);
            let mut words = code.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
            assert!(words.all(|word| word != "unsafe"), "{}", path.display());
        }
    }
}

#[test]
fn each_crate_is_listed_once() {
    let mut seen = BTreeMap::new();
    for name in FLOORS.concat() {
        assert_eq!(seen.insert(name, ()), None, "{name}");
    }
}
