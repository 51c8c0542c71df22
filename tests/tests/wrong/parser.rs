use scene_format::conformance::parser as kit;
use scene_format::scene_file::{Color, Image, ShaderKind, Statement};
use scene_format::{
    FileError, Files, Limits, NoFiles, Parsed, SceneFile, Severity, Span, Spanned, parse_within as right,
};

use crate::Kit;

/// Changes each statement, those of includes, too.
fn each(scene: &mut SceneFile, change: &impl Fn(&mut Statement)) {
    for statement in &mut scene.statements {
        change(&mut statement.value);
        if let Statement::Include { file: Some(file), .. } = &mut statement.value {
            each(&mut file.scene, change);
        }
    }
}

/// The right reading, its statements changed.
fn changed<'s>(
    (name, text, files, limits): (&str, &'s str, &dyn Files, &Limits),
    change: impl Fn(&mut Statement),
) -> Parsed<'s> {
    let mut parsed = right(name, text, files, limits);
    each(&mut parsed.scene, &change);
    parsed
}

/// Text without messages of a kind.
fn without<'s>(mut parsed: Parsed<'s>, dropped: impl Fn(Severity) -> bool) -> Parsed<'s> {
    parsed.diagnostics.retain(|diagnostic| !dropped(diagnostic.severity));
    parsed
}

/// Gives nothing, and says that there is an empty file.
struct Empty<'f>(&'f dyn Files);

impl Files for Empty<'_> {
    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        self.0.read(path).or_else(|_| Ok(b"bucket 8 row".to_vec()))
    }
}

