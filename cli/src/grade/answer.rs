use geometry::conformance::Broken;
use serde_json::{Value, json};

/// What came of trying a law.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Answer {
    /// The part keeps it.
    Kept,
    /// A case breaks it.
    Broken(Report),
    /// The process ended without an answer.
    Died(Reason),
}

/// The case that breaks a law.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Report {
    pub(crate) case: String,
    pub(crate) expected: String,
    pub(crate) found: String,
    /// A drawing of it, as SVG.
    pub(crate) figure: Option<String>,
}

/// Why a process gave no answer, as far as can be seen from outside.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Reason {
    /// It was ended at the time limit of so many milliseconds.
    Time(u64),
    /// It asked for more than so many MiB.
    Memory(u64),
    /// Calls within calls without end.
    Stack,
    /// Anything else: how it ended, and the last that it said.
    Other(String),
}

impl Answer {
    /// What the process of a law writes down.
    pub(crate) fn written(result: &Result<(), Broken>) -> Value {
        match result {
            Ok(()) => json!({ "kept": true }),
            Err(Broken { counterexample, .. }) => json!({
                "kept": false,
                "case": counterexample.case,
                "expected": counterexample.expected,
                "found": counterexample.found,
                "figure": counterexample.figure.as_ref().map(geometry::conformance::Figure::to_svg),
            }),
        }
    }

    /// Reads what [`Self::written`] wrote; `None` if it is something else.
    pub(crate) fn read(value: &Value) -> Option<Self> {
        if value.get("kept")?.as_bool()? {
            return Some(Self::Kept);
        }
        let text = |name: &str| value.get(name)?.as_str().map(str::to_owned);
        Some(Self::Broken(Report {
            case: text("case")?,
            expected: text("expected")?,
            found: text("found")?,
            figure: text("figure"),
        }))
    }

    /// In a word.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Self::Kept => "kept",
            Self::Broken(_) => "broken",
            Self::Died(Reason::Time(_)) => "too long",
            Self::Died(Reason::Memory(_)) => "too large",
            Self::Died(Reason::Stack) => "too deep",
            Self::Died(Reason::Other(_)) => "crashed",
        }
    }
}

impl Reason {
    /// In a sentence, with what to look for.
    pub(crate) fn sentence(&self) -> String {
        match self {
            Self::Time(limit) => format!(
                "no answer within {} s: a loop without end, or a part that is far too slow",
                *limit as f64 / 1e3
            ),
            Self::Memory(limit) => {
                format!(
                    "more than {limit} MiB of memory: something grows without end, or its size is computed from a wild number"
                )
            }
            Self::Stack => "the stack overflowed: a function calls itself without end".to_owned(),
            Self::Other(how) => format!("the process ended without an answer: {how}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::conformance::Counterexample;

    #[test]
    fn what_is_written_is_read() {
        let mut counterexample = Counterexample::new("1", "2");
        counterexample.case = "Ray { .. }".to_owned();
        let broken = Broken { law: "a_law", usually: "it is", counterexample, seed: 1, picture: None };
        let report =
            Report { case: "Ray { .. }".to_owned(), expected: "1".to_owned(), found: "2".to_owned(), figure: None };
        assert_eq!(Answer::read(&Answer::written(&Err(broken))), Some(Answer::Broken(report)));
        assert_eq!(Answer::read(&Answer::written(&Ok(()))), Some(Answer::Kept));
        for nonsense in [json!({}), json!({ "kept": 1 }), json!({ "kept": false, "case": "x" }), json!(null)] {
            assert_eq!(Answer::read(&nonsense), None, "{nonsense}");
        }
    }
}
