//! A text that is laid out anew says the same, loses nothing, and is laid out.

use insta::assert_snapshot;
use proptest::prelude::*;
use scene_format::{format, print};

use crate::{messages, read};
use scene_format::conformance::scene;

/// The words and comments of a text, white space aside.
fn pieces(text: &str) -> String {
    text.chars().filter(|character| !character.is_whitespace() && *character != '\u{feff}').collect()
}

fn assert_laid_out(text: &str) {
    let parsed = read(text);
    let Ok(once) = format(text) else { return };
    assert_eq!(read(&once).scene, parsed.scene, "in\n{text}\nlaid out as\n{once}\nwith\n{}", messages(&read(&once)));
    assert_eq!(format(&once).as_ref(), Ok(&once), "a second time, of\n{text}");
    // The second mark of a quote that its line ended is put in.
    let (before, after) = (pieces(text).replace('"', ""), pieces(&once).replace('"', ""));
    assert_eq!(before, after, "of\n{text}\nlaid out as\n{once}");
}

/// Comments and line ends between the words of a text.
fn peppered(text: &str, with: &[(usize, &str)]) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for (at, what) in with {
        let count = lines.len();
        if let Some(line) = lines.get_mut(at % count.max(1)) {
            // Not into program text, where it would be no comment.
            if !text.contains("<code>") {
                line.push_str(what);
            }
        }
    }
    lines.join("\r\n")
}

proptest! {
    #[test]
    fn a_scene_that_is_laid_out_is_the_same_scene(
        scene in scene(),
        pepper in prop::collection::vec((any::<usize>(), prop::sample::select(vec![
            " % why", "\n\n\n", "\n# alone", " /* a\nb */", "\n /* c */ ", "\n\t", " %", "\n\n% apart\n\n",
        ])), 0..6),
    ) {
        let text = print(&scene);
        assert_laid_out(&text);
        assert_laid_out(&peppered(&text, &pepper));
    }

    #[test]
    fn printing_and_laying_out_have_one_style(scene in scene()) {
        let text = print(&scene);
        let again = format(&text);
        prop_assert_eq!(again.as_ref(), Ok(&text));
    }
}

#[test]
fn each_place_of_what_moves_has_a_line() {
    let text = "camera { type fisheye steps 2 times 0 1 { eye 1 1 1 target 0 0 0 up 0 0 1 } transform { } }
object { shader a transform steps 2 times 0 1 { scaleu 1 } row 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 type box }";
    assert_laid_out(text);
    assert_snapshot!(format(text).unwrap(), @"
        camera {
          type fisheye
          steps 2 times 0 1
          {
            eye 1 1 1
            target 0 0 0
            up 0 0 1
          }
          transform { }
        }
        
        object {
          shader a
          transform steps 2 times 0 1
          {
            scaleu 1
          }
          row 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1
          type box
        }
    ");
}

#[test]
fn one_style() {
    let text = "\u{feff}% a scene\r\nimage{ resolution 640\t480\n\n\n  aa 0 1 % two by two\n}\nbucket 32 \"reverse row\"   accel bih
/* the
   camera */ camera { type pinhole eye 0 -5 0 target 0 0 0 up 0 0 1 fov 30 aspect 1 }
shader { name \"a b\" type phong diff {\"sRGB nonlinear\" 1 0 0} spec 1 1 1 50 }
object { shader \"a b\" transform { scaleu 2 rotatex 90 } type generic-mesh points 3 0 0 0 1 0 0 0 0 1 % corners
triangles 1 0 1 2 normals none uvs none face_shaders 0 }
shader { name j type janino <code>
  return \"{%\";
</code> }
xyzzy { some {words}
 on lines }
";
    assert_laid_out(text);
    assert_snapshot!(format(text).unwrap());
}

#[test]
fn a_text_with_an_error_is_not_laid_out() {
    let error = format("image { aa x }").unwrap_err();
    assert_eq!(error.code.as_str(), "SC201");
}

#[test]
fn an_include_need_not_be_there() {
    assert_eq!(format("include   x.sc").as_deref(), Ok("include x.sc\n"));
}

#[test]
fn a_byte_order_mark_behind_white_space_is_white_space() {
    // Found by fuzzing: it came to stand at the beginning, where the second time it was no part of the word any more.
    assert_laid_out("\n\u{feff}ect { type boxl }");
    assert_eq!(format("\n\u{feff}xyzzy").as_deref(), Ok("xyzzy\n"));
}

#[test]
fn a_statement_that_is_glued_to_a_brace_begins_a_line() {
    // Found by fuzzing: the word lost its place to the brace.
    assert_laid_out("image { aa 0 1 }x bucket 8 row");
    assert_eq!(format("image { aa 0 1 }x").as_deref(), Ok("image {\n  aa 0 1\n}\n\nx\n"));
}

#[test]
fn an_unknown_word_behind_a_comment_that_ends_its_line_is_not_indented() {
    // Found by fuzzing: it was taken for the rest of a line that was cut, and only the second time for one of its own.
    assert_laid_out("gi {\n  type ig\n  steps 1 % light\rs\n}");
    assert_laid_out("xyzzy {\n  a /* b */ c\n}");
    assert_eq!(format("xyzzy {\n  a /* b */ c\n}").as_deref(), Ok("xyzzy {\n  a  /* b */\n  c\n}\n"));
}
