use scene_format::scene_file::Statement;
use scene_format::{FileError, Files, Parsed, parse};

use crate::{Table, messages};

fn read(files: &'static [(&'static str, &'static str)]) -> Parsed<'static> {
    parse("scenes/main.sc", files[0].1, &Table(files))
}

/// The paths of all includes, in the order in which they are read.
fn paths(statements: &[scene_format::Spanned<Statement>]) -> Vec<String> {
    let mut found = Vec::new();
    for statement in statements {
        if let Statement::Include { file: Some(file), .. } = &statement.value {
            found.push(file.path.clone());
            found.append(&mut paths(&file.scene.statements));
        }
    }
    found
}

#[test]
fn an_include_is_read_in_place_and_its_directory_searched() {
    let parsed = read(&[
        ("main.sc", "include \"parts\\a.sc\" include b.sc"),
        ("parts/a.sc", "bucket 8 row include c.sc"),
        ("parts/b.sc", "bucket 8 row"),
        ("parts/c.sc", "bucket 8 row"),
    ]);
    assert_eq!(messages(&parsed), "");
    assert_eq!(paths(&parsed.scene.statements), ["parts/a.sc", "parts/c.sc", "parts/b.sc"]);
    let names: Vec<&str> = parsed.sources.files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["scenes/main.sc", "parts/a.sc", "parts/c.sc", "parts/b.sc"]);
}

#[test]
fn an_include_path_counts_from_the_file_that_names_it() {
    let parsed = read(&[
        ("main.sc", "include sub/a.sc"),
        ("sub/a.sc", "includepath more include b.sc"),
        ("sub/more/b.sc", "bucket 8 row"),
    ]);
    assert_eq!(paths(&parsed.scene.statements), ["sub/a.sc", "sub/more/b.sc"]);
}

#[test]
fn messages_name_the_file_that_they_are_about() {
    let parsed = read(&[("main.sc", "\ninclude a.sc"), ("a.sc", "bucket 8 row\n\nshader { }")]);
    insta::assert_snapshot!(messages(&parsed), @"a.sc:3:1: error[SC112]: the shader has no `type` [expected `type <type>` in this block] (types that are rendered: constant, diffuse, phong, mirror, glass, shiny)");
}

#[test]
fn includes_that_cannot_be_read_are_errors() {
    let parsed = read(&[
        ("main.sc", "includepath parts include missing.sc include a.sca include empty.sc include main.sc"),
        ("parts/empty.sc", " % nothing"),
    ]);
    insta::assert_snapshot!(messages(&parsed), @"
        scenes/main.sc:1:27: error[SC501]: cannot find the include `missing.sc` (looked in the scene's own directory, `parts/`; `includepath` adds a directory)
        scenes/main.sc:1:46: error[SC502]: cannot include `a.sca`: only .sc files are read
        scenes/main.sc:1:77: error[SC503]: `main.sc` includes itself [main.sc -> main.sc]
        parts/empty.sc:1:11: warning[SC116]: the file has no statement
    ");
}

#[test]
fn a_file_that_cannot_be_read_says_why() {
    struct Locked;
    impl Files for Locked {
        fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
            if path == "picture.sc" {
                Ok(vec![0; 9])
            } else {
                Err(FileError::Unreadable("permission denied".to_owned()))
            }
        }
    }
    let parsed = parse("main.sc", "include picture.sc include a.sc", &Locked);
    insta::assert_snapshot!(messages(&parsed), @"
        main.sc:1:9: error[SC502]: cannot read `picture.sc`: this is not a text file
        main.sc:1:28: error[SC502]: cannot read the include `a.sc`: permission denied
    ");
}

#[test]
fn files_that_include_each_other_are_an_error() {
    let parsed = read(&[("main.sc", "include a.sc"), ("a.sc", "include ./b.sc"), ("b.sc", "include a.sc")]);
    insta::assert_snapshot!(messages(&parsed), @"b.sc:1:9: error[SC503]: `a.sc` includes itself [main.sc -> a.sc -> b.sc -> a.sc]");
}

/// Every file includes the next one, and for each name there is one.
struct Endless;

impl Files for Endless {
    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        Ok(format!("include {path}x include {path}y").into_bytes())
    }
}

#[test]
fn includes_end_at_a_depth_and_at_a_number_of_files() {
    // Without the second limit: two to the power of the first.
    let parsed = parse("main.sc", "include a", &Endless);
    assert_eq!(parsed.sources.files.len(), 4096);
    assert!(parsed.diagnostics.iter().any(|it| it.message == "more than 32 files that include each other"));
}
