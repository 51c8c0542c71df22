use std::ops::ControlFlow;
use std::panic;
use std::time::{Duration, Instant};

use geometry::conformance::Trial;
use render::{Film, Modules, Settings, render};
use serde_json::{Value, json};

use super::{Answer, exams};
use crate::args::{ExamineArguments, ExamineSpeedArguments, ResultArguments};
use crate::input::SceneSource;
use crate::options::RenderOptions;
use crate::output::write_file;
use crate::report::{Failure, Show};

/// Tries one law in this process, held to its limits, and writes down what came of it.
pub(crate) fn examine(arguments: &ExamineArguments, modules: Modules) -> Result<(), Failure> {
    let exam = exams(arguments.part).into_iter().find(|exam| exam.law == arguments.law);
    let exam = exam.ok_or_else(|| Failure::new(format!("`{}` has no law `{}`", arguments.part, arguments.law)))?;
    let trial = Trial { cases: arguments.cases, seed: arguments.seed };
    answer(&arguments.result, move || {
        // A panic breaks the law, and is told as what was found.
        panic::set_hook(Box::new(|_| {}));
        Ok(Answer::written(&exam.try_on(&modules, &trial)))
    })
}

/// Renders a scene with this program's parts and with the reference's, in turn, and writes down the least time of each.
pub(crate) fn examine_speed(arguments: &ExamineSpeedArguments, modules: Modules) -> Result<(), Failure> {
    let scene = arguments.scene.clone();
    let rounds = arguments.rounds.get();
    answer(&arguments.result, move || {
        let source = SceneSource::find(&scene)?;
        let reference = Modules::default();
        let texts = [source.parse(&modules), source.parse(&reference)];
        let ready =
            |number: usize, modules| source.assemble(&texts[number], &RenderOptions::default(), modules, Show::Errors);
        let sides = [ready(0, modules)?, ready(1, reference)?];
        let mut times = [Duration::MAX; 2];
        let mut films: [Option<Film>; 2] = [None, None];
        for _ in 0..rounds {
            for (number, side) in sides.iter().enumerate() {
                let settings = Settings {
                    size: Settings::default().size.map(|edge| edge / 2),
                    aa: 0,
                    samples: 1,
                    ..side.settings.clone()
                };
                let start = Instant::now();
                films[number] = render(&side.assembled.scene, &settings, &|_| ControlFlow::Continue(()));
                times[number] = times[number].min(start.elapsed());
            }
        }
        let [Some(own), Some(_)] = films else { return Err(Failure::new("a rendering was broken off")) };
        let [own_time, reference_time] = times.map(|time| time.as_secs_f64());
        Ok(json!({ "own": own_time, "reference": reference_time, "rays": own.rays.total() }))
    })
}

/// Works in a thread with a stack as small as a test's, so that a part that passes here passes there.
fn answer(to: &ResultArguments, work: impl FnOnce() -> Result<Value, Failure> + Send + 'static) -> Result<(), Failure> {
    to.limits().keep()?;
    let thread = std::thread::Builder::new().name("law".to_owned()).spawn(work);
    let thread = thread.map_err(|error| Failure::of("a thread cannot be started", error))?;
    let value = thread.join().map_err(|_| Failure::new("the law itself panicked"))??;
    write_file(&to.result, value.to_string().as_bytes())
}
