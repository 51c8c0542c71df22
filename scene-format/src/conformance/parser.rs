//! The kit of a reader of `.sc` scenes.
//!
//! **The idea.** A scene is words between white space, in blocks. A reader makes data of it, and where it cannot, it says where and why, and
//! goes on: one run shows all that is wrong.
//!
//! ```text
//!   image { resolution 640 480 }          words ........ where each begins and ends, in bytes
//!   |       |          |                  statements ... data, each with its place
//!   keyword field      values             diagnostics .. place, what was expected, what was found
//! ```
//!
//! **The contract.** A [`Parser`] makes a [`Parsed`] of a name, a text, what gives it included files, and [`Limits`]. The scene holds the
//! statements in the order of the text; what a text leaves out is `None`: whoever renders knows what is usual. [`crate::print()`] is the way back.
//!
//! **Hard cases.** Every text, be it no scene at all: no panic, and soon. Counts that announce more than follows: memory is taken for what is
//! there. Files that include each other. Letters of several bytes before a place. Unknown blocks, braces and all.
//!
//! **How it is tested.** Scenes are made at random, printed, and read. Equality looks at values alone; places have laws of their own.
//!
//! **Literature.** Aho, Lam, Sethi, Ullman: Compilers, 2nd ed. 2006, sections 4.1.3 and 4.8.3 (going on after an error). Crafting Interpreters
//! (Nystrom 2021), part II. Clinger: How to Read Floating Point Numbers Accurately, PLDI 1990.
//!
//! **Exercises.** Pass the kit up to the places with words alone. Wrap [`crate::parse_within`] to know one more shader. Suggest the word that was
//! meant. Read a mesh of a million triangles faster than the reference, and say where the time goes.
//!
//! | mistake | law that names it |
//! |---|---|
//! | nothing is read | [`an_image_s_size_is_read`] |
//! | a block lost: lights | [`every_statement_of_the_course_is_read`] |
//! | green and blue exchanged | [`every_statement_of_the_course_is_read`] |
//! | statements turned around | [`a_scene_keeps_its_statements_in_order`] |
//! | only the last of several shaders kept | [`a_scene_keeps_its_statements_in_order`] |
//! | wrong defaults: `samples` made up | [`what_a_text_leaves_out_is_none`] |
//! | comments read as words | [`comments_and_white_space_mean_nothing`] |
//! | numbers rounded to six digits | [`a_number_keeps_every_bit`] |
//! | no places | [`a_statement_s_place_is_where_it_stands`] |
//! | places counted in characters, not bytes | [`a_statement_s_place_is_where_it_stands`] |
//! | a wrong number without a message | [`a_wrong_word_is_an_error_at_its_place`] |
//! | a message without position | [`a_wrong_word_is_an_error_at_its_place`] |
//! | reading ends at the first error | [`after_an_error_the_next_statement_is_read`] |
//! | an unknown block is an error | [`an_unknown_statement_is_skipped_with_a_warning`] |
//! | includes ignored | [`an_include_is_read_in_its_place`] |
//! | a missing include without a message | [`an_include_that_is_missing_is_an_error`] |
//! | limits ignored | [`limits_are_kept`] |
//! | a panic at an open quote | [`any_text_is_read_without_a_panic`] |
//! | places beyond the text's end | [`places_lie_in_the_text`] |
//! | what is not rendered is thrown away | [`a_scene_that_was_printed_is_read_as_it_was`] |

use geometry::conformance::{Counterexample, Trial, Verdict, same};
use proptest::prelude::*;

use super::{common_scene, common_statement, float, scene};
use crate::scene_file::*;
use crate::{Diagnostic, FileError, Files, Limits, NoFiles, Parsed, SceneFile, Severity, Span, Spanned, print};

/// A reader: of the scene's name for messages, its text, what gives it its includes, and the limits.
pub type Parser = for<'s> fn(&str, &'s str, &dyn Files, &Limits) -> Parsed<'s>;

fn read<'s>(parser: &Parser, text: &'s str) -> Parsed<'s> {
    parser("scene.sc", text, &NoFiles, &Limits::default())
}

fn has_error(parsed: &Parsed<'_>) -> bool {
    parsed.diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
}

