//! The reader is total: it answers to every text, soon, with values or messages.

use proptest::prelude::*;
use scene_format::{Severity, print};

use crate::read;
use scene_format::conformance::{
    parser::{disturbance, disturbed},
    scene,
};

const SCENE: &str = r#"
% a scene with something of everything
image { resolution 320 200 aa 0 1 samples 4 filter mitchell jitter true }
bucket 32 "reverse spiral"
trace-depths { diff 1 refl 4 refr 4 }
background { color { "sRGB nonlinear" 0.5 .5 5e-1 } }
camera { type thinlens eye 0 -8 3 target 0 0 1 up 0 0 1 fov 45 aspect 1.3 shift 0 .1 fdist 8 lensr 0.1 sides 6 rotation 3 }
shader { name a type phong diff 1 0 0 spec { XYZ 1 1 1 } 50 samples 4 }
shader { name b type glass eta 1.5 color 1 1 1 absorbtion.distance 3 absorbtion.color 1 1 1 50 }
shader { name c type janino <code>
  return "{%";
</code> }
light { type point color 1 1 1 power 100 p 1 2 3 }
light { type meshlight name m emit 1 1 1 points 3 0 0 0 1 0 0 0 1 0 triangles 1 0 1 2 }
object { shader a transform { rotate 0 0 1 30 translate 1 2 3 } type sphere name s }
object { shader a transform steps 2 times 0 1 row 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 { } type plane p 0 0 0 p 1 0 0 p 0 1 0 }
object { shaders 2 a b type generic-mesh points 3 0 0 0 1 0 0 0 1 0 triangles 1 0 1 2
  normals vertex 0 0 1 0 0 1 0 0 1 uvs facevarying 0 0 1 0 0 1 face_shaders 1 }
object { shader a type mesh name o 3 1 v 0 0 0 0 0 1 0 0 v 1 0 0 0 0 1 0 0 v 0 1 0 0 0 1 0 0 t 0 1 2 }
instance { name i geometry s transform { scaleu 2 } shader b }
/* gone */ gi { type path samples 4 } include "x.sc" unknown { camera { } }
"#;

#[test]
fn the_example_has_no_error_but_its_missing_include() {
    let errors = read(SCENE).diagnostics.into_iter().filter(|diagnostic| diagnostic.severity == Severity::Error);
    let errors: Vec<String> = errors.map(|error| error.message).collect();
    assert_eq!(errors, ["cannot find the include `x.sc`"]);
}

#[test]
fn every_beginning_of_a_scene_can_be_read_and_printed() {
    for (end, _) in SCENE.char_indices() {
        print(&read(&SCENE[..end]).scene);
    }
}

proptest! {
    #[test]
    fn any_text_can_be_read(text in any::<String>()) {
        print(&read(&text).scene);
    }

    #[test]
    fn any_row_of_the_formats_words_can_be_read(
        words in prop::collection::vec((0.0..1.0, 1..4usize), 0..40),
    ) {
        let known: Vec<&str> = SCENE.split_whitespace().collect();
        let piece = |(from, length): (f64, usize)| {
            let start = (from * known.len() as f64) as usize;
            known[start..(start + length).min(known.len())].join(" ")
        };
        let text: Vec<String> = words.into_iter().map(piece).collect();
        print(&read(&text.join("\n")).scene);
    }

    #[test]
    fn a_disturbed_scene_can_be_read(
        scene in prop::option::of(scene()),
        changes in prop::collection::vec((0.0..1.0, 0.0..0.02, disturbance()), 1..4),
    ) {
        let mut text = scene.map_or_else(|| SCENE.to_owned(), |scene| print(&scene));
        for (from, length, by) in changes {
            text = disturbed(&text, from, length, &by);
        }
        let parsed = read(&text);
        for diagnostic in &parsed.diagnostics {
            parsed.sources.line_column(diagnostic.span);
        }
        print(&parsed.scene);
    }
}

/// A count takes no memory before its data are seen: these would ask for many gigabytes.
#[test]
fn an_announced_count_is_not_trusted() {
    for source in [
        "object { shader a type generic-mesh points 4294967295 0 0 0 triangles 4000000000 0 0 0 }",
        "object { shader a type mesh 4294967295 4294967295 v 0 0 0 0 0 0 0 0 }",
        "object { shaders 2147483647 a type sphere }",
        "object { shader a transform steps 2147483647 times 0 1 { } type sphere }",
    ] {
        assert!(read(source).diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error), "{source}");
    }
}

/// Time grows with the length of the text and not with its square, which for these would be minutes instead of milliseconds.
#[test]
fn repeated_beginnings_take_no_longer_than_their_length() {
    for piece in [
        "{",
        "}",
        "{ ",
        "object {",
        "object { shader ",
        "x { ",
        "x {a",
        "x { bucket 8 row ",
        "gi { ",
        "{x{",
        "\"",
        "/* ",
        "/*x",
        "<code>\n",
        "shader { type x { ",
        "object { type mesh 1 1 ",
        "transform { ",
        "include a ",
        "% \u{3000}",
        "object { type x <code>\n",
    ] {
        read(&piece.repeat(500_000 / piece.len()));
    }
}
