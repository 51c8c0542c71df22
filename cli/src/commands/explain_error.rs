use scene_format::Code;

use crate::args::ExplainArguments;
use crate::output::print;
use crate::report::Failure;

pub(crate) fn run(arguments: &ExplainArguments) -> Result<(), Failure> {
    let Some(name) = &arguments.code else {
        let titles =
            Code::ALL.map(|code| code.explanation().lines().next().unwrap_or_default().replace("## ", "") + "\n");
        return print(&titles.concat());
    };
    match Code::from_name(name) {
        Some(code) => print(&format!("{}\n", code.explanation())),
        None => Err(Failure::new(format!("no message has the code `{name}`"))
            .help("`girasol explain-error` lists all of them; a code stands in brackets before its message")),
    }
}