/// The verdict that a text is read as a scene, without any message; told by the first statement that is not.
fn is_read_as(parser: &Parser, text: &str, expected: &SceneFile) -> Verdict {
    let parsed = read(parser, text);
    let (expected, found) = (&expected.statements, &parsed.scene.statements);
    let wrong = (0..expected.len().max(found.len())).find(|&at| expected.get(at) != found.get(at));
    if let Some(at) = wrong {
        let told = |statement: Option<&Spanned<Statement>>| {
            statement.map_or("nothing".to_owned(), |it| format!("{:?}", it.value))
        };
        let expected = format!("statement {at} of the text below to be {}\n{text}", told(expected.get(at)));
        return Err(Counterexample::new(
            expected,
            format!("{}, {}", told(found.get(at)), messages(&parsed.diagnostics)),
        ));
    }
    Ok(())
}

fn messages(diagnostics: &[Diagnostic]) -> String {
    let all: Vec<_> =
        diagnostics.iter().map(|it| format!("{:?}: {} ({:?})", it.severity, it.message, it.label)).collect();
    if all.is_empty() { "no message".to_owned() } else { all.join("; ") }
}

fn alone(statement: Statement) -> SceneFile {
    SceneFile { statements: vec![statement.into()] }
}

/// `image { resolution WIDTH HEIGHT }`: keyword, block, field, two numbers.
pub fn an_image_s_size_is_read(parser: &Parser, trial: &Trial) -> Verdict {
    trial.search([1..2000_u32, 1..2000_u32], |&[width, height]| {
        let text = format!("image {{ resolution {width} {height} }}");
        let image = Image { resolution: Some([width, height].into()), ..Image::default() };
        is_read_as(parser, &text, &alone(Statement::Image(image)))
    })
}

/// Image, bucket, trace-depths, background, camera, shaders, objects and point lights, with all that they may say.
pub fn every_statement_of_the_course_is_read(parser: &Parser, trial: &Trial) -> Verdict {
    trial.times(2).search(common_statement(), |statement| {
        let scene = alone(statement.clone());
        is_read_as(parser, &print(&scene), &scene)
    })
}

/// None is lost; where two set the same thing, whoever renders takes the last.
pub fn a_scene_keeps_its_statements_in_order(parser: &Parser, trial: &Trial) -> Verdict {
    trial.search(common_scene(), |scene| is_read_as(parser, &print(scene), scene))
}