#[test]
fn every_mistake_in_a_reader_is_named() {
    let course = "every_statement_of_the_course_is_read";
    let order = "a_scene_keeps_its_statements_in_order";
    let place = "a_statement_s_place_is_where_it_stands";
    let wrong = "a_wrong_word_is_an_error_at_its_place";
    Kit { page: "scene-format/src/conformance/parser.rs", laws: kit::LAWS }.catches([
        (
            "nothing is read",
            (|name, _, files, limits| right(name, "", files, limits)) as kit::Parser,
            "an_image_s_size_is_read",
        ),
        (
            "a block lost: lights",
            |name, text, files, limits| {
                let mut parsed = right(name, text, files, limits);
                parsed.scene.statements.retain(|statement| !matches!(statement.value, Statement::Light(_)));
                parsed
            },
            course,
        ),
        (
            "green and blue exchanged",
            |name, text, files, limits| {
                changed((name, text, files, limits), |statement| {
                    if let Statement::Background(Spanned { value: Color::SrgbNonlinear([_, green, blue]), .. }) =
                        statement
                    {
                        std::mem::swap(green, blue);
                    }
                })
            },
            course,
        ),
        (
            "statements turned around",
            |name, text, files, limits| {
                let mut parsed = right(name, text, files, limits);
                parsed.scene.statements.reverse();
                parsed
            },
            order,
        ),
        (
            "only the last of several shaders kept",
            |name, text, files, limits| {
                let mut parsed = right(name, text, files, limits);
                let is_shader = |statement: &Spanned<Statement>| matches!(statement.value, Statement::Shader(_));
                let last = parsed.scene.statements.iter().rposition(is_shader);
                let mut at = 0;
                parsed.scene.statements.retain(|statement| {
                    at += 1;
                    !is_shader(statement) || Some(at - 1) == last
                });
                parsed
            },
            order,
        ),
        (
            "wrong defaults: `samples` made up",
            |name, text, files, limits| {
                changed((name, text, files, limits), |statement| {
                    if let Statement::Shader(shader) = statement
                        && let ShaderKind::Phong { samples, .. } = &mut shader.kind
                    {
                        samples.get_or_insert(4.into());
                    }
                })
            },
            "what_a_text_leaves_out_is_none",
        ),
        (
            "comments read as words",
            |name, text, files, limits| match text.contains('%') {
                true => {
                    let mut parsed = right(name, "", files, limits);
                    parsed.sources.files[0].text = text.into();
                    parsed
                }
                false => right(name, text, files, limits),
            },
            "comments_and_white_space_mean_nothing",
        ),
        (
            "numbers rounded to six digits",
            |name, text, files, limits| {
                changed((name, text, files, limits), |statement| {
                    if let Statement::Background(Spanned { value: Color::Bare(channels), .. }) = statement {
                        *channels = channels.map(|channel| format!("{channel:.5e}").parse().unwrap_or(channel));
                    }
                })
            },
            "a_number_keeps_every_bit",
        ),
        (
            "no places",
            |name, text, files, limits| {
                let mut parsed = right(name, text, files, limits);
                for statement in &mut parsed.scene.statements {
                    statement.span = Span::default();
                }
                parsed
            },
            place,
        ),
        (
            "places counted in characters, not bytes",
            |name, text, files, limits| {
                let mut parsed = right(name, text, files, limits);
                let characters = |at: u32| text.get(..at as usize).map_or(at, |before| before.chars().count() as u32);
                for statement in &mut parsed.scene.statements {
                    let Span { file, start, end } = statement.span;
                    statement.span = Span { file, start: characters(start), end: characters(end) };
                }
                parsed
            },
            place,
        ),
        (
            "a wrong number without a message",
            |name, text, files, limits| {
                without(right(name, text, files, limits), |severity| severity == Severity::Error)
            },
            wrong,
        ),
        (
            "a message without position",
            |name, text, files, limits| {
                let mut parsed = right(name, text, files, limits);
                for diagnostic in &mut parsed.diagnostics {
                    diagnostic.span = Span::default();
                }
                parsed
            },
            wrong,
        ),
        (
            "reading ends at the first error",
            |name, text, files, limits| {
                let mut parsed = right(name, text, files, limits);
                let errors = parsed.diagnostics.iter().filter(|it| it.severity == Severity::Error);
                if let Some(first) = errors.map(|error| error.span.start).min() {
                    parsed.scene.statements.retain(|statement| statement.span.start < first);
                }
                parsed
            },
            "after_an_error_the_next_statement_is_read",
        ),
        (
            "an unknown block is an error",
            |name, text, files, limits| {
                let mut parsed = right(name, text, files, limits);
                for diagnostic in &mut parsed.diagnostics {
                    diagnostic.severity = Severity::Error;
                }
                parsed
            },
            "an_unknown_statement_is_skipped_with_a_warning",
        ),
        (
            "includes ignored",
            |name, text, _, limits| right(name, text, &NoFiles, limits),
            "an_include_is_read_in_its_place",
        ),
        (
            "a missing include without a message",
            |name, text, files, limits| match text.starts_with("include missing") {
                true => right(name, text, &Empty(files), limits),
                false => right(name, text, files, limits),
            },
            "an_include_that_is_missing_is_an_error",
        ),
        ("limits ignored", |name, text, files, _| right(name, text, files, &Limits::default()), "limits_are_kept"),
        (
            "a panic at an open quote",
            |name, text, files, limits| {
                assert!(text.matches('"').count() % 2 == 0, "index out of bounds");
                right(name, text, files, limits)
            },
            "any_text_is_read_without_a_panic",
        ),
        (
            "places beyond the text's end",
            |name, text, files, limits| {
                let mut parsed = right(name, text, files, limits);
                let end = text.len() as u32;
                for diagnostic in parsed.diagnostics.iter_mut().filter(|it| it.span.end == end) {
                    diagnostic.span.end += 1;
                }
                parsed
            },
            "places_lie_in_the_text",
        ),
        (
            "what is not rendered is thrown away",
            |name, text, files, limits| {
                let mut parsed = right(name, text, files, limits);
                parsed.scene.statements.retain(|statement| !matches!(statement.value, Statement::Gi(_)));
                changed_images(parsed)
            },
            "a_scene_that_was_printed_is_read_as_it_was",
        ),
    ]);
}

/// What nobody heeds in an `image` is thrown away, too.
fn changed_images(mut parsed: Parsed<'_>) -> Parsed<'_> {
    each(&mut parsed.scene, &|statement| {
        if let Statement::Image(image) = statement {
            *image = Image { filter: None, jitter: None, ..std::mem::take(image) };
        }
    });
    parsed
}
