use std::time::Duration;

use super::{Answer, Cases, Reason, Report, Speed};
use crate::parts::Part;

/// All that a program was marked for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sheet {
    /// A mark for each law, in the order of the kits.
    pub(crate) marks: Vec<Mark>,
    /// The time against the reference's, if it was measured: and what it is worth, of what it can be.
    pub(crate) speed: Option<(Result<Speed, Reason>, f64, f64)>,
    /// The seed of all cases.
    pub(crate) seed: u64,
    /// How many a law of ordinary cost is tried on.
    pub(crate) case_count: u32,
    pub(crate) cases: Cases,
}

/// What came of a law.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mark {
    pub(crate) part: Part,
    pub(crate) law: &'static str,
    pub(crate) usually: &'static str,
    pub(crate) answer: Answer,
    /// What it is worth if it is kept; a law that is not kept is worth nothing.
    pub(crate) most: f64,
    pub(crate) time: Duration,
}

impl Mark {
    pub(crate) fn is_kept(&self) -> bool {
        self.answer == Answer::Kept
    }

    pub(crate) fn points(&self) -> f64 {
        if self.is_kept() { self.most } else { 0.0 }
    }

    /// The law's name as a sentence.
    pub(crate) fn sentence(&self) -> String {
        self.law.replace('_', " ")
    }

    /// What there is to say about a law that is not kept, in lines; nothing about one that is.
    pub(crate) fn said(&self, cases: Cases) -> String {
        let usually = format!("usually: {}", self.usually);
        match (&self.answer, cases) {
            (Answer::Kept, _) => String::new(),
            (Answer::Broken(_), Cases::Hidden) => usually,
            (Answer::Broken(Report { case, expected, found, .. }), Cases::Shown) => {
                format!("   case: {case}\nexpected: {expected}\n  found: {found}\n{usually}")
            }
            // What a process says last may be a case.
            (Answer::Died(Reason::Other(_)), Cases::Hidden) => {
                format!("the process ended without an answer\n{usually}")
            }
            (Answer::Died(reason), _) => format!("{}\n{usually}", reason.sentence()),
        }
    }
}

impl Sheet {
    /// Points reached.
    pub(crate) fn score(&self) -> f64 {
        self.marks.iter().map(Mark::points).sum::<f64>() + self.speed.as_ref().map_or(0.0, |(_, points, _)| *points)
    }

    /// Points that there are.
    pub(crate) fn most(&self) -> f64 {
        self.marks.iter().map(|mark| mark.most).sum::<f64>() + self.speed.as_ref().map_or(0.0, |(.., most)| *most)
    }

    /// The seed, for those who may see it.
    pub(crate) fn shown_seed(&self) -> Option<u64> {
        (self.cases == Cases::Shown).then_some(self.seed)
    }

    /// The parts, each once.
    pub(crate) fn parts(&self) -> Vec<Part> {
        let mut parts: Vec<Part> = self.marks.iter().map(|mark| mark.part).collect();
        parts.dedup();
        parts
    }

    /// What is said of the speed.
    pub(crate) fn speed_said(&self) -> Option<String> {
        let (speed, ..) = self.speed.as_ref()?;
        Some(speed.as_ref().map_or_else(|reason| format!("not measured: {}", reason.sentence()), Speed::sentence))
    }

    /// The speed, where it was measured.
    pub(crate) fn measured(&self) -> Option<&Speed> {
        self.speed.as_ref().and_then(|(speed, ..)| speed.as_ref().ok())
    }
}

/// A sheet with one of each, for the tests of the reports.
#[cfg(test)]
pub(crate) fn example(cases: Cases) -> Sheet {
    let mark = |law, answer, most| Mark {
        part: Part::Sphere,
        law,
        usually: "the sign is <wrong> & so is \"this\"",
        answer,
        most,
        time: Duration::from_millis(1250),
    };
    let report = Report {
        case: "Case { 12345 }".to_owned(),
        expected: "Some(1)".to_owned(),
        found: "None\u{1b}[0m".to_owned(),
        figure: Some("<svg/>".to_owned()),
    };
    Sheet {
        marks: vec![
            mark("it_is_met", Answer::Kept, 1.0),
            mark("it_is_missed", Answer::Broken(report), 2.0),
            mark("it_is_behind", Answer::Died(Reason::Time(10_000)), 1.5),
            mark("it_is_large", Answer::Died(Reason::Other("exit status: 3; it said: Case 12345".to_owned())), 1.0),
        ],
        speed: Some((Ok(Speed { own: 3.0, reference: 2.0, rays: 6e6 }), 2.25, 3.0)),
        seed: 987_654,
        case_count: 256,
        cases,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_score_is_that_of_the_laws_kept_and_of_speed() {
        let sheet = example(Cases::Shown);
        assert_eq!((sheet.score(), sheet.most()), (1.0 + 2.25, 5.5 + 3.0));
    }

    #[test]
    fn what_is_hidden_is_in_no_report() {
        let reports = |cases| {
            let sheet = example(cases);
            [
                super::super::summary(&sheet),
                super::super::junit(&sheet).unwrap(),
                super::super::gradescope(&sheet).to_string(),
                super::super::json(&sheet).to_string(),
            ]
        };
        for secret in ["12345", "987654", "Some(1)", "None", "svg"] {
            for (number, report) in reports(Cases::Hidden).iter().enumerate() {
                assert!(!report.contains(secret), "{number} tells {secret}: {report}");
            }
        }
        for (number, report) in reports(Cases::Shown).iter().enumerate() {
            for shown in ["12345", "987654", "Some(1)"] {
                assert!(report.contains(shown), "{number} does not tell {shown}: {report}");
            }
        }
    }
}
