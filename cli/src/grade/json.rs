use serde_json::{Value, json};

use super::{Answer, Cases, Mark, Sheet};

/// All that is known, for programs of one's own: of each law the case, what was expected and found, and a drawing as SVG.
pub(crate) fn json(sheet: &Sheet) -> Value {
    json!({
        "score": sheet.score(),
        "max_score": sheet.most(),
        "seed": sheet.shown_seed(),
        "cases": sheet.case_count,
        "laws": sheet.marks.iter().map(|mark| law(mark, sheet.cases)).collect::<Vec<_>>(),
        "speed": sheet.speed.as_ref().map(|(speed, points, most)| json!({
            "score": points,
            "max_score": most,
            "seconds": speed.as_ref().ok().map(|speed| speed.own),
            "reference_seconds": speed.as_ref().ok().map(|speed| speed.reference),
            "rays_per_second": speed.as_ref().ok().map(|speed| speed.rays / speed.own),
            "said": sheet.speed_said(),
        })),
    })
}

fn law(mark: &Mark, cases: Cases) -> Value {
    let mut law = json!({
        "part": mark.part.name(),
        "law": mark.law,
        "result": mark.answer.word(),
        "score": mark.points(),
        "max_score": mark.most,
        "seconds": mark.time.as_secs_f64(),
    });
    if !mark.is_kept() {
        law["usually"] = mark.usually.into();
        law["said"] = mark.said(cases).into();
    }
    if let (Answer::Broken(report), Cases::Shown) = (&mark.answer, cases) {
        law["case"] = report.case.as_str().into();
        law["expected"] = report.expected.as_str().into();
        law["found"] = report.found.as_str().into();
        law["figure"] = report.figure.as_deref().into();
    }
    law
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::sheet::example;

    #[test]
    fn a_broken_law_has_its_case_and_a_kept_one_nothing_more() {
        let sheet = json(&example(Cases::Shown));
        assert_eq!(sheet["laws"][1]["case"], "Case { 12345 }");
        assert_eq!(sheet["laws"][1]["figure"], "<svg/>");
        assert_eq!(sheet["laws"][0].get("usually"), None);
        assert_eq!((&sheet["score"], &sheet["max_score"]), (&json!(3.25), &json!(8.5)));
        assert_eq!(sheet["speed"]["reference_seconds"], 2.0);
    }
}
