use std::any::Any;
use std::cell::Cell;
use std::collections::hash_map::RandomState;
use std::fmt::{self, Debug, Display};
use std::hash::BuildHasher;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngAlgorithm, RngSeed, TestCaseError, TestError, TestRunner};

use super::{Figure, picture};

/// A law that every implementation of a part keeps: our own, a student's.
///
/// A kit is a list of them; [`crate::kit!`] makes one.
#[derive(Clone, Copy)]
pub struct Law<Part: 'static> {
    /// The law as a sentence, which is the name of its test as well.
    pub name: &'static str,
    /// What is usually wrong where it is broken, in one sentence.
    pub usually: &'static str,
    /// Looks for a case that breaks it.
    pub search: fn(&Part, &Trial) -> Verdict,
}

/// Whether a law is kept, or the smallest case found that breaks it.
pub type Verdict = Result<(), Box<Counterexample>>;

/// A case that breaks a law.
#[derive(Clone, Debug, PartialEq)]
pub struct Counterexample {
    /// The case, as a literal for a test. Where it is empty, [`Trial::search`] fills in what it tried.
    pub case: String,
    /// What the law asks for.
    pub expected: String,
    /// What the part returned.
    pub found: String,
    /// The case as a drawing.
    pub figure: Option<Figure>,
}

impl Counterexample {
    /// What was expected and what was found.
    pub fn new(expected: impl Into<String>, found: impl Into<String>) -> Box<Self> {
        Box::new(Self { case: String::new(), expected: expected.into(), found: found.into(), figure: None })
    }

    /// Of a smaller case than was tried: of its many questions, say, the one that was answered wrongly.
    #[must_use]
    pub fn of(mut self: Box<Self>, case: &impl Debug) -> Box<Self> {
        self.case = format!("{case:?}");
        self
    }

    /// With a drawing.
    #[must_use]
    pub fn drawn(mut self: Box<Self>, figure: Figure) -> Box<Self> {
        self.figure = Some(figure);
        self
    }
}

/// The verdict of a law that asks for one value.
///
/// # Errors
///
/// If the other was found.
pub fn same<Value: PartialEq + Debug>(expected: &Value, found: &Value) -> Verdict {
    if expected == found { Ok(()) } else { Err(Counterexample::new(format!("{expected:?}"), format!("{found:?}"))) }
}

/// How many cases are tried, and from which seed they are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Trial {
    /// The number of cases for a law of ordinary cost.
    pub cases: u32,
    /// The same seed makes the same cases, on every machine.
    pub seed: u64,
}

impl Default for Trial {
    /// `PROPTEST_CASES` and `PROPTEST_RNG_SEED`, or 256 cases from a seed of its own for each trial.
    fn default() -> Self {
        let Config { cases, rng_seed, .. } = Config::default();
        let seed = match rng_seed {
            RngSeed::Fixed(seed) => seed,
            RngSeed::Random => RandomState::new().hash_one(()),
        };
        Self { cases, seed }
    }
}

impl Trial {
    /// So many times as many cases, for a law that is cheap to try and hard to break.
    #[must_use]
    pub fn times(self, factor: u32) -> Self {
        Self { cases: self.cases.saturating_mul(factor), ..self }
    }

    /// Tries a law on cases; one that breaks it is made as small as can be. A panic breaks it, too.
    pub fn search<Case: Debug>(&self, cases: impl Strategy<Value = Case>, law: impl Fn(&Case) -> Verdict) -> Verdict {
        let config = Config {
            cases: self.cases,
            rng_algorithm: RngAlgorithm::ChaCha,
            rng_seed: RngSeed::Fixed(self.seed),
            failure_persistence: None,
            max_global_rejects: self.cases.saturating_mul(16),
            // It would write to the terminal that it gives up. (The greatest number means another.)
            max_shrink_iters: u32::MAX - 1,
            ..Config::default()
        };
        // How often a case that breaks the law is still made smaller.
        let steps_left = Cell::new(None);
        let tried = TestRunner::new(config).run(&cases, |case| {
            match steps_left.get() {
                Some(0) => return Ok(()),
                Some(steps) => steps_left.set(Some(steps - 1)),
                None => {}
            }
            attempt(&law, &case).map_err(|broken| {
                steps_left.set(steps_left.get().or(Some(self.cases.saturating_mul(4))));
                TestCaseError::fail(broken.found)
            })
        });
        match tried {
            Ok(()) => Ok(()),
            Err(TestError::Abort(reason)) => panic!("the kit makes too few cases: {reason}"),
            Err(TestError::Fail(found_before, case)) => {
                let again = Counterexample::new("the same answer whenever it is asked", found_before.message());
                let mut broken = attempt(&law, &case).err().unwrap_or(again);
                if broken.case.is_empty() {
                    broken = broken.of(&case);
                }
                Err(broken)
            }
        }
    }
}

