use std::ops::ControlFlow;
use std::panic;
use std::time::{Duration, Instant};

use geometry::conformance::Trial;
use render::{Film, Modules, Settings};
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

/// The size of the pictures that are timed.
const SIZE: [u32; 2] = [320, 240];

/// Makes a picture of a scene with this program's parts and with the reference's, in turn, and writes down the least time of each.
pub(crate) fn examine_speed(arguments: &ExamineSpeedArguments, modules: Modules) -> Result<(), Failure> {
    let scene = arguments.scene.clone();
    let rounds = arguments.rounds.get();
    answer(&arguments.result, move || {
        let source = SceneSource::find(&scene)?;
        let sides = [modules, Modules::default()];
        let mut times = [Duration::MAX; 2];
        let mut rays = [0; 2];
        for _ in 0..rounds {
            for (number, side) in sides.into_iter().enumerate() {
                let start = Instant::now();
                rays[number] = picture(&source, side)?.rays.total();
                times[number] = times[number].min(start.elapsed());
            }
        }
        let [own, reference] = times.map(|time| time.as_secs_f64());
        Ok(json!({ "own": own, "reference": reference, "rays": rays[0] }))
    })
}

/// From text to picture, with one ray a pixel.
fn picture(source: &SceneSource, modules: Modules) -> Result<Film, Failure> {
    let text = source.parse(&modules);
    let ready = source.assemble(&text, &RenderOptions::default(), modules, Show::Errors)?;
    let settings = Settings { size: SIZE, aa: 0, samples: 1, ..ready.settings };
    let scene = &ready.assembled.scene;
    scene.render(&settings, &|_| ControlFlow::Continue(())).ok_or_else(|| Failure::new("the rendering was broken off"))
}

/// Works in a thread with a stack as small as a test's, so that a part that passes here passes there.
fn answer(to: &ResultArguments, work: impl FnOnce() -> Result<Value, Failure> + Send + 'static) -> Result<(), Failure> {
    to.limits().keep()?;
    let thread = std::thread::Builder::new().name("law".to_owned()).spawn(work);
    let thread = thread.map_err(|error| Failure::of("a thread cannot be started", error))?;
    let value = thread.join().map_err(|_| Failure::new("the law itself panicked"))??;
    write_file(&to.result, value.to_string().as_bytes())
}
