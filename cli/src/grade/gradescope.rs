use serde_json::{Value, json};

use super::{Mark, Sheet};

/// The `results.json` of a Gradescope autograder: <https://gradescope-autograders.readthedocs.io/en/latest/specs/>.
pub(crate) fn gradescope(sheet: &Sheet) -> Value {
    let parts = sheet.parts();
    let mut number_in_part = 0;
    let mut last = None;
    let mut tests: Vec<Value> = Vec::new();
    for mark in &sheet.marks {
        number_in_part = if last == Some(mark.part) { number_in_part + 1 } else { 1 };
        last = Some(mark.part);
        let part = 1 + parts.iter().position(|part| *part == mark.part).unwrap_or(0);
        tests.push(test(mark, sheet, &format!("{part}.{number_in_part}")));
    }
    if let (Some((speed, points, most)), Some(said)) = (&sheet.speed, sheet.speed_said()) {
        tests.push(json!({
            "name": "speed against the reference",
            "number": (1 + parts.len()).to_string(),
            "score": points,
            "max_score": most,
            "status": if speed.is_ok() { "passed" } else { "failed" },
            "output": said,
        }));
    }
    let seed = sheet.shown_seed();
    let kept = sheet.marks.iter().filter(|mark| mark.is_kept()).count();
    let again = seed
        .map_or_else(String::new, |seed| format!(" The same cases again: --seed {seed} --cases {}.", sheet.case_count));
    json!({
        "score": sheet.score(),
        "output": format!("{kept} of {} laws kept.{again}", sheet.marks.len()),
        "output_format": "text",
        "execution_time": sheet.marks.iter().map(|mark| mark.time.as_secs_f64()).sum::<f64>().ceil(),
        "tests": tests,
        "leaderboard": leaderboard(sheet),
    })
}

fn test(mark: &Mark, sheet: &Sheet, number: &str) -> Value {
    json!({
        "name": format!("{}: {}", mark.part, mark.sentence()),
        "number": number,
        "score": mark.points(),
        "max_score": mark.most,
        "status": if mark.is_kept() { "passed" } else { "failed" },
        "output": mark.said(sheet.cases),
        "output_format": "text",
    })
}

/// Laws kept, and where it was measured the time: less is better.
fn leaderboard(sheet: &Sheet) -> Vec<Value> {
    let kept = sheet.marks.iter().filter(|mark| mark.is_kept()).count();
    let mut columns = vec![json!({ "name": "laws kept", "value": kept, "order": "desc" })];
    if let Some(speed) = sheet.measured() {
        let rounded = |value: f64| (value * 1e3).round() / 1e3;
        columns.push(json!({ "name": "times the reference's time", "value": rounded(speed.ratio()), "order": "asc" }));
        columns.push(json!({ "name": "million rays a second", "value": rounded(speed.mega_rays()), "order": "desc" }));
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::{Cases, sheet::example};

    #[test]
    fn scores_add_up_and_tests_have_what_is_asked_for() {
        let results = gradescope(&example(Cases::Shown));
        let tests = results["tests"].as_array().unwrap();
        let sum = |name: &str| tests.iter().map(|test| test[name].as_f64().unwrap()).sum::<f64>();
        assert_eq!((results["score"].as_f64(), sum("score"), sum("max_score")), (Some(3.25), 3.25, 8.5));
        let texts = |name: &str| tests.iter().map(|test| test[name].as_str().unwrap()).collect::<Vec<_>>();
        assert_eq!(texts("number"), ["1.1", "1.2", "1.3", "1.4", "2"]);
        assert_eq!(texts("status"), ["passed", "failed", "failed", "failed", "passed"]);
        assert_eq!(texts("name")[1], "sphere: it is missed");
        assert!(texts("output")[1].contains("expected: Some(1)"));
    }

    #[test]
    fn the_leaderboard_says_which_way_is_better() {
        let results = gradescope(&example(Cases::Hidden));
        let expected = json!([
            { "name": "laws kept", "value": 1, "order": "desc" },
            { "name": "times the reference's time", "value": 1.5, "order": "asc" },
            { "name": "million rays a second", "value": 2.0, "order": "desc" },
        ]);
        assert_eq!(results["leaderboard"], expected);
    }
}
