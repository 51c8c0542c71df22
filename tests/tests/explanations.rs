//! Every code's explanation has a scene that gives it and one that gives nothing at all.

use render::{Lighting, Modules};
use scene_format::{Code, Diagnostic, parse};
use tests::{Folder, MemoryFiles};

const PROGRAM: &str = env!("CARGO_BIN_EXE_girasol-under-test");

/// All that is said of a scene called `scene.sc`, which may ask for itself.
fn said(text: &str, modules: Modules) -> Vec<Diagnostic> {
    let files = MemoryFiles::default().with("scene.sc", text.into()).with("teapot.rib", Vec::new());
    let parsed = parse("scene.sc", text, &files);
    let assembled = match render::assemble(&parsed.scene, &modules, &Lighting::default(), &files) {
        Ok(assembled) => assembled.warnings,
        Err(diagnostics) => diagnostics,
    };
    parsed.diagnostics.into_iter().chain(assembled).collect()
}

/// Glossy reflections are a matter of Sunflow's lighting, where every scene is.
fn modules(code: Code) -> Modules {
    if code == Code::GlossNotRendered { Modules::default().lit_as_by_sunflow() } else { Modules::default() }
}

#[test]
fn every_code_is_explained_once() {
    for code in Code::ALL {
        let explanation = code.explanation();
        assert!(explanation.starts_with(&format!("## {code}: ")), "{code}");
        assert!(explanation.lines().count() > 2, "{code}");
        assert_eq!(Code::from_name(&code.as_str().to_lowercase()), Some(code));
    }
    assert_eq!(Code::from_name("SC000"), None);
}

#[test]
fn the_wrong_example_of_a_code_gives_it() {
    for code in Code::ALL {
        let text = code.example("wrong").unwrap_or_else(|| panic!("{code} has no wrong example"));
        let codes: Vec<Code> = said(text, modules(code)).iter().map(|diagnostic| diagnostic.code).collect();
        assert!(codes.contains(&code), "{code}: {codes:?} of\n{text}");
    }
}

/// All texts in one place, to be read over: each message as people see it.
#[test]
fn what_is_said_of_each_wrong_example() {
    let mut texts = String::new();
    for code in Code::ALL {
        let folder = Folder::for_program(PROGRAM).with("scene.sc", code.example("wrong").unwrap_or_default());
        let lighting = if code == Code::GlossNotRendered { "sunflow" } else { "report" };
        let ended = folder.run(&["render", "scene.sc", "--size", "4x3", "--lighting", lighting]);
        let said = ended.stderr.lines().filter(|line| !line.contains(" pixels in ")).map(|line| format!("{line}\n"));
        texts += &format!("## {code}: exit code {}\n\n{}\n", ended.code.unwrap_or(-1), said.collect::<String>());
    }
    insta::assert_snapshot!(texts.replace("girasol-under-test", "girasol"));
}

#[test]
fn the_right_example_of_a_code_gives_nothing() {
    for code in Code::ALL {
        let text = code.example("right").unwrap_or_else(|| panic!("{code} has no right example"));
        let said = said(text, modules(code));
        assert!(said.is_empty(), "{code}: {said:#?} of\n{text}");
    }
}

#[test]
fn the_program_explains_a_code_in_whatever_case() {
    let folder = Folder::for_program(PROGRAM);
    let ended = folder.run(&["explain-error", "sc107"]);
    assert_eq!((ended.code, ended.stdout), (Some(0), format!("{}\n", Code::UnknownWord.explanation())));
    let all = folder.run(&["explain-error"]);
    assert_eq!(all.stdout.lines().count(), Code::ALL.len());
    assert!(all.stdout.starts_with("SC101: an unknown statement\n"), "{}", all.stdout);
    let ended = folder.run(&["explain-error", "E0308"]);
    assert_eq!(ended.code, Some(1));
}
