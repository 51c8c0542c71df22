//! Instructions of a test: counted by Valgrind, where it is installed.
//!
//! Hardware counters want a privilege, and a crate with `unsafe` code. Valgrind's callgrind runs a program on a simulated processor and
//! counts every instruction; so this program has itself run twice for each kernel, once going through the cases more often, and
//! divides the difference.

use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::process::{Command, Stdio};
use std::str::FromStr;

use geometry::Kernels;

use super::families::{self, Family};
use super::kernels::{self, Role, Subject};
use super::measure::{TIMED_CASES, run, timed_cases};

/// So many more times the cases are gone through in the second run.
const PASSES: usize = 40;

/// What was counted, or why nothing was.
pub(crate) struct Counts(Result<BTreeMap<(&'static str, &'static str), f64>, String>);

/// One kernel to be run for Valgrind: as an argument `sphere,naive,3`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct KernelRun {
    primitive: String,
    whose: String,
    passes: usize,
}

impl FromStr for KernelRun {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split(',').collect::<Vec<_>>()[..] {
            [primitive, whose, passes] => {
                let passes = passes.parse().map_err(|_| "the third is a number of passes".to_owned())?;
                Ok(Self { primitive: primitive.to_owned(), whose: whose.to_owned(), passes })
            }
            _ => Err("a primitive, whose kernel, and a number of passes, as in sphere,naive,3".to_owned()),
        }
    }
}

/// Does nothing but what is to be counted.
pub(crate) fn run_kernel(kernels: &Kernels, wanted: &KernelRun, seed: u64) {
    go_through(&kernels::sphere(kernels), &families::spheres(), wanted, seed);
    go_through(&kernels::ellipsoid(kernels), &families::ellipsoids(), wanted, seed);
    go_through(&kernels::triangle(kernels), &families::triangles(), wanted, seed);
    go_through(&kernels::plane(kernels), &families::planes(), wanted, seed);
    go_through(&kernels::aabb(kernels), &families::boxes(), wanted, seed);
}

fn go_through<Shape>(subject: &Subject<Shape>, families: &[Family<Shape>], wanted: &KernelRun, seed: u64) {
    if subject.name != wanted.primitive {
        return;
    }
    for contender in subject.contenders.iter().filter(|contender| contender.role.name() == wanted.whose) {
        for family in families {
            run(contender, &timed_cases(subject, family, seed), wanted.passes);
        }
    }
}

impl Counts {
    /// Nothing, for a reason.
    pub(crate) fn none(reason: &str) -> Self {
        Self(Err(reason.to_owned()))
    }

    /// Counts the instructions of every kernel, with `done` told after each.
    pub(crate) fn of_all(kernels: &Kernels, seed: u64, done: &dyn Fn()) -> Self {
        let wanted: Vec<(&'static str, Role, usize)> = [
            tests(&kernels::sphere(kernels), families::spheres().len()),
            tests(&kernels::ellipsoid(kernels), families::ellipsoids().len()),
            tests(&kernels::triangle(kernels), families::triangles().len()),
            tests(&kernels::plane(kernels), families::planes().len()),
            tests(&kernels::aabb(kernels), families::boxes().len()),
        ]
        .concat();
        let counted = wanted.into_iter().map(|(primitive, role, tests)| {
            let count = |passes| counted_run(primitive, role, passes, seed);
            let (few, many) = std::thread::scope(|scope| {
                let few = scope.spawn(|| count(1));
                let many = count(1 + PASSES);
                (few.join().unwrap_or_else(|_| Err("a thread failed".to_owned())), many)
            });
            let difference = many?.saturating_sub(few?);
            done();
            Ok(((primitive, role.name()), difference as f64 / tests as f64))
        });
        Self(counted.collect())
    }

    /// Instructions of a test, if they were counted.
    pub(crate) fn of(&self, primitive: &'static str, role: Role) -> Option<f64> {
        self.0.as_ref().ok()?.get(&(primitive, role.name())).copied()
    }

    /// How they were counted, or why they were not, for readers.
    pub(crate) fn explanation(&self) -> String {
        match &self.0 {
            Ok(_) => "Instructions of a test, with the call through a pointer, as counted by Valgrind's callgrind: the mean over all \
                      families, as the time is."
                .to_owned(),
            Err(why) => format!("Instructions were not counted: {why}."),
        }
    }
}

/// How many tests the difference between two runs is.
fn tests<Shape>(subject: &Subject<Shape>, families: usize) -> Vec<(&'static str, Role, usize)> {
    let tests = families * TIMED_CASES * PASSES;
    subject.contenders.iter().map(|contender| (subject.name, contender.role, tests)).collect()
}

/// The instructions of this program from its start to its end.
fn counted_run(primitive: &str, role: Role, passes: usize, seed: u64) -> Result<u64, String> {
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(["accuracy", "--seed", &seed.to_string()])
        .args(["--run-kernel", &format!("{primitive},{},{passes}", role.name())])
        .stdin(Stdio::null())
        .output()
        .map_err(|error| match error.kind() {
            ErrorKind::NotFound => "Valgrind is not installed, and hardware counters are not read".to_owned(),
            _ => format!("Valgrind cannot be run: {error}"),
        })?;
    let said = String::from_utf8_lossy(&output.stderr);
    let collected = said.lines().find_map(|line| line.split_once("Collected :")).and_then(|(_, count)| {
        // One number for each event; instructions come first.
        count.split_whitespace().next()?.parse().ok()
    });
    collected.filter(|_| output.status.success()).ok_or_else(|| "Valgrind could not run this program".to_owned())
}

/// How many kernels there are to count.
pub(crate) fn steps(kernels: &Kernels) -> usize {
    let own = [kernels.sphere.is_some(), kernels.ellipsoid.is_some(), kernels.triangle.is_some()];
    let others = [kernels.plane.is_some(), kernels.aabb.is_some()];
    2 * (own.len() + others.len()) + own.into_iter().chain(others).filter(|given| *given).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_given_by_three_words() {
        let run: KernelRun = "box,girasol,41".parse().unwrap();
        assert_eq!((&*run.primitive, &*run.whose, run.passes), ("box", "girasol", 41));
        assert!("box,girasol".parse::<KernelRun>().is_err() && "box,girasol,x".parse::<KernelRun>().is_err());
    }

    #[test]
    fn what_was_not_counted_says_why() {
        let counts = Counts::none("of a whim");
        assert_eq!(counts.of("sphere", Role::Ours), None);
        assert_eq!(counts.explanation(), "Instructions were not counted: of a whim.");
    }
}
