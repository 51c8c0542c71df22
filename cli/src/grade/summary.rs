use std::fmt::Write;

use super::Sheet;
use crate::table::{Align, markdown};

/// A table of all laws, what there is to say about those that are not kept, and the score.
pub(crate) fn summary(sheet: &Sheet) -> String {
    let headings = [
        ("part", Align::Left),
        ("law", Align::Left),
        ("", Align::Left),
        ("points", Align::Right),
        ("time", Align::Right),
    ];
    let points = |points: f64, most: f64| format!("{} of {}", number(points), number(most));
    let mut rows: Vec<Vec<String>> = Vec::new();
    for mark in &sheet.marks {
        rows.push(vec![
            mark.part.to_string(),
            mark.sentence(),
            mark.answer.word().to_owned(),
            points(mark.points(), mark.most),
            format!("{:.2} s", mark.time.as_secs_f64()),
        ]);
    }
    if let Some((speed, reached, most)) = &sheet.speed {
        let time = speed.as_ref().map_or_else(|_| "-".to_owned(), |speed| format!("{:.2} s", speed.own));
        let ratio = speed.as_ref().map_or_else(|_| "-".to_owned(), |speed| format!("{:.2} x", speed.ratio()));
        rows.push(vec![
            "speed".to_owned(),
            "against the reference's time".to_owned(),
            ratio,
            points(*reached, *most),
            time,
        ]);
    }
    let mut text = markdown(&headings, &rows);
    for mark in sheet.marks.iter().filter(|mark| !mark.is_kept()) {
        let said = mark.said(sheet.cases).replace('\n', "\n    ");
        let _ = write!(text, "\n{}: {} ({})\n    {said}\n", mark.part, mark.sentence(), mark.answer.word());
    }
    let kept = sheet.marks.iter().filter(|mark| mark.is_kept()).count();
    let _ = write!(text, "\n{kept} of {} laws kept: {} points", sheet.marks.len(), points(sheet.score(), sheet.most()));
    if let Some(said) = sheet.speed_said() {
        let _ = write!(text, "; speed: {said}");
    }
    if let Some(seed) = sheet.shown_seed() {
        let _ = write!(text, "\nthe same cases again: --seed {seed} --cases {}", sheet.case_count);
    }
    text.push('\n');
    text
}

/// To two digits after the point, and none where there are none.
fn number(points: f64) -> String {
    let text = format!("{points:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::{Cases, sheet::example};

    #[test]
    fn points_are_shown_without_needless_digits() {
        assert_eq!([0.0, 10.0, 2.5, 1.0 / 3.0].map(number), ["0", "10", "2.5", "0.33"]);
    }

    #[test]
    fn each_law_has_a_row_and_each_that_is_not_kept_a_paragraph() {
        let text = summary(&example(Cases::Shown));
        assert_eq!(text.lines().filter(|line| line.starts_with("| sphere")).count(), 4);
        assert!(text.contains("| speed  | against the reference's time | 1.50 x   | 2.25 of 3 | 3.00 s |"), "{text}");
        assert!(text.contains("sphere: it is behind (too long)\n    no answer within 10 s"), "{text}");
        let last: Vec<&str> = text.lines().rev().take(2).collect();
        assert_eq!(last[0], "the same cases again: --seed 987654 --cases 256");
        assert_eq!(
            last[1],
            "1 of 4 laws kept: 3.25 of 8.5 points; speed: 1.50 times the reference's time, 2.00 million rays a second"
        );
    }
}