/// The reader makes nothing up: that is left to whoever renders.
pub fn what_a_text_leaves_out_is_none(parser: &Parser, trial: &Trial) -> Verdict {
    let color = || Spanned::from(Color::Bare([1.0, 2.0, 3.0]));
    let view = || View { fov: 60.0.into(), aspect: 2.0.into(), shift: None };
    let camera = |lens: Lens| {
        let [eye, target, up] = [[0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Spanned::from);
        Statement::Camera(Camera {
            lens: lens.into(),
            placement: CameraPlacement::LookAt { eye, target, up },
            shutter: None,
        })
    };
    let shader = |kind| Statement::Shader(Shader { name: "a".to_owned().into(), kind });
    let place = "eye 0 0 0 target 0 1 0 up 0 0 1 fov 60 aspect 2";
    let thin = Lens::Thin { view: view(), focus_distance: 8.0.into(), radius: 0.5.into(), sides: None, rotation: None };
    let cases = [
        ("image { samples 4 }".to_owned(), Statement::Image(Image { samples: Some(4.into()), ..Image::default() })),
        (
            "trace-depths { refl 2 }".to_owned(),
            Statement::TraceDepths(TraceDepths { reflection: Some(2.into()), ..TraceDepths::default() }),
        ),
        (format!("camera {{ type pinhole {place} }}"), camera(Lens::Pinhole(view()))),
        (format!("camera {{ type thinlens {place} fdist 8 lensr 0.5 }}"), camera(thin)),
        (
            "shader { name a type phong diff 1 2 3 spec 1 2 3 50 }".to_owned(),
            shader(ShaderKind::Phong {
                diffuse: Paint::Color(color()),
                specular: color(),
                exponent: 50.0.into(),
                samples: None,
            }),
        ),
        (
            "shader { name a type glass eta 1.5 color 1 2 3 }".to_owned(),
            shader(ShaderKind::Glass { eta: 1.5.into(), color: color(), absorption: Absorption::default() }),
        ),
    ];
    trial.search(0..cases.len(), |&number| {
        let (text, statement) = &cases[number];
        is_read_as(parser, text, &alone(statement.clone()))
    })
}

/// Any white space separates words, and so does a comment: `%` to the end of its line.
pub fn comments_and_white_space_mean_nothing(parser: &Parser, trial: &Trial) -> Verdict {
    let gap = prop::sample::select(vec!["\n", "  ", "\t", " \r\n", " % a comment { } 1\n", " %\n"]);
    trial.search((common_scene(), prop::collection::vec(gap, 8)), |(scene, gaps)| {
        let mut gaps = gaps.iter().cycle();
        // Not within quotes.
        let pieces = print(scene).split('"').map(str::to_owned).enumerate().collect::<Vec<_>>();
        let spaced = pieces.into_iter().map(|(number, piece)| match number % 2 {
            0 => piece
                .split(' ')
                .map(str::to_owned)
                .reduce(|text, word| text + gaps.next().unwrap_or(&" ") + &word)
                .unwrap_or_default(),
            _ => piece,
        });
        is_read_as(parser, &spaced.collect::<Vec<_>>().join("\""), scene)
    })
}

/// Of all finite `f32`, by the shortest digits that name them, and of the forms that Java reads, such as `+1.`, `.5` and `1e2`.
pub fn a_number_keeps_every_bit(parser: &Parser, trial: &Trial) -> Verdict {
    let written = prop_oneof![
        float()
            .prop_map(|number| (number, print(&alone(Statement::Background(Color::Bare([number, 0.0, 0.0]).into()))))),
        prop::sample::select(vec![(1.0_f32, "+1."), (0.5, ".5"), (100.0, "1e2"), (-2.0, "-002"), (0.25, "2.5E-1")])
            .prop_map(|(number, written)| (number, format!("background {{ color {written} 0 0 }}"))),
    ];
    trial.times(4).search(written, |(number, text)| {
        // Bits, since equal floats may differ in the sign of zero.
        match read(parser, text).scene.statements.first().map(|it| &it.value) {
            Some(Statement::Background(Spanned { value: Color::Bare([found, ..]), .. })) => {
                let told = |number: f32| format!("{number:e} (bits {:#x})", number.to_bits());
                same(&told(*number), &told(*found))
            }
            other => Err(Counterexample::new(format!("a background from\n{text}"), format!("{other:?}"))),
        }
    })
}

fn text_at(text: &str, span: Span) -> Option<&str> {
    if span.file == 0 { text.get(span.start as usize..span.end as usize) } else { None }
}

/// From its keyword to its last word, in bytes: read alone, that part of the text is the statement.
pub fn a_statement_s_place_is_where_it_stands(parser: &Parser, trial: &Trial) -> Verdict {
    trial.search(common_scene(), |scene| {
        let text = format!("% \u{e9}\u{3000}\n{}", print(scene));
        for statement in &read(parser, &text).scene.statements {
            let part = text_at(&text, statement.span).unwrap_or("no part of the text");
            let begins = part.starts_with(|letter: char| letter.is_ascii_lowercase());
            let again = read(parser, part).scene.statements;
            if !(begins && again.len() == 1 && again[0] == *statement) {
                let expected = format!("the place of {:?} in\n{text}", statement.value);
                return Err(Counterexample::new(expected, format!("{:?}: {part}", statement.span)));
            }
        }
        Ok(())
    })
}

/// Texts with one wrong word, and what that is.
const WRONG: [(&str, &str); 6] = [
    ("bucket 8 row\nobject { shader a type sphere c 0 zero 0 r 1 }", "zero"),
    ("% \u{e9}\nimage { resolution 320 many }", "many"),
    ("camera { type pinhole eye 0 0 0 target 0 1 x up 0 0 1 fov 60 aspect 1 }", "x"),
    ("light { type point color 1 1 1 power strong p 0 0 0 }", "strong"),
    ("camera { type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov sixty aspect 1 }", "sixty"),
    ("shader { name a type mirror refl 1 2 three }", "three"),
];

/// Where a number is due and none stands.
pub fn a_wrong_word_is_an_error_at_its_place(parser: &Parser, trial: &Trial) -> Verdict {
    trial.search(prop::sample::select(WRONG.to_vec()), |&(text, word)| {
        let parsed = read(parser, text);
        let errors = parsed.diagnostics.iter().filter(|it| it.severity == Severity::Error);
        let places: Vec<_> = errors.map(|error| text_at(text, error.span)).collect();
        if places.contains(&Some(word)) {
            return Ok(());
        }
        Err(Counterexample::new(
            format!("an error at `{word}`"),
            format!("errors at {places:?}, {}", messages(&parsed.diagnostics)),
        ))
    })
}

/// What stands behind the statement that has it is read as if nothing were wrong.
pub fn after_an_error_the_next_statement_is_read(parser: &Parser, trial: &Trial) -> Verdict {
    let wrong = prop::sample::select(WRONG.to_vec());
    trial.search((wrong, common_statement()), |((wrong, _), statement)| {
        let text = format!("{wrong}\n{}", print(&alone(statement.clone())));
        let parsed = read(parser, &text);
        let last = parsed.scene.statements.last().map(|it| &it.value);
        if last == Some(statement) {
            return Ok(());
        }
        Err(Counterexample::new(format!("{statement:?} at the end of\n{text}"), format!("{last:?}")))
    })
}

/// The scene is rendered without it: no error.
pub fn an_unknown_statement_is_skipped_with_a_warning(parser: &Parser, trial: &Trial) -> Verdict {
    let unknown = prop::sample::select(vec!["xyzzy { width 3 }", "xyzzy { a { b 1 } c }", "xyzzy 1 2 3", "xyzzy"]);
    trial.search((unknown, common_statement()), |(unknown, statement)| {
        let text = format!("{unknown}\n{}", print(&alone(statement.clone())));
        let parsed = read(parser, &text);
        let last = parsed.scene.statements.last().map(|it| &it.value);
        let warned = parsed.diagnostics.iter().any(|it| it.severity == Severity::Warning && it.span.start == 0);
        if last == Some(statement) && warned && !has_error(&parsed) {
            return Ok(());
        }
        let expected = format!("a warning at the beginning, no error, and {statement:?}, of\n{text}");
        Err(Counterexample::new(expected, format!("{last:?}, {}", messages(&parsed.diagnostics))))
    })
}

/// One file, whatever its name's directory; nothing else is there.
struct OneFile(String);

impl Files for OneFile {
    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        if path == "part.sc" { Ok(self.0.clone().into_bytes()) } else { Err(FileError::NotFound) }
    }
}

