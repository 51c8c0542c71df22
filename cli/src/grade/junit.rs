use std::io;

use quick_xml::Writer;
use quick_xml::events::BytesText;

use super::{Answer, Mark, Sheet};
use crate::report::Failure;

/// The marks as JUnit XML, as Jenkins, GitLab and others read it: a suite for each part, a case for each law; one that is broken has a
/// `failure`, one whose process died an `error`. Without points, which the format has no place for.
pub(crate) fn junit(sheet: &Sheet) -> Result<String, Failure> {
    let mut writer = Writer::new_with_indent(Vec::new(), b' ', 2);
    write(&mut writer, sheet).map_err(|error| Failure::of("the JUnit XML cannot be made", error))?;
    let xml =
        String::from_utf8(writer.into_inner()).map_err(|error| Failure::of("the JUnit XML cannot be made", error))?;
    Ok(format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{xml}\n"))
}

fn write(writer: &mut Writer<Vec<u8>>, sheet: &Sheet) -> io::Result<()> {
    let marks: Vec<&Mark> = sheet.marks.iter().collect();
    let all = totals(&marks);
    writer.create_element("testsuites").with_attributes(attributes("girasol grade", &all)).write_inner_content(
        |writer| {
            for part in sheet.parts() {
                let name = part.name();
                let marks: Vec<&Mark> = sheet.marks.iter().filter(|mark| mark.part == part).collect();
                let of_part = totals(&marks);
                writer
                    .create_element("testsuite")
                    .with_attributes(attributes(&name, &of_part))
                    .write_inner_content(|writer| marks.iter().try_for_each(|mark| case(writer, mark, sheet)))?;
            }
            Ok(())
        },
    )?;
    Ok(())
}

/// How many there are, how many are broken, how many died, and the seconds that they took.
fn totals(marks: &[&Mark]) -> [String; 4] {
    let count = |wanted: fn(&Answer) -> bool| marks.iter().filter(|mark| wanted(&mark.answer)).count().to_string();
    let seconds: f64 = marks.iter().map(|mark| mark.time.as_secs_f64()).sum();
    [
        count(|_| true),
        count(|answer| matches!(answer, Answer::Broken(_))),
        count(|answer| matches!(answer, Answer::Died(_))),
        format!("{seconds:.3}"),
    ]
}

fn attributes<'a>(name: &'a str, [tests, failures, errors, time]: &'a [String; 4]) -> [(&'static str, &'a str); 5] {
    [("name", name), ("tests", tests), ("failures", failures), ("errors", errors), ("time", time)]
}

fn case(writer: &mut Writer<Vec<u8>>, mark: &Mark, sheet: &Sheet) -> io::Result<()> {
    let (class, time) = (mark.part.name(), format!("{:.3}", mark.time.as_secs_f64()));
    let attributes = [("classname", &*class), ("name", mark.law), ("time", &*time)];
    let element = writer.create_element("testcase").with_attributes(attributes);
    let tag = match mark.answer {
        Answer::Kept => return element.write_empty().map(|_| ()),
        Answer::Broken(_) => "failure",
        Answer::Died(_) => "error",
    };
    let seed = sheet
        .shown_seed()
        .map_or_else(String::new, |seed| format!("\n  again: --seed {seed} --cases {}", sheet.case_count));
    let said = readable(&format!("{}{seed}", mark.said(sheet.cases)));
    let attributes = [("type", mark.answer.word()), ("message", mark.usually)];
    element.write_inner_content(|writer| {
        let inner = writer.create_element(tag).with_attributes(attributes);
        inner.write_text_content(BytesText::new(&said)).map(|_| ())
    })?;
    Ok(())
}

/// Without the characters that XML has no way to write.
fn readable(text: &str) -> String {
    text.replace(
        |letter: char| {
            letter.is_control() && !['\n', '\t'].contains(&letter) || letter > '\u{fffd}' && letter <= '\u{ffff}'
        },
        "\u{fffd}",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::{Cases, sheet::example};

    #[test]
    fn suites_cases_failures_and_errors_stand_where_tools_look_for_them() {
        let expected = r#"<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="girasol grade" tests="4" failures="1" errors="2" time="5.000">
  <testsuite name="sphere" tests="4" failures="1" errors="2" time="5.000">
    <testcase classname="sphere" name="it_is_met" time="1.250"/>
    <testcase classname="sphere" name="it_is_missed" time="1.250">
      <failure type="broken" message="the sign is &lt;wrong&gt; &amp; so is &quot;this&quot;">usually: the sign is &lt;wrong&gt; &amp; so is &quot;this&quot;</failure>
    </testcase>
    <testcase classname="sphere" name="it_is_behind" time="1.250">
      <error type="too long" message="the sign is &lt;wrong&gt; &amp; so is &quot;this&quot;">no answer within 10 s: a loop without end, or a part that is far too slow
usually: the sign is &lt;wrong&gt; &amp; so is &quot;this&quot;</error>
    </testcase>
    <testcase classname="sphere" name="it_is_large" time="1.250">
      <error type="crashed" message="the sign is &lt;wrong&gt; &amp; so is &quot;this&quot;">the process ended without an answer
usually: the sign is &lt;wrong&gt; &amp; so is &quot;this&quot;</error>
    </testcase>
  </testsuite>
</testsuites>
"#;
        assert_eq!(junit(&example(Cases::Hidden)).unwrap(), expected);
    }

    #[test]
    fn what_xml_cannot_write_is_replaced() {
        // The example's found value has an escape character in it.
        let xml = junit(&example(Cases::Shown)).unwrap();
        assert!(xml.contains("None\u{fffd}[0m") && xml.contains("again: --seed 987654"), "{xml}");
        assert_eq!(readable("a\u{0}b\n\u{ffff}\u{1f600}"), "a\u{fffd}b\n\u{fffd}\u{1f600}");
    }
}