/// Tries one case; a panic becomes what was found.
fn attempt<Case>(law: impl Fn(&Case) -> Verdict, case: &Case) -> Verdict {
    catch_unwind(AssertUnwindSafe(|| law(case)))
        .unwrap_or_else(|panic| Err(Counterexample::new("an answer", format!("a panic: {}", message(&*panic)))))
}

fn message(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("without a message")
}

impl<Part> Law<Part> {
    /// Tries the law on a part.
    ///
    /// # Errors
    ///
    /// A report of the smallest case found that breaks it.
    pub fn check(&self, part: &Part, trial: &Trial) -> Result<(), Broken> {
        (self.search)(part, trial).map_err(|counterexample| Broken {
            law: self.name,
            usually: self.usually,
            counterexample,
            seed: trial.seed,
            picture: None,
        })
    }

    /// Tries the law on a part, as a test.
    ///
    /// # Panics
    ///
    /// If it is broken: with the report, after a picture was written beside the program's other test output.
    #[track_caller]
    #[expect(clippy::needless_pass_by_value, reason = "only as a value does a function or a closure become a part")]
    pub fn assert(&self, part: Part) {
        if let Err(mut broken) = self.check(&part, &Trial::default()) {
            broken.picture = broken.counterexample.figure.as_ref().and_then(|figure| picture::keep(self.name, figure));
            panic!("{broken}");
        }
    }
}

/// The report of a broken law.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// Its name.
    pub law: &'static str,
    /// What is usually wrong.
    pub usually: &'static str,
    /// The case.
    pub counterexample: Box<Counterexample>,
    /// What makes the same cases again.
    pub seed: u64,
    /// Where the picture stands.
    pub picture: Option<PathBuf>,
}

impl Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Counterexample { case, expected, found, .. } = &*self.counterexample;
        writeln!(f, "{}: this law is broken", self.law)?;
        writeln!(f, "      case: {case}")?;
        writeln!(f, "  expected: {expected}")?;
        writeln!(f, "     found: {found}")?;
        writeln!(f, "   usually: {}", self.usually)?;
        if let Some(picture) = &self.picture {
            writeln!(f, "   picture: {}", picture.display())?;
        }
        write!(f, "     again: PROPTEST_RNG_SEED={} cargo test {}", self.seed, self.law)
    }
}

