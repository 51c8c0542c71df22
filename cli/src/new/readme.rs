use std::fmt::Write;

use super::Template;
use crate::grade::exams;
use crate::parts::Part;

/// Where the laws stand in a task's text: before the first of its other headings.
const HINTS: &str = "## Hints";

/// The task, the laws, what to type, hints and papers.
pub(super) fn readme(part: Part, template: &Template, name: &str) -> String {
    let (task, hints) = template.task().split_once(HINTS).unwrap_or((template.task(), ""));
    format!(
        "# {name}\n\nA renderer with its own {}: everything else is girasol's.\n\n## Task\n\n{task}{}{}{HINTS}{hints}",
        template.called,
        commands(template),
        laws(part),
    )
}

fn commands(template: &Template) -> String {
    let Template { module, kit, .. } = template;
    let doc = format!("cargo doc --open -p {kit}");
    format!(
        "Write it in `src/{module}.rs`; nothing else needs to change.\n\n\
         ```console\n\
         $ cargo test                                   # the laws\n\
         $ cargo run --release -- render marbles        # a picture\n\
         $ cargo run --release -- compare marbles       # beside the reference's, with a slider, in one page\n\
         $ cargo run --release -- grade                 # a table of marks, and the time against the reference's\n\
         $ cargo run --release -- --help                # all else\n\
         $ {doc:<45}# the contract; in `conformance` the kit's own page\n\
         ```\n\n"
    )
}

fn laws(part: Part) -> String {
    let mut text = String::from(
        "## The laws\n\n\
         From the easiest to the hardest: begin with the first that fails. A failing test prints the smallest case that it found as a literal, what was \
         expected and what was found, and where it has drawn a picture of it. `PROPTEST_CASES` scales how many cases are tried, \
         `PROPTEST_RNG_SEED` repeats them.\n\n",
    );
    for (number, exam) in (1..).zip(exams(part)) {
        let _ = writeln!(text, "{number}. **{}.** If not, usually: {}.", sentence(exam.law), exam.usually);
    }
    text.push('\n');
    text
}

/// A law's name as a sentence.
fn sentence(law: &str) -> String {
    let words = law.replace('_', " ");
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