/// With its path, and its own statements, which the file gives.
pub fn an_include_is_read_in_its_place(parser: &Parser, trial: &Trial) -> Verdict {
    trial.search((common_scene(), common_statement()), |(part, last)| {
        let text = format!("include part.sc\n{}", print(&alone(last.clone())));
        let parsed = parser("scene.sc", &text, &OneFile(print(part)), &Limits::default());
        let statements: Vec<_> = parsed.scene.statements.iter().map(|it| &it.value).collect();
        match statements[..] {
            [Statement::Include { file: Some(file), .. }, found]
                if file.path == "part.sc" && file.scene == *part && found == last =>
            {
                Ok(())
            }
            _ => Err(Counterexample::new(
                format!("the statements of `part.sc` in its place, then {last:?}"),
                format!("{statements:?}, {}", messages(&parsed.diagnostics)),
            )),
        }
    })
}

/// At the statement that names it. Nor may a file include itself, however that is written.
pub fn an_include_that_is_missing_is_an_error(parser: &Parser, trial: &Trial) -> Verdict {
    let names = prop::sample::select(vec!["missing.sc", "part.sc", "./part.sc", "scene.sc"]);
    trial.search(names, |name| {
        let text = format!("include {name}");
        let parsed =
            parser("scene.sc", &text, &OneFile("include part.sc include missing.sc".to_owned()), &Limits::default());
        if has_error(&parsed) {
            return Ok(());
        }
        let expected = format!("an error: `{text}` leads to a file that is not there or includes itself");
        Err(Counterexample::new(expected, messages(&parsed.diagnostics)))
    })
}

/// Over each stands an error; counts that announce too much do not take the memory.
pub fn limits_are_kept(parser: &Parser, trial: &Trial) -> Verdict {
    let narrow = Limits { elements: 2, picture_edge: 100, ..Limits::default() };
    let texts = vec![
        "image { resolution 101 50 }",
        "object { shader a type generic-mesh points 3 0 0 0 1 0 0 0 1 0 triangles 1 0 1 2 }",
        "object { shader a type generic-mesh points 4294967295 0 0 0 triangles 4000000000 0 0 0 }",
        "object { shaders 2147483647 a type sphere }",
    ];
    trial.search(prop::sample::select(texts), |text| {
        let parsed = parser("scene.sc", text, &NoFiles, &narrow);
        if has_error(&parsed) { Ok(()) } else { Err(Counterexample::new("an error", messages(&parsed.diagnostics))) }
    })
}

