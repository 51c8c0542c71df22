use render::Modules;

use crate::args::SceneArgument;
use crate::input::SceneSource;
use crate::options::RenderOptions;
use crate::report::{self, Failure, Show};

pub(crate) fn run(arguments: &SceneArgument, modules: Modules) -> Result<(), Failure> {
    let source = SceneSource::find(&arguments.scene)?;
    let parsed = source.parse(&modules);
    let ready = source.assemble(&parsed, &RenderOptions::default(), modules, Show::All)?;
    let diagnostics = [&parsed.diagnostics[..], &ready.assembled.warnings].concat();
    report::line(format!("`{}` can be rendered: {}", source.label(), report::counted(&diagnostics)));
    Ok(())
}