/// Makes a kit of laws: the constant `LAWS`, from the easiest to the hardest, and a macro that names them as tests of a part.
///
/// A law is a function `fn(&Part, &Trial) -> Verdict` beside it, then what is usually wrong where it is broken:
///
/// ```
/// pub mod conformance {
///     pub mod root {
///         use geometry::conformance::{Counterexample, Trial, Verdict};
///
///         pub type Root = fn(f64) -> f64;
///
///         /// The root of a square is its side.
///         pub fn a_square_has_its_side(root: &Root, trial: &Trial) -> Verdict {
///             trial.search(0.0..1e3_f64, |&side| {
///                 let found = root(side * side);
///                 let close = (found - side).abs() <= 1e-12 * side;
///                 if close { Ok(()) } else { Err(Counterexample::new(side.to_string(), found.to_string())) }
///             })
///         }
///
///         geometry::kit! { $crate
///             /// Names the laws of a square root as tests.
///             root_conformance, Root, root;
///             a_square_has_its_side: "a guess was not made better often enough";
///         }
///     }
/// }
///
/// fn main() {
///     use conformance::root::{LAWS, Root};
///     let trial = geometry::conformance::Trial::default();
///     assert!(LAWS[0].check(&(f64::sqrt as Root), &trial).is_ok());
///     assert!(LAWS[0].check(&((|square| square / 2.0) as Root), &trial).is_err());
/// }
/// ```
///
/// Kits are modules of their crate's module `conformance`, which the macro's third word names. (The `$crate` lets one macro write
/// another that finds the crate of the kit.) A test file of another crate then says `root_conformance!(my_root);`.
#[macro_export]
macro_rules! kit {
    ($d:tt $kit:tt
        $(#[$doc:meta])*
        $tests:ident, $part:ty, $module:ident;
        $($law:ident: $usually:literal;)+
    ) => {
        /// The laws of the kit, from the easiest to the hardest.
        pub const LAWS: &[$crate::conformance::Law<$part>] =
            &[$($crate::conformance::Law { name: stringify!($law), usually: $usually, search: $law }),+];

        $(#[$doc])*
        #[macro_export]
        macro_rules! $tests {
            ($d part:expr) => {
                $(
                    #[test]
                    fn $law() {
                        let laws = $d $kit::conformance::$module::LAWS;
                        let law = laws.iter().find(|law| law.name == stringify!($law)).expect("a law of the kit");
                        law.assert($d part);
                    }
                )+
            };
        }
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    type Half = fn(u32) -> u32;

    fn twice_the_half_is_the_whole(half: &Half, trial: &Trial) -> Verdict {
        trial.times(4).search(0..1000_u32, |&number| same(&(2 * number), &(2 * half(2 * number))))
    }

    const LAW: Law<Half> = Law {
        name: "twice_the_half_is_the_whole",
        usually: "the division is a subtraction",
        search: twice_the_half_is_the_whole,
    };
    const TRIAL: Trial = Trial { cases: 64, seed: 7 };

    #[test]
    fn a_part_that_keeps_a_law_passes() {
        assert_eq!(LAW.check(&((|number| number / 2) as Half), &TRIAL), Ok(()));
    }

    #[test]
    fn the_smallest_case_is_reported() {
        let wrong: Half = |number| if number < 20 { number / 2 } else { number / 2 + 1 };
        let report = LAW.check(&wrong, &TRIAL).unwrap_err().to_string();
        let expected = "\
twice_the_half_is_the_whole: this law is broken
      case: 10
  expected: 20
     found: 22
   usually: the division is a subtraction
     again: PROPTEST_RNG_SEED=7 cargo test twice_the_half_is_the_whole";
        assert_eq!(report, expected);
    }

    #[test]
    fn a_panic_breaks_a_law() {
        let wrong: Half = |number| if number < 20 { number / 2 } else { panic!("at {number}") };
        let broken = LAW.check(&wrong, &TRIAL).unwrap_err().counterexample;
        assert_eq!((broken.case.as_str(), broken.found.as_str()), ("10", "a panic: at 20"));
    }

    #[test]
    fn making_a_case_smaller_comes_to_an_end() {
        let asked = Cell::new(0);
        let broken = TRIAL.search(proptest::collection::vec(0..1000_u32, 500), |_| {
            asked.set(asked.get() + 1);
            Err(Counterexample::new("", ""))
        });
        assert!(broken.is_err());
        assert_eq!(asked.get(), 1 + 4 * TRIAL.cases + 1);
    }

    #[test]
    fn a_part_that_changes_its_mind_breaks_a_law() {
        use std::sync::atomic::{AtomicU32, Ordering};
        static ASKED: AtomicU32 = AtomicU32::new(0);
        let wrong: Half = |number| number / 2 + u32::from(ASKED.fetch_add(1, Ordering::Relaxed) == 3);
        let broken = LAW.check(&wrong, &TRIAL).unwrap_err().counterexample;
        assert_eq!(broken.expected, "the same answer whenever it is asked");
    }

    #[test]
    fn a_seed_makes_the_same_cases_again() {
        let wrong: Half = |number| if number % 14 != 4 { number / 2 } else { 0 };
        assert_eq!(LAW.check(&wrong, &TRIAL), LAW.check(&wrong, &TRIAL));
    }
}