/// Texts that are nearly scenes: printed, then pieces replaced; and any text.
pub fn texts() -> impl Strategy<Value = String> {
    let changes = prop::collection::vec((0.0..1.0, 0.0..0.02, disturbance()), 1..4);
    let disturbed = (scene(), changes).prop_map(|(scene, changes)| {
        changes.into_iter().fold(print(&scene), |text, (from, length, by)| disturbed(&text, from, length, &by))
    });
    prop_oneof![3 => disturbed, 1 => any::<String>()]
}

/// What a slip or an attack may put anywhere: marks, keywords, numbers at the edge, or anything.
pub fn disturbance() -> impl Strategy<Value = String> {
    let words = [
        "{",
        "}",
        "\"",
        "%",
        "/*",
        "*/",
        "<code>",
        "</code>",
        "shader {",
        "object",
        "type",
        "type sphere",
        "include",
        "steps 9",
        "row",
        "points 4294967295",
        "triangles 99999999999",
        "-1",
        "1e99",
        "NaN",
        "spectrum",
        "\u{feff}",
        "\u{3000}",
        "\u{e9}",
        "\r",
        "\n",
        "\0",
        "",
    ];
    prop_oneof![3 => prop::sample::select(words.to_vec()).prop_map(str::to_owned), 1 => any::<String>()]
}

/// The text with a piece of it replaced; places are shares of its length.
pub fn disturbed(text: &str, from: f64, length: f64, by: &str) -> String {
    let boundary = |share: f64| {
        let at = (share * text.len() as f64) as usize;
        (at..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(text.len())
    };
    let (start, end) = (boundary(from), boundary((from + length).min(1.0)));
    format!("{}{by}{}", &text[..start], &text[end..])
}

/// It may come from anywhere.
pub fn any_text_is_read_without_a_panic(parser: &Parser, trial: &Trial) -> Verdict {
    trial.times(2).search(texts(), |text| {
        read(parser, text);
        Ok(())
    })
}

/// Each message's, and each statement's, and on the borders of letters: so that what stands there can be shown.
pub fn places_lie_in_the_text(parser: &Parser, trial: &Trial) -> Verdict {
    trial.times(2).search(texts(), |text| {
        let parsed = read(parser, text);
        let statements = parsed.scene.statements.iter().map(|it| it.span);
        let outside =
            statements.chain(parsed.diagnostics.iter().map(|it| it.span)).find(|&span| text_at(text, span).is_none());
        let Some(span) = outside else { return Ok(()) };
        Err(Counterexample::new(format!("places from 0 to {}", text.len()), format!("{span:?}")))
    })
}

/// All that the format has, rendered or not: blocks that nobody knows keep their words.
pub fn a_scene_that_was_printed_is_read_as_it_was(parser: &Parser, trial: &Trial) -> Verdict {
    trial.search(scene(), |scene| is_read_as(parser, &print(scene), scene))
}

geometry::kit! { $crate
    /// Names the laws of a reader as tests: of a function like [`crate::parse_within`].
    parser_conformance, Parser, parser;
    an_image_s_size_is_read: "nothing is read yet: cut the text into words at white space, and begin with the keyword `image`";
    every_statement_of_the_course_is_read: "a kind of statement is skipped, or two of its numbers are exchanged";
    a_scene_keeps_its_statements_in_order: "the second statement begins where the first one's last word was not taken; or names are kept in a map";
    what_a_text_leaves_out_is_none: "a usual value is filled in, or what is optional is asked for";
    comments_and_white_space_mean_nothing: "words are cut at single blanks, or a comment ends with the next word instead of its line";
    a_number_keeps_every_bit: "digits are added up by hand, or read in single precision twice";
    a_statement_s_place_is_where_it_stands: "places count characters or words instead of bytes, or end with the last word but one";
    a_wrong_word_is_an_error_at_its_place: "what cannot be read counts as 0, or the error stands at the block's beginning";
    after_an_error_the_next_statement_is_read: "reading ends with the first error, or swallows the next keyword";
    an_unknown_statement_is_skipped_with_a_warning: "an unknown word is an error, or its braces are not counted";
    an_include_is_read_in_its_place: "the file is not asked for, or its statements come last";
    an_include_that_is_missing_is_an_error: "what is not there is passed over in silence, or a file that includes itself is read again";
    limits_are_kept: "the limits are not asked, or memory is taken for what a count announces";
    any_text_is_read_without_a_panic: "an index past the last word, or a slice in the middle of a letter";
    places_lie_in_the_text: "a place one past the end, or in the middle of a letter";
    a_scene_that_was_printed_is_read_as_it_was: "what is not rendered is thrown away, or a quote, a brace or program text is not understood";
}
