//! Scenes that did not survive printing once; that all do is a law of the kit.

use scene_format::{SceneFile, print};

use crate::{messages, read};

fn assert_round_trip(scene: &SceneFile) {
    let text = print(scene);
    let parsed = read(&text);
    assert_eq!(&parsed.scene, scene, "printed as\n{text}\nwith\n{}", messages(&parsed));
}

#[test]
fn program_text_in_a_scene_survives_printing() {
    let source = "shader {\n name a type janino\n <code>\n  int b = c % 2; // \" {\n\n </code>\n}";
    let scene = read(source).scene;
    assert!(print(&scene).contains("  int b = c % 2; // \" {\n\n"));
    assert_round_trip(&scene);
}

#[test]
fn program_text_in_an_unknown_statement_survives_printing() {
    // Found by the law above: its `}` closed the statement.
    assert_round_trip(&read("xyzzy { <code>\n }\n</code>\n x }").scene);
    assert_round_trip(&read("gi { { <code>\n }\n</code>\n } }").scene);
}

#[test]
fn unknown_statements_that_a_stray_brace_parts_survive_printing() {
    // Found by fuzzing: printed without the brace, the second was read as more of the first.
    assert_round_trip(&read("skat 1 } shape { type mesh }").scene);
    assert_round_trip(&read("skat { 1 } shape 2 { }").scene);
}
