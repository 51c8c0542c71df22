//! Scenes that did not survive printing once; that all do is a law of the kit.

use scene_format::scene_file::{Shape, Statement};
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
    // Found by that law: its `}` closed the statement.
    assert_round_trip(&read("xyzzy { <code>\n }\n</code>\n x }").scene);
    assert_round_trip(&read("gi { { <code>\n }\n</code>\n } }").scene);
}

#[test]
fn what_only_looks_like_program_text_survives_printing() {
    // Found by fuzzing: `</code>` begins no line, so these are words like any others.
    assert_round_trip(&read("r <code>{</code>\n}").scene);
    assert_round_trip(&read("r <code> x </code> y").scene);
    assert_round_trip(&read("r { <code> { </code>\n } }").scene);
    // Here it begins a statement.
    assert_round_trip(&read("p } <code> <code>\n</code>").scene);
    assert_round_trip(&read("<code> x\n }\n</code> y").scene);
}

#[test]
fn unknown_statements_that_a_stray_brace_parts_survive_printing() {
    // Found by fuzzing: printed without the brace, the second was read as more of the first.
    assert_round_trip(&read("skat 1 } shape { type mesh }").scene);
    assert_round_trip(&read("skat { 1 } shape 2 { }").scene);
}

#[test]
fn a_number_that_a_stray_brace_parts_from_a_filter_survives_printing() {
    // Found by fuzzing: printed without the brace, it was read as the filter's size.
    assert_round_trip(&read("filter box } .3").scene);
    assert_round_trip(&read("skat 1 filter box filter box } .3 4 { 5 } }").scene);
}

#[test]
fn a_name_that_is_the_word_type_survives_printing() {
    // Found by fuzzing: the word behind it was taken for the object's type.
    for object in [
        "object { shader cool accel type type sphere c 1 2 3 r 4 }",
        "object { shaders 2 type sphere type box }",
        "object { shader a modifiers 2 type type type file-mesh filename type }",
    ] {
        let parsed = read(object);
        assert_eq!(messages(&parsed).matches("error").count(), 0, "{object}");
        assert!(
            matches!(&parsed.scene.statements[0].value, Statement::Object(it) if !matches!(*it.shape, Shape::Unknown(_)))
        );
        assert_round_trip(&parsed.scene);
    }
    // Here the sphere has lost its type, and nothing else can be meant.
    assert!(messages(&read("object { shader cool accel type sphere c 1 2 3 r 4 }")).contains("has no `type`"));
}
