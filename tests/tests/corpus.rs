//! Real scenes by other people, which are no part of this repository: `GIRASOL_SHARED/scenes/corpus`, with an index that says what
//! Sunflow's own reader makes of each.
//!
//! `girasol check FOLDER` prints the table; here stands what must hold in it.
#![expect(clippy::print_stdout, reason = "figures for whoever runs it")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use scene_format::{Severity, format, print};
use tests::{Beside, Ended, Folder, shared_folder};

const PROGRAM: &str = env!("CARGO_BIN_EXE_girasol-under-test");

/// What the index says of a file.
struct Indexed {
    accepted_by_sunflow: bool,
    misses_files: bool,
}

fn corpus() -> Option<PathBuf> {
    shared_folder().map(|shared| shared.join("scenes/corpus"))
}

fn index(corpus: &Path) -> BTreeMap<String, Indexed> {
    let text = fs::read_to_string(corpus.join("INDEX.tsv")).unwrap();
    let mut lines = text.lines().map(|line| line.split('\t').collect::<Vec<_>>());
    let heading = lines.next().unwrap();
    let column = |name: &str| heading.iter().position(|cell| *cell == name).unwrap();
    let (parser, missing) = (column("sunflow_parser"), column("missing"));
    lines
        .map(|cells| {
            let misses_files = cells.get(missing).is_some_and(|cell| !cell.is_empty());
            (cells[0].to_owned(), Indexed { accepted_by_sunflow: cells[parser] == "ok", misses_files })
        })
        .collect()
}

/// Each row of the table: file, read, warnings, errors, rendered.
fn rows(table: &str) -> Vec<[String; 5]> {
    let cells = |line: &str| line.trim_matches('|').split(" | ").map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    table.lines().filter(|line| line.starts_with('|')).skip(2).map(|line| cells(line).try_into().unwrap()).collect()
}

#[test]
fn real_scenes_are_read_and_rendered() {
    let Some(corpus) = corpus() else { return };
    let index = index(&corpus);
    let Ended { stdout, .. } = Folder::for_program(PROGRAM).run(&["check", corpus.to_str().unwrap()]);
    println!("{stdout}");
    let rows = rows(&stdout);
    assert_eq!(rows.len(), index.len());
    let (mut rejected, mut read_all_the_same) = (0, 0);
    for [file, read, _, errors, rendered] in &rows {
        let indexed = &index[file];
        if indexed.accepted_by_sunflow && !indexed.misses_files {
            assert_eq!(errors, "0", "{file}: {rendered}");
            assert!(rendered == "yes" || rendered == "no: it has no camera", "{file}: {rendered}");
        }
        if !indexed.accepted_by_sunflow {
            rejected += 1;
            read_all_the_same += usize::from(read == "yes");
        }
    }
    println!("of {rejected} scenes that Sunflow rejects, {read_all_the_same} are read");
    assert!(rejected > 0 && read_all_the_same * 100 >= rejected * 95);
}

/// The whole texts of all real scenes of the folders beside each other.
fn texts(shared: &Path) -> Vec<(PathBuf, String)> {
    fn below(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                below(&path, found);
            } else if path.extension().is_some_and(|ending| ending == "sc") {
                found.push(path);
            }
        }
    }
    let mut paths = Vec::new();
    below(&shared.join("scenes"), &mut paths);
    paths.sort();
    assert!(paths.len() > 100);
    let text = |path: &PathBuf| scene_format::decode(&fs::read(path).unwrap()).unwrap();
    paths.iter().map(|path| (path.clone(), text(path))).collect()
}

#[test]
fn real_scenes_survive_printing() {
    let Some(shared) = shared_folder() else { return };
    for (path, text) in texts(&shared) {
        let files = Beside(path.parent().unwrap().to_owned());
        let read = |text: &str| scene_format::parse("scene.sc", text, &files).scene;
        let scene = read(&text);
        assert_eq!(read(&print(&scene)), scene, "{}", path.display());
    }
}

#[test]
fn real_scenes_survive_being_laid_out() {
    let Some(shared) = shared_folder() else { return };
    let mut laid_out = 0;
    for (path, text) in texts(&shared) {
        let files = Beside(path.parent().unwrap().to_owned());
        let parsed = scene_format::parse("scene.sc", &text, &files);
        let Ok(once) = format(&text) else {
            assert!(parsed.diagnostics.iter().any(|said| said.severity == Severity::Error), "{}", path.display());
            continue;
        };
        laid_out += 1;
        let again = scene_format::parse("scene.sc", &once, &files);
        assert_eq!(again.scene, parsed.scene, "{}", path.display());
        let codes =
            |parsed: &scene_format::Parsed<'_>| parsed.diagnostics.iter().map(|said| said.code).collect::<Vec<_>>();
        assert_eq!(codes(&again), codes(&parsed), "{}", path.display());
        assert_eq!(format(&once).as_ref(), Ok(&once), "{}", path.display());
        let pieces = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
        assert_eq!(pieces(&once), pieces(text.trim_start_matches('\u{feff}')), "{}", path.display());
    }
    println!("{laid_out} scenes laid out");
}
